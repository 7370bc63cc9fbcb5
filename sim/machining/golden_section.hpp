// The least value of a convex function by golden section.
#pragma once

#include <algorithm>

namespace volute::sim {

/// Where between 0 and 1 its two places stand: 1 - golden and golden, so that each step uses one of them again.
inline constexpr double golden = 0.6180339887498949;

/// Narrows [low, high] about the least value of `function`, which is to be convex there. Each step costs one value and
/// leaves golden of the length. Of equal values the lower place is kept.
template <typename Function>
class GoldenSection {
 public:
  GoldenSection(const Function& function, double low, double high)
      : function_(function), low_(low), high_(high), x1_(inner_low()), x2_(inner_high()) {
    f1_ = function_(x1_);
    f2_ = function_(x2_);
  }

  void narrow(int steps) {
    for (int i = 0; i < steps; ++i) {
      if (f1_ <= f2_) {
        high_ = x2_;
        x2_ = x1_;
        f2_ = f1_;
        x1_ = inner_low();
        f1_ = function_(x1_);
      } else {
        low_ = x1_;
        x1_ = x2_;
        f1_ = f2_;
        x2_ = inner_high();
        f2_ = function_(x2_);
      }
    }
  }

  /// The values at the two places, lower place first.
  [[nodiscard]] double first() const { return f1_; }
  [[nodiscard]] double second() const { return f2_; }
  [[nodiscard]] double least() const { return std::min(f1_, f2_); }

 private:
  [[nodiscard]] double inner_low() const { return high_ - golden * (high_ - low_); }
  [[nodiscard]] double inner_high() const { return low_ + golden * (high_ - low_); }

  const Function& function_;
  double low_, high_, x1_, x2_;
  double f1_ = 0.0, f2_ = 0.0;
};

}  // namespace volute::sim

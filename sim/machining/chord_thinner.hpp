// From the states of every interpolation cycle to as few as a stated chord error allows; nothing else is kept.
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include <Eigen/Core>

namespace volute::sim {

/// Streams items and keeps those that linear motion between them needs. `Trait` gives:
///   Point   an Eigen vector of mm that stands for an item's place,
///   Point point(const Item&) const,
///   bool same_stretch(const Item& a, const Item& b) const: false where an item must be kept between a and b.
/// Properties: 1. Every item left out lies within `tolerance_mm` of the segment between the kept items about it. 2. The
/// first, the last, and the last before each new stretch are kept. 3. Memory: the kept items and at most `pending_max`
/// others.
template <class Item, class Trait>
class ChordThinner {
 public:
  ChordThinner(double tolerance_mm, Trait trait) : tolerance_mm_(tolerance_mm), trait_(std::move(trait)) {}

  void add(const Item& item) {
    if (kept_.empty()) {
      kept_.push_back(item);
      last_ = trait_.point(item);
      return;
    }
    if (!pending_.empty() && !trait_.same_stretch(pending_.back(), item)) flush();
    pending_.push_back(item);
    points_.push_back(trait_.point(item));
    if (pending_.size() < next_check_) return;
    if (pending_.size() < pending_max && straight(pending_.size())) {
      next_check_ = pending_.size() + std::max<std::size_t>(4, pending_.size() / 2);
      return;
    }
    keep_some();
  }

  /// Ends the stream. The thinner is empty afterwards.
  std::vector<Item> finish() {
    flush();
    return std::exchange(kept_, {});
  }

  static constexpr std::size_t pending_max = 256;

 private:
  using Point = typename Trait::Point;

  void flush() {
    while (!pending_.empty()) keep_some();
  }

  /// Whether the first `count` pending items can be one move from the last kept one: the last of them ends it.
  [[nodiscard]] bool straight(std::size_t count) const {
    const Point along = points_[count - 1] - last_;
    const double length_sq = along.squaredNorm(), limit_sq = tolerance_mm_ * tolerance_mm_;
    for (std::size_t i = 0; i + 1 < count; ++i) {
      const Point w = points_[i] - last_;
      const double s = length_sq > 0.0 ? std::clamp(w.dot(along) / length_sq, 0.0, 1.0) : 0.0;
      if ((w - s * along).squaredNorm() > limit_sq) return false;
    }
    return true;
  }

  /// Keeps the end of the longest straight beginning of what is pending, found by halving. Requires: something is
  /// pending.
  void keep_some() {
    std::size_t good = 1, bad = pending_.size() + 1;
    while (bad - good > 1) {
      const std::size_t middle = (good + bad) / 2;
      (straight(middle) ? good : bad) = middle;
    }
    kept_.push_back(pending_[good - 1]);
    last_ = points_[good - 1];
    pending_.erase(pending_.begin(), pending_.begin() + static_cast<std::ptrdiff_t>(good));
    points_.erase(points_.begin(), points_.begin() + static_cast<std::ptrdiff_t>(good));
    next_check_ = 4;
  }

  double tolerance_mm_;
  Trait trait_;
  std::size_t next_check_ = 4;
  Point last_;
  std::vector<Item> kept_, pending_;
  std::vector<Point> points_;
};

}  // namespace volute::sim

// An angle that cannot be made from a bare number: the unit is always said.
#pragma once

#include <cmath>
#include <compare>
#include <numbers>

namespace volute::geometry {

/// A plane angle, kept in radians, not reduced to one turn.
/// Properties: 1. Angle::degrees(x).radians() == x * pi / 180. 2. Ordering is that of the radians.
class Angle {
 public:
  constexpr Angle() = default;
  static constexpr Angle radians(double value) { return Angle(value); }
  static constexpr Angle degrees(double value) { return Angle(value * (std::numbers::pi / 180.0)); }

  [[nodiscard]] constexpr double radians() const { return radians_; }
  [[nodiscard]] constexpr double degrees() const { return radians_ * (180.0 / std::numbers::pi); }

  constexpr Angle operator-() const { return Angle(-radians_); }
  constexpr Angle& operator+=(Angle other) {
    radians_ += other.radians_;
    return *this;
  }
  constexpr Angle& operator-=(Angle other) {
    radians_ -= other.radians_;
    return *this;
  }
  friend constexpr Angle operator+(Angle a, Angle b) { return Angle(a.radians_ + b.radians_); }
  friend constexpr Angle operator-(Angle a, Angle b) { return Angle(a.radians_ - b.radians_); }
  friend constexpr Angle operator*(double s, Angle a) { return Angle(s * a.radians_); }
  friend constexpr Angle operator*(Angle a, double s) { return Angle(s * a.radians_); }
  friend constexpr Angle operator/(Angle a, double s) { return Angle(a.radians_ / s); }
  friend constexpr double operator/(Angle a, Angle b) { return a.radians_ / b.radians_; }
  friend constexpr auto operator<=>(Angle, Angle) = default;

 private:
  constexpr explicit Angle(double value) : radians_(value) {}
  double radians_ = 0.0;
};

inline double sin(Angle a) { return std::sin(a.radians()); }
inline double cos(Angle a) { return std::cos(a.radians()); }
inline double tan(Angle a) { return std::tan(a.radians()); }

/// The same direction in (-pi, pi].
inline Angle wrapped_to_half_turn(Angle a) {
  const double turns = std::remainder(a.radians(), 2.0 * std::numbers::pi);
  return Angle::radians(turns == -std::numbers::pi ? std::numbers::pi : turns);
}

}  // namespace volute::geometry

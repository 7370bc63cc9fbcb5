// The smoothest spline in both rotaries that stays allowed, from a curve that is.
#pragma once

#include <optional>
#include <vector>

#include "planner/orientation/bounded_smooth.hpp"
#include "planner/orientation/neighbours.hpp"
#include "planner/orientation/pin_loop.hpp"
#include "planner/orientation/rotary_spline.hpp"

namespace volute::planner {

/// Coefficients of both rotaries on one grid.
using Coefficients = std::array<std::vector<double>, 2>;

/// A station where the rotaries (of axes[3] and axes[4]), or one of them, have a value.
struct HeldStation {
  int station = 0;
  Rotaries value{};
  std::array<bool, 2> rotary = {true, true};
};

/// What a smoothing has to keep besides the allowed set.
struct SmoothingAims {
  std::array<std::optional<PeakLimits>, 2> peaks;  ///< of each rotary, per arc length; none: least squares alone
  std::vector<HeldStation> held;
};

class CorridorSmoother {
 public:
  explicit CorridorSmoother(const AllowedSet& allowed);

  [[nodiscard]] const SplineGrid& grid() const { return grid_; }
  /// The station next to where each coefficient acts.
  [[nodiscard]] const std::vector<int>& points() const { return points_; }
  [[nodiscard]] const std::vector<SplineGrid::Weights>& weights() const { return weights_; }
  [[nodiscard]] std::vector<Rotaries> stations_of(const Coefficients& c) const;
  /// Coefficients whose curve follows `at` and is allowed: first values at the places of the coefficients (what the
  /// differences of `at` keep, theirs keep too; the curve is off by step^2 / 6 of the second derivative), then
  /// corrected towards interpolation until it is allowed. Nothing when it never is.
  [[nodiscard]] std::optional<Coefficients> following(const std::vector<Rotaries>& at);
  /// Which stations are not allowed, or not on the way to the next.
  [[nodiscard]] std::vector<char> touching(const Coefficients& c) { return check_.touching(stations_of(c)); }

  /// The smoothest curve with its coefficients bounded round `base`; where it is not allowed the bounds draw back to
  /// `base`. Energy: velocity, acceleration and jerk per arc length, and the turn to the neighbouring passes.
  /// Nothing when the bounds did not settle in `tightenings_max` rounds. Requires: base is allowed.
  [[nodiscard]] std::optional<Coefficients> smoothed(const Coefficients& base, const SmoothingAims& aims,
                                                     int tightenings_max);

  [[nodiscard]] int iterations() const { return iterations_; }
  [[nodiscard]] double solve_s() const { return solve_s_; }

 private:
  [[nodiscard]] int nearest_station(double s_mm) const;
  [[nodiscard]] Rotaries station_of(const Coefficients& c, std::size_t i) const;
  [[nodiscard]] Coefficients sampled(const std::vector<Rotaries>& at) const;
  [[nodiscard]] std::array<Attraction, 2> alike(const Coefficients& c) const;
  [[nodiscard]] Rotaries nearest_way(const Vec3& axis_P, const Rotaries& to, const Rotaries& influence) const;
  [[nodiscard]] double allowed_share(std::size_t i, const Rotaries& base, const Rotaries& wanted) const;
  void draw_back(const std::vector<char>& bad, const Coefficients& base, const Coefficients& found, Coefficients& lower,
                 Coefficients& upper) const;
  [[nodiscard]] std::vector<HeldValue> held_values(const std::vector<HeldStation>& held, std::size_t k) const;

  const AllowedSet& allowed_;
  PathCheck check_;
  SplineGrid grid_;
  std::vector<SplineGrid::Weights> weights_;
  std::vector<int> points_;
  std::vector<Beside> beside_;  ///< of points_
  int iterations_ = 0;
  double solve_s_ = 0.0;
};

}  // namespace volute::planner

// The RBF-spline approximation of [Huang2016]: the field sampled on a parameter grid and interpolated by a cubic tensor
// B-spline.
#pragma once

#include <functional>
#include <vector>

#include "geometry/vector.hpp"

namespace volute::planner {

using geometry::Vec2;
using geometry::Vec3;

enum class KnotRule {
  averaged,  ///< Piegl and Tiller: collocation stays well conditioned (Lebesgue constant about 2)
  eq3,       ///< as [Huang2016] eq. 3 prints them: for comparison only, its condition grows without bound
};

struct FieldSplineOptions {
  int u_intervals = 30,
      v_intervals = 10;   ///< N_u, N_v: the grid has one point more in an open direction, as many in a closed one
  bool v_closed = false;  ///< half-open surface: v has period 1
  KnotRule knots = KnotRule::averaged;
};

/// Cubic in both directions over [0, 1]^2. Property: value(grid point) is the sampled value.
class FieldSpline {
 public:
  /// Requires: at least 3 intervals each way. `sample` is called at every grid point.
  FieldSpline(const std::function<Vec3(const Vec2& uv)>& sample, const FieldSplineOptions& options);

  [[nodiscard]] Vec3 value(const Vec2& uv) const;
  [[nodiscard]] const std::vector<std::vector<Vec3>>& control_points() const { return control_; }

 private:
  FieldSplineOptions options_;
  std::vector<double> u_knots_, v_knots_;
  std::vector<std::vector<Vec3>> control_;  ///< [u][v]
};

/// Non-zero cubic basis functions at t: four values, for control points first .. first + 3.
struct CubicBasis {
  int first = 0;
  double values[4] = {};
};
CubicBasis cubic_basis(const std::vector<double>& knots, double t);
/// Clamped knots for data at i / intervals.
std::vector<double> open_knots(int intervals, KnotRule rule);
/// Knots j / intervals for j = -3 .. intervals + 3.
std::vector<double> closed_knots(int intervals);

}  // namespace volute::planner

// How smooth a field is and how well it meets its keys: the indexes of [Huang2016] section 2.2.3 and sound ones beside
// them.
#pragma once

#include <functional>
#include <vector>

#include "geometry/angle.hpp"
#include "geometry/vector.hpp"

namespace volute::planner {

using geometry::Vec2;
using geometry::Vec3;

/// Field values on a grid over [0, 1]^2: values[i][j] at (i / (rows - 1), j / (columns - 1)).
using FieldGrid = std::vector<std::vector<Vec3>>;
FieldGrid sample_grid(const std::function<Vec3(const Vec2&)>& field, int rows, int columns);

/// All over the inner grid points, by central differences. Requires: at least 3 x 3.
struct SmoothnessIndexes {
  double dirichlet = 0.0;        ///< mean of (T_u^2 + T_v^2) / 2: the sound one; converges with the grid
  double s_td_derivative = 0.0;  ///< mean of (T_u + T_v)^2 / 2: eq. 9 read as derivatives; has a cross term
  double s_td_literal = 0.0;     ///< eq. 9 to the letter, multiplied by du and dv
  double s_td_sum = 0.0;  ///< sum of the squared differences / 8: the reading that comes near the source's tables
};
SmoothnessIndexes smoothness(const FieldGrid& grid);

/// I_fa of eq. 11: mean scalar product of key axes and field there, both taken as they are.
double fitting_accuracy(const std::vector<Vec3>& keys, const std::vector<Vec3>& fitted);
/// The largest angle between a key and the field there: what I_fa hides.
geometry::Angle largest_angle(const std::vector<Vec3>& keys, const std::vector<Vec3>& fitted);

}  // namespace volute::planner

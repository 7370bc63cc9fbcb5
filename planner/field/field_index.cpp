#include "planner/field/field_index.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/check.hpp"

namespace volute::planner {

FieldGrid sample_grid(const std::function<Vec3(const Vec2&)>& field, int rows, int columns) {
  VOLUTE_CHECK(rows >= 2 && columns >= 2, rows, columns);
  FieldGrid grid(static_cast<std::size_t>(rows), std::vector<Vec3>(static_cast<std::size_t>(columns)));
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j)
      grid[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] =
          field({static_cast<double>(i) / (rows - 1), static_cast<double>(j) / (columns - 1)});
  return grid;
}

SmoothnessIndexes smoothness(const FieldGrid& grid) {
  VOLUTE_CHECK(grid.size() >= 3 && grid.front().size() >= 3, grid.size());
  const std::size_t rows = grid.size(), columns = grid.front().size();
  const double du = 1.0 / static_cast<double>(rows - 1), dv = 1.0 / static_cast<double>(columns - 1);
  SmoothnessIndexes sum;
  for (std::size_t i = 1; i + 1 < rows; ++i)
    for (std::size_t j = 1; j + 1 < columns; ++j) {
      const Vec3 step_u = grid[i + 1][j] - grid[i - 1][j], step_v = grid[i][j + 1] - grid[i][j - 1];
      sum.dirichlet += ((step_u / du).squaredNorm() + (step_v / dv).squaredNorm()) / 8.0;
      sum.s_td_derivative += (step_u / du + step_v / dv).squaredNorm() / 8.0;
      sum.s_td_literal += (step_u * du + step_v * dv).squaredNorm() / 8.0;
      sum.s_td_sum += (step_u + step_v).squaredNorm() / 8.0;
    }
  const double points = static_cast<double>((rows - 2) * (columns - 2));
  return {sum.dirichlet / points, sum.s_td_derivative / points, sum.s_td_literal / points, sum.s_td_sum};
}

double fitting_accuracy(const std::vector<Vec3>& keys, const std::vector<Vec3>& fitted) {
  VOLUTE_CHECK(!keys.empty() && keys.size() == fitted.size(), keys.size(), fitted.size());
  double sum = 0.0;
  for (std::size_t i = 0; i < keys.size(); ++i) sum += keys[i].dot(fitted[i]);
  return sum / static_cast<double>(keys.size());
}

geometry::Angle largest_angle(const std::vector<Vec3>& keys, const std::vector<Vec3>& fitted) {
  VOLUTE_CHECK(keys.size() == fitted.size(), keys.size(), fitted.size());
  double largest = 0.0;
  for (std::size_t i = 0; i < keys.size(); ++i)
    largest = std::max(largest, std::atan2(keys[i].cross(fitted[i]).norm(), keys[i].dot(fitted[i])));
  return geometry::Angle::radians(largest);
}

}  // namespace volute::planner

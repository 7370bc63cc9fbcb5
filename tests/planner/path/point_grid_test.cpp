// Points in cells, against cells told from the coordinates alone.
#include <algorithm>
#include <cmath>
#include <random>
#include <tuple>

#include <gtest/gtest.h>

#include "planner/path/point_grid.hpp"
#include "tests/cases.hpp"

namespace volute::planner {
namespace {

using geometry::Index;
using geometry::Vec3;

/// What near() must visit: the points of the cells that a cube around the place meets, cell by cell, in the points'
/// order within each.
std::vector<Index> wanted(const std::vector<Vec3>& points, double cell_mm, const Vec3& place, double reach_mm) {
  const auto cell = [&](double x) { return static_cast<long>(std::floor(x / cell_mm)); };
  std::vector<std::tuple<long, long, long, Index>> found;
  for (std::size_t i = 0; i < points.size(); ++i) {
    bool met = true;
    for (int d = 0; d < 3; ++d)
      met = met && cell(points[i][d]) >= cell(place[d] - reach_mm) && cell(points[i][d]) <= cell(place[d] + reach_mm);
    if (met) found.emplace_back(cell(points[i].x()), cell(points[i].y()), cell(points[i].z()), static_cast<Index>(i));
  }
  std::sort(found.begin(), found.end());
  std::vector<Index> out;
  for (const auto& f : found) out.push_back(std::get<3>(f));
  return out;
}

// Flat clouds and tall ones: columns of one cell and of many; places inside, outside and at the rim.
TEST(PointGrid, VisitsTheCellsThatTheReachMeetsInTheirOrder) {
  constexpr unsigned seed = 41;
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  std::size_t visited = 0;
  for (int i = 0; i < cases(40); ++i) {
    const Vec3 size(5.0, 3.0, i % 2 == 0 ? 0.3 : 12.0);
    std::vector<Vec3> points(static_cast<std::size_t>(1 + i * 20));
    for (Vec3& p : points) p = size.cwiseProduct(Vec3(unit(random), unit(random), unit(random)));
    const double cell_mm = 0.2 + 0.3 * (1.0 + unit(random));
    const PointGrid grid(points, cell_mm);
    for (int k = 0; k < 30; ++k) {
      const Vec3 place = 1.2 * size.cwiseProduct(Vec3(unit(random), unit(random), unit(random)));
      const double reach_mm = 1.0 + unit(random);
      std::vector<Index> got;
      grid.near(place, reach_mm, [&](Index p) { got.push_back(p); });
      ASSERT_EQ(got, wanted(points, cell_mm, place, reach_mm)) << "seed " << seed << ", case " << i << ", place " << k;
      visited += got.size();
    }
  }
  EXPECT_GT(visited, std::size_t{1000});
}

TEST(PointGrid, NothingIsNearWhereThereAreNoPoints) {
  const PointGrid grid({}, 1.0);
  int met = 0;
  grid.near(Vec3::Zero(), 5.0, [&](Index) { ++met; });
  EXPECT_EQ(met, 0);
}

}  // namespace
}  // namespace volute::planner

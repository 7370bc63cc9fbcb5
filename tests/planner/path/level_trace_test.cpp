#include <cmath>
#include <cstdlib>
#include <map>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "planner/path/level_trace.hpp"
#include "planner/surface/periodic_coordinate.hpp"
#include "tests/cases.hpp"

namespace volute::planner {
namespace {

using geometry::MeshTopology;

TriangleMesh ring(int around, int across, double inner_mm, double outer_mm) {
  TriangleMesh mesh;
  for (int j = 0; j <= across; ++j) {
    const double radius = inner_mm + (outer_mm - inner_mm) * j / across;
    for (int i = 0; i < around; ++i) {
      const double angle = 2.0 * std::numbers::pi * (i + 0.5 * j) / around;
      mesh.vertices_mm.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.0);
    }
  }
  for (int j = 0; j < across; ++j) {
    for (int i = 0; i < around; ++i) {
      const int a = j * around + i, b = j * around + (i + 1) % around, c = a + around, d = b + around;
      mesh.triangles.push_back({a, d, b});
      mesh.triangles.push_back({a, c, d});
    }
  }
  return mesh;
}

std::vector<double> random_values(const TriangleMesh& mesh, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> value(-3.0, 3.0);
  std::vector<double> out(mesh.vertices_mm.size());
  for (double& v : out) v = value(random);
  // Values that equal a level exactly are the hard case.
  for (std::size_t i = 0; i < out.size(); i += 5) out[i] = std::round(out[i]) + 0.5;
  return out;
}

TEST(LevelTrace, EveryLineIsClosedOrEndsOnTheBoundary) {
  const TriangleMesh mesh = ring(20, 6, 4.0, 10.0);
  const auto topology = MeshTopology::build(mesh);
  for (int seed = 0; seed < cases(20); ++seed) {
    SCOPED_TRACE(seed);
    const auto values = random_values(mesh, static_cast<unsigned>(seed));
    for (const LevelLine& line : trace_levels(mesh, *topology, {values, {}}, 0.5)) {
      EXPECT_EQ(line.points.size(), line.triangles.size() + (line.closed ? 0 : 1));
      if (line.closed) continue;
      for (const SurfacePoint& end : {line.points.front(), line.points.back()}) {
        EXPECT_TRUE(topology->is_boundary_vertex(end.a) && topology->is_boundary_vertex(end.b));
      }
    }
  }
}

// Independent count: a triangle with corner cells low and high is crossed by high - low levels.
TEST(LevelTrace, EachTriangleAndLevelLiesInOneLine) {
  const TriangleMesh mesh = ring(20, 6, 4.0, 10.0);
  const auto topology = MeshTopology::build(mesh);
  for (int seed = 0; seed < cases(20); ++seed) {
    SCOPED_TRACE(seed);
    const auto values = random_values(mesh, static_cast<unsigned>(seed));
    std::map<Index, int> traced;
    for (const LevelLine& line : trace_levels(mesh, *topology, {values, {}}, 0.5)) {
      for (Index t : line.triangles) ++traced[t];
    }
    for (Index t = 0; t < static_cast<Index>(mesh.triangles.size()); ++t) {
      double low = 1e9, high = -1e9;
      for (Index v : mesh.triangles[static_cast<std::size_t>(t)]) {
        low = std::min(low, std::floor(values[static_cast<std::size_t>(v)] - 0.5));
        high = std::max(high, std::floor(values[static_cast<std::size_t>(v)] - 0.5));
      }
      EXPECT_EQ(traced[t], static_cast<int>(high - low)) << "triangle " << t;
    }
  }
}

// Closed form: phi - theta with phi = (outer - r) / pitch is an Archimedean spiral; length by integrating sqrt(r^2 +
// (dr/da)^2).
TEST(LevelTrace, SpiralOnARingIsArchimedes) {
  const double inner = 4.0, outer = 10.0, pitch = 0.8;
  const TriangleMesh mesh = ring(400, 80, inner, outer);
  const auto topology = MeshTopology::build(mesh);
  const auto& loops = topology->boundary_loops();
  const auto seam = seam_between(mesh, *topology, loops[0], loops[1]);
  ASSERT_TRUE(seam.has_value());
  const auto theta = periodic_harmonic(mesh, *topology, *seam);
  ASSERT_TRUE(theta.has_value());
  std::vector<double> winding;
  for (std::size_t v = 0; v < mesh.vertices_mm.size(); ++v) {
    winding.push_back((outer - mesh.vertices_mm[v].norm()) / pitch - theta->vertex[v]);
  }
  const auto lines = trace_levels(mesh, *topology, {winding, theta->jump}, 0.5);
  ASSERT_EQ(lines.size(), 1u) << "one arm, whatever the seam";
  EXPECT_FALSE(lines[0].closed);
  const double slope = pitch / (2.0 * std::numbers::pi);  // dr / da
  double length = 0.0;
  constexpr int steps = 20000;
  for (int i = 0; i < steps; ++i) {
    const double r = inner + (outer - inner) * (i + 0.5) / steps;
    length += (outer - inner) / steps / slope * std::hypot(r, slope);
  }
  EXPECT_NEAR(lines[0].length_mm, length, 1e-3 * length);
  // Inward, counter-clockwise: greater values on the left.
  const Vec3 start = position_mm(mesh, lines[0].points.front()), next = position_mm(mesh, lines[0].points[20]);
  EXPECT_NEAR(start.norm(), outer, 1e-2);
  EXPECT_GT(start.cross(next).z(), 0.0);
}

}  // namespace
}  // namespace volute::planner

#include <array>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <numbers>
#include <random>
#include <string>

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "geometry/mesh_measure.hpp"
#include "planner/path/even_domain.hpp"
#include "planner/path/even_field.hpp"
#include "planner/path/even_resample.hpp"
#include "planner/path/even_spiral.hpp"
#include "planner/path/path_interval.hpp"
#include "tests/planner/path/dense_scallop.hpp"
#include "tests/planner/path/sample_surfaces.hpp"

namespace volute::planner {
namespace {

using geometry::MeshTopology;

struct Hole {
  double x_mm, y_mm, radius_mm;
};

double height(double x, double y) { return 2.0 * std::sin(0.11 * x + 0.4) * std::cos(0.09 * y); }

/// A bumpy disc with round holes: a hexagonal lattice, its cells cut away where a hole or the outside is, and the
/// vertices that are left on a rim moved onto its circle.
TriangleMesh disc_with_holes(double radius_mm, const std::vector<Hole>& holes, double edge_mm) {
  TriangleMesh all;
  const int n = static_cast<int>(radius_mm / edge_mm) + 2, row = 2 * n + 1;
  for (int j = -n; j <= n; ++j) {
    for (int i = -n; i <= n; ++i) {
      all.vertices_mm.emplace_back((i + 0.5 * (j & 1)) * edge_mm, j * edge_mm * std::sqrt(0.75), 0.0);
    }
  }
  const auto inside = [&](Index v) {
    const Vec3& p = all.vertices_mm[static_cast<std::size_t>(v)];
    if (p.norm() > radius_mm) return false;
    for (const Hole& h : holes) {
      if (std::hypot(p.x() - h.x_mm, p.y() - h.y_mm) < h.radius_mm) return false;
    }
    return true;
  };
  for (int j = 0; j < 2 * n; ++j) {
    for (int i = 0; i < 2 * n; ++i) {
      const Index a = j * row + i, b = a + 1, c = a + row, d = c + 1;
      const bool odd = ((j - n) & 1) != 0;
      const std::array<geometry::Triangle, 2> cells = odd ? std::array<geometry::Triangle, 2>{{{a, b, d}, {a, d, c}}}
                                                          : std::array<geometry::Triangle, 2>{{{a, b, c}, {b, d, c}}};
      for (const auto& t : cells) {
        if (inside(t[0]) && inside(t[1]) && inside(t[2])) all.triangles.push_back(t);
      }
    }
  }
  TriangleMesh mesh = in_memory_order(all);
  const auto topology = MeshTopology::build(mesh);
  for (const auto& loop : topology->boundary_loops()) {
    for (Index v : loop.vertices) {
      Vec3& p = mesh.vertices_mm[static_cast<std::size_t>(v)];
      Hole rim{0.0, 0.0, radius_mm};
      double least = std::abs(p.norm() - radius_mm);
      for (const Hole& h : holes) {
        const double off = std::abs(std::hypot(p.x() - h.x_mm, p.y() - h.y_mm) - h.radius_mm);
        if (off < least) {
          least = off;
          rim = h;
        }
      }
      const Vec3 centre(rim.x_mm, rim.y_mm, 0.0);
      p = centre + (p - centre).normalized() * rim.radius_mm;
    }
  }
  for (Vec3& p : mesh.vertices_mm) p.z() = height(p.x(), p.y());
  return mesh;
}

kinematics::Cutter ball(double radius_mm) {
  kinematics::Cutter cutter;
  cutter.radius_mm = cutter.corner_radius_mm = radius_mm;
  return cutter;
}

CcPathResult planned(const TriangleMesh& mesh, double radius_mm, double scallop_mm) {
  PathOptions options;
  options.scallop_mm = scallop_mm;
  auto result = plan_even_spiral(mesh, ball(radius_mm), options, {});
  EXPECT_TRUE(result.has_value()) << (result ? "" : result.error().message);
  return result ? *result : CcPathResult{};
}

void expect_sound(const TriangleMesh& mesh, const CcPathResult& result, double ratio_max) {
  ASSERT_EQ(result.path.pieces.size(), 1u);
  EXPECT_EQ(result.report.pieces, 1);
  EXPECT_GE(result.report.length_ratio, 1.0);
  EXPECT_LE(result.report.length_ratio, ratio_max);
  EXPECT_LE(*result.report.scallop_ratio_p9999, 1.05);
  EXPECT_LE(*result.report.scallop_ratio_max, 1.10);
  EXPECT_LE(*result.report.scallop_area_above_percent, 0.15);
  EXPECT_LE(samples::greatest_scallop_ratio(mesh, result.path, 3.0, 0.2, 1500, 7), 1.10);
  // One piece: neighbouring points share a triangle, so no step is longer than the longest edge (edge curves bulge by
  // far less).
  double longest_mm = 0.0;
  for (const auto& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto a = static_cast<std::size_t>(t[k]), b = static_cast<std::size_t>(t[(k + 1) % 3]);
      longest_mm = std::max(longest_mm, (mesh.vertices_mm[a] - mesh.vertices_mm[b]).norm());
    }
  }
  const auto& points = result.path.pieces[0].points;
  for (std::size_t i = 1; i < points.size(); ++i) {
    ASSERT_LT((points[i].point_P_mm - points[i - 1].point_P_mm).norm(), 1.02 * longest_mm) << "point " << i;
  }
}

TEST(EvenSpiral, HoldsTheScallopWithAConcentricHole) {
  const TriangleMesh mesh = disc_with_holes(30.0, {{0.0, 0.0, 9.0}}, 1.2);
  expect_sound(mesh, planned(mesh, 3.0, 0.2), 1.2);
}

TEST(EvenSpiral, HoldsTheScallopAroundTwoHoles) {
  const TriangleMesh mesh = disc_with_holes(32.0, {{-13.0, 4.0, 5.0}, {12.0, -7.0, 6.0}}, 1.2);
  expect_sound(mesh, planned(mesh, 3.0, 0.2), 1.5);
}

TEST(EvenSpiral, EndsInASlitWhereThereIsNoHole) {
  const TriangleMesh mesh = disc_with_holes(25.0, {}, 1.2);
  const CcPathResult result = planned(mesh, 3.0, 0.2);
  expect_sound(mesh, result, 1.25);
  EXPECT_FALSE(result.map.bridges_P.empty());
  EXPECT_GT(result.map.guide_lines.size(), 5u);  // one a turn: 25 mm over intervals of 2.2 mm, in from both sides
}

TEST(EvenSpiral, BendsSharplyWhereRoundBendsTakeALongPath) {
  samples::PlateOptions plate;
  plate.width_mm = 30.0;
  plate.depth_mm = 18.0;
  plate.columns = 20;
  plate.rows = 12;
  TriangleMesh mesh = samples::plate(plate);
  for (Vec3& p : mesh.vertices_mm) p.y() *= 0.55 - 0.03 * p.x();  // from 18 to 2 mm
  const CcPathResult result = planned(mesh, 3.0, 0.2);
  ASSERT_EQ(result.path.pieces.size(), 1u);
  EXPECT_LE(*result.report.scallop_ratio_p9999, 1.05);
  ASSERT_EQ(result.report.notes.size(), 1u);
  EXPECT_NE(result.report.notes[0].find("passes bend sharply"), std::string::npos) << result.report.notes[0];
}

TEST(EvenSpiral, SameBytesOnOneAndTwoThreads) {
  const TriangleMesh mesh = disc_with_holes(24.0, {{8.0, 3.0, 5.0}}, 1.4);
  std::vector<CcPathResult> results;
  for (std::size_t threads : {1u, 2u}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    results.push_back(planned(mesh, 3.0, 0.2));
  }
  const auto &a = results[0].path.pieces.at(0).points, &b = results[1].path.pieces.at(0).points;
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(std::memcmp(a[i].point_P_mm.data(), b[i].point_P_mm.data(), 3 * sizeof(double)), 0) << "point " << i;
  }
}

TEST(EvenSpiral, NamesACentreLoopThatIsNotThere) {
  const TriangleMesh mesh = disc_with_holes(20.0, {{0.0, 0.0, 6.0}}, 1.6);
  PathOptions options;
  options.scallop_mm = 0.2;
  options.centre_loop = 4;
  const auto result = plan_even_spiral(mesh, ball(3.0), options, {});
  ASSERT_FALSE(result.has_value());
  EXPECT_EQ(result.error().code, "path-centre-loop");
}

// On a ring the harmonic map is log(r) whatever the mesh; the gathered theta still grows by one around any loop.
TEST(EvenDomain, HarmonicAndThetaOnARing) {
  TriangleMesh mesh = disc_with_holes(30.0, {{0.0, 0.0, 9.0}}, 1.2);
  for (Vec3& p : mesh.vertices_mm) p.z() = 0.0;
  const auto surface = EvenSurface::build(mesh);
  ASSERT_TRUE(surface.has_value());
  for (double ramp_share : {1.0, 0.3}) {
    const auto domain = even_domain(*surface, Centre{Index{1}, {}}, ramp_share);
    ASSERT_TRUE(domain.has_value());
    for (std::size_t v = 0; v < domain->harmonic.size(); ++v) {
      const double r = domain->mesh.vertices_mm[v].norm();
      EXPECT_NEAR(domain->harmonic[v], std::log(30.0 / r) / std::log(30.0 / 9.0), 0.01);
    }
    for (const auto* loop : {&domain->outer, &domain->centre}) {
      double grown = 0.0;
      for (std::size_t i = 0; i < loop->vertices.size(); ++i) {
        const Index a = loop->vertices[i], b = loop->vertices[(i + 1) % loop->vertices.size()];
        grown += std::remainder(
            domain->theta.vertex[static_cast<std::size_t>(b)] - domain->theta.vertex[static_cast<std::size_t>(a)], 1.0);
      }
      EXPECT_NEAR(grown, loop == &domain->outer ? 1.0 : -1.0, 1e-9);  // the hole's loop runs clockwise
    }
  }
}

/// What bending costs: the mean square of the Laplacian of phi - theta over the inner vertices, 1 / mm^4.
double bending(const EvenDomain& domain, const std::vector<Vec2>& slopes) {
  const auto flux = divergence(domain.mesh, domain.operators, slopes);
  const auto areas = vertex_areas_mm2(domain.mesh);
  double sum = 0.0, area_mm2 = 0.0;
  for (std::size_t v = 0; v < areas.size(); ++v) {
    if (domain.topology.is_boundary_vertex(static_cast<Index>(v))) continue;
    sum += flux[v] * flux[v] / areas[v];
    area_mm2 += areas[v];
  }
  return sum / area_mm2;
}

// Dearer bending bends less; a gain of 1 everywhere is the solver as it was, to the last bit.
TEST(EvenField, StiffeningLowersTheBending) {
  const auto surface = EvenSurface::build(disc_with_holes(24.0, {{-9.0, 3.0, 4.0}, {8.0, -5.0, 4.0}}, 1.2));
  ASSERT_TRUE(surface.has_value());
  const auto domain = even_domain(*surface, Centre{Index{1}, {}});
  ASSERT_TRUE(domain.has_value());
  const IntervalRule rule = interval_rule(ball(3.0), 0.2, {});
  const std::vector<double> gain(domain->mesh.triangles.size(), 1.0);
  std::vector<EvenField> fields;
  std::vector<double> bent;
  for (double stiff : {0.0, 1.0, 64.0}) {  // 0: not called
    auto solver = EvenFieldSolver::build(*domain, rule, {}, std::nullopt);
    ASSERT_TRUE(solver.has_value());
    if (stiff > 0.0) {
      ASSERT_TRUE(solver->stiffen(std::vector<double>(domain->mesh.vertices_mm.size(), stiff)).has_value());
    }
    fields.push_back(solver->start());
    solver->improve(fields.back(), gain, 4, 20);
    bent.push_back(bending(*domain, solver->slopes(fields.back())));
  }
  EXPECT_EQ(fields[0].phi, fields[1].phi);
  EXPECT_LT(bent[2], 0.5 * bent[0]);
}

/// A flat square ring about the origin: rays of a round ring stretched onto squares.
TriangleMesh square_ring(double inner_mm, double outer_mm, int around, int across) {
  TriangleMesh mesh = samples::ring(inner_mm, outer_mm, around, across);
  for (Vec3& p : mesh.vertices_mm) p *= p.norm() / std::max(std::abs(p.x()), std::abs(p.y()));
  return mesh;
}

/// Path length that the field asks for over the least: the mean of |grad| times the interval, where the plane is flat.
double mean_slope_ratio(const EvenDomain& domain, const std::vector<Vec2>& slopes, double interval_mm) {
  double sum = 0.0, area_mm2 = 0.0;
  for (std::size_t t = 0; t < slopes.size(); ++t) {
    sum += domain.operators[t].area_mm2 * slopes[t].norm() * interval_mm;
    area_mm2 += domain.operators[t].area_mm2;
  }
  return sum / area_mm2;
}

// What factor() gives before levels and theta are settled serves after, to the last bit.
TEST(EvenField, AFactorHadBeforeTheLevelsGivesTheSameField) {
  const auto surface = EvenSurface::build(disc_with_holes(24.0, {{-9.0, 3.0, 4.0}, {8.0, -5.0, 4.0}}, 1.2));
  ASSERT_TRUE(surface.has_value());
  auto domain = even_domain(*surface, Centre{Index{1}, {}});
  ASSERT_TRUE(domain.has_value());
  ASSERT_EQ(domain->floating.size(), 1U);
  const IntervalRule rule = interval_rule(ball(3.0), 0.2, {});
  auto ready = EvenFieldSolver::factor(*domain, rule, {});
  ASSERT_TRUE(ready.has_value());
  for (double& theta : domain->theta.vertex) theta += 0.3;
  const HeldLevels levels{{2.0}, {}};
  const std::vector<double> gain(domain->mesh.triangles.size(), 1.0);
  std::vector<EvenField> fields;
  for (const bool had : {false, true}) {
    const auto solver = EvenFieldSolver::build(*domain, rule, {}, levels,
                                               had ? std::optional<SparseSolver>(std::move(*ready)) : std::nullopt);
    ASSERT_TRUE(solver.has_value());
    fields.push_back(solver->start());
    solver->improve(fields.back(), gain, 2, 10);
  }
  EXPECT_EQ(fields[0].phi, fields[1].phi);
  EXPECT_EQ(fields[0].turns, fields[1].turns);
}

TEST(EvenField, CreasesLetPassesTurnCornersAtTheSameDistance) {
  const auto surface = EvenSurface::build(square_ring(4.0, 20.0, 160, 24));
  ASSERT_TRUE(surface.has_value());
  const auto domain = even_domain(*surface, Centre{Index{1}, {}});
  ASSERT_TRUE(domain.has_value());
  const IntervalRule rule = interval_rule(ball(3.0), 0.2, {});
  const std::vector<double> gain(domain->mesh.triangles.size(), 1.0);
  std::array<double, 2> ratio{};
  for (const bool creases : {false, true}) {
    const EvenFieldOptions options{.bend = 0.01, .creases = creases};
    const auto solver = EvenFieldSolver::build(*domain, rule, options, std::nullopt);
    ASSERT_TRUE(solver.has_value());
    EvenField field = solver->start();
    solver->improve(field, gain, 10, 25);
    ratio[creases ? 1 : 0] = mean_slope_ratio(*domain, solver->slopes(field), rule.interval_mm(0.0));
  }
  // Nested squares have 1; arcs around the corners, an interval apart on the diagonals, far more.
  EXPECT_GT(ratio[0], 1.05);
  EXPECT_NEAR(ratio[1], 1.0, 0.02);
}

TEST(EvenResample, CoarserKeepsTopologyAndVertices) {
  const TriangleMesh mesh = disc_with_holes(30.0, {{-10.0, 4.0, 5.0}, {12.0, -7.0, 6.0}}, 1.0);
  const CoarseMesh coarse = coarser(mesh, 3.0, 0.3);
  const auto before = MeshTopology::build(mesh), after = MeshTopology::build(coarse.mesh);
  ASSERT_TRUE(after.has_value());
  EXPECT_LT(coarse.mesh.triangles.size(), mesh.triangles.size() / 3);
  EXPECT_EQ(after->boundary_loops().size(), before->boundary_loops().size());
  EXPECT_EQ(after->components().size(), 1u);
  EXPECT_EQ(after->components()[0].handles, 0);
  for (std::size_t v = 0; v < coarse.original.size(); ++v) {
    EXPECT_EQ(coarse.mesh.vertices_mm[v], mesh.vertices_mm[static_cast<std::size_t>(coarse.original[v])]);
  }
  EXPECT_NEAR(geometry::area_mm2(coarse.mesh), geometry::area_mm2(mesh), 0.02 * geometry::area_mm2(mesh));
}

TEST(EvenResample, FinerKeepsTheSurface) {
  const TriangleMesh mesh = disc_with_holes(15.0, {{2.0, 1.0, 4.0}}, 2.0);
  const auto fine = finer(mesh, 0.9);
  ASSERT_TRUE(fine.has_value());
  const auto topology = MeshTopology::build(fine->mesh);
  ASSERT_TRUE(topology.has_value());
  EXPECT_EQ(topology->boundary_loops().size(), 2u);
  EXPECT_NEAR(geometry::area_mm2(fine->mesh), geometry::area_mm2(mesh), 1e-9 * geometry::area_mm2(mesh));
  for (const auto& t : fine->mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 edge = fine->mesh.vertices_mm[static_cast<std::size_t>(t[(k + 1) % 3])] -
                        fine->mesh.vertices_mm[static_cast<std::size_t>(t[k])];
      EXPECT_LE(edge.norm(), 0.9);
    }
  }
}

}  // namespace
}  // namespace volute::planner

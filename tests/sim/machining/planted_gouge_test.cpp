// Five micrometres too deep at a random place of a random surface: found with its line and depth, and nothing without
// it.
#include <gtest/gtest.h>

#include "shapes.hpp"
#include "sim/machining/cutter_profile.hpp"

namespace volute::sim {
namespace {

using geometry::Vec3;
using test::ball_at;

constexpr double deep_mm = 0.005;
constexpr double limit_mm = 0.0045;

/// The environment's VOLUTE_SEED: other cases of the same kind.
int seed_or(int usual) {
  const char* text = std::getenv("VOLUTE_SEED");
  const auto asked = text != nullptr ? geometry::parse_integer(text) : std::nullopt;
  return asked ? static_cast<int>(*asked) : usual;
}

/// z = f(x, y) over [0, side]^2 as a fine mesh, curved gently enough for the cutter.
struct Wave {
  double side = 4.0, bend_x = 0.0, bend_y = 0.0, height = 0.0, length = 5.0;
  [[nodiscard]] Vec3 at(double x, double y) const {
    return {x, y, bend_x * x * x + bend_y * y * y + height * std::sin(x / length) * std::cos(1.3 * y / length)};
  }
  [[nodiscard]] Vec3 normal(double x, double y) const {
    const double sx = 2 * bend_x * x + height / length * std::cos(x / length) * std::cos(1.3 * y / length);
    const double sy = 2 * bend_y * y - 1.3 * height / length * std::sin(x / length) * std::sin(1.3 * y / length);
    return Vec3(-sx, -sy, 1.0).normalized();
  }
};

Wave random_wave(std::mt19937_64& random) {
  std::uniform_real_distribution<> uniform(-1.0, 1.0);
  Wave w;
  w.bend_x = 0.04 * uniform(random);  // 1 / (2 R): R from 12.5 mm, hollow or raised, saddles too
  w.bend_y = 0.04 * uniform(random);
  w.height = 0.3 * uniform(random);
  return w;
}

/// Passes along y in steps that follow the surface to a tenth of a micrometre, the ball on it everywhere.
std::vector<SweptPose> passes(const Wave& w, double radius, double interval, const Vec3& axis) {
  std::vector<SweptPose> poses;
  std::int64_t line = 1;
  bool back = false;
  for (double x = -interval; x < w.side + 1.5 * interval; x += interval, back = !back) {
    for (int k = -16; k <= 96; ++k) {  // far enough out that the links between passes, straight ones, are no gouges
      const double y = w.side * (back ? 80 - k : k) / 80.0;
      poses.push_back(ball_at(w.at(x, y) + radius * w.normal(x, y), axis, radius, line++));
    }
  }
  return poses;
}

/// A pose far above, at the plant, and far above again, all with one line.
void plant(std::vector<SweptPose>& poses, const Vec3& tip, const Vec3& axis, std::int64_t line) {
  const Vec3 above = tip + 40.0 * axis;
  poses.push_back({{Vec3(poses.back().pose.tip_P_mm + 40.0 * axis), axis}, line, 1.0, false});
  poses.push_back({{above, axis}, line, 2.0, false});
  poses.push_back({{tip, axis}, line, 3.0, false});
  poses.push_back({{above, axis}, line, 4.0, false});
}

TEST(PlantedGouge, OfABallIsFoundAnywhereOnCurvedSurfacesAndNoneWithoutIt) {
  const int count = cases(8);
  const int seed = seed_or(31);
  std::mt19937_64 random(static_cast<std::uint64_t>(seed));
  std::uniform_real_distribution<> uniform(0.0, 1.0);
  double worst = 0.0;
  for (int i = 0; i < count; ++i) {
    const double radius = 2.0 + 2.0 * uniform(random), tilt = 0.5 * uniform(random), around = 6.28 * uniform(random);
    const Vec3 axis(std::sin(tilt) * std::cos(around), std::sin(tilt) * std::sin(around), std::cos(tilt));
    const Wave w = random_wave(random);
    // Facets of 0.05 mm stand off a radius of 12 mm by less than a tenth of a micrometre.
    const auto surface = test::sheet(80, 80, [&](double u, double v) { return w.at(w.side * u, w.side * v); });
    auto poses = passes(w, radius, 0.9, axis);
    const CutSurfaceOptions options{.uncut_limit_mm = 0.2, .gouge_limit_mm = limit_mm};
    const auto clean = measure_cut_surface(surface, test::ball(radius), poses, options);
    ASSERT_TRUE(clean.findings.empty()) << "seed " << seed << ", case " << i << ": " << clean.findings[0].text;
    const double x = w.side * uniform(random), y = w.side * uniform(random);  // edges and corners included
    plant(poses, w.at(x, y) + (radius - deep_mm) * w.normal(x, y) - radius * axis, axis, 7777777);
    const auto report = measure_cut_surface(surface, test::ball(radius), poses, options);
    ASSERT_EQ(report.findings.size(), 1u) << "seed " << seed << ", case " << i;
    EXPECT_EQ(report.findings[0].kind, "gouge");
    EXPECT_EQ(report.findings[0].line, 7777777);
    worst = std::max(worst, std::abs(report.gouge_max_mm - deep_mm));
    EXPECT_NEAR(report.gouge_max_mm, deep_mm, 3e-4) << "seed " << seed << ", case " << i;
  }
  RecordProperty("greatest_error_of_depth_nm", static_cast<int>(1e6 * worst));
}

/// The rim of a tilted flat end, or a small corner radius, dips in: a crescent down to hundredths of a millimetre wide.
TEST(PlantedGouge, OfASharpTiltedEndIsFoundAnywhereAndNoneWithoutIt) {
  const int count = cases(8);
  const int seed = seed_or(32);
  std::mt19937_64 random(static_cast<std::uint64_t>(seed));
  std::uniform_real_distribution<> uniform(0.0, 1.0);
  for (int i = 0; i < count; ++i) {
    const double radius = 3.0 + 3.0 * uniform(random), tilt = 0.05 + 0.7 * uniform(random), side = 8.0;
    const auto cutter = i % 2 == 0 ? test::flat(radius) : test::bull(radius, 0.3);
    const double around = 6.28 * uniform(random), corner = cutter.corner_radius_mm;
    const Vec3 flat_way(std::cos(around), std::sin(around), 0.0);
    const Vec3 axis = std::sin(tilt) * flat_way + std::cos(tilt) * Vec3::UnitZ();
    // The tip that puts the cutter's lowest point on a spot of the plane, `deep` below it.
    const auto tip_at = [&](double x, double y, double deep) {
      const Vec3 rim = (flat_way - axis.dot(flat_way) * axis).normalized();
      const Vec3 lowest = (radius - corner) * rim + corner * axis - corner * Vec3::UnitZ();
      return Vec3(Vec3(x, y, -deep) - lowest);
    };
    const auto surface = test::plane(side, 1 + i % 7);
    std::vector<SweptPose> poses;
    std::int64_t line = 1;
    for (double y = -0.5; y < side + 0.5; y += 0.5) {
      for (const double x : {-3.0, side + 3.0}) poses.push_back({{tip_at(x, y, 0.0), axis}, line++, 0.0, false});
      poses.push_back({{Vec3(poses.back().pose.tip_P_mm + 40.0 * axis), axis}, line++, 0.0, false});
      poses.push_back({{Vec3(tip_at(-3.0, y + 0.5, 0.0) + 40.0 * axis), axis}, line++, 0.0, false});
    }
    const CutSurfaceOptions options{.uncut_limit_mm = 0.2, .gouge_limit_mm = limit_mm};
    const auto clean = measure_cut_surface(surface, cutter, poses, options);
    for (const auto& f : clean.findings)
      ASSERT_NE(f.kind, "gouge") << "seed " << seed << ", case " << i << ": " << f.text;
    plant(poses, tip_at(side * uniform(random), side * uniform(random), deep_mm), axis, 7777777);
    const auto report = measure_cut_surface(surface, cutter, poses, options);
    ASSERT_FALSE(report.findings.empty()) << "seed " << seed << ", case " << i;
    EXPECT_EQ(report.findings[0].kind, "gouge");
    EXPECT_EQ(report.findings[0].line, 7777777);
    EXPECT_NEAR(report.gouge_max_mm, deep_mm, 1e-5) << "seed " << seed << ", case " << i << ", tilt " << tilt;
  }
}

/// How deep a standing cutter reaches below a triangle at least, by points that close in: shares nothing with the
/// search. Never more than the true depth; up to a few per cent less, where a narrow ridge runs between the points.
double deepest_by_points(const CutterProfile& profile, const StandingCutter& stand, const geometry::TriangleMesh& mesh,
                         const geometry::Triangle& triangle, const Vec3& about) {
  const auto v = [&](std::size_t k) { return mesh.vertices_mm[static_cast<std::size_t>(triangle[k])]; };
  const Vec3 normal = (v(1) - v(0)).cross(v(2) - v(0)).normalized();
  if ((v(0) - about).norm() > 1.0) return 0.0;
  // The depth is a ridge many times longer than wide: the best point may lie far along it from the best of a grid, so
  // that the grid closes in by halves only.
  constexpr int levels = 18, first_steps = 60, steps = 24;
  double deepest = 0.0, u0 = 0.0, w0 = 0.0, size = 1.0;
  for (int level = 0; level < levels; ++level, size *= 0.5) {
    const double around_u = u0, around_w = w0;
    const int count = level == 0 ? first_steps : steps;
    for (int i = 0; i <= count; ++i) {
      for (int j = 0; j <= count; ++j) {
        const double a = static_cast<double>(i) / count, b = static_cast<double>(j) / count;
        const double u = level == 0 ? a : around_u + size * (2.0 * a - 1.0),
                     w = level == 0 ? b : around_w + size * (2.0 * b - 1.0);
        if (u < 0 || w < 0 || u + w > 1) continue;
        const auto t = line_entry_mm(profile, stand, v(0) + u * (v(1) - v(0)) + w * (v(2) - v(0)), normal, 0.0);
        if (!t || -*t <= deepest) continue;
        deepest = -*t;
        u0 = u;
        w0 = w;
      }
    }
    if (deepest == 0.0) return 0.0;
  }
  return deepest;
}

enum class Plant { anywhere, on_an_edge, at_a_vertex };

/// A flat end planted 0.02 mm deep into a dome of facets 0.5 mm wide whose normals differ by 0.7 degrees: the share of
/// the depth that the measure misses. Brute force over all facets is a depth that is there; and as the facets are
/// chords of the dome, none is deeper below them than the rim below the dome.
double share_missed(std::mt19937_64& random, Plant where) {
  std::uniform_real_distribution<> uniform(0.0, 1.0);
  const double R = 40.0, radius = 4.0, tilt = 0.1 + 0.4 * uniform(random), around = 6.28 * uniform(random);
  const auto dome = [&](double u, double w) {
    const double x = 12 * (u - 0.5), y = 12 * (w - 0.5);
    return Vec3(x, y, std::sqrt(R * R - x * x - y * y) - R);
  };
  constexpr int cuts = 24;
  const auto surface = test::sheet(cuts, cuts, dome);
  double u = 0.3 + 0.4 * uniform(random), w = 0.3 + 0.4 * uniform(random);
  const auto on_grid = [](double share) { return std::round(cuts * share) / cuts; };
  if (where != Plant::anywhere) u = on_grid(u);
  if (where == Plant::at_a_vertex) w = on_grid(w);
  const Vec3 spot = dome(u, w);
  const Vec3 normal = (spot + Vec3(0, 0, R)).normalized();
  const Vec3 way = Eigen::AngleAxisd(around, normal) * normal.unitOrthogonal();
  const Vec3 axis = std::cos(tilt) * normal + std::sin(tilt) * way;
  const Vec3 rim = (way - axis.dot(way) * axis).normalized();
  constexpr double planted_mm = 0.02;
  const Vec3 tip = spot - planted_mm * normal - radius * rim;
  std::vector<SweptPose> poses{{{Vec3(tip + 40.0 * axis), axis}, 1, 0.0, false}};
  plant(poses, tip, axis, 5);
  const auto cutter = test::flat(radius);
  const auto report = measure_cut_surface(surface, cutter, poses, {.uncut_limit_mm = 0.2, .gouge_limit_mm = limit_mm});
  double expected = 0.0;
  for (const auto& t : surface.triangles)
    expected = std::max(expected, deepest_by_points(CutterProfile(cutter), {tip, axis}, surface, t, spot));
  EXPECT_GT(expected, 0.01);
  EXPECT_LT(report.gouge_max_mm, 1.001 * planted_mm);
  EXPECT_GT(report.gouge_max_mm, 0.999 * expected);
  return (expected - report.gouge_max_mm) / expected;
}

// On facets the deepest point lies mostly where the foot of the cutter's own deepest falls beside each triangle.
TEST(PlantedGouge, OfASharpEndOnFacetsIsReadToAFraction) {
  const int seed = seed_or(33), count = cases(4);
  std::mt19937_64 random(static_cast<std::uint64_t>(seed));
  double worst = 0.0;
  for (int i = 0; i < count; ++i) {
    SCOPED_TRACE("seed " + std::to_string(seed) + ", case " + std::to_string(i));
    worst = std::max(worst, share_missed(random, Plant::anywhere));
  }
  RecordProperty("greatest_share_missed_permille", static_cast<int>(1000 * worst));
}

TEST(PlantedGouge, OfASharpEndOnAnEdgeOrVertexOfFacetsIsReadToAFraction) {
  const int seed = seed_or(34), count = cases(4);
  std::mt19937_64 random(static_cast<std::uint64_t>(seed));
  double worst = 0.0;
  for (int i = 0; i < count; ++i) {
    SCOPED_TRACE("seed " + std::to_string(seed) + ", case " + std::to_string(i));
    worst = std::max(worst, share_missed(random, i % 2 == 0 ? Plant::on_an_edge : Plant::at_a_vertex));
  }
  RecordProperty("greatest_share_missed_permille", static_cast<int>(1000 * worst));
}

}  // namespace
}  // namespace volute::sim

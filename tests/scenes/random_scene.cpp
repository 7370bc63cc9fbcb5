#include "tests/scenes/random_scene.hpp"

#include <cmath>
#include <cstdint>
#include <numbers>

#include "tests/planner/scenes.hpp"

namespace volute::scenes {

using geometry::TriangleMesh;
using geometry::Vec3;

namespace {

constexpr double half_x_mm = 20.0, half_y_mm = 14.0;

/// SplitMix64: the same numbers with every standard library.
class Random {
 public:
  explicit Random(unsigned seed) : state_(0x9E3779B97F4A7C15ull * (seed + 1)) {}
  double between(double least, double most) {
    state_ += 0x9E3779B97F4A7C15ull;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
    return least + (most - least) * (static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1.0p-53);
  }
  int one_of(int count) { return static_cast<int>(between(0.0, count)); }

 private:
  std::uint64_t state_;
};

/// A closed body of revolution along `axis` from `base`: rings of radius r at height z.
TriangleMesh revolved(const Vec3& base, const Vec3& axis, const std::vector<std::pair<double, double>>& z_and_r) {
  constexpr geometry::Index sides = 24;
  const Vec3 u = axis.unitOrthogonal(), v = axis.cross(u);
  TriangleMesh mesh;
  for (const auto& [z, r] : z_and_r) {
    for (geometry::Index k = 0; k < sides; ++k) {
      const double a = 2.0 * std::numbers::pi * k / sides;
      mesh.vertices_mm.push_back(base + z * axis + r * (std::cos(a) * u + std::sin(a) * v));
    }
  }
  const auto rings = static_cast<geometry::Index>(z_and_r.size());
  for (geometry::Index ring = 0; ring + 1 < rings; ++ring) {
    for (geometry::Index k = 0; k < sides; ++k) {
      const geometry::Index next = (k + 1) % sides, a = ring * sides, b = a + sides;
      mesh.triangles.push_back({a + k, a + next, b + next});
      mesh.triangles.push_back({a + k, b + next, b + k});
    }
  }
  const auto centres = static_cast<geometry::Index>(mesh.vertices_mm.size());
  mesh.vertices_mm.push_back(base + z_and_r.front().first * axis);
  mesh.vertices_mm.push_back(base + z_and_r.back().first * axis);
  for (geometry::Index k = 0; k < sides; ++k) {
    const geometry::Index next = (k + 1) % sides, top = (rings - 1) * sides;
    mesh.triangles.push_back({centres, next, k});
    mesh.triangles.push_back({centres + 1, top + k, top + next});
  }
  return mesh;
}

struct Place {
  Vec3 edge, outward;
};

/// Somewhere on the plate's edge.
Place place_on_edge(Random& random) {
  const double t = random.between(-0.9, 0.9);
  switch (random.one_of(4)) {
    case 0:
      return {Vec3(half_x_mm, t * half_y_mm, 0), Vec3::UnitX()};
    case 1:
      return {Vec3(-half_x_mm, t * half_y_mm, 0), -Vec3::UnitX()};
    case 2:
      return {Vec3(t * half_x_mm, half_y_mm, 0), Vec3::UnitY()};
    default:
      return {Vec3(t * half_x_mm, -half_y_mm, 0), -Vec3::UnitY()};
  }
}

TriangleMesh obstacle(Random& random, std::string& name) {
  const Place place = place_on_edge(random);
  const double away = random.between(3.0, 12.0), radius = random.between(2.0, 7.0), height = random.between(8.0, 80.0);
  const Vec3 foot = place.edge + (away + radius) * place.outward - 10.0 * Vec3::UnitZ();
  switch (random.one_of(4)) {
    case 0:
      name = "post";
      return revolved(foot, Vec3::UnitZ(), {{0.0, radius}, {height, radius}});
    case 1: {
      name = "box";
      const double wide = random.between(2.0, 15.0);
      const Vec3 along = Vec3::UnitZ().cross(place.outward);
      const Vec3 half = radius * place.outward.cwiseAbs() + wide * along.cwiseAbs();
      return planner::testing::box(foot - half, foot + half + height * Vec3::UnitZ());
    }
    case 2: {
      name = "sphere";
      std::vector<std::pair<double, double>> rings;
      for (int k = 1; k < 12; ++k) {
        const double a = std::numbers::pi * k / 12.0;
        rings.emplace_back(-radius * std::cos(a), radius * std::sin(a));
      }
      return revolved(foot + (10.0 + random.between(0.0, 30.0)) * Vec3::UnitZ(), Vec3::UnitZ(), rings);
    }
    default: {
      name = "leaning cylinder";
      const Vec3 lean = (random.between(-0.35, 0.2) * -place.outward +
                         random.between(-0.3, 0.3) * Vec3::UnitZ().cross(place.outward) + Vec3::UnitZ())
                            .normalized();
      return revolved(foot, lean, {{0.0, radius}, {height, radius}});
    }
  }
}

}  // namespace

RandomScene random_scene(unsigned seed) {
  Random random(seed);
  RandomScene scene;
  scene.seed = seed;
  const double wave = random.between(0.5, 3.0), phase = random.between(0.0, 6.0), slant = random.between(-0.1, 0.1);
  scene.plate = planner::testing::sheet(-half_x_mm, half_x_mm, -half_y_mm, half_y_mm, 1.25, [&](double x, double y) {
    return wave * std::sin(0.11 * x + phase) * std::cos(0.13 * y) + slant * y;
  });
  const int count = 1 + random.one_of(5);
  for (int k = 0; k < count; ++k) {
    std::string name;
    scene.obstacles.push_back(obstacle(random, name));
    scene.names.push_back(name + " " + std::to_string(k + 1));
  }
  return scene;
}

planner::PlanRequest plan_request(const RandomScene& scene, const kinematics::Machine& machine,
                                  planner::Smoothing smoothing) {
  planner::PlanRequest request;
  request.surface = scene.plate;
  request.tool = planner::testing::ball_tool();
  request.tool.cutter.length_mm = 12.0;
  request.tool.shank_radius_mm = 2.8;
  request.tool.holder = {{8.0, 12.0, 40.0, 20.0}, {16.0, 20.0, 60.0, 30.0}};
  request.tool.gauge_length_mm = 100.0;
  request.scene.part = scene.plate;
  request.scene.obstacles = scene.obstacles;
  request.scene.names = scene.names;
  request.path.scallop_mm = 0.3;
  request.orientation.smoothing = smoothing;
  request.process.feed_mm_s = 10.0;
  request.machine = machine;
  return request;
}

}  // namespace volute::scenes

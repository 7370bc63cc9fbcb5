// Checks a second and core beside the plain pairwise use of FCL: every piece of the tool against every body by
// collide().
//
// Scene: a wavy plate of 200 x 200 mm in 51,200 or 500,000 triangles with two posts; 2,000 poses with the ball from
// 0.5 mm in the part to 10 mm above it, tilted up to 50 degrees. Both sides decide the same poses; Agreement tells how
// many verdicts differ.
#include <benchmark/benchmark.h>

#include <cmath>
#include <map>
#include <memory>
#include <random>

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/narrowphase/collision.h>

#include "geometry/turn.hpp"
#include "planner/interference.hpp"
#include "planner/interference_shapes.hpp"
#include "tests/planner/scenes.hpp"

namespace volute::planner {
namespace {

using geometry::Vec3;
using kinematics::ToolPose;

double height(double x, double y) { return 6.0 * std::sin(0.05 * x) * std::cos(0.06 * y); }

struct Case {
  Scene scene;
  kinematics::Tool tool;
  std::vector<ToolPose> poses;
  std::unique_ptr<Interference> checks;
};

const Case& wavy_plate(int cells) {
  static std::map<int, Case> cases;
  if (const auto found = cases.find(cells); found != cases.end()) return found->second;
  Case& made = cases[cells];
  made.scene.part = testing::sheet(-100, 100, -100, 100, 200.0 / cells, height);
  made.scene.obstacles = {testing::box(Vec3(-70, -20, -10), Vec3(-60, 20, 60)),
                          testing::box(Vec3(50, 60, -10), Vec3(70, 80, 50))};
  made.tool.cutter = {kinematics::CutterShape::ball, 5.0, 5.0, {}, 20.0, 2};
  made.tool.shank_radius_mm = 5.0;
  made.tool.stick_out_mm = 50.0;
  made.tool.holder = {{20.0, 25.0, 50.0, 40.0}, {25.0, 25.0, 90.0, 60.0}};
  std::mt19937 random(4);
  std::uniform_real_distribution<double> any(0.0, 1.0);
  for (int n = 0; n < 2000; ++n) {
    const double x = 180.0 * any(random) - 90.0, y = 180.0 * any(random) - 90.0, tilt = 0.87 * any(random),
                 turn = 6.28 * any(random);
    made.poses.push_back({Vec3(x, y, height(x, y) - 0.5 + 10.5 * any(random)),
                          Vec3(std::sin(tilt) * std::cos(turn), std::sin(tilt) * std::sin(turn), std::cos(tilt))});
  }
  made.checks = std::make_unique<Interference>(made.scene, made.tool, nullptr, nullptr);
  return made;
}

/// What anybody would write with FCL's documentation open.
template <class BoundingVolume>
class PlainPairs {
 public:
  using Model = fcl::BVHModel<BoundingVolume>;

  explicit PlainPairs(const Case& from) {
    add(from.scene.part);
    for (const auto& mesh : from.scene.obstacles) add(mesh);
    for (const ToolPiece& piece : tool_pieces(from.tool)) {
      const bool cuts = piece.part == "cutter";
      pieces_.push_back({placed_shape(piece, cuts ? -from.scene.gouge_tolerance_mm : from.scene.clearance_mm),
                         placed_shape(piece, from.scene.clearance_mm)});
    }
  }

  [[nodiscard]] bool is_free(const ToolPose& pose) const {
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      for (const auto& [at_part, at_others] : pieces_) {
        const PlacedShape& shape = b == 0 ? at_part : at_others;
        fcl::Transform3d X = fcl::Transform3d::Identity();
        X.linear() = geometry::turn_from_z(pose.axis_P).toRotationMatrix();
        X.translation() = pose.tip_P_mm + shape.centre_z_mm * pose.axis_P;
        fcl::CollisionRequestd request;
        fcl::CollisionResultd result;
        if (fcl::collide(shape.shape.get(), X, bodies_[b].get(), fcl::Transform3d::Identity(), request, result) > 0)
          return false;
      }
    }
    return true;
  }

 private:
  void add(const geometry::TriangleMesh& mesh) {
    std::vector<fcl::Vector3d> points(mesh.vertices_mm.begin(), mesh.vertices_mm.end());
    std::vector<fcl::Triangle> triangles;
    for (const auto& t : mesh.triangles) {
      triangles.emplace_back(static_cast<std::size_t>(t[0]), static_cast<std::size_t>(t[1]),
                             static_cast<std::size_t>(t[2]));
    }
    auto model = std::make_shared<Model>();
    model->beginModel();
    model->addSubModel(points, triangles);
    model->endModel();
    bodies_.push_back(std::move(model));
  }

  std::vector<std::shared_ptr<const Model>> bodies_;
  std::vector<std::pair<PlacedShape, PlacedShape>> pieces_;
};

void count_checks(benchmark::State& state, const Case& on) {
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(on.poses.size()));
}

template <class BoundingVolume>
void BM_PlainFcl(benchmark::State& state) {
  const Case& on = wavy_plate(static_cast<int>(state.range(0)));
  const PlainPairs<BoundingVolume> plain(on);
  int free = 0, differ = 0;
  for (auto run : state) {
    for (const ToolPose& pose : on.poses) free += plain.is_free(pose) ? 1 : 0;
  }
  for (const ToolPose& pose : on.poses) differ += plain.is_free(pose) != on.checks->is_free(pose) ? 1 : 0;
  benchmark::DoNotOptimize(free);
  state.counters["verdicts_that_differ"] = differ;
  count_checks(state, on);
}
BENCHMARK(BM_PlainFcl<fcl::OBBRSSd>)->Arg(160)->Arg(500)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_PlainFcl<fcl::OBBd>)->Arg(160)->Arg(500)->Unit(benchmark::kMillisecond);

void BM_Interference(benchmark::State& state) {
  const Case& on = wavy_plate(static_cast<int>(state.range(0)));
  int free = 0;
  for (auto run : state) {
    for (const ToolPose& pose : on.poses) free += on.checks->is_free(pose) ? 1 : 0;
  }
  state.counters["free_share"] =
      static_cast<double>(free) / static_cast<double>(state.iterations() * static_cast<std::int64_t>(on.poses.size()));
  count_checks(state, on);
}
BENCHMARK(BM_Interference)->Arg(160)->Arg(500)->Unit(benchmark::kMillisecond);

/// The way of 1 mm and 2 degrees to a pose beside each free one, proved by Interference ...
std::vector<ToolMotion> motions(const Case& on) {
  std::vector<ToolMotion> made;
  for (const ToolPose& pose : on.poses) {
    const ToolPose to{pose.tip_P_mm + Vec3(1.0, 0.0, 0.1),
                      (pose.axis_P + 0.035 * pose.axis_P.unitOrthogonal()).normalized()};
    if (on.checks->is_free_but_tip(pose) && on.checks->is_free_but_tip(to)) made.push_back({pose, to, std::nullopt});
  }
  return made;
}

void BM_Motion(benchmark::State& state) {
  const Case& on = wavy_plate(static_cast<int>(state.range(0)));
  const std::vector<ToolMotion> ways = motions(on);
  int free = 0;
  for (auto run : state) {
    for (const ToolMotion& way : ways) free += on.checks->motion_is_free(way) ? 1 : 0;
  }
  benchmark::DoNotOptimize(free);
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(ways.size()));
}
BENCHMARK(BM_Motion)->Arg(160)->Arg(500)->Unit(benchmark::kMillisecond);

/// ... and by plain FCL at so many poses that no point moves further than the same tolerance from one of them.
void BM_MotionPlainFcl(benchmark::State& state) {
  const Case& on = wavy_plate(static_cast<int>(state.range(0)));
  const std::vector<ToolMotion> ways = motions(on);
  const PlainPairs<fcl::OBBRSSd> plain(on);
  int free = 0;
  for (auto run : state) {
    for (std::size_t w = 0; w < ways.size(); w += 20) {
      const ToolMotion& way = ways[w];
      const double turn = std::acos(std::min(1.0, way.from.axis_P.dot(way.to.axis_P)));
      const double most = (way.to.tip_P_mm - way.from.tip_P_mm).norm() + turn * on.checks->reach_mm();
      const int steps = static_cast<int>(std::ceil(0.5 * most / on.checks->motion_tolerance_mm()));
      bool all = true;
      for (int k = 0; k < steps && all; ++k) {
        const double t = (k + 0.5) / steps;
        all = plain.is_free({way.from.tip_P_mm + t * (way.to.tip_P_mm - way.from.tip_P_mm),
                             ((1.0 - t) * way.from.axis_P + t * way.to.axis_P).normalized()});
      }
      free += all ? 1 : 0;
    }
  }
  benchmark::DoNotOptimize(free);
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>((ways.size() + 19) / 20));
}
BENCHMARK(BM_MotionPlainFcl)->Arg(160)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace volute::planner

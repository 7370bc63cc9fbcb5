// A straight pass along x over a gently wavy sheet, with boxes beside it.
#pragma once

#include "planner/orientation/allowed_set.hpp"
#include "planner/orientation/orient.hpp"
#include "tests/planner/scenes.hpp"

namespace volute::planner::testing {

using geometry::Angle;

inline TriangleMesh wall_beside_the_middle() { return box(Vec3(40, 6, 0), Vec3(60, 12, 70)); }

struct Strip {
  Scene scene;
  CcPiece piece;
  kinematics::Tool tool = ball_tool();
  kinematics::Machine machine = ac_head();
  kinematics::Setup setup;
  OrientationOptions options;

  explicit Strip(std::vector<TriangleMesh> obstacles) {
    const auto height = [](double x, double) { return 2.0 * std::sin(0.05 * x); };
    scene.part = sheet(-5, 105, -15, 15, 1.0, height);
    scene.obstacles = std::move(obstacles);
    for (double x = 0.0; x <= 100.0; x += 0.5) {
      CcPoint point;
      point.point_P_mm = Vec3(x, 0.0, height(x, 0.0));
      point.normal_P = Vec3(-0.1 * std::cos(0.05 * x), 0.0, 1.0).normalized();
      piece.points.push_back(point);
    }
    options.tilt = Angle::degrees(10.0);
  }
  [[nodiscard]] Result<OrientedPath> orient(Smoothing smoothing) {
    options.smoothing = smoothing;
    const Interference interference(scene, tool, nullptr, nullptr);
    return planner::orient(piece, tool, machine, setup, interference, options, 500.0 / 60.0);
  }
  [[nodiscard]] int touching(const OrientedPath& path) const {
    const Interference interference(scene, tool, nullptr, nullptr);
    int count = 0;
    for (const auto& point : path.tool_path.points) count += interference.is_free_but_tip(point.pose) ? 0 : 1;
    return count;
  }
};

/// The allowed set of a strip, and what it stands on.
struct AllowedStrip {
  std::vector<Station> stations;
  RotaryChart chart;
  Interference interference;
  AllowedSet set;

  explicit AllowedStrip(const Strip& strip)
      : stations(make_stations(strip.piece, 1.0)),
        chart(strip.machine, strip.setup),
        interference(strip.scene, strip.tool, nullptr, nullptr),
        set(stations, strip.tool, chart, interference, strip.options) {}
};

}  // namespace volute::planner::testing

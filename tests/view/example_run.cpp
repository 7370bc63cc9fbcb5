#include "tests/view/example_run.hpp"

#include <cmath>
#include <numbers>

#include "geometry/check.hpp"
#include "geometry/number_text.hpp"

namespace volute::view {

namespace {

using geometry::Vec2;
using geometry::Vec3;
using kinematics::AxisVector;

constexpr double pi = std::numbers::pi, outer_mm = 30.0, inner_mm = 6.0, ball_mm = 3.0, feed_mm_s = 10.0;
constexpr int header_lines = 6;

double height(double x, double y) { return 3.0 * std::sin(x / 9.0) * std::cos(y / 11.0); }
Vec3 normal(double x, double y) {
  return Vec3(-3.0 / 9.0 * std::cos(x / 9.0) * std::cos(y / 11.0), 3.0 / 11.0 * std::sin(x / 9.0) * std::sin(y / 11.0),
              1.0)
      .normalized();
}

geometry::TriangleMesh disc(int rings) {
  geometry::TriangleMesh mesh;
  const int sectors = 4 * rings;
  for (int ring = 0; ring <= rings; ++ring)
    for (int sector = 0; sector < sectors; ++sector) {
      const double radius = inner_mm + (outer_mm - inner_mm) * ring / rings, angle = 2 * pi * sector / sectors;
      const double x = radius * std::cos(angle), y = radius * std::sin(angle);
      mesh.vertices_mm.emplace_back(x, y, height(x, y));
    }
  for (int ring = 0; ring < rings; ++ring)
    for (int sector = 0; sector < sectors; ++sector) {
      const int next = (sector + 1) % sectors;
      const int a = ring * sectors + sector, b = ring * sectors + next, c = a + sectors, d = b + sectors;
      mesh.triangles.push_back({a, c, d});
      mesh.triangles.push_back({a, d, b});
    }
  return mesh;
}

geometry::TriangleMesh post() {
  geometry::TriangleMesh mesh;
  for (int k = 0; k < 8; ++k) mesh.vertices_mm.emplace_back(28 + 6 * (k & 1), 20 + 3 * (k & 2), -4 + 7 * (k & 4) / 1.0);
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

kinematics::Tool tool() {
  kinematics::Tool tool;
  tool.cutter.radius_mm = tool.cutter.corner_radius_mm = tool.shank_radius_mm = ball_mm;
  tool.holder = {{10, 12, 40, 30}, {16, 20, 70, 30}};
  return tool;
}

/// The spiral's point at a share of the way, from the rim to the hole.
kinematics::ToolPathPoint path_point(double share, double turns) {
  const double radius = outer_mm - 1.0 + (inner_mm + 2.0 - outer_mm) * share, angle = 2 * pi * turns * share;
  const double x = radius * std::cos(angle), y = radius * std::sin(angle);
  kinematics::ToolPathPoint point;
  point.contact_P_mm = {x, y, height(x, y)};
  point.normal_P = normal(x, y);
  const Vec3 outward(std::cos(angle), std::sin(angle), 0.0);
  point.pose.axis_P = (point.normal_P + 0.8 * outward + 0.05 * std::sin(5 * angle) * Vec3::UnitY()).normalized();
  point.pose.tip_P_mm = point.contact_P_mm + ball_mm * (point.normal_P - point.pose.axis_P);
  point.feed_mm_s = feed_mm_s;
  point.turn = turns * share;
  return point;
}

/// Axes of the A/C head for a pose: axis = (sin C sin A, -cos C sin A, cos A) [Sun2016] eq. 22, `near_C` picks the
/// turn.
AxisVector axes_of(const RunView& view, const kinematics::ToolPose& pose, double near_C) {
  AxisVector q = AxisVector::Zero();
  const Vec3& axis = pose.axis_P;
  const kinematics::Machine& machine = view.profile->machine;
  const int A = machine.axis_index('A'), C = machine.axis_index('C');
  q[A] = std::acos(axis.z());
  q[C] = std::atan2(axis.x(), -axis.y());
  q[C] += 2 * pi * std::round((near_C - q[C]) / (2 * pi));
  q.head<3>() = pose.tip_P_mm - kinematics::tool_pose(machine, view.setup, view.tool.gauge_length_mm, q).tip_P_mm;
  return q;
}

void add_samples(RunView& view, const ExampleSize& size, double turns) {
  const double length_mm = pi * (outer_mm + inner_mm) * turns, step_s = length_mm / feed_mm_s / size.samples;
  double near_C = 0.0;
  for (int i = 0; i < size.samples; ++i) {
    const kinematics::ToolPathPoint point = path_point(static_cast<double>(i) / size.samples, turns);
    sim::AxisSample sample;
    sample.time_s = i * step_s;
    sample.position = axes_of(view, point.pose, near_C);
    near_C = sample.position[view.profile->machine.axis_index('C')];
    sample.actual = sample.position - AxisVector::Constant(1e-4);
    sample.velocity.setZero();
    sample.acceleration.setZero();
    sample.jerk.setZero();
    sample.line = line_of_sample(size, i);
    sample.tip_speed_mm_s = feed_mm_s * (0.75 + 0.25 * std::cos(40.0 * i / size.samples));
    sample.cutting = true;
    view.trace.samples.push_back(sample);
    view.trace.poses_P.push_back(point.pose);
  }
}

void add_derivatives(RunView& view, const ExampleSize& size) {
  auto& samples = view.trace.samples;
  const double step_s = samples[1].time_s;
  for (std::size_t i = 1; i < samples.size(); ++i)
    samples[i].velocity = (samples[i].position - samples[i - 1].position) / step_s;
  for (std::size_t i = 2; i < samples.size(); ++i)
    samples[i].acceleration = (samples[i].velocity - samples[i - 1].velocity) / step_s;
  for (std::size_t i = 3; i < samples.size(); ++i)
    samples[i].jerk = (samples[i].acceleration - samples[i - 1].acceleration) / step_s;
  auto& spike = samples[static_cast<std::size_t>(spike_sample(size))];
  const int A = view.profile->machine.axis_index('A');
  spike.velocity[A] = spike_velocity_rad_s;
  spike.limit = sim::Limit::axis_velocity;
  spike.limiting_axis = static_cast<std::int8_t>(A);
}

std::string program(const ExampleSize& size, double turns) {
  std::string text = "%\nO0001 (EXAMPLE)\nG21 G90\nT1 M6\nS3000 M3\nG43.4 H1\n";
  for (int block = 0; block < size.blocks; ++block) {
    const Vec3 tip = path_point(static_cast<double>(block) / size.blocks, turns).pose.tip_P_mm;
    text += "N" + std::to_string(block + 1) + " G1";
    for (int axis = 0; axis < 3; ++axis) text += std::string(" ") + "XYZ"[axis] + geometry::fixed_text(tip[axis], 3);
    text += "\n";
  }
  return text + "M30\n%\n";
}

sim::CutSurfaceReport cut(const geometry::TriangleMesh& surface) {
  sim::CutSurfaceReport cut;
  cut.histogram.assign(60, 0);
  cut.histogram_min_mm = -0.02;
  cut.histogram_step_mm = 0.002;
  for (const Vec3& vertex : surface.vertices_mm) {
    const double deviation = 0.04 + 0.05 * std::sin(vertex.x() * 2.0) * std::cos(vertex.y() * 1.5);
    cut.vertex_deviation_mm.push_back(deviation);
    ++cut.histogram[static_cast<std::size_t>((deviation - cut.histogram_min_mm) / cut.histogram_step_mm)];
  }
  cut.vertex_deviation_mm.front() = std::nan("");
  return cut;
}

constexpr const char* report_text = R"({"program":{"file":"example.nc","blocks":500},
"path":{"strategy":"spiral","length_mm":1234.5,"rapid_traversals":0,"liftings":1,"linkings":0,"sharp_corners":2},
"run":{"cycle_time_s":123.4,"programmed_feed_mm_min":600.0,"actual_feed_mm_min":450.0,"feed_loss_percent":-25.0,
"limiting":{"A":3.5,"C":0.0},"time_by_cause":{"feed":80.0,"corner":30.0,"rotary_limit":13.4},
"worst_blocks":[{"block":77,"time_s":1.5,"lost_s":0.5,"programmed_feed_mm_min":600.0,"actual_feed_mm_min":100.0}]},
"machining":{"samples":1000,"scallop_max_mm":0.09,"scallop_p99_mm":0.08,"gouge_max_mm":0.01,"uncut_area_mm2":0.0,"uncut":false},
"collision":{"pairs_checked":5000,"sim_hits":1,"closest_mm":0.0,"closest_pair":"holder-post","at_block":200}})";

}  // namespace

int spike_sample(const ExampleSize& size) { return size.samples * 37 / 100; }
int line_of_sample(const ExampleSize& size, int sample) {
  return header_lines + 1 + static_cast<int>(static_cast<std::int64_t>(sample) * size.blocks / size.samples);
}

RunView example_run(const ExampleSize& size) {
  constexpr double turns = 12.0;
  RunView view;
  view.title = "wavy disc <example> on ac-head-fanuc";
  view.surface_P = disc(size.mesh_rings);
  view.obstacles_P = {post()};
  view.obstacle_names = {"post"};
  view.tool = tool();
  view.setup.part_in_machine.translation() = Vec3(20, -15, -150);
  const auto profile = kinematics::load_profile(VOLUTE_SOURCE_DIR "/machines", "ac-head-fanuc");
  VOLUTE_CHECK(profile.has_value(), profile ? "" : profile.error().message);
  view.profile = *profile;
  for (int i = 0; i < size.blocks; ++i)
    view.tool_path.points.push_back(path_point(static_cast<double>(i) / size.blocks, turns));
  add_samples(view, size, turns);
  add_derivatives(view, size);
  view.cut = cut(view.surface_P);
  const std::int64_t hit = line_of_sample(size, size.samples / 2);
  view.findings = {{"collision", hit, view.trace.samples[static_cast<std::size_t>(size.samples / 2)].time_s,
                    "holder-post", 0.5, 0.0,
                    "line " + std::to_string(hit) + ": holder-post meet (0.5 mm deep) </script><b>"}};
  view.report_json = report_text;
  view.program_name = "example.nc";
  view.program_text = program(size, turns);
  view.map_guide_lines = {};
  return view;
}

}  // namespace volute::view

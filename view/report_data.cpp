#include "view/report_data.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "view/axis_plots.hpp"
#include "view/coarse_mesh.hpp"
#include "view/packed_data.hpp"
#include "view/trace_store.hpp"

namespace volute::view {

namespace {

using Json = nlohmann::ordered_json;
using geometry::Vec3;

constexpr double degrees_per_radian = 180.0 / std::numbers::pi;
constexpr double length_step_mm = 0.001, angle_step_deg = 0.0005, direction_step = 2e-5, time_step_s = 1e-5;
constexpr double deviation_step_mm = 1e-5, mesh_steps = 30000.0, turn_step = 1e-4, profile_tolerance_mm = 0.02;
/// Of the surface and of each obstacle: what a browser without a graphics card draws at once.
constexpr std::size_t page_triangles_max = 120'000;

/// People's unit of an axis: mm or deg.
double unit_of(const kinematics::Axis& axis) {
  return axis.kind == kinematics::AxisKind::rotary ? degrees_per_radian : 1.0;
}

Json vector_json(const Vec3& vector) { return {vector.x(), vector.y(), vector.z()}; }

Json transform_json(const geometry::Transform& transform) {
  Json rows = Json::array();
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row) rows.push_back(transform.matrix()(row, column));
  return rows;  // column after column, as WebGL counts
}

Json axis_json(const kinematics::Axis& axis) {
  const double unit = unit_of(axis);
  Json json{{"letter", std::string(1, axis.letter)},
            {"rotary", axis.kind == kinematics::AxisKind::rotary},
            {"direction", vector_json(axis.direction_M)},
            {"point", vector_json(axis.point_M_mm)},
            {"zero", axis.zero * unit},
            {"velocity_max", axis.velocity_max * unit},
            {"acceleration_max", axis.acceleration_max * unit},
            {"jerk_max", axis.jerk_max * unit}};
  if (axis.travel_min) json["travel_min"] = *axis.travel_min * unit;
  if (axis.travel_max) json["travel_max"] = *axis.travel_max * unit;
  return json;
}

Json machine_json(const RunView& view) {
  const kinematics::Machine& machine = view.profile->machine;
  Json json{{"name", view.profile->name},
            {"title", machine.title},
            {"control", view.profile->control.title},
            {"table_axes", machine.table_axes},
            {"chain", machine.chain},
            {"part_in_machine", transform_json(view.setup.part_in_machine)},
            {"gauge", transform_json(machine.gauge_at_zero_M)}};
  for (const kinematics::Axis& axis : machine.axes) json["axes"].push_back(axis_json(axis));
  json["links"] = Json::array();
  for (const kinematics::LinkShape& shape : machine.shapes)
    json["links"].push_back({{"name", shape.name}, {"link", shape.link}});
  return json;
}

Json tool_json(const kinematics::Tool& tool) {
  Json profile = Json::array();
  for (const kinematics::ProfilePoint& point : kinematics::assembly_profile(tool, profile_tolerance_mm))
    profile.push_back({point.z_mm, point.radius_mm});
  return {{"name", tool.name},
          {"profile", profile},
          {"radius_mm", tool.cutter.radius_mm},
          {"flutes_end_mm", tool.cutter.length_mm},
          {"holder_start_mm", tool.stick_out_mm},
          {"gauge_length_mm", tool.gauge_length_mm}};
}

Json findings_json(const std::vector<sim::Finding>& findings) {
  Json list = Json::array();
  for (const sim::Finding& finding : findings)
    list.push_back({{"kind", finding.kind},
                    {"line", finding.line},
                    {"time_s", finding.time_s},
                    {"where", finding.axis_or_pair},
                    {"value", finding.value},
                    {"limit", finding.limit},
                    {"text", finding.text}});
  return list;
}

Json report_json(const RunView& view) {
  Json json{{"title", view.title}, {"program", view.program_name}, {"planned", !view.tool_path.points.empty()}};
  Json numbers = Json::parse(view.report_json, nullptr, false);
  json["report"] = numbers.is_discarded() ? Json::object() : std::move(numbers);
  json["report"].erase("findings");
  json["findings"] = findings_json(view.findings);
  json["tool"] = tool_json(view.tool);
  json["colours"] = plot_colours();
  json["obstacles"] = Json::array();
  for (std::size_t i = 0; i < view.obstacles_P.size(); ++i)
    json["obstacles"].push_back(i < view.obstacle_names.size() ? view.obstacle_names[i] : "obstacle");
  if (view.profile) json["machine"] = machine_json(view);
  if (view.cut && !view.cut->histogram.empty())
    json["histogram"] = {{"counts", view.cut->histogram},
                         {"least_mm", view.cut->histogram_min_mm},
                         {"step_mm", view.cut->histogram_step_mm}};
  return json;
}

/// Coordinates of all points of a list, one column each.
template <class Points, class Get>
void add_points(PackedData& data, const std::string& name, const Points& points, double step, const Get& get) {
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> column(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) column[i] = get(points[i])[axis];
    data.add(name + "." + "xyz"[axis], column, step);
  }
}

double extent_mm(const geometry::TriangleMesh& mesh) {
  double extent = 0.0;
  for (const Vec3& vertex : mesh.vertices_mm) extent = std::max(extent, vertex.cwiseAbs().maxCoeff());
  return extent;
}

void add_mesh(PackedData& data, const std::string& name, const geometry::TriangleMesh& mesh) {
  const double step = std::max(extent_mm(mesh) / mesh_steps, 1e-6);
  add_points(data, name, mesh.vertices_mm, step, [](const Vec3& vertex) -> const Vec3& { return vertex; });
  std::vector<std::int64_t> corners;
  for (const geometry::Triangle& triangle : mesh.triangles)
    corners.insert(corners.end(), triangle.begin(), triangle.end());
  data.add_integers(name + ".corners", corners);
}

void add_deviation(PackedData& data, const RunView& view, const CoarseMesh& coarse) {
  if (!view.cut || view.cut->vertex_deviation_mm.size() != view.surface_P.vertices_mm.size()) return;
  std::vector<double> deviation;
  std::vector<std::int64_t> reached;
  for (const double value : coarse_values(coarse, view.cut->vertex_deviation_mm)) {
    deviation.push_back(std::isfinite(value) ? value : 0.0);
    reached.push_back(std::isfinite(value) ? 1 : 0);
  }
  data.add("surface.deviation", deviation, deviation_step_mm);
  data.add_integers("surface.reached", reached);
}

void add_planned_path(PackedData& data, const RunView& view) {
  const auto& points = view.tool_path.points;
  if (points.empty()) return;
  add_points(data, "plan.contact", points, length_step_mm,
             [](const auto& point) -> const Vec3& { return point.contact_P_mm; });
  std::vector<double> turn, tilt;
  std::vector<std::int64_t> move;
  for (const kinematics::ToolPathPoint& point : points) {
    turn.push_back(point.turn);
    tilt.push_back(std::acos(std::clamp(point.pose.axis_P.dot(point.normal_P), -1.0, 1.0)) * degrees_per_radian);
    move.push_back(static_cast<std::int64_t>(point.move));
  }
  data.add("plan.turn", turn, turn_step);
  data.add("plan.tilt", tilt, angle_step_deg);
  data.add_integers("plan.move", move);
}

std::string scene_bytes(const RunView& view) {
  PackedData data;
  const CoarseMesh surface = coarse_mesh(view.surface_P, page_triangles_max);
  add_mesh(data, "surface", surface.mesh);
  add_deviation(data, view, surface);
  for (std::size_t i = 0; i < view.obstacles_P.size(); ++i)
    add_mesh(data, "obstacle" + std::to_string(i), coarse_mesh(view.obstacles_P[i], page_triangles_max).mesh);
  if (view.profile)
    for (std::size_t i = 0; i < view.profile->machine.shapes.size(); ++i)
      add_mesh(data, "link" + std::to_string(i), view.profile->machine.shapes[i].mesh_M);
  add_planned_path(data, view);
  return data.bytes();
}

template <class Get>
std::vector<double> column_of(const std::vector<sim::AxisSample>& samples, const Get& get) {
  std::vector<double> column(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) column[i] = get(samples[i]);
  return column;
}

void add_axis(PackedData& data, const RunView& view, int index) {
  const kinematics::Axis& axis = view.profile->machine.axes[static_cast<std::size_t>(index)];
  const double unit = unit_of(axis);
  const auto& samples = view.trace.samples;
  const std::string letter(1, axis.letter);
  const double step = axis.kind == kinematics::AxisKind::rotary ? angle_step_deg : length_step_mm;
  data.add("position." + letter, column_of(samples, [&](const auto& s) { return s.position[index] * unit; }), step);
  data.add_curve("velocity." + letter, column_of(samples, [&](const auto& s) { return s.velocity[index] * unit; }));
  data.add_curve("acceleration." + letter,
                 column_of(samples, [&](const auto& s) { return s.acceleration[index] * unit; }));
  data.add_curve("jerk." + letter, column_of(samples, [&](const auto& s) { return s.jerk[index] * unit; }));
  data.add_curve("lag." + letter,
                 column_of(samples, [&](const auto& s) { return (s.position[index] - s.actual[index]) * unit; }));
}

std::string trace_bytes(const RunView& given) {
  RunView view;
  view.profile = given.profile;
  view.trace = trace_as_stored(given.trace);  // so that a page made again from the run's files is the same
  PackedData data;
  const auto& samples = view.trace.samples;
  data.add("time", column_of(samples, [](const auto& s) { return s.time_s; }), time_step_s);
  add_points(data, "tip", view.trace.poses_P, length_step_mm,
             [](const auto& pose) -> const Vec3& { return pose.tip_P_mm; });
  add_points(data, "axis", view.trace.poses_P, direction_step,
             [](const auto& pose) -> const Vec3& { return pose.axis_P; });
  data.add_curve("feed", column_of(samples, [](const auto& s) { return s.tip_speed_mm_s * 60.0; }));
  std::vector<std::int64_t> line, limit, limiting_axis, motion;
  for (const sim::AxisSample& sample : samples) {
    line.push_back(sample.line);
    limit.push_back(static_cast<std::int64_t>(sample.limit));
    limiting_axis.push_back(sample.limiting_axis);
    motion.push_back(sample.rapid ? 2 : sample.cutting ? 1 : 0);
  }
  data.add_integers("line", line);
  data.add_integers("limit", limit);
  data.add_integers("limiting_axis", limiting_axis);
  data.add_integers("motion", motion);
  if (view.profile)
    for (int axis = 0; axis < kinematics::axis_count; ++axis) add_axis(data, view, axis);
  return data.bytes();
}

PagePart packed(const std::string& id, const std::string& bytes) { return {id, base64_text(zlib_bytes(bytes)), true}; }

}  // namespace

std::vector<PagePart> page_parts(const RunView& view) {
  std::vector<PagePart> parts;
  parts.push_back({"report", report_json(view).dump(), false});
  parts.push_back(packed("scene", scene_bytes(view)));
  if (!view.trace.samples.empty()) parts.push_back(packed("trace", trace_bytes(view)));
  if (!view.program_text.empty()) parts.push_back(packed("program", view.program_text));
  return parts;
}

}  // namespace volute::view

// A run's view as one file, view.cbor.z: CBOR (RFC 8949, written by nlohmann::json) in a zlib stream. Tables of doubles
// under named keys, the samples packed (trace_store.hpp).
#include <cstring>
#include <nlohmann/json.hpp>

#include "geometry/file.hpp"
#include "view/packed_data.hpp"
#include "view/run_view.hpp"
#include "view/trace_store.hpp"

namespace volute::view {

namespace {

using Json = nlohmann::json;
using geometry::Vec2;
using geometry::Vec3;

constexpr const char* file_name = "view.cbor.z";
constexpr int layout_version = 3;
/// tip, axis, contact, normal, feed, turn, move.
constexpr std::size_t point_doubles = 15;

template <class T>
Json binary(const std::vector<T>& values) {
  std::vector<std::uint8_t> bytes(values.size() * sizeof(T));
  if (!bytes.empty()) std::memcpy(bytes.data(), values.data(), bytes.size());
  return Json::binary(std::move(bytes));
}

Json byte_string(std::string_view bytes) { return Json::binary(std::vector<std::uint8_t>(bytes.begin(), bytes.end())); }

template <class T>
std::vector<T> values_of(const Json& json) {
  const auto& bytes = json.get_binary();
  std::vector<T> values(bytes.size() / sizeof(T));
  if (!values.empty()) std::memcpy(values.data(), bytes.data(), values.size() * sizeof(T));
  return values;
}

template <class Vector>
void append(std::vector<double>& out, const Vector& vector) {
  for (Eigen::Index i = 0; i < vector.size(); ++i) out.push_back(vector[i]);
}

/// Takes doubles one after the other.
class Taker {
 public:
  explicit Taker(const std::vector<double>& values) : next_(values.data()) {}
  double one() { return *next_++; }
  template <class Vector>
  void into(Vector& vector) {
    for (Eigen::Index i = 0; i < vector.size(); ++i) vector[i] = one();
  }

 private:
  const double* next_;
};

Json mesh_json(const geometry::TriangleMesh& mesh) {
  std::vector<double> points;
  for (const Vec3& vertex : mesh.vertices_mm) append(points, vertex);
  return {{"vertices", binary(points)}, {"triangles", binary(mesh.triangles)}};
}

geometry::TriangleMesh mesh_of(const Json& json) {
  geometry::TriangleMesh mesh;
  const auto points = values_of<double>(json.at("vertices"));
  Taker taker(points);
  mesh.vertices_mm.resize(points.size() / 3);
  for (Vec3& vertex : mesh.vertices_mm) taker.into(vertex);
  mesh.triangles = values_of<geometry::Triangle>(json.at("triangles"));
  return mesh;
}

Json path_json(const kinematics::ToolPath& path) {
  std::vector<double> out;
  out.reserve(path.points.size() * point_doubles);
  for (const kinematics::ToolPathPoint& point : path.points) {
    for (const Vec3* vector : {&point.pose.tip_P_mm, &point.pose.axis_P, &point.contact_P_mm, &point.normal_P})
      append(out, *vector);
    for (const double value : {point.feed_mm_s, point.turn, static_cast<double>(point.move)}) out.push_back(value);
  }
  return binary(out);
}

kinematics::ToolPath path_of(const Json& json) {
  kinematics::ToolPath path;
  const auto values = values_of<double>(json);
  Taker taker(values);
  path.points.resize(values.size() / point_doubles);
  for (kinematics::ToolPathPoint& point : path.points) {
    for (Vec3* vector : {&point.pose.tip_P_mm, &point.pose.axis_P, &point.contact_P_mm, &point.normal_P})
      taker.into(*vector);
    point.feed_mm_s = taker.one();
    point.turn = taker.one();
    point.move = static_cast<kinematics::MoveKind>(static_cast<int>(taker.one()));
  }
  return path;
}

Json tool_json(const kinematics::Tool& tool) {
  Json holder = Json::array();
  for (const kinematics::ConeSegment& cone : tool.holder)
    holder.push_back({cone.bottom_radius_mm, cone.top_radius_mm, cone.z_mm, cone.length_mm});
  return {{"name", tool.name},
          {"shape", static_cast<int>(tool.cutter.shape)},
          {"radius", tool.cutter.radius_mm},
          {"corner", tool.cutter.corner_radius_mm},
          {"taper", tool.cutter.taper.radians()},
          {"length", tool.cutter.length_mm},
          {"shank", tool.shank_radius_mm},
          {"stick_out", tool.stick_out_mm},
          {"gauge", tool.gauge_length_mm},
          {"holder", holder}};
}

kinematics::Tool tool_of(const Json& json) {
  kinematics::Tool tool;
  tool.name = json.at("name");
  tool.cutter.shape = static_cast<kinematics::CutterShape>(json.at("shape").get<int>());
  tool.cutter.radius_mm = json.at("radius");
  tool.cutter.corner_radius_mm = json.at("corner");
  tool.cutter.taper = geometry::Angle::radians(json.at("taper"));
  tool.cutter.length_mm = json.at("length");
  tool.shank_radius_mm = json.at("shank");
  tool.stick_out_mm = json.at("stick_out");
  tool.gauge_length_mm = json.at("gauge");
  for (const Json& cone : json.at("holder")) tool.holder.push_back({cone.at(0), cone.at(1), cone.at(2), cone.at(3)});
  return tool;
}

Json cut_json(const sim::CutSurfaceReport& cut) {
  return {{"deviation", binary(cut.vertex_deviation_mm)},
          {"histogram", binary(cut.histogram)},
          {"histogram_min", cut.histogram_min_mm},
          {"histogram_step", cut.histogram_step_mm},
          {"samples", cut.samples},
          {"scallop_max", cut.scallop_max_mm},
          {"scallop_p99", cut.scallop_p99_mm},
          {"gouge_max", cut.gouge_max_mm},
          {"uncut_area", cut.uncut_area_mm2},
          {"uncut", cut.uncut}};
}

sim::CutSurfaceReport cut_of(const Json& json) {
  sim::CutSurfaceReport cut;
  cut.vertex_deviation_mm = values_of<double>(json.at("deviation"));
  cut.histogram = values_of<std::int64_t>(json.at("histogram"));
  cut.histogram_min_mm = json.at("histogram_min");
  cut.histogram_step_mm = json.at("histogram_step");
  cut.samples = json.at("samples");
  cut.scallop_max_mm = json.at("scallop_max");
  cut.scallop_p99_mm = json.at("scallop_p99");
  cut.gouge_max_mm = json.at("gouge_max");
  cut.uncut_area_mm2 = json.at("uncut_area");
  cut.uncut = json.at("uncut");
  return cut;
}

Json findings_json(const std::vector<sim::Finding>& findings) {
  Json list = Json::array();
  for (const sim::Finding& finding : findings)
    list.push_back(
        {finding.kind, finding.line, finding.time_s, finding.axis_or_pair, finding.value, finding.limit, finding.text});
  return list;
}

std::vector<sim::Finding> findings_of(const Json& json) {
  std::vector<sim::Finding> findings;
  for (const Json& f : json) findings.push_back({f.at(0), f.at(1), f.at(2), f.at(3), f.at(4), f.at(5), f.at(6)});
  return findings;
}

Json rule_json(const OrientationRule& rule) {
  return {{"angles", {rule.tilt.radians(), rule.yaw.radians(), rule.tilt_min.radians(), rule.tilt_max.radians()}},
          {"clearance", rule.clearance_mm},
          {"gouge", rule.gouge_tolerance_mm},
          {"fixtures", rule.fixtures},
          {"rotaries", binary(rule.rotaries_rad)}};
}

OrientationRule rule_of(const Json& json) {
  const auto angle = [&](std::size_t k) { return geometry::Angle::radians(json.at("angles").at(k).get<double>()); };
  return {angle(0),
          angle(1),
          angle(2),
          angle(3),
          json.at("clearance"),
          json.at("gouge"),
          json.at("fixtures"),
          values_of<std::array<double, 2>>(json.at("rotaries"))};
}

Json map_json(const RunView& view) {
  std::vector<double> vertices;
  for (const Vec2& vertex : view.map_vertices) append(vertices, vertex);
  Json lines = Json::array();
  for (const auto& line : view.map_guide_lines) {
    std::vector<double> points;
    for (const Vec2& point : line) append(points, point);
    lines.push_back(binary(points));
  }
  return {{"vertices", binary(vertices)}, {"triangles", binary(view.map_triangles)}, {"lines", lines}};
}

std::vector<Vec2> points_of(const Json& json) {
  const auto values = values_of<double>(json);
  std::vector<Vec2> points(values.size() / 2);
  Taker taker(values);
  for (Vec2& point : points) taker.into(point);
  return points;
}

RunView view_of(const Json& json) {
  RunView view;
  view.title = json.at("title");
  view.surface_P = mesh_of(json.at("surface"));
  for (const Json& obstacle : json.at("obstacles")) view.obstacles_P.push_back(mesh_of(obstacle));
  view.obstacle_names = json.at("obstacle_names").get<std::vector<std::string>>();
  view.tool = tool_of(json.at("tool"));
  const auto setup = values_of<double>(json.at("setup"));
  view.setup.part_in_machine.matrix() = Eigen::Map<const Eigen::Matrix4d>(setup.data());
  view.tool_path = path_of(json.at("tool_path"));
  if (json.contains("orientation")) view.orientation = rule_of(json.at("orientation"));
  if (json.contains("cut")) view.cut = cut_of(json.at("cut"));
  view.findings = findings_of(json.at("findings"));
  view.report_json = json.at("report");
  view.program_name = json.at("program_name");
  view.program_text = json.at("program_text");
  view.map_vertices = points_of(json.at("map").at("vertices"));
  view.map_triangles = values_of<geometry::Triangle>(json.at("map").at("triangles"));
  for (const Json& line : json.at("map").at("lines")) view.map_guide_lines.push_back(points_of(line));
  return view;
}

/// The machine and control files as they were named; when they are gone, the pictures that need them are left out.
std::optional<kinematics::Profile> profile_of(const Json& json) {
  if (!json.contains("profile")) return std::nullopt;
  const auto machine = kinematics::load_machine(json.at("profile").at("machine").get<std::string>());
  const auto control = kinematics::load_control(json.at("profile").at("control").get<std::string>());
  if (!machine || !control) return std::nullopt;
  return kinematics::Profile{json.at("profile").at("name"), *machine, *control};
}

}  // namespace

Result<void> save_view(const RunView& view, const std::filesystem::path& folder) {
  Json obstacles = Json::array();
  for (const geometry::TriangleMesh& obstacle : view.obstacles_P) obstacles.push_back(mesh_json(obstacle));
  const Eigen::Matrix4d setup = view.setup.part_in_machine.matrix();
  Json json{{"layout", layout_version},
            {"title", view.title},
            {"surface", mesh_json(view.surface_P)},
            {"obstacles", obstacles},
            {"obstacle_names", view.obstacle_names},
            {"tool", tool_json(view.tool)},
            {"setup", binary(std::vector<double>(setup.data(), setup.data() + 16))},
            {"tool_path", path_json(view.tool_path)},
            {"trace", byte_string(packed_trace(view.trace))},
            {"findings", findings_json(view.findings)},
            {"report", view.report_json},
            {"program_name", view.program_name},
            {"program_text", view.program_text},
            {"map", map_json(view)}};
  if (view.orientation) json["orientation"] = rule_json(*view.orientation);
  if (view.cut) json["cut"] = cut_json(*view.cut);
  if (view.profile)
    json["profile"] = {{"name", view.profile->name},
                       {"machine", view.profile->machine.file.string()},
                       {"control", view.profile->control.file.string()}};
  const std::vector<std::uint8_t> bytes = Json::to_cbor(json);
  return geometry::write_file(folder / file_name,
                              zlib_bytes(std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size())));
}

Result<RunView> load_view(const std::filesystem::path& folder) {
  const auto bytes = geometry::read_file(folder / file_name);
  if (!bytes)
    return geometry::bad_input("view-missing", folder.string() + ": holds no " + file_name +
                                                   "; name a folder that volute run or volute simulate wrote");
  try {
    const Json json = Json::from_cbor(inflated_bytes(*bytes));
    if (json.at("layout") != layout_version)
      return geometry::bad_input(
          "view-layout", (folder / file_name).string() + ": written by another version of Volute; run the job again");
    RunView view = view_of(json);
    const auto& packed = json.at("trace").get_binary();
    auto trace = unpacked_trace(std::string_view(reinterpret_cast<const char*>(packed.data()), packed.size()));
    if (!trace)
      return geometry::bad_input(
          "view-damaged", (folder / file_name).string() + ": damaged: its samples cannot be read; run the job again");
    view.trace = std::move(*trace);
    view.profile = profile_of(json);
    return view;
  } catch (const Json::exception& error) {
    return geometry::bad_input("view-damaged",
                               (folder / file_name).string() + ": damaged: " + error.what() + "; run the job again");
  }
}

}  // namespace volute::view

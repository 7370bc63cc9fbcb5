#include "app/job.hpp"

#include <cmath>
#include <numbers>

#include "geometry/number_text.hpp"
#include "kinematics/model/toml_reader.hpp"

namespace volute::app {

namespace {

using geometry::Angle;
using geometry::short_text;
using geometry::Vec3;
using kinematics::TomlReader;

constexpr double seconds_per_minute = 60.0;
constexpr double full_turn_rad = 2.0 * std::numbers::pi;

/// Reads one section after the other; the reader keeps the first error.
class JobReader {
 public:
  explicit JobReader(const std::filesystem::path& file) : reader_(file, "job") {
    job_.file = file;
    job_.name = file.stem().string();
  }

  geometry::Result<Job> read() {
    if (reader_.error()) return tl::unexpected(*reader_.error());
    reader_.only_keys(
        root(), "", {"part", "tool", "holder", "scene", "path", "orientation", "process", "machine", "field", "stock"});
    limit_numbers(root(), "");
    read_part();
    read_tool();
    read_holder();
    read_scene();
    read_path();
    read_orientation();
    read_field();
    read_process();
    read_machine();
    read_stock();
    if (reader_.error()) return tl::unexpected(*reader_.error());
    if (auto valid = kinematics::validate(job_.tool); !valid) {
      geometry::Error error = valid.error();
      error.message = job_.file.string() + ": " + error.message;
      return tl::unexpected(error);
    }
    return job_;
  }

 private:
  [[nodiscard]] const toml::table& root() const { return reader_.root(); }

  /// No length, feed or speed of a job is larger than a million of its unit; what is has a wrong unit or a lost point.
  void limit_numbers(const toml::node& node, const std::string& key) {
    constexpr double greatest = 1e6;
    if (const toml::table* table = node.as_table())
      for (const auto& [name, below] : *table)
        limit_numbers(below, key.empty() ? std::string(name.str()) : key + "." + std::string(name.str()));
    if (const toml::array* list = node.as_array())
      for (const toml::node& below : *list) limit_numbers(below, key);
    const auto value = node.is_number() ? node.value<double>() : std::nullopt;
    if (value && std::abs(*value) > greatest)
      reader_.refuse(&node, key, short_text(*value) + " is out of all measure; numbers here are at most 1000000");
  }

  std::filesystem::path beside(const std::string& name) const { return job_.file.parent_path() / name; }

  std::vector<std::filesystem::path> files(const toml::table& table, std::string_view key) {
    std::vector<std::filesystem::path> list;
    for (const std::string& name : reader_.texts(table, "scene", key)) list.push_back(beside(name));
    return list;
  }

  Angle angle(const toml::table& table, const std::string& where, std::string_view key, Angle fallback,
              double least_deg, double most_deg) {
    const double value = reader_.number(table, where, key, fallback.degrees());
    if (value < least_deg || value > most_deg)
      reader_.refuse(
          table.get(key), where + "." + std::string(key),
          short_text(value) + " deg must lie in [" + short_text(least_deg) + ", " + short_text(most_deg) + "]");
    return Angle::degrees(value);
  }

  double not_negative(const toml::table& table, const std::string& where, std::string_view key, double fallback) {
    const double value = reader_.number(table, where, key, fallback);
    if (value < 0.0)
      reader_.refuse(table.get(key), where + "." + std::string(key), short_text(value) + " must not be below 0");
    return value;
  }

  void read_part() {
    const toml::table& part = reader_.table(root(), "", "part");
    reader_.only_keys(part, "part", {"surface", "unit", "component"});
    job_.surface_file = beside(reader_.text(part, "part", "surface"));
    job_.unit_mm = reader_.choice(part, "part", "unit", {"mm", "inch", "m"}, 0) == 0 ? 1.0 : unit_of(part);
    job_.component = reader_.integer(part, "part", "component", -1, 0, 1'000'000);
  }

  static double unit_of(const toml::table& part) {
    return part["unit"].value_or(std::string()) == "inch" ? 25.4 : 1000.0;
  }

  void read_tool() {
    const toml::table& tool = reader_.table(root(), "", "tool");
    reader_.only_keys(tool, "tool",
                      {"name", "number", "shape", "radius_mm", "corner_radius_mm", "taper_deg", "length_mm", "flutes",
                       "shank_radius_mm", "stick_out_mm", "gauge_length_mm"});
    kinematics::Cutter& cutter = job_.tool.cutter;
    constexpr std::array shapes{kinematics::CutterShape::ball, kinematics::CutterShape::bull,
                                kinematics::CutterShape::flat, kinematics::CutterShape::taper_ball};
    cutter.shape = shapes[reader_.choice(tool, "tool", "shape", {"ball", "bull", "flat", "taper-ball"}, 0)];
    cutter.radius_mm = reader_.positive(tool, "tool", "radius_mm");
    const bool round =
        cutter.shape == kinematics::CutterShape::ball || cutter.shape == kinematics::CutterShape::taper_ball;
    cutter.corner_radius_mm = not_negative(tool, "tool", "corner_radius_mm", round ? cutter.radius_mm : 0.0);
    if (cutter.shape == kinematics::CutterShape::bull && !tool.contains("corner_radius_mm"))
      reader_.refuse(&tool, "tool.corner_radius_mm", "is missing; a bull cutter needs it (mm)", "key");
    cutter.taper = angle(tool, "tool", "taper_deg", Angle(), 0.0, 45.0);
    cutter.length_mm = reader_.positive(tool, "tool", "length_mm", 6.0 * cutter.radius_mm);
    cutter.flutes = reader_.integer(tool, "tool", "flutes", 2, 1, 64);
    job_.tool.name = reader_.text(tool, "tool", "name", std::string("tool"));
    job_.tool.number = reader_.integer(tool, "tool", "number", 1, 1, 9999);
    job_.tool.shank_radius_mm = reader_.positive(tool, "tool", "shank_radius_mm", cutter.radius_mm);
    job_.tool.stick_out_mm = reader_.positive(tool, "tool", "stick_out_mm", cutter.length_mm + 20.0);
    job_.tool.gauge_length_mm = reader_.positive(tool, "tool", "gauge_length_mm", job_.tool.stick_out_mm + 60.0);
  }

  void read_holder() {
    const toml::table& holder = reader_.optional_table(root(), "", "holder");
    reader_.only_keys(holder, "holder", {"segments"});
    const toml::array* segments = holder["segments"].as_array();
    if (!segments) {
      if (holder.contains("segments"))
        reader_.refuse(holder.get("segments"), "holder.segments",
                       "must be a list of [bottom diameter, top diameter, length]");
      return;
    }
    double z_mm = job_.tool.stick_out_mm;
    for (const toml::node& node : *segments) {
      const auto numbers = three_numbers(node);
      job_.tool.holder.push_back({numbers[0] / 2.0, numbers[1] / 2.0, z_mm, numbers[2]});
      z_mm += numbers[2];
    }
  }

  std::array<double, 3> three_numbers(const toml::node& node) {
    std::array<double, 3> values{0.0, 0.0, 1.0};
    const toml::array* list = node.as_array();
    bool good = list && list->size() == 3;
    for (std::size_t i = 0; good && i < 3; ++i) {
      const auto value = (*list)[i].value<double>();
      good = value.has_value() && (i < 2 ? *value >= 0.0 : *value > 0.0);
      values[i] = value.value_or(0.0);
    }
    if (!good)
      reader_.refuse(&node, "holder.segments",
                     "each segment is [bottom diameter, top diameter, length] in mm, length above 0");
    return values;
  }

  void read_scene() {
    const toml::table& scene = reader_.optional_table(root(), "", "scene");
    reader_.only_keys(scene, "scene", {"obstacles", "fixtures", "clearance_mm", "gouge_tolerance_mm"});
    job_.obstacle_files = files(scene, "obstacles");
    job_.fixture_files = files(scene, "fixtures");
    job_.clearance_mm = not_negative(scene, "scene", "clearance_mm", 1.0);
    job_.gouge_tolerance_mm = not_negative(scene, "scene", "gouge_tolerance_mm", 0.0);
  }

  void read_path() {
    using planner::Method, planner::Strategy, planner::Direction, planner::CutDirection;
    const toml::table& path = reader_.table(root(), "", "path");
    reader_.only_keys(path, "path",
                      {"strategy", "method", "scallop_mm", "tolerance_mm", "direction", "cut_direction", "allowance_mm",
                       "centre_loop", "root_child", "start_mm", "from_turn", "to_turn", "plane_angle_deg"});
    constexpr std::array strategies{Strategy::spiral, Strategy::contour_parallel, Strategy::projected_spiral,
                                    Strategy::contour_offset, Strategy::iso_planar};
    job_.path.strategy = strategies[reader_.choice(
        path, "path", "strategy", {"spiral", "contour-parallel", "projected-spiral", "contour-offset", "iso-planar"},
        0)];
    constexpr std::array methods{Method::even, Method::periodic, Method::paper};
    job_.path.method = methods[reader_.choice(path, "path", "method", {"even", "periodic", "paper"}, 0)];
    job_.path.scallop_mm = reader_.positive(path, "path", "scallop_mm", 0.1);
    job_.path.tolerance_mm = reader_.positive(path, "path", "tolerance_mm", 0.01);
    job_.path.direction = reader_.choice(path, "path", "direction", {"inward", "outward"}, 0) == 0 ? Direction::inward
                                                                                                   : Direction::outward;
    constexpr std::array cuts{CutDirection::any, CutDirection::climb, CutDirection::conventional};
    job_.path.cut_direction = cuts[reader_.choice(path, "path", "cut_direction", {"any", "climb", "conventional"}, 0)];
    job_.path.allowance_mm = not_negative(path, "path", "allowance_mm", 0.0);
    job_.path.centre_loop = reader_.integer(path, "path", "centre_loop", -1, 0, 1'000'000);
    job_.path.root_child = reader_.choice(path, "path", "root_child", {"nearest", "farthest"}, 0) == 0
                               ? planner::RootChild::nearest
                               : planner::RootChild::farthest;
    if (path.contains("start_mm")) job_.path.start_P_mm = reader_.vector(path, "path", "start_mm");
    if (path.contains("from_turn")) job_.path.from_turn = not_negative(path, "path", "from_turn", 0.0);
    if (path.contains("to_turn")) job_.path.to_turn = not_negative(path, "path", "to_turn", 0.0);
    job_.path.plane_angle_rad = angle(path, "path", "plane_angle_deg", Angle(), -360.0, 360.0).radians();
    if (job_.path.scallop_mm >= job_.tool.cutter.radius_mm)
      reader_.refuse(path.get("scallop_mm"), "path.scallop_mm",
                     short_text(job_.path.scallop_mm) +
                         " must be below tool.radius_mm = " + short_text(job_.tool.cutter.radius_mm));
  }

  void read_orientation() {
    using planner::Smoothing;
    const toml::table& table = reader_.optional_table(root(), "", "orientation");
    reader_.only_keys(table, "orientation",
                      {"initial", "smoothing", "weights", "tilt_min_deg", "tilt_max_deg", "keys", "iterations_max"});
    const toml::table& initial = reader_.optional_table(table, "orientation", "initial");
    reader_.only_keys(initial, "orientation.initial", {"tilt_deg", "yaw_deg"});
    planner::OrientationOptions& options = job_.orientation;
    options.tilt = angle(initial, "orientation.initial", "tilt_deg", options.tilt, -89.0, 89.0);
    options.yaw = angle(initial, "orientation.initial", "yaw_deg", options.yaw, -360.0, 360.0);
    constexpr std::array smoothings{Smoothing::none, Smoothing::velocity, Smoothing::acceleration, Smoothing::field,
                                    Smoothing::corridor};
    options.smoothing = smoothings[reader_.choice(table, "orientation", "smoothing",
                                                  {"none", "velocity", "acceleration", "field", "corridor"}, 2)];
    options.weights = reader_.choice(table, "orientation", "weights", {"arc-length", "as-printed"}, 0) == 0
                          ? planner::Weights::arc_length
                          : planner::Weights::as_printed;
    options.tilt_min = angle(table, "orientation", "tilt_min_deg", options.tilt_min, 0.0, 89.0);
    options.tilt_max = angle(table, "orientation", "tilt_max_deg", options.tilt_max, options.tilt_min.degrees(), 89.0);
    options.iterations_max = reader_.integer(table, "orientation", "iterations_max", options.iterations_max, 1, 1000);
    options.clearance_mm = job_.clearance_mm;
    options.gouge_tolerance_mm = job_.gouge_tolerance_mm =
        job_.gouge_tolerance_mm > 0.0 ? job_.gouge_tolerance_mm : job_.path.tolerance_mm;
    if (const toml::node* keys = table.get("keys")) read_keys(*keys);
  }

  void read_keys(const toml::node& node) {
    const toml::array* list = node.as_array();
    if (!list)
      return reader_.refuse(
          &node, "orientation.keys",
          "must be a list of { at = 0.5, axis = [0, 0, 1] } or { point_mm = [x, y, z], axis = [...] }");
    for (const toml::node& item : *list) {
      const toml::table* key = item.as_table();
      if (!key) return reader_.refuse(&item, "orientation.keys", "each key is a table { at | point_mm, axis }");
      reader_.only_keys(*key, "orientation.keys", {"at", "point_mm", "axis"});
      planner::KeyOrientation orientation;
      if (key->contains("at")) orientation.path_fraction = reader_.number(*key, "orientation.keys", "at");
      if (key->contains("point_mm")) orientation.point_P_mm = reader_.vector(*key, "orientation.keys", "point_mm");
      const Vec3 axis = reader_.vector(*key, "orientation.keys", "axis");
      if (orientation.path_fraction.has_value() == orientation.point_P_mm.has_value())
        reader_.refuse(&item, "orientation.keys", "give either at (0 to 1 of the path's length) or point_mm");
      if (orientation.path_fraction && (*orientation.path_fraction < 0.0 || *orientation.path_fraction > 1.0))
        reader_.refuse(&item, "orientation.keys.at", short_text(*orientation.path_fraction) + " must lie in [0, 1]");
      if (axis.norm() <= 0.0) reader_.refuse(&item, "orientation.keys.axis", "must not be zero");
      orientation.axis_P = axis.normalized();
      options_keys().push_back(orientation);
    }
  }

  std::vector<planner::KeyOrientation>& options_keys() { return job_.orientation.keys; }

  void read_field() {
    using planner::BasisKind, planner::FieldPlacement;
    const toml::table& field = reader_.optional_table(root(), "", "field");
    reader_.only_keys(field, "field",
                      {"basis", "a", "beta", "order", "placement", "spline", "u_intervals", "v_intervals"});
    constexpr std::array kinds{BasisKind::inverse_multiquadric, BasisKind::gaussian, BasisKind::half_open};
    job_.field.basis.kind =
        kinds[reader_.choice(field, "field", "basis", {"inverse-multiquadric", "gaussian", "half-open"}, 0)];
    if (field.contains("a")) job_.field.basis.a = reader_.positive(field, "field", "a");
    job_.field.basis.beta = reader_.positive(field, "field", "beta", 1.0);
    job_.field.basis.order = reader_.integer(field, "field", "order", 2, 1, 12);
    constexpr std::array placements{FieldPlacement::straight, FieldPlacement::box, FieldPlacement::cylinder};
    job_.field.placement = placements[reader_.choice(field, "field", "placement", {"straight", "box", "cylinder"}, 0)];
    job_.field.spline = reader_.boolean(field, "field", "spline", false);
    job_.field.u_intervals = reader_.integer(field, "field", "u_intervals", 30, 3, 2000);
    job_.field.v_intervals = reader_.integer(field, "field", "v_intervals", 10, 4, 2000);
    job_.orientation.field = job_.field;
  }

  void read_process() {
    const toml::table& process = reader_.table(root(), "", "process");
    reader_.only_keys(process, "process",
                      {"feed_mm_min", "approach_feed_mm_min", "spindle_rpm", "clearance_height_mm", "safe_distance_mm",
                       "lead", "lead_radius_mm", "link_lead_radius_mm", "ramp_deg", "coolant"});
    job_.process.feed_mm_s = reader_.positive(process, "process", "feed_mm_min") / seconds_per_minute;
    job_.process.approach_feed_mm_s =
        not_negative(process, "process", "approach_feed_mm_min", 0.0) / seconds_per_minute;
    job_.spindle_rpm = reader_.positive(process, "process", "spindle_rpm", 5000.0);
    job_.process.spindle_rad_s = job_.spindle_rpm * full_turn_rad / seconds_per_minute;
    job_.process.clearance_height_mm =
        reader_.positive(process, "process", "clearance_height_mm", job_.process.clearance_height_mm);
    job_.process.safe_distance_mm =
        reader_.positive(process, "process", "safe_distance_mm", job_.process.safe_distance_mm);
    job_.process.lead_radius_mm = not_negative(process, "process", "lead_radius_mm", 0.0);
    job_.process.link_lead_radius_mm = not_negative(process, "process", "link_lead_radius_mm", 0.0);
    job_.process.lead_shape = reader_.choice(process, "process", "lead", {"arc", "ramp"}, 0) == 0
                                  ? planner::LeadShape::arc
                                  : planner::LeadShape::ramp;
    job_.process.ramp_angle = angle(process, "process", "ramp_deg", job_.process.ramp_angle, 1.0, 80.0);
    job_.coolant = reader_.boolean(process, "process", "coolant", true);
  }

  void read_machine() {
    const toml::table& machine = reader_.table(root(), "", "machine");
    reader_.only_keys(machine, "machine", {"profile", "setup"});
    job_.profile = reader_.text(machine, "machine", "profile");
    const toml::table& setup = reader_.optional_table(machine, "machine", "setup");
    reader_.only_keys(setup, "machine.setup", {"origin_mm", "turn_deg"});
    const Vec3 origin_mm = reader_.vector(setup, "machine.setup", "origin_mm", Vec3::Zero().eval());
    const Angle turn = angle(setup, "machine.setup", "turn_deg", Angle(), -360.0, 360.0);
    job_.setup.part_in_machine = Eigen::Translation3d(origin_mm) * Eigen::AngleAxisd(turn.radians(), Vec3::UnitZ());
  }

  void read_stock() {
    const toml::table& stock = reader_.optional_table(root(), "", "stock");
    reader_.only_keys(stock, "stock", {"solid", "near_net_mm", "low_mm", "high_mm", "allowance_mm", "grid_mm", "skip"});
    StockJob& out = job_.stock;
    out.skip = reader_.boolean(stock, "stock", "skip", false);
    if (stock.contains("solid")) out.solid_file = beside(reader_.text(stock, "stock", "solid"));
    if (stock.contains("low_mm")) out.low_mm = reader_.vector(stock, "stock", "low_mm");
    if (stock.contains("high_mm")) out.high_mm = reader_.vector(stock, "stock", "high_mm");
    if (out.low_mm.has_value() != out.high_mm.has_value())
      reader_.refuse(&stock, "stock", "a box needs both corners, low_mm and high_mm");
    if (!out.solid_file.empty() && out.low_mm)
      reader_.refuse(stock.get("low_mm"), "stock.low_mm", "stands beside stock.solid; give the box or the solid");
    if (stock.contains("near_net_mm")) {
      out.near_net_mm = not_negative(stock, "stock", "near_net_mm", 0.0);
      if (!out.solid_file.empty() || out.low_mm || stock.contains("allowance_mm"))
        reader_.refuse(stock.get("near_net_mm"), "stock.near_net_mm",
                       "stands beside a solid, a box or allowance_mm; give one of them");
    }
    out.given = !out.solid_file.empty() || out.low_mm || out.near_net_mm || stock.contains("allowance_mm");
    out.allowance_mm = not_negative(stock, "stock", "allowance_mm", out.allowance_mm);
    if (stock.contains("grid_mm")) out.grid_mm = reader_.positive(stock, "stock", "grid_mm");
  }

  TomlReader reader_;
  Job job_;
};

}  // namespace

geometry::Result<Job> load_job(const std::filesystem::path& file) {
  for (const char* ending : {".stl", ".ply", ".off", ".obj"})
    if (file.extension() == ending)
      return geometry::bad_input("job-is-a-surface",
                                 file.string() + " is a surface; a job file (TOML) names it as surface = \"" +
                                     file.filename().string() +
                                     "\": copy one of examples/*.toml and change it, docs/job-file.md tells its keys");
  return JobReader(file).read();
}

geometry::Result<kinematics::Setup> parse_setup(const std::string& text) {
  kinematics::Setup setup;
  if (text.empty()) return setup;
  Vec3 origin_mm = Vec3::Zero();
  std::size_t start = 0;
  for (int i = 0; i < 3; ++i) {
    const std::size_t end = i < 2 ? text.find(',', start) : text.size();
    const auto value = end == std::string::npos
                           ? std::nullopt
                           : geometry::parse_number(std::string_view(text).substr(start, end - start));
    constexpr double farthest_mm = 1e6;
    if (!value || std::abs(*value) > farthest_mm)
      return geometry::bad_input(
          "setup-syntax", "--setup " + text + ": must be x,y,z in mm, each within a kilometre, as in --setup 0,0,120");
    origin_mm[i] = *value;
    start = end + 1;
  }
  setup.part_in_machine = Eigen::Translation3d(origin_mm) * Eigen::Quaterniond::Identity();
  return setup;
}

}  // namespace volute::app

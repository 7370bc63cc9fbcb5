#include "app/report.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "app/machining_feed.hpp"

namespace volute::app {

namespace {

constexpr double degrees_per_radian = 180.0 / std::numbers::pi;
constexpr double per_minute = 60.0;

template <class T>
void put_if(Json& object, const char* key, const std::optional<T>& value) {
  if (value) object[key] = *value;
}

std::string letter_key(char letter) { return std::string(1, letter); }

Json motion_peaks(const planner::AxisMotionPeaks& peaks) {
  return {{"velocity_max", peaks.velocity_max * degrees_per_radian},
          {"acceleration_max", peaks.acceleration_max * degrees_per_radian},
          {"jerk_max", peaks.jerk_max * degrees_per_radian},
          {"velocity_rms", peaks.velocity_rms * degrees_per_radian},
          {"acceleration_rms", peaks.acceleration_rms * degrees_per_radian},
          {"jerk_rms", peaks.jerk_rms * degrees_per_radian}};
}

double people_unit(const kinematics::Axis& axis) {
  return axis.kind == kinematics::AxisKind::rotary ? degrees_per_radian : 1.0;
}

}  // namespace

Json surface_json(const planner::SurfaceReport& surface) {
  Json json{
      {"triangles", surface.triangles}, {"boundary_loops", surface.boundary_loops}, {"area_mm2", surface.area_mm2}};
  put_if(json, "map_flips", surface.map_flips);
  put_if(json, "map_quasi_conformal_error", surface.map_quasi_conformal_error);
  return json;
}

Json path_json(const planner::PathReport& path) {
  Json json{{"strategy", path.strategy}};
  if (!path.method.empty()) json["method"] = path.method;
  json["length_mm"] = path.length_mm;
  json["lower_bound_mm"] = path.lower_bound_mm;
  json["length_ratio"] = path.length_ratio;
  json["cc_points"] = path.cc_points;
  json["pieces"] = path.pieces;
  json["rapid_traversals"] = path.rapid_traversals;
  json["liftings"] = path.liftings;
  json["linkings"] = path.linkings;
  json["sharp_corners"] = path.sharp_corners;
  json["sharp_corners_60"] = path.sharp_corners_60;
  put_if(json, "interval_ratio_max", path.interval_ratio_max);
  put_if(json, "scallop_ratio_p9999", path.scallop_ratio_p9999);
  put_if(json, "scallop_ratio_max", path.scallop_ratio_max);
  put_if(json, "scallop_area_above_percent", path.scallop_area_above_percent);
  put_if(json, "seam_kink_max_deg", path.seam_kink_max_deg);
  if (!path.notes.empty()) json["notes"] = path.notes;
  return json;
}

Json orientation_json(const planner::OrientationReport& orientation) {
  Json json{{"smoothing", orientation.smoothing},
            {"pins", orientation.pins},
            {"iterations", orientation.iterations},
            {"solve_s", orientation.solve_s},
            {"interferences_before", orientation.interferences_before},
            {"interferences_after", orientation.interferences_after},
            {"neighbour_turn_max_deg", orientation.neighbour_turn_max_rad * degrees_per_radian}};
  json[letter_key(orientation.first_letter)] = motion_peaks(orientation.first);
  json[letter_key(orientation.second_letter)] = motion_peaks(orientation.second);
  if (!orientation.notes.empty()) json["notes"] = orientation.notes;
  return json;
}

Json run_json(const sim::RunReport& run, const kinematics::Machine& machine) {
  Json json{{"cycle_time_s", run.cycle_time_s},
            {"programmed_feed_mm_min", run.programmed_feed_mm_s * per_minute},
            {"actual_feed_mm_min", run.actual_feed_mm_s * per_minute},
            {"feed_loss_percent", run.feed_loss_percent},
            {"feed_length_mm", run.feed_length_mm},
            {"feed_time_s", run.feed_time_s},
            {"blocks", run.blocks},
            {"samples", run.samples},
            {"contour_error_max_mm", run.contour_error_max_mm}};
  Json axes = Json::object();
  Json limiting = Json::object();
  for (std::size_t i = 0; i < run.axes.size(); ++i) {
    const kinematics::Axis& axis = machine.axes[i];
    const sim::AxisPeaks& peaks = run.axes[i];
    const double unit = people_unit(axis);
    axes[letter_key(axis.letter)] = {
        {"velocity_max", peaks.velocity_max * unit}, {"acceleration_max", peaks.acceleration_max * unit},
        {"jerk_max", peaks.jerk_max * unit},         {"following_error_max", peaks.following_error_max * unit},
        {"limit_ratio_max", peaks.limit_ratio_max},  {"position_min", peaks.position_min * unit},
        {"position_max", peaks.position_max * unit}};
    limiting[letter_key(axis.letter)] = run.limited_by_axis_s[i];
  }
  json["axes"] = axes;
  json["limiting"] = limiting;
  json["time_by_cause"] = timing_json(run.time_by_cause_s);
  Json worst = Json::array();
  for (const sim::SlowBlock& block : run.worst_blocks)
    worst.push_back({{"block", block.line},
                     {"time_s", block.time_s},
                     {"lost_s", block.lost_s},
                     {"programmed_feed_mm_min", block.programmed_mm_s * per_minute},
                     {"actual_feed_mm_min", block.actual_mm_s * per_minute}});
  json["worst_blocks"] = worst;
  return json;
}

Json unlimited_jerk_json(const sim::UnlimitedJerkRun& run) {
  Json json{{"cycle_time_s", run.cycle_time_s}, {"feed_loss_percent", run.feed_loss_percent}};
  put_if(json, "machining_time_s", run.machining_time_s);
  return json;
}

Json machining_json(const sim::CutSurfaceReport& cut) {
  return {{"samples", cut.samples},
          {"scallop_max_mm", cut.scallop_max_mm},
          {"scallop_p99_mm", cut.scallop_p99_mm},
          {"gouge_max_mm", cut.gouge_max_mm},
          {"uncut_area_mm2", cut.uncut_area_mm2},
          {"uncut", cut.uncut},
          {"deviation_mean_mm", cut.deviation_mean_mm},
          {"sample_spacing_mm", cut.sample_spacing_mm},
          {"histogram",
           {{"least_mm", cut.histogram_min_mm}, {"step_mm", cut.histogram_step_mm}, {"counts", cut.histogram}}}};
}

Json stock_json(const sim::StockOutcome& stock) {
  const auto corner = [](const geometry::Vec3& p) { return Json{p.x(), p.y(), p.z()}; };
  Json json{{"assumed", stock.assumed},
            {"box_min_mm", corner(stock.box_P_mm.min())},
            {"box_max_mm", corner(stock.box_P_mm.max())},
            {"grid_mm", stock.grid_mm},
            {"first_mm3", stock.report.first_mm3},
            {"left_mm3", stock.report.left_mm3},
            {"removed_mm3", stock.report.first_mm3 - stock.report.left_mm3},
            {"cutting_blocks", stock.report.removed.size()}};
  const sim::LineVolume* most = nullptr;
  for (const sim::LineVolume& line : stock.report.removed)
    if (line.time_s > 0.0 && (!most || line.removed_mm3 * most->time_s > most->removed_mm3 * line.time_s)) most = &line;
  if (most) {
    json["removal_rate_max_mm3_s"] = most->removed_mm3 / most->time_s;
    json["removal_rate_at_block"] = most->line;
  }
  return json;
}

Json collision_json(const sim::CollisionReport& collision, int planner_hits) {
  return {{"pairs_checked", collision.pairs_checked}, {"planner_hits", planner_hits},
          {"sim_hits", collision.sim_hits},           {"closest_mm", collision.closest_mm},
          {"closest_pair", collision.closest_pair},   {"at_block", collision.at_line}};
}

Json loads_json(const sim::LoadsReport& loads, const kinematics::Machine& machine) {
  Json json = Json::object();
  for (std::size_t i = 0; i < loads.axes.size(); ++i) {
    const bool rotary = machine.axes[i].kind == kinematics::AxisKind::rotary;
    json[letter_key(machine.axes[i].letter)] = {{rotary ? "torque_max_nm" : "force_max_n", loads.axes[i].peak},
                                                {rotary ? "torque_rms_nm" : "force_rms_n", loads.axes[i].rms}};
  }
  return json;
}

Json findings_json(const std::vector<sim::Finding>& findings, const kinematics::Machine& machine,
                   const char* severity) {
  Json json = Json::array();
  for (const sim::Finding& finding : findings) {
    json.push_back({{"kind", finding.kind},
                    {"severity", severity},
                    {"block", finding.line},
                    {"time_s", finding.time_s},
                    {"axis_or_pair", finding.axis_or_pair},
                    {"value", finding.value},
                    {"limit", finding.limit},
                    {"text", finding.text}});
    if (finding.pose_P) {
      const auto &tip = finding.pose_P->tip_P_mm, &axis = finding.pose_P->axis_P;
      json.back()["tip_mm"] = {tip.x(), tip.y(), tip.z()};
      json.back()["tool_axis"] = {axis.x(), axis.y(), axis.z()};
    }
    if (!finding.axes) continue;
    for (std::size_t i = 0; i < machine.axes.size(); ++i)
      json.back()["axes"][letter_key(machine.axes[i].letter)] =
          (*finding.axes)[static_cast<Eigen::Index>(i)] * people_unit(machine.axes[i]);
  }
  return json;
}

std::vector<std::string> texts(const std::vector<sim::Finding>& findings) {
  std::vector<std::string> lines;
  for (const sim::Finding& finding : findings) lines.push_back(finding.text);
  return lines;
}

Json timing_json(const std::map<std::string, double>& timing_s) {
  Json json = Json::object();
  for (const auto& [stage, seconds] : timing_s) json[stage] = seconds;
  return json;
}

Json mesh_json(const geometry::MeshReport& report, const std::string& file) {
  Json loops = Json::array();
  for (const geometry::BoundaryLoop& loop : report.loops)
    loops.push_back({{"edges", loop.vertices.size()}, {"length_mm", loop.length_mm}, {"component", loop.component}});
  Json components = Json::array();
  for (const geometry::Component& part : report.components)
    components.push_back(
        {{"triangles", part.triangles}, {"boundary_loops", part.boundary_loops}, {"handles", part.handles}});
  const auto corner = [](const geometry::Vec3& p) { return Json{p.x(), p.y(), p.z()}; };
  Json json{{"file", file},
            {"machinable", report.machinable},
            {"reason_code", report.reason_code},
            {"reason", report.reason},
            {"triangles", report.triangles},
            {"vertices", report.vertices},
            {"area_mm2", report.area_mm2},
            {"box_min_mm", corner(report.least_mm)},
            {"box_max_mm", corner(report.greatest_mm)},
            {"boundary_loops", report.loops.size()},
            {"components", report.components.size()},
            {"handles", report.handles},
            {"loops", loops},
            {"parts", components},
            {"least_angle_deg", report.least_angle_deg},
            {"greatest_angle_deg", report.greatest_angle_deg},
            {"obtuse_triangles", report.obtuse_triangles},
            {"median_edge_mm", report.median_edge_mm}};
  json["repairs"] = {{"vertices_welded", report.repairs.vertices_welded},
                     {"degenerate_triangles_removed", report.repairs.degenerate_triangles_removed},
                     {"duplicate_triangles_removed", report.repairs.duplicate_triangles_removed},
                     {"triangles_turned", report.repairs.triangles_turned}};
  return json;
}

Json without_seconds(Json report) {
  report.erase("timing");
  if (report.contains("orientation")) report["orientation"].erase("solve_s");
  return report;
}

void put_machining_feed(Json& report, const kinematics::ToolPath& path, const sim::VerifyResult& verified) {
  const auto feed = machining_feed(path, verified);
  if (!feed) return;
  Json& run = report["run"];
  run["cutting_length_mm"] = feed->cutting_length_mm;
  run["machining_feed_mm_min"] = feed->actual_mm_s * per_minute;
  run["machining_feed_loss_percent"] = feed->loss_percent;
  if (feed->unlimited_jerk_loss_percent)
    run["unlimited_jerk"]["machining_feed_loss_percent"] = *feed->unlimited_jerk_loss_percent;
}

Json plan_json(const planner::PlanResult& plan) {
  return {{"surface", surface_json(plan.cc.surface)},
          {"path", path_json(plan.cc.report)},
          {"orientation", orientation_json(plan.orientation)},
          {"timing", timing_json(plan.timing_s)}};
}

Json verify_json(const sim::VerifyResult& result, const kinematics::Profile& profile, int planner_hits) {
  Json json{{"run", run_json(result.run, profile.machine)}};
  put_if(json["run"], "machining_time_s", result.machining_time_s);
  if (result.unlimited_jerk) json["run"]["unlimited_jerk"] = unlimited_jerk_json(*result.unlimited_jerk);
  if (result.cut) json["machining"] = machining_json(*result.cut);
  if (result.stock) json["stock"] = stock_json(*result.stock);
  if (result.collision) json["collision"] = collision_json(*result.collision, planner_hits);
  if (result.loads.known) json["loads"] = loads_json(result.loads, profile.machine);
  json["findings"] = findings_json(result.findings, profile.machine, "error");
  if (!result.warnings.empty()) json["warnings"] = findings_json(result.warnings, profile.machine, "warning");
  json["timing"] = timing_json(result.timing_s);
  return json;
}

}  // namespace volute::app

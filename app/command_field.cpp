// volute field: a tool axis everywhere on the surface from the job's key axes ([Huang2016]).
#include <nlohmann/json.hpp>

#include "app/commands.hpp"
#include "app/exit_status.hpp"
#include "app/output_folder.hpp"
#include "app/pipeline.hpp"
#include "app/report.hpp"
#include "app/run_table.hpp"
#include "geometry/mesh_measure.hpp"
#include "geometry/number_text.hpp"
#include "planner/field/mesh_field.hpp"

namespace volute::app {

namespace {

using geometry::Result;
using geometry::short_text;

/// Arrows enough to see the field, not so many that they hide it.
constexpr std::size_t arrows_wanted = 900;

Result<std::vector<planner::PointKey>> point_keys(const Job& job) {
  std::vector<planner::PointKey> keys;
  for (const planner::KeyOrientation& key : job.orientation.keys) {
    if (!key.point_P_mm)
      return geometry::bad_input(
          "field-key-without-point",
          job.file.string() +
              ": orientation.keys: a field needs point_mm in every key; this job has keys along the path (at)");
    keys.push_back({*key.point_P_mm, key.axis_P});
  }
  return keys;
}

std::string table_text(const geometry::TriangleMesh& mesh, const planner::MeshField& field) {
  std::string text = "x_mm,y_mm,z_mm,axis_x,axis_y,axis_z\n";
  for (std::size_t i = 0; i < field.axes_P.size(); ++i) {
    for (int k = 0; k < 3; ++k) text += geometry::fixed_text(mesh.vertices_mm[i][k], 6) + ",";
    for (int k = 0; k < 3; ++k) text += geometry::fixed_text(field.axes_P[i][k], 9) + (k < 2 ? "," : "\n");
  }
  return text;
}

view::RunView field_view(const JobInputs& inputs, const planner::MeshField& field) {
  view::RunView view;
  view.title = inputs.job.name + ": orientation field";
  view.surface_P = inputs.surface;
  view.obstacles_P = inputs.obstacles;
  view.obstacle_names = inputs.obstacle_names;
  view.tool = inputs.job.tool;
  const std::vector<geometry::Vec3> normals = geometry::vertex_normals(inputs.surface);
  const std::size_t step = std::max<std::size_t>(1, field.axes_P.size() / arrows_wanted);
  for (std::size_t i = 0; i < field.axes_P.size(); i += step) {
    kinematics::ToolPathPoint point;
    point.pose = {inputs.surface.vertices_mm[i], field.axes_P[i]};
    point.contact_P_mm = inputs.surface.vertices_mm[i];
    point.normal_P = normals[i];
    view.tool_path.points.push_back(point);
  }
  return view;
}

Json field_json(const planner::MeshFieldReport& report) {
  return {{"keys", report.keys},
          {"reciprocal_condition", report.reciprocal_condition},
          {"fitting_accuracy", report.fitting_accuracy},
          {"largest_key_angle_deg", report.largest_key_angle.degrees()},
          {"dirichlet_per_mm2", report.dirichlet_per_mm2},
          {"largest_turn_on_an_edge_deg", report.largest_turn.degrees()},
          {"tilt_min_deg", report.tilt_least.degrees()},
          {"tilt_max_deg", report.tilt_greatest.degrees()}};
}

std::string field_table(const planner::MeshFieldReport& report, const std::string& picture) {
  std::string text = table_row(
      "key axes", std::to_string(report.keys) + "; reciprocal condition " + short_text(report.reciprocal_condition, 2));
  text += table_row("at the keys", "I_fa " + geometry::fixed_text(report.fitting_accuracy, 9) + ", largest angle " +
                                       short_text(report.largest_key_angle.degrees(), 3) + " deg");
  text += table_row("Dirichlet energy", short_text(report.dirichlet_per_mm2, 5) + " per mm2");
  text += table_row("largest turn on an edge", short_text(report.largest_turn.degrees(), 4) + " deg");
  text += table_row("tilt from the normal", short_text(report.tilt_least.degrees(), 4) + " to " +
                                                short_text(report.tilt_greatest.degrees(), 4) + " deg");
  return text + table_row("picture", picture);
}

Result<int> field(const FieldArguments& arguments, Context& context) {
  const auto inputs = load_inputs(arguments.job, context);
  if (!inputs) return tl::unexpected(inputs.error());
  const path folder = arguments.out.empty() ? path(inputs->job.name + "-field") : arguments.out;
  if (auto possible = OutputFolder::check(folder); !possible) return tl::unexpected(possible.error());
  context.warn(inputs->warnings);
  const auto keys = point_keys(inputs->job);
  if (!keys) return tl::unexpected(keys.error());
  const auto made = planner::field_on_mesh(inputs->surface, *keys, inputs->job.field);
  if (!made) return tl::unexpected(made.error());
  const auto out = OutputFolder::make(folder);
  if (!out) return tl::unexpected(out.error());
  const Json report = field_json(made->report);
  if (auto written = out->write("field.json", report.dump(2) + "\n"); !written) return tl::unexpected(written.error());
  if (auto written = out->write("field.csv", table_text(inputs->surface, *made)); !written)
    return tl::unexpected(written.error());
  const auto pictures = view::write_pictures(field_view(*inputs, *made), out->folder());
  if (!pictures) return tl::unexpected(pictures.error());
  std::string names;
  for (const std::string& name : *pictures) names += (names.empty() ? "" : ", ") + out->file(name).string();
  context.print(report, field_table(made->report, names));
  return exit_clean;
}

}  // namespace

int field_command(const FieldArguments& arguments, Context& context) {
  const auto status = field(arguments, context);
  return status ? *status : context.fail(status.error());
}

}  // namespace volute::app

// volute post: CL data, from any CAM system, to G-code.
#include <nlohmann/json.hpp>

#include "app/commands.hpp"
#include "app/exit_status.hpp"
#include "app/job.hpp"
#include "app/report.hpp"
#include "app/run_table.hpp"
#include "geometry/file.hpp"
#include "geometry/number_text.hpp"
#include "post/cl_data.hpp"
#include "post/post.hpp"

namespace volute::app {

namespace {

/// What the control's own interpolation leaves between the tool path and the motion, before and after points were put
/// in.
std::string linearization_text(const kinematics::AxisPathReport& report) {
  const auto degrees = [](double rad) { return geometry::short_text(geometry::Angle::radians(rad).degrees(), 2); };
  return std::to_string(report.points_added) + " points put in; tip " +
         geometry::short_text(report.chordal_error_mm, 2) + " -> " +
         geometry::short_text(report.chordal_error_after_mm, 2) + " mm, axis " + degrees(report.rotary_error_rad) +
         " -> " + degrees(report.rotary_error_after_rad) + " deg";
}

geometry::Result<int> post(const PostArguments& arguments, Context& context) {
  const auto profile = kinematics::load_profile(context.machines_folder(), arguments.machine);
  if (!profile) return tl::unexpected(profile.error());
  const auto setup = parse_setup(arguments.setup);
  if (!setup) return tl::unexpected(setup.error());
  const auto bytes = geometry::read_file(arguments.cl_file);
  if (!bytes) return tl::unexpected(bytes.error());
  auto data = post::parse_cl(*bytes, arguments.cl_file.string());
  if (!data) return tl::unexpected(data.error());
  context.warn(data->warnings);

  post::PostRequest request;
  request.program_name = arguments.cl_file.stem().string();
  request.path = std::move(data->path);
  request.tool = data->tool;
  request.setup = *setup;
  request.spindle_rpm = data->spindle_rpm;
  request.coolant = data->coolant;
  request.tolerance_mm = arguments.tolerance_mm;
  const auto posted = post::post(request, *profile);
  if (!posted) return tl::unexpected(posted.error());

  path out = arguments.out;
  if (out.empty()) out = path(arguments.cl_file).replace_extension(profile->control.program_extension);
  if (auto written = geometry::write_file(out, posted->text); !written) return tl::unexpected(written.error());
  const Json json{
      {"file", out.string()},
      {"dialect", profile->control.name},
      {"blocks", posted->blocks},
      {"bytes", posted->text.size()},
      {"points_added", posted->linearization.points_added},
      {"rewinds", posted->linearization.rewinds},
      {"pole_crossings", posted->linearization.pole_crossings},
      {"chordal_error_mm", posted->linearization.chordal_error_after_mm},
      {"rotary_error_deg", geometry::Angle::radians(posted->linearization.rotary_error_after_rad).degrees()}};
  context.print(
      json,
      table_row("program", out.string() + ", " + std::to_string(posted->blocks) + " blocks, " + profile->control.name) +
          table_row("linearization", linearization_text(posted->linearization)) +
          table_row("rewinds, pole crossings", std::to_string(posted->linearization.rewinds) + ", " +
                                                   std::to_string(posted->linearization.pole_crossings)));
  return exit_clean;
}

}  // namespace

int post_command(const PostArguments& arguments, Context& context) {
  const auto status = post(arguments, context);
  return status ? *status : context.fail(status.error());
}

}  // namespace volute::app

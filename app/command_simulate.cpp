// volute simulate: anybody's program on the virtual machine; with --compare a second one beside it.
#include <nlohmann/json.hpp>

#include "app/commands.hpp"
#include "app/exit_status.hpp"
#include "app/job.hpp"
#include "app/output_folder.hpp"
#include "app/pipeline.hpp"
#include "app/report.hpp"
#include "app/result_files.hpp"
#include "app/run_table.hpp"
#include "geometry/file.hpp"
#include "geometry/mesh_io.hpp"
#include "geometry/number_text.hpp"
#include "sim/verify.hpp"
#include "view/run_view.hpp"

namespace volute::app {

namespace {

using geometry::Result;

/// What both programs of a comparison share.
struct Bench {
  sim::VerifyRequest request;  ///< but for the program
};

struct Simulated {
  std::string text;
  sim::VerifyResult result;
  Json report;
};

/// From a job: part, tool with holder, obstacles, fixtures, stock, setup and limits.
Result<JobInputs> inputs_of_job(const SimulateArguments& arguments, const Context& context) {
  return load_inputs(arguments.job, context, SurfaceUse::judged, arguments.machine);
}

/// From words on the command line: no holder, no stock but an assumed one.
Result<JobInputs> inputs_of_words(const SimulateArguments& arguments, const Context& context) {
  JobInputs inputs;
  auto profile = kinematics::load_profile(context.machines_folder(), arguments.machine);
  if (!profile) return tl::unexpected(profile.error());
  inputs.profile = std::move(*profile);
  const auto setup = parse_setup(arguments.setup);
  if (!setup) return tl::unexpected(setup.error());
  inputs.job.setup = *setup;
  kinematics::Tool& tool = inputs.job.tool;
  tool.gauge_length_mm = arguments.tool_length_mm;
  if (!arguments.cutter.empty()) {
    const auto cutter = kinematics::parse_cutter(arguments.cutter);
    if (!cutter) return tl::unexpected(cutter.error());
    tool.cutter = *cutter;
    tool.shank_radius_mm = cutter->radius_mm;
    tool.stick_out_mm = std::max(tool.stick_out_mm, cutter->length_mm);
  }
  if (!arguments.part.empty()) {
    auto loaded = geometry::load_mesh(arguments.part);
    if (!loaded) return tl::unexpected(loaded.error());
    inputs.warnings = loaded->repairs.warnings;
    inputs.surface = std::move(loaded->mesh);
  }
  return inputs;
}

Result<Bench> set_up(const SimulateArguments& arguments, Context& context) {
  auto inputs = arguments.job.empty() ? inputs_of_words(arguments, context) : inputs_of_job(arguments, context);
  if (!inputs) return tl::unexpected(inputs.error());
  for (const path& file : arguments.obstacles)
    if (auto loaded = load_obstacle(file, *inputs); !loaded) return tl::unexpected(loaded.error());
  context.warn(inputs->warnings);
  const bool judged = !arguments.job.empty() || (!arguments.part.empty() && !arguments.cutter.empty());
  Bench bench{verify_request(*inputs, judged)};
  if (!judged) bench.request.surface_P.reset();
  if (arguments.job.empty()) {
    bench.request.cut = {};
    bench.request.cut.uncut_limit_mm = arguments.scallop_mm;
  }
  return bench;
}

Result<Simulated> simulate_one(const path& program, const Bench& bench, Context& context) {
  auto bytes = geometry::read_file(program);
  if (!bytes) return tl::unexpected(bytes.error());
  sim::VerifyRequest request = bench.request;
  request.text = std::move(*bytes);
  request.file_name = program.string();
  request.progress = context.progress().callback();
  auto result = sim::verify(request);
  if (!result) return tl::unexpected(result.error());
  context.warn(texts(result->warnings));
  const kinematics::Profile& profile = bench.request.profile;
  Simulated simulated{std::move(request.text), std::move(*result), {}};
  simulated.report["program"] = {{"file", program.filename().string()},
                                 {"dialect", profile.control.name},
                                 {"profile", profile.name},
                                 {"blocks", simulated.result.run.blocks},
                                 {"bytes", simulated.text.size()}};
  simulated.report.update(verify_json(simulated.result, profile, 0));
  if (simulated.report.contains("collision")) simulated.report["collision"].erase("planner_hits");
  return simulated;
}

view::RunView view_of(const path& program, const Bench& bench, const Simulated& simulated) {
  view::RunView view;
  const sim::VerifyRequest& request = bench.request;
  view.title = program.filename().string() + " on " + request.profile.name;
  if (request.surface_P) view.surface_P = *request.surface_P;
  view.obstacles_P = request.obstacles_P;
  view.obstacle_names = request.obstacle_names;
  view.tool = request.tool;
  view.setup = request.setup;
  view.profile = request.profile;
  view.trace = simulated.result.trace;
  view.cut = simulated.result.cut;
  view.findings = simulated.result.findings;
  view.report_json = without_seconds(simulated.report).dump(2);
  view.program_name = program.filename().string();
  view.program_text = simulated.text;
  return view;
}

Result<std::vector<std::string>> write_results(const path& program, const Bench& bench, const Simulated& simulated,
                                               const OutputFolder& out) {
  const view::RunView view = view_of(program, bench, simulated);
  if (auto written = out.write("report.json", simulated.report.dump(2) + "\n"); !written)
    return tl::unexpected(written.error());
  return write_result_files(out, view, simulated.result, std::nullopt);
}

std::string comparison_table(const Json& first, const Json& second) {
  const auto first_name = first["program"]["file"].get<std::string>(),
             second_name = second["program"]["file"].get<std::string>();
  constexpr std::size_t least_width = 16;  // of a number
  const std::size_t width = std::max({first_name.size(), second_name.size(), least_width}) + 2;
  const auto padded = [&](const std::string& text) { return text + std::string(width - text.size(), ' '); };
  const auto comparison_row = [&](const std::string& name, const std::string& a, const std::string& b,
                                  const std::string& more = "") {
    return table_row(name, padded(a) + (more.empty() ? b : padded(b) + more));
  };
  const auto numbers = [&](const std::string& name, const char* part, const char* key, int decimals, bool percent) {
    if (!first.contains(part) || !second.contains(part)) return std::string();
    const double a = first[part][key].get<double>(), b = second[part][key].get<double>();
    const std::string change =
        percent && a != 0.0 ? (b < a ? "" : "+") + geometry::fixed_text(100.0 * (b - a) / a, 2) + " %" : "";
    return comparison_row(name, geometry::fixed_text(a, decimals), geometry::fixed_text(b, decimals), change);
  };
  const auto count = [](const Json& report, const char* list) {
    return std::to_string(report.contains(list) ? report[list].size() : 0);
  };
  std::string text = comparison_row("compared", first_name, second_name, "the second to the first");
  text += numbers("cycle time, s", "run", "cycle_time_s", 3, true);
  text += numbers("actual feed, mm/min", "run", "actual_feed_mm_min", 1, true);
  text += numbers("loss, %", "run", "feed_loss_percent", 2, false);
  text += numbers("scallop left, mm", "machining", "scallop_max_mm", 4, true);
  text += numbers("gouge, mm", "machining", "gouge_max_mm", 4, false);
  text += numbers("uncut, mm2", "machining", "uncut_area_mm2", 2, false);
  text += comparison_row("findings", count(first, "findings"), count(second, "findings"));
  return text + comparison_row("warnings", count(first, "warnings"), count(second, "warnings"));
}

Result<int> simulate(const SimulateArguments& arguments, Context& context) {
  if (arguments.machine.empty() && arguments.job.empty())
    return geometry::bad_input("machine-missing",
                               "--machine is missing: name the profile that the program is for (volute machines lists "
                               "them), or give --job with a job file that names one");
  if (!arguments.obstacles.empty() && arguments.job.empty() && arguments.cutter.empty())
    return geometry::bad_input("cutter-missing",
                               "--obstacle is given without --cutter or --job: say which tool is to keep clear of it, "
                               "as in --cutter ball,3");
  if (!arguments.part.empty() && arguments.cutter.empty())
    return geometry::bad_input(
        "cutter-missing",
        "--part is given without --cutter: say which cutter the program is for, as in --cutter ball,3");
  const auto bench = set_up(arguments, context);
  if (!bench) return tl::unexpected(bench.error());
  const path folder = arguments.out.empty() ? path(arguments.program.stem().string() + "-simulation") : arguments.out;
  if (auto possible = OutputFolder::check(folder); !possible) return tl::unexpected(possible.error());
  const auto first = simulate_one(arguments.program, *bench, context);
  if (!first) return tl::unexpected(first.error());
  const auto out = OutputFolder::make(folder);
  if (!out) return tl::unexpected(out.error());
  const auto pictures = write_results(arguments.program, *bench, *first, *out);
  if (!pictures) return tl::unexpected(pictures.error());
  bool found = !first->result.findings.empty();
  Json json = first->report;
  std::string text = run_table(first->report, out->folder(), *pictures);
  if (!arguments.compare.empty()) {
    const auto second = simulate_one(arguments.compare, *bench, context);
    if (!second) return tl::unexpected(second.error());
    found = found || !second->result.findings.empty();
    json = Json{{"programs", Json::array({first->report, second->report})}};
    text += "\n" + comparison_table(first->report, second->report);
  }
  context.print(json, text);
  return found ? exit_found : exit_clean;
}

}  // namespace

int simulate_command(const SimulateArguments& arguments, Context& context) {
  const auto status = simulate(arguments, context);
  return status ? *status : context.fail(status.error());
}

}  // namespace volute::app

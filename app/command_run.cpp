// volute run: plan, post, simulate, report. The body reads as the way of one part through the program.
#include <chrono>
#include <nlohmann/json.hpp>

#include "app/commands.hpp"
#include "app/exit_status.hpp"
#include "app/output_folder.hpp"
#include "app/pipeline.hpp"
#include "app/report.hpp"
#include "app/result_files.hpp"
#include "app/run_table.hpp"

namespace volute::app {

namespace {

using geometry::Result;

/// Time by the clock.
class Stopwatch {
 public:
  [[nodiscard]] double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
  /// Since the last lap, and begins the next.
  double lap_s() {
    const double lap = seconds();
    start_ = Clock::now();
    return lap;
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

Json full_report(const JobInputs& inputs, const planner::PlanResult& plan, const post::PostResult& posted,
                 const sim::VerifyResult& verified, const std::string& program_name) {
  Json report;
  report["program"] = {{"file", program_name},
                       {"dialect", inputs.profile.control.name},
                       {"profile", inputs.profile.name},
                       {"blocks", posted.blocks},
                       {"bytes", posted.text.size()}};
  Json planned = plan_json(plan);
  report["surface"] = planned["surface"];
  report["path"] = planned["path"];
  report["orientation"] = planned["orientation"];
  const Json judged = verify_json(verified, inputs.profile, plan.orientation.interferences_after);
  for (const char* key : {"run", "machining", "stock", "collision", "loads", "findings", "warnings"})
    if (judged.contains(key)) report[key] = judged[key];
  put_machining_feed(report, plan.tool_path, verified);
  report["timing"] = planned["timing"];
  report["timing"].update(judged["timing"]);
  return report;
}

Result<std::vector<std::string>> write_results(const OutputFolder& out, const JobInputs& inputs,
                                               const sim::VerifyResult& verified, view::RunView& view, Json& report,
                                               const Stopwatch& watch) {
  view.report_json = without_seconds(report).dump(2);
  auto pictures = write_result_files(out, view, verified, inputs.job.spindle_rpm);
  if (!pictures) return pictures;
  report["timing"]["pictures and files"] = watch.seconds();
  if (auto written = out.write("report.json", report.dump(2) + "\n"); !written) return tl::unexpected(written.error());
  return pictures;
}

/// The program under the name that its verdict gives it, and what was planned.
Result<std::string> write_program(const OutputFolder& out, const JobInputs& inputs, const planner::PlanResult& plan,
                                  const post::PostResult& posted, bool passed) {
  const auto program =
      out.write_program(inputs.job.name, inputs.profile.control.program_extension, posted.text, passed);
  if (!program) return program;
  if (auto written = out.write("toolpath.cls", cl_text(inputs, plan)); !written) return tl::unexpected(written.error());
  if (auto written = out.write("plan.json", plan_json(plan).dump(2) + "\n"); !written)
    return tl::unexpected(written.error());
  return program;
}

Result<int> run(const RunArguments& arguments, Context& context) {
  Stopwatch watch;
  const auto inputs = load_inputs(arguments.job, context);
  if (!inputs) return tl::unexpected(inputs.error());
  const path folder = arguments.out.empty() ? path(inputs->job.name) : arguments.out;
  if (auto possible = OutputFolder::check(folder); !possible) return tl::unexpected(possible.error());
  context.warn(inputs->warnings);
  const double inputs_s = watch.lap_s();
  const auto plan = plan_job(*inputs, context.progress());
  if (!plan) return tl::unexpected(plan.error());
  context.warn(plan->cc.report.notes);
  context.warn(plan->orientation.notes);
  watch.lap_s();
  const auto posted = post_job(*inputs, *plan);
  if (!posted) return tl::unexpected(posted.error());
  const double posted_s = watch.lap_s();
  const auto verified = verify_job(*inputs, *plan, *posted, context.progress(), true);
  if (!verified) return tl::unexpected(verified.error());
  context.warn(texts(verified->warnings));
  watch.lap_s();

  const auto out = OutputFolder::make(folder);
  if (!out) return tl::unexpected(out.error());
  const bool passed = verified->findings.empty();
  context.progress().report("pictures and files", 0.0);
  const auto program = write_program(*out, *inputs, *plan, *posted, passed);
  if (!program) return tl::unexpected(program.error());
  Json report = full_report(*inputs, *plan, *posted, *verified, *program);
  report["timing"]["inputs"] = inputs_s;
  report["timing"]["post"] = posted_s;
  view::RunView view = run_view(*inputs, *plan, *posted, *verified);
  view.program_name = *program;
  const auto pictures = write_results(*out, *inputs, *verified, view, report, watch);
  if (!pictures) return tl::unexpected(pictures.error());
  context.print(report, run_table(report, out->folder(), *pictures));
  return passed ? exit_clean : exit_found;
}

}  // namespace

int run_command(const RunArguments& arguments, Context& context) {
  const auto status = run(arguments, context);
  return status ? *status : context.fail(status.error());
}

}  // namespace volute::app

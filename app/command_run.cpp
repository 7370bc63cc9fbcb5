// volute run: plan, post, simulate, report. The body reads as the way of one part through the program.
#include <nlohmann/json.hpp>

#include "app/commands.hpp"
#include "app/exit_status.hpp"
#include "app/material_files.hpp"
#include "app/output_folder.hpp"
#include "app/pipeline.hpp"
#include "app/report.hpp"
#include "app/run_table.hpp"

namespace volute::app {

namespace {

using geometry::Result;

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
  report["timing"] = planned["timing"];
  report["timing"].update(judged["timing"]);
  return report;
}

Result<std::vector<std::string>> write_results(const OutputFolder& out, view::RunView& view, const Json& report) {
  view.report_json = without_seconds(report).dump(2);
  if (auto written = out.write("report.json", report.dump(2) + "\n"); !written) return tl::unexpected(written.error());
  if (auto saved = view::save_view(view, out.folder()); !saved) return tl::unexpected(saved.error());
  auto pictures = view::write_pictures(view, out.folder());
  if (!pictures) return pictures;
  if (auto page = view::write_report_html(view, out.file("report.html")); !page) return tl::unexpected(page.error());
  return pictures;
}

Result<int> run(const RunArguments& arguments, Context& context) {
  const auto inputs = load_inputs(arguments.job, context);
  if (!inputs) return tl::unexpected(inputs.error());
  context.warn(inputs->warnings);
  const auto plan = plan_job(*inputs, context.progress());
  if (!plan) return tl::unexpected(plan.error());
  context.warn(plan->cc.report.notes);
  context.warn(plan->orientation.notes);
  const auto posted = post_job(*inputs, *plan);
  if (!posted) return tl::unexpected(posted.error());
  const auto verified = verify_job(*inputs, *plan, *posted, context.progress(), true);
  if (!verified) return tl::unexpected(verified.error());
  context.warn(texts(verified->warnings));

  const auto out = OutputFolder::make(arguments.out.empty() ? path(inputs->job.name) : arguments.out);
  if (!out) return tl::unexpected(out.error());
  const bool passed = verified->findings.empty();
  const auto program =
      out->write_program(inputs->job.name, inputs->profile.control.program_extension, posted->text, passed);
  if (!program) return tl::unexpected(program.error());
  if (auto written = out->write("toolpath.cls", cl_text(*inputs, *plan)); !written)
    return tl::unexpected(written.error());
  if (auto written = out->write("plan.json", plan_json(*plan).dump(2) + "\n"); !written)
    return tl::unexpected(written.error());

  if (auto written = write_material(*verified, inputs->job.tool.cutter, inputs->job.spindle_rpm, *out); !written)
    return tl::unexpected(written.error());

  const Json report = full_report(*inputs, *plan, *posted, *verified, *program);
  view::RunView view = run_view(*inputs, *plan, *posted, *verified);
  view.program_name = *program;
  context.progress().report("pictures", 0.0);
  const auto pictures = write_results(*out, view, report);
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

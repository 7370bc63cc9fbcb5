// volute plan: the tool path only.
#include <nlohmann/json.hpp>

#include "app/commands.hpp"
#include "app/exit_status.hpp"
#include "app/output_folder.hpp"
#include "app/pipeline.hpp"
#include "app/report.hpp"
#include "app/run_table.hpp"

namespace volute::app {

namespace {

geometry::Result<int> plan(const PlanArguments& arguments, Context& context) {
  const auto inputs = load_inputs(arguments.job, context);
  if (!inputs) return tl::unexpected(inputs.error());
  const path folder = arguments.out.empty() ? path(inputs->job.name) : arguments.out;
  if (auto possible = OutputFolder::check(folder); !possible) return tl::unexpected(possible.error());
  context.warn(inputs->warnings);
  const auto planned = plan_job(*inputs, context.progress());
  if (!planned) return tl::unexpected(planned.error());
  context.warn(planned->cc.report.notes);
  context.warn(planned->orientation.notes);
  const auto out = OutputFolder::make(folder);
  if (!out) return tl::unexpected(out.error());
  const Json report = plan_json(*planned);
  if (auto written = out->write("toolpath.cls", cl_text(*inputs, *planned)); !written)
    return tl::unexpected(written.error());
  if (auto written = out->write("plan.json", report.dump(2) + "\n"); !written) return tl::unexpected(written.error());
  context.print(report, plan_table(report, out->folder()));
  return exit_clean;
}

}  // namespace

int plan_command(const PlanArguments& arguments, Context& context) {
  const auto status = plan(arguments, context);
  return status ? *status : context.fail(status.error());
}

}  // namespace volute::app

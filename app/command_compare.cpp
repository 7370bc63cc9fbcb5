// volute compare: one part, several strategies, one table: the columns of Table 2 of [Sun2016].
#include <nlohmann/json.hpp>

#include "app/commands.hpp"
#include "app/exit_status.hpp"
#include "app/output_folder.hpp"
#include "app/pipeline.hpp"
#include "app/report.hpp"
#include "geometry/number_text.hpp"
#include "view/comparison_html.hpp"
#include "view/figure_sheet.hpp"
#include "view/pictures.hpp"

namespace volute::app {

namespace {

using geometry::fixed_text;
using geometry::Result;
using planner::Strategy;

struct NamedStrategy {
  const char* name;
  Strategy strategy;
};
constexpr std::array<NamedStrategy, 5> all_strategies{{{"contour-parallel", Strategy::contour_parallel},
                                                       {"projected-spiral", Strategy::projected_spiral},
                                                       {"contour-offset", Strategy::contour_offset},
                                                       {"iso-planar", Strategy::iso_planar},
                                                       {"spiral", Strategy::spiral}}};
/// What Table 2 compares.
const std::vector<std::string> table_2_strategies{"contour-offset", "projected-spiral", "spiral"};

Result<std::vector<NamedStrategy>> chosen(const std::vector<std::string>& names) {
  std::vector<NamedStrategy> list;
  for (const std::string& name : names.empty() ? table_2_strategies : names) {
    const auto* found = std::find_if(all_strategies.begin(), all_strategies.end(),
                                     [&](const NamedStrategy& s) { return name == s.name; });
    if (found == all_strategies.end())
      return geometry::bad_input(
          "strategy-unknown",
          "--strategies " + name +
              ": is none of contour-parallel, projected-spiral, contour-offset, iso-planar, spiral");
    list.push_back(*found);
  }
  return list;
}

/// The columns of Table 2, and length and time. "loss %": of feed moves; "all %": over the whole machining time.
const std::vector<std::string> table_heading{"rapids",    "lifts",       "links",  "corners", "uncut",
                                             "length mm", "feed mm/min", "loss %", "all %",   "time s"};

std::vector<std::string> table_cells(const Json& row) {
  const Json& path = row["path"];
  const Json& run = row["run"];
  const bool uncut = row.contains("machining") && row["machining"]["uncut"].get<bool>();
  const auto count = [&](const char* key) { return std::to_string(path[key].get<int>()); };
  return {count("rapid_traversals"),
          count("liftings"),
          count("linkings"),
          count("sharp_corners"),
          uncut ? "Y" : "N",
          fixed_text(path["length_mm"].get<double>(), 0),
          fixed_text(run["actual_feed_mm_min"].get<double>(), 1),
          fixed_text(run["feed_loss_percent"].get<double>(), 2),
          run.contains("machining_feed_loss_percent") ? fixed_text(run["machining_feed_loss_percent"].get<double>(), 2)
                                                      : "-",
          fixed_text(run["cycle_time_s"].get<double>(), 1)};
}

/// The strategy's part of the joint page.
Result<view::ComparedRun> compared_run(const view::RunView& view, const NamedStrategy& strategy, const Json& report) {
  view::ComparedRun run{strategy.name, view.findings.empty(), {}, table_cells(report), {}, {}};
  run.verdict = view.findings.empty()
                    ? "The virtual machine found nothing wrong."
                    : std::to_string(view.findings.size()) + " findings. " + view.findings.front().text;
  run.report_link = std::string(strategy.name) + "/report.html";
  const view::PictureStyle style = view::panel_style(720, 540);
  if (auto added = view::add_panel(run.pictures, "path on the part", view::path_picture(view, style)); !added)
    return tl::unexpected(added.error());
  if (auto added = view::add_panel(run.pictures, "feed that the machine reached",
                                   view::coloured_path_picture(view, view::PathColour::feed, style));
      !added)
    return tl::unexpected(added.error());
  if (!view.cut || view.cut->vertex_deviation_mm.size() != view.surface_P.vertices_mm.size()) return run;
  if (auto added = view::add_panel(run.pictures, "machined surface: deviation", view::machined_picture(view, style));
      !added)
    return tl::unexpected(added.error());
  return run;
}

Result<Json> run_strategy(JobInputs& inputs, const NamedStrategy& strategy, const OutputFolder& out,
                          view::Comparison& page, Context& context) {
  inputs.job.path.strategy = strategy.strategy;
  const auto plan = plan_job(inputs, context.progress());
  if (!plan) return tl::unexpected(plan.error());
  const auto posted = post_job(inputs, *plan);
  if (!posted) return tl::unexpected(posted.error());
  const auto verified = verify_job(inputs, *plan, *posted, context.progress());
  if (!verified) return tl::unexpected(verified.error());
  const auto program =
      out.write_program(inputs.job.name + "-" + strategy.name, inputs.profile.control.program_extension, posted->text,
                        verified->findings.empty());
  if (!program) return tl::unexpected(program.error());
  Json report{{"strategy", strategy.name},
              {"program", {{"file", *program}, {"blocks", posted->blocks}, {"bytes", posted->text.size()}}}};
  report.update(plan_json(*plan));
  report.update(verify_json(*verified, inputs.profile, plan->orientation.interferences_after));
  put_machining_feed(report, plan->tool_path, *verified);
  view::RunView view = run_view(inputs, *plan, *posted, *verified);
  view.title = inputs.job.name + ", " + strategy.name + ", on " + inputs.profile.name;
  view.program_name = *program;
  view.report_json = without_seconds(report).dump(2);
  const auto folder = OutputFolder::make(out.file(strategy.name));
  if (!folder) return tl::unexpected(folder.error());
  if (auto written = folder->write("report.json", report.dump(2) + "\n"); !written)
    return tl::unexpected(written.error());
  if (auto pictures = view::write_pictures(view, folder->folder()); !pictures) return tl::unexpected(pictures.error());
  if (auto written = view::write_report_html(view, folder->file("report.html")); !written)
    return tl::unexpected(written.error());
  auto compared = compared_run(view, strategy, report);
  if (!compared) return tl::unexpected(compared.error());
  page.runs.push_back(std::move(*compared));
  return report;
}

std::string column(const std::string& text, std::size_t width) {
  return std::string(text.size() < width ? width - text.size() : 0, ' ') + text;
}

constexpr std::array<std::size_t, 10> column_widths{8, 7, 7, 9, 7, 11, 13, 9, 9, 9};

std::string table_2(const Json& rows) {
  std::string text = "  strategy          ";
  for (std::size_t i = 0; i < table_heading.size(); ++i) text += column(table_heading[i], column_widths[i]);
  text += "\n";
  for (const Json& row : rows) {
    const std::string name = row["strategy"].get<std::string>();
    text += "  " + name + std::string(name.size() < 18 ? 18 - name.size() : 1, ' ');
    if (row.contains("error")) {
      text += "  " + row["error"].get<std::string>() + "\n";
      continue;
    }
    const std::vector<std::string> cells = table_cells(row);
    for (std::size_t i = 0; i < cells.size(); ++i) text += column(cells[i], column_widths[i]);
    text += "\n";
  }
  return text;
}

Result<int> compare(const CompareArguments& arguments, Context& context) {
  const auto strategies = chosen(arguments.strategies);
  if (!strategies) return tl::unexpected(strategies.error());
  auto inputs = load_inputs(arguments.job, context);
  if (!inputs) return tl::unexpected(inputs.error());
  context.warn(inputs->warnings);
  const auto out = OutputFolder::make(arguments.out.empty() ? path(inputs->job.name + "-comparison") : arguments.out);
  if (!out) return tl::unexpected(out.error());
  Json rows = Json::array();
  view::Comparison page{inputs->job.name + " on " + inputs->profile.name + ": paths compared", table_heading, {}};
  for (const NamedStrategy& strategy : *strategies) {
    auto row = run_strategy(*inputs, strategy, *out, page, context);
    if (!row && row.error().kind == geometry::ErrorKind::system) return tl::unexpected(row.error());
    if (!row) page.runs.push_back({strategy.name, false, row.error().message, {}, {}, {}});
    rows.push_back(row ? *row : Json{{"strategy", strategy.name}, {"error", row.error().message}});
  }
  const Json report{{"job", inputs->job.name}, {"profile", inputs->profile.name}, {"strategies", rows}};
  if (auto written = out->write("comparison.json", report.dump(2) + "\n"); !written)
    return tl::unexpected(written.error());
  if (auto written = view::write_comparison_html(page, out->file("report.html")); !written)
    return tl::unexpected(written.error());
  context.print(report, table_2(rows) + "  report            " + out->file("report.html").string() + "\n");
  const bool found = std::any_of(rows.begin(), rows.end(),
                                 [](const Json& row) { return row.contains("error") || !row["findings"].empty(); });
  return found ? exit_found : exit_clean;
}

}  // namespace

int compare_command(const CompareArguments& arguments, Context& context) {
  const auto status = compare(arguments, context);
  return status ? *status : context.fail(status.error());
}

}  // namespace volute::app

// volute compare: one part, several strategies, one table: the columns of Table 2 of [Sun2016].
#include <nlohmann/json.hpp>

#include "app/commands.hpp"
#include "app/compared_path.hpp"
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

/// What Table 2 compares: what CAM systems give with their axes, the same paths with the job's, and the spiral.
const std::vector<std::string> table_2_paths{"contour-offset:normal", "projected-spiral:normal", "contour-offset",
                                             "projected-spiral", "spiral"};

Result<std::vector<ComparedPath>> chosen(const std::vector<std::string>& names) {
  std::vector<ComparedPath> list;
  for (const std::string& name : names.empty() ? table_2_paths : names) {
    auto path = compared_path(name);
    if (!path) return tl::unexpected(path.error());
    list.push_back(std::move(*path));
  }
  return list;
}

/// The columns of Table 2, and length and time.
const std::vector<std::string> table_heading{"rapids",      "lifts",  "links", "corners", "uncut", "length mm",
                                             "feed mm/min", "loss %", "all %", "least %", "time s"};

constexpr const char* table_legend =
    "loss %: of the feed moves. all %: of the whole machining; rapids, leads and linkings are time without length. "
    "least "
    "%: the same if no jerk were limited; a control that plans jerk along the path lies between.";

std::vector<std::string> table_cells(const Json& row) {
  const Json& path = row["path"];
  const Json& run = row["run"];
  const bool uncut = row.contains("machining") && row["machining"]["uncut"].get<bool>();
  const auto count = [&](const char* key) { return std::to_string(path[key].get<int>()); };
  constexpr const char* all = "machining_feed_loss_percent";
  const auto loss = [&](const Json& of, const char* key) {
    return of.contains(key) ? fixed_text(of[key].get<double>(), 2) : "-";
  };
  return {count("rapid_traversals"),
          count("liftings"),
          count("linkings"),
          count("sharp_corners"),
          uncut ? "Y" : "N",
          fixed_text(path["length_mm"].get<double>(), 0),
          fixed_text(run["actual_feed_mm_min"].get<double>(), 1),
          loss(run, "feed_loss_percent"),
          loss(run, all),
          run.contains("unlimited_jerk") ? loss(run["unlimited_jerk"], all) : "-",
          fixed_text(run["cycle_time_s"].get<double>(), 1)};
}

/// The path's part of the joint page.
Result<view::ComparedRun> compared_run(const view::RunView& view, const ComparedPath& compared, const Json& report) {
  view::ComparedRun run{compared.name, view.findings.empty(), {}, table_cells(report), {}, {}};
  run.verdict = view.findings.empty()
                    ? "The virtual machine found nothing wrong."
                    : std::to_string(view.findings.size()) +
                          (view.findings.size() == 1 ? " finding. " : " findings. ") + view.findings.front().text;
  run.report_link = compared.folder + "/report.html";
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

Result<Json> run_path(const JobInputs& given, const ComparedPath& compared, const OutputFolder& out,
                      view::Comparison& page, Context& context) {
  const JobInputs inputs = with_path(given, compared.strategy, compared.axis);
  const auto plan = plan_job(inputs, context.progress());
  if (!plan) return tl::unexpected(plan.error());
  const auto posted = post_job(inputs, *plan);
  if (!posted) return tl::unexpected(posted.error());
  const auto verified = verify_job(inputs, *plan, *posted, context.progress());
  if (!verified) return tl::unexpected(verified.error());
  const auto program =
      out.write_program(inputs.job.name + "-" + compared.folder, inputs.profile.control.program_extension, posted->text,
                        verified->findings.empty());
  if (!program) return tl::unexpected(program.error());
  Json report{{"strategy", compared.name},
              {"program", {{"file", *program}, {"blocks", posted->blocks}, {"bytes", posted->text.size()}}}};
  report.update(plan_json(*plan));
  report.update(verify_json(*verified, inputs.profile, plan->orientation.interferences_after));
  put_machining_feed(report, plan->tool_path, *verified);
  view::RunView view = run_view(inputs, *plan, *posted, *verified);
  view.title = inputs.job.name + ", " + compared.name + ", on " + inputs.profile.name;
  view.program_name = *program;
  view.report_json = without_seconds(report).dump(2);
  const auto folder = OutputFolder::make(out.file(compared.folder));
  if (!folder) return tl::unexpected(folder.error());
  if (auto written = folder->write("report.json", report.dump(2) + "\n"); !written)
    return tl::unexpected(written.error());
  if (auto pictures = view::write_pictures(view, folder->folder()); !pictures) return tl::unexpected(pictures.error());
  if (auto written = view::write_report_html(view, folder->file("report.html")); !written)
    return tl::unexpected(written.error());
  auto run = compared_run(view, compared, report);
  if (!run) return tl::unexpected(run.error());
  page.runs.push_back(std::move(*run));
  return report;
}

std::string column(const std::string& text, std::size_t width) {
  return std::string(text.size() < width ? width - text.size() : 0, ' ') + text;
}

constexpr std::array<std::size_t, 11> column_widths{8, 7, 7, 9, 7, 11, 13, 9, 9, 9, 9};

constexpr std::size_t name_width = 24;

std::string table_2(const Json& rows) {
  std::string text = "  path" + std::string(name_width - 4, ' ');
  for (std::size_t i = 0; i < table_heading.size(); ++i) text += column(table_heading[i], column_widths[i]);
  text += "\n";
  for (const Json& row : rows) {
    const std::string name = row["strategy"].get<std::string>();
    text += "  " + name + std::string(name.size() < name_width ? name_width - name.size() : 1, ' ');
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
  const auto paths = chosen(arguments.strategies);
  if (!paths) return tl::unexpected(paths.error());
  auto inputs = load_inputs(arguments.job, context);
  if (!inputs) return tl::unexpected(inputs.error());
  context.warn(inputs->warnings);
  const auto out = OutputFolder::make(arguments.out.empty() ? path(inputs->job.name + "-comparison") : arguments.out);
  if (!out) return tl::unexpected(out.error());
  Json rows = Json::array();
  view::Comparison page{
      inputs->job.name + " on " + inputs->profile.name + ": paths compared", table_heading, {}, table_legend};
  for (const ComparedPath& compared : *paths) {
    auto row = run_path(*inputs, compared, *out, page, context);
    if (!row && row.error().kind == geometry::ErrorKind::system) return tl::unexpected(row.error());
    if (!row) page.runs.push_back({compared.name, false, row.error().message, {}, {}, {}});
    rows.push_back(row ? *row : Json{{"strategy", compared.name}, {"error", row.error().message}});
  }
  const Json report{{"job", inputs->job.name}, {"profile", inputs->profile.name}, {"strategies", rows}};
  if (auto written = out->write("comparison.json", report.dump(2) + "\n"); !written)
    return tl::unexpected(written.error());
  if (auto written = view::write_comparison_html(page, out->file("report.html")); !written)
    return tl::unexpected(written.error());
  context.print(report, table_2(rows) + "  " + table_legend + "\n  report            " +
                            out->file("report.html").string() + "\n");
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

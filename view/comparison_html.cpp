#include "view/comparison_html.hpp"

#include <algorithm>

#include "geometry/check.hpp"
#include "geometry/file.hpp"
#include "view/html.hpp"
#include "view/packed_data.hpp"
#include "view/page_asset.hpp"

namespace volute::view {

namespace {

constexpr const char* own_style =
    ".compared{display:grid;grid-template-columns:repeat(auto-fit,minmax(320px,1fr));gap:12px}.compared "
    "figure{margin:0}"
    ".compared img{width:100%;border:1px solid var(--line);border-radius:8px}.compared "
    "figcaption{color:var(--soft);font-size:13px}"
    ".wide{overflow-x:auto}.wide td{text-align:right;white-space:nowrap}.wide td:first-child{text-align:left}";

std::string row_text(const ComparedRun& run, std::size_t columns) {
  std::string text = "<tr><td>";
  text += run.report_link.empty()
              ? html_escaped(run.name)
              : "<a href=\"" + html_escaped(run.report_link) + "\">" + html_escaped(run.name) + "</a>";
  text += "</td>";
  if (run.cells.empty())
    return text + "<td colspan=\"" + std::to_string(columns) + "\">" + html_escaped(run.verdict) + "</td></tr>\n";
  for (const std::string& cell : run.cells) text += "<td>" + html_escaped(cell) + "</td>";
  return text + "</tr>\n";
}

std::string table_text(const Comparison& comparison) {
  std::string text = "<div class=\"wide\"><table id=\"comparison\"><tr><th>path</th>";
  for (const std::string& name : comparison.heading) text += "<th>" + html_escaped(name) + "</th>";
  text += "</tr>\n";
  for (const ComparedRun& run : comparison.runs) text += row_text(run, comparison.heading.size());
  text += "</table></div>\n";
  if (!comparison.legend.empty()) text += "<p>" + html_escaped(comparison.legend) + "</p>\n";
  return text;
}

std::string run_text(const ComparedRun& run) {
  std::string text = "<h2>" + html_escaped(run.name) + "</h2><p class=\"" + (run.passed ? "passed" : "rejected") +
                     "\">" + html_escaped(run.verdict) + "</p>\n<div class=\"compared\">";
  for (const FigurePanel& picture : run.pictures) {
    const std::string name = html_escaped(picture.caption);
    text += "<figure><img alt=\"" + html_escaped(run.name) + ": " + name + "\" src=\"data:image/png;base64," +
            base64_text(png_bytes(picture.image)) + "\"><figcaption>" + name + "</figcaption></figure>\n";
  }
  text += "</div>\n";
  if (!run.report_link.empty())
    text += "<p><a href=\"" + html_escaped(run.report_link) + "\">Playback, plots and findings of this run</a></p>\n";
  return text;
}

}  // namespace

geometry::Result<void> write_comparison_html(const Comparison& comparison, const std::filesystem::path& file) {
  for (const ComparedRun& run : comparison.runs)
    VOLUTE_CHECK(run.cells.empty() || run.cells.size() == comparison.heading.size(), run.cells.size());
  const auto passed =
      std::count_if(comparison.runs.begin(), comparison.runs.end(), [](const auto& r) { return r.passed; });
  const std::string title = html_escaped(comparison.title);
  std::string page =
      "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
      "content=\"width=device-width,initial-scale=1\"><link rel=\"icon\" href=\"data:,\"><title>" +
      title + "</title>\n<style>";
  page.append(page_style());
  page += std::string(own_style) + "</style></head>\n<body><header><h1>" + title + "</h1><p id=\"verdict\" class=\"" +
          (passed == static_cast<std::ptrdiff_t>(comparison.runs.size()) ? "passed" : "rejected") + "\">" +
          std::to_string(passed) + " of " + std::to_string(comparison.runs.size()) +
          " passed on the virtual machine.</p></header>\n<main>\n" + table_text(comparison);
  for (const ComparedRun& run : comparison.runs) page += run_text(run);
  return geometry::write_file(file, page + "</main></body></html>\n");
}

}  // namespace volute::view

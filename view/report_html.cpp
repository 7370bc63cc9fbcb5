// report.html: one page that needs no network. The numbers stand in it as JSON, the rest as packed data; view/page
// shows them.
#include "geometry/file.hpp"
#include "view/figure_sheet.hpp"
#include "view/html.hpp"
#include "view/packed_data.hpp"
#include "view/page_asset.hpp"
#include "view/pictures.hpp"
#include "view/report_data.hpp"
#include "view/run_view.hpp"
#include "view/trace_store.hpp"

namespace volute::view {

namespace {

// As wide as the live view in a usual window; few shades: it is looked at for a second or two.
constexpr int still_width = 880, still_height = 560, still_shades = 32;

/// JSON inside a script element: nothing in it may end the element.
std::string safe_json(const std::string& json) {
  std::string out;
  out.reserve(json.size());
  for (const char c : json) c == '<' ? out += "\\u003c" : out += c;
  return out;
}

std::string verdict_text(const RunView& view) {
  if (view.findings.empty()) return "PASSED: the virtual machine found nothing wrong.";
  return "REJECTED: " + std::to_string(view.findings.size()) +
         (view.findings.size() == 1 ? " finding. " : " findings. ") + view.findings.front().text;
}

std::string data_element(const PagePart& part) {
  return std::string("<script id=\"data-") + part.id + "\" type=\"" +
         (part.packed ? "text/plain" : "application/json") + "\">" + (part.packed ? part.text : safe_json(part.text)) +
         "</script>\n";
}

RunView with_trace_as_stored(RunView view) {
  view.trace = trace_as_stored(view.trace);
  return view;
}

/// The part with its path, as a picture in the page: in sight before the live view is, and where scripts are off.
Result<std::string> still_picture(const RunView& view) {
  const bool drawable = !view.surface_P.triangles.empty() || (view.profile && !view.trace.samples.empty());
  if (!drawable) return std::string();
  const PictureStyle style = panel_style(still_width, still_height);
  // Without a plan the trace is drawn, as it is kept: `volute render` then makes the same bytes.
  const bool planned = !view.tool_path.points.empty();
  auto picture = planned ? path_picture(view, style) : path_picture(with_trace_as_stored(view), style);
  if (!picture) return tl::unexpected(picture.error());
  round_shades(*picture, still_shades);
  return "<img id=\"still\" alt=\"the part with the path\" width=\"" + std::to_string(still_width) + "\" height=\"" +
         std::to_string(still_height) + "\" src=\"data:image/png;base64," + base64_text(png_bytes(*picture)) + "\">";
}

/// What stands in the page before its program runs, and all of it where scripts are off.
std::string first_words(const RunView& view, const std::string& still) {
  return "<header><h1>" + html_escaped(view.title) + "</h1><p id=\"verdict\" class=\"" +
         (view.findings.empty() ? "passed" : "rejected") + "\">" + html_escaped(verdict_text(view)) +
         "</p></header>\n<main id=\"page\">" + still +
         "<noscript>The figures, the playback and the plots need JavaScript. " +
         "The same numbers stand in report.json beside this file.</noscript></main>\n";
}

}  // namespace

std::string html_escaped(std::string_view text) {
  std::string out;
  for (const char c : text)
    out += c == '<' ? "&lt;" : c == '&' ? "&amp;" : c == '>' ? "&gt;" : c == '"' ? "&quot;" : std::string(1, c);
  return out;
}

Result<void> write_report_html(const RunView& view, const std::filesystem::path& file) {
  const auto still = still_picture(view);
  if (!still) return tl::unexpected(still.error());
  std::string page =
      "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
      "content=\"width=device-width,initial-scale=1\">"
      "<link rel=\"icon\" href=\"data:,\"><title>" +
      html_escaped(view.title) + "</title>\n<style>";
  page.append(page_style());
  page += "</style></head>\n<body>\n" + first_words(view, *still);
  for (const PagePart& part : page_parts(view)) page += data_element(part);
  page += "<script>";
  page.append(page_script());
  page += "</script>\n</body></html>\n";
  return geometry::write_file(file, page);
}

}  // namespace volute::view

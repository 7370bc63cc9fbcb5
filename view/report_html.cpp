// report.html: one page that needs no network.
#include <nlohmann/json.hpp>

#include "geometry/file.hpp"
#include "geometry/number_text.hpp"
#include "view/axis_plots.hpp"
#include "view/run_view.hpp"

namespace volute::view {

namespace {

using Json = nlohmann::ordered_json;

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) out += c == '<' ? "&lt;" : c == '&' ? "&amp;" : c == '>' ? "&gt;" : c == '"' ? "&quot;" : std::string(1, c);
  return out;
}

std::string value_text(const Json& value) {
  if (value.is_number_float()) return geometry::short_text(value.get<double>());
  if (value.is_string()) return escaped(value.get<std::string>());
  return escaped(value.dump());
}

/// Nested objects become dotted names: run.axes.X.velocity_max.
void add_rows(std::string& out, const Json& object, const std::string& prefix) {
  for (const auto& [key, value] : object.items()) {
    if (value.is_object()) add_rows(out, value, prefix + key + ".");
    else if (!value.is_array()) out += "<tr><td>" + escaped(prefix + key) + "</td><td>" + value_text(value) + "</td></tr>\n";
  }
}

std::string findings_table(const std::vector<sim::Finding>& findings) {
  if (findings.empty()) return "<p class=\"good\">PASSED: the virtual machine found nothing wrong.</p>\n";
  std::string out = "<p class=\"bad\">REJECTED: " + std::to_string(findings.size()) + " finding(s).</p>\n<table><tr><th>line</th><th>kind</th><th>what</th></tr>\n";
  for (const sim::Finding& finding : findings)
    out += "<tr><td>" + std::to_string(finding.line) + "</td><td>" + escaped(finding.kind) + "</td><td>" + escaped(finding.text) + "</td></tr>\n";
  return out + "</table>\n";
}

constexpr const char* page_style =
    "body{font-family:sans-serif;max-width:1200px;margin:2em auto;padding:0 1em;color:#222}table{border-collapse:collapse}"
    "td,th{border:1px solid #ccc;padding:.25em .7em;text-align:left}.good{color:#00683f;font-weight:bold}.bad{color:#b00020;font-weight:bold}svg{width:100%}";

}  // namespace

Result<void> write_report_html(const RunView& view, const std::filesystem::path& file) {
  std::string page = "<!doctype html><html lang=\"en\"><head><meta charset=\"utf-8\"><title>" + escaped(view.title) + "</title><style>" + page_style +
                     "</style></head><body>\n<h1>" + escaped(view.title) + "</h1>\n" + findings_table(view.findings);
  if (view.profile && !view.trace.samples.empty()) page += svg_text(rotary_plot(view)) + svg_text(feed_plot(view));
  page += "<h2>Numbers</h2>\n<table>\n";
  if (const Json report = Json::parse(view.report_json, nullptr, false); report.is_object()) add_rows(page, report, "");
  page += "</table>\n</body></html>\n";
  return geometry::write_file(file, page);
}

}  // namespace volute::view

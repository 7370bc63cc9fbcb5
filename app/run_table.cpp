#include "app/run_table.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "geometry/number_text.hpp"

namespace volute::app {

namespace {

using geometry::fixed_text;
using geometry::short_text;
using Json = nlohmann::ordered_json;

constexpr std::size_t name_width = 26;
constexpr std::size_t findings_shown = 8;

std::string number(const Json& object, const char* key, int decimals) {
  return object.contains(key) ? fixed_text(object[key].get<double>(), decimals) : "-";
}

std::string time_text(double seconds) {
  if (seconds < 59.95) return fixed_text(seconds, 1) + " s";
  const long whole = std::lround(seconds);
  return std::to_string(whole / 60) + " min " + std::to_string(whole % 60) + " s";
}

/// What the jerk limits add to the time, where that is worth a line.
std::string unlimited_jerk_row(const Json& run) {
  constexpr double told_from = 1.005;
  if (!run.contains("unlimited_jerk")) return {};
  const Json& free = run["unlimited_jerk"];
  const double least_s = free["cycle_time_s"].get<double>();
  if (run["cycle_time_s"].get<double>() < told_from * least_s) return {};
  return table_row("if jerk were not limited", time_text(least_s) + ", loss " + number(free, "feed_loss_percent", 2) +
                                                   " %; a control that plans jerk along the path lies between");
}

std::string path_rows(const Json& path) {
  std::string text = table_row("path", path["strategy"].get<std::string>() +
                                           (path.contains("method") ? ", " + path["method"].get<std::string>() : "") +
                                           ", " + std::to_string(path["cc_points"].get<int>()) + " CC points, " +
                                           std::to_string(path["pieces"].get<int>()) + " piece(s)");
  text += table_row("length", number(path, "length_mm", 0) + " mm, " + number(path, "length_ratio", 3) +
                                  " times the scallop lower bound");
  if (path.contains("scallop_ratio_max"))
    text += table_row("scallop / allowed", number(path, "scallop_ratio_p9999", 3) + " at 99.99 %, " +
                                               number(path, "scallop_ratio_max", 3) + " at most");
  text += table_row("retracts, links, corners",
                    std::to_string(path["rapid_traversals"].get<int>()) + " rapid traversals, " +
                        std::to_string(path["liftings"].get<int>()) + " liftings, " +
                        std::to_string(path["linkings"].get<int>()) + " linkings, " +
                        std::to_string(path["sharp_corners"].get<int>()) + " sharp corners");
  return text;
}

std::string orientation_rows(const Json& orientation) {
  std::string text =
      table_row("orientation", orientation["smoothing"].get<std::string>() + ", " +
                                   std::to_string(orientation["pins"].get<int>()) + " pins, interferences " +
                                   std::to_string(orientation["interferences_before"].get<int>()) + " -> " +
                                   std::to_string(orientation["interferences_after"].get<int>()));
  return text;
}

std::string run_rows(const Json& run) {
  std::string text = table_row("cycle time", time_text(run["cycle_time_s"].get<double>()));
  text += table_row("feed, programmed", number(run, "programmed_feed_mm_min", 1) + " mm/min");
  text += table_row("feed, actual", number(run, "actual_feed_mm_min", 1) + " mm/min (loss " +
                                        number(run, "feed_loss_percent", 2) + " %)");
  if (run.contains("machining_feed_loss_percent"))
    text += table_row("feed, whole machining", number(run, "machining_feed_mm_min", 1) + " mm/min (loss " +
                                                   number(run, "machining_feed_loss_percent", 2) +
                                                   " %: leads, linkings and rapids are time without length)");
  text += unlimited_jerk_row(run);
  text += "\n  axis    velocity   acceleration        jerk   lag max   of limit\n";
  for (const auto& [letter, peaks] : run["axes"].items()) {
    const bool rotary = letter == "A" || letter == "B" || letter == "C";
    const auto cell = [&](const char* key, std::size_t width, int digits) {
      const std::string value = short_text(peaks[key].get<double>(), digits);
      return std::string(value.size() < width ? width - value.size() : 0, ' ') + value;
    };
    text += "  " + letter + cell("velocity_max", 15, 4) + cell("acceleration_max", 15, 4) + cell("jerk_max", 12, 4) +
            cell("following_error_max", 10, 3) + cell("limit_ratio_max", 11, 3) + (rotary ? "   (deg)\n" : "   (mm)\n");
  }
  return text + "\n";
}

std::string stock_row(const Json& stock) {
  std::string text = number(stock, "removed_mm3", 0) + " of " + number(stock, "first_mm3", 0) + " mm3 removed";
  if (stock.contains("removal_rate_max_mm3_s"))
    text += ", at most " + number(stock, "removal_rate_max_mm3_s", 1) + " mm3/s in line " +
            std::to_string(stock["removal_rate_at_block"].get<long>());
  return table_row("stock", text + (stock["assumed"].get<bool>() ? " (a full block, as none is given)" : ""));
}

std::string machining_rows(const Json& report) {
  std::string text;
  if (report.contains("machining")) {
    const Json& cut = report["machining"];
    text += table_row("scallop left", number(cut, "scallop_p99_mm", 4) + " mm at 99 %, " +
                                          number(cut, "scallop_max_mm", 4) + " mm at most");
    text += table_row("gouge", number(cut, "gouge_max_mm", 4) + " mm");
    text += table_row("uncut", cut["uncut"].get<bool>() ? number(cut, "uncut_area_mm2", 2) + " mm2"
                               : cut["uncut_area_mm2"].get<double>() < 1.0
                                   ? "none"
                                   : number(cut, "uncut_area_mm2", 0) + " mm2, left on purpose");
  }
  if (report.contains("stock")) text += stock_row(report["stock"]);
  if (report.contains("collision")) {
    const Json& collision = report["collision"];
    const std::string planned = collision.contains("planner_hits")
                                    ? ", " + std::to_string(collision["planner_hits"].get<int>()) + " in the planner"
                                    : "";
    text +=
        table_row("collisions", std::to_string(collision["sim_hits"].get<int>()) + " on the virtual machine" + planned);
    if (!collision["closest_pair"].get<std::string>().empty())
      text += table_row("closest", number(collision, "closest_mm", 3) + " mm, " +
                                       collision["closest_pair"].get<std::string>() + ", line " +
                                       std::to_string(collision["at_block"].get<long>()));
  }
  return text;
}

/// Texts of findings at a line begin with it; what holds for the whole program has no line.
std::string finding_row(const Json& finding) {
  const long line = finding["block"].get<long>();
  const std::string text = finding["text"].get<std::string>();
  const bool told = line == 0 || text.starts_with("line " + std::to_string(line) + ":");
  return "  " + (told ? "" : "line " + std::to_string(line) + ": ") + finding["kind"].get<std::string>() + ": " + text +
         "\n";
}

std::string finding_rows(const Json& findings) {
  std::string text;
  for (std::size_t i = 0; i < std::min(findings.size(), findings_shown); ++i) text += finding_row(findings[i]);
  if (findings.size() > findings_shown)
    text += "  ... and " + std::to_string(findings.size() - findings_shown) + " more in report.json\n";
  return text;
}

/// A program that Volute made is kept under another name when it fails; one of others is only judged.
std::string verdict(const Json& report) {
  const Json& findings = report["findings"];
  const std::size_t warnings = report.contains("warnings") ? report["warnings"].size() : 0;
  if (findings.empty())
    return warnings == 0 ? "PASSED: the virtual machine found nothing wrong.\n"
                         : "PASSED: the virtual machine found nothing wrong; " + std::to_string(warnings) +
                               " warning(s):\n" + finding_rows(report["warnings"]);
  const std::string count = std::to_string(findings.size()) + " finding(s)";
  return (report.contains("path") ? "REJECTED: " + count + "; the program keeps .rejected in its name.\n"
                                  : "FOUND: " + count + ".\n") +
         finding_rows(findings) +
         (warnings == 0 ? "" : std::to_string(warnings) + " warning(s):\n" + finding_rows(report["warnings"]));
}

}  // namespace

std::string table_row(const std::string& name, const std::string& value) {
  return "  " + name + std::string(name.size() < name_width ? name_width - name.size() : 1, ' ') + value + "\n";
}

std::string plan_table(const Json& report, const std::filesystem::path& folder) {
  return path_rows(report["path"]) + orientation_rows(report["orientation"]) +
         table_row("tool path", (folder / "toolpath.cls").string());
}

std::string run_table(const Json& report, const std::filesystem::path& folder,
                      const std::vector<std::string>& pictures) {
  std::string text;
  if (report.contains("program")) {
    const Json& program = report["program"];
    text += table_row("program", (folder / program["file"].get<std::string>()).string() + ", " +
                                     std::to_string(program["blocks"].get<long>()) + " blocks, " +
                                     program["dialect"].get<std::string>());
  }
  if (report.contains("path")) text += path_rows(report["path"]);
  if (report.contains("orientation")) text += orientation_rows(report["orientation"]);
  if (report.contains("run")) text += run_rows(report["run"]);
  text += machining_rows(report);
  text += table_row("report", (folder / "report.html").string());
  std::string names;
  for (const std::string& picture : pictures) names += (names.empty() ? "" : ", ") + picture;
  if (!names.empty()) text += table_row("pictures", names);
  return text + "\n" + verdict(report);
}

}  // namespace volute::app

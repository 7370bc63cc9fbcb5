#include "app/reproduce/document.hpp"

namespace volute::app {

namespace {

constexpr std::string_view mark_begin = "<!-- volute reproduce ", mark_end = " -->\n", mark_last = "<!-- end -->\n";

constexpr const char* preface =
    "# The papers' tables and figures, made again\n\n"
    "Written by `volute reproduce --out docs`; one item alone by `volute reproduce table-2 --out docs`. [Sun2016]: "
    "Sun, Xu, Jin, Guo, "
    "Smooth tool path generation for 5-axis machining of triangular mesh surface with nonzero genus, Computer-Aided "
    "Design "
    "79 (2016). [Huang2016]: Huang, Zhang, Gong, Li, Fang, Wang, Constructing smooth tool orientation field based on "
    "radial "
    "basis function for 5-axis machining, Int. J. Adv. Manuf. Technol. (2016).\n\n"
    "Neither paper publishes its models, its machine or its control. All parts here are the project's own examples, "
    "with "
    "sizes and features like those that the figures show, on the profile `ac-head-fanuc`, whose limits are typical and "
    "assumed. "
    "What else was assumed, and where a printed number cannot come out, stands with each item.\n\n";

constexpr const char* left_out =
    "## What no program can make again\n\n"
    "- [Sun2016] Figs. 6, 7, 9, 10 and A.1, [Huang2016] Figs. 1 and 5: drawings that explain a formula. The formulas "
    "are in "
    "`planner/` and have tests; of eqs. 15 and 16 the sign of eta is mended, without which the edge curve is not "
    "tangent to the surface.\n"
    "- [Sun2016] Fig. 8, [Huang2016] Figs. 2 and 4: flow charts. `planner/orientation/pin_loop` and `field_loop` are "
    "the loops.\n"
    "- [Huang2016] Fig. 12: photographs of two machined half-spheres. The mark between the regions comes from errors "
    "of the machine, "
    "which the paper does not give and a rigid virtual machine does not have.\n"
    "- The photographs of [Sun2016] Figs. 17 and 18 are replaced by computed deviations.\n";

std::string table_text(const TextTable& table) {
  std::string text;
  for (std::size_t row = 0; row < table.size(); ++row) {
    for (const std::string& cell : table[row]) text += "| " + cell + " ";
    text += "|\n";
    if (row > 0) continue;
    for (std::size_t i = 0; i < table[row].size(); ++i) text += "|---";
    text += "|\n";
  }
  return text + "\n";
}

std::string list_text(const std::string& heading, const std::vector<std::string>& lines) {
  if (lines.empty()) return {};
  std::string text = heading + "\n";
  for (const std::string& line : lines) text += "- " + line + "\n";
  return text + "\n";
}

}  // namespace

std::string section_text(const Item& item, const ItemPage& page, const std::string& figures) {
  std::string text =
      "## " + std::string(item.source) + ": " + item.title + "\n\n`volute reproduce " + item.name + "`\n\n";
  if (!page.opening.empty()) text += page.opening + "\n\n";
  for (const std::string& picture : page.pictures)
    text += "![" + std::string(item.source) + ": " + item.title + "](" + figures + "/" + picture + ")\n\n";
  for (const TextTable& table : page.tables) text += table_text(table);
  return text + list_text("Assumed, because the paper does not say:", page.assumed) +
         list_text("Remarks:", page.remarks);
}

std::map<std::string, std::string> sections_of(std::string_view document) {
  std::map<std::string, std::string> sections;
  for (std::size_t at = document.find(mark_begin); at != std::string_view::npos; at = document.find(mark_begin, at)) {
    const std::size_t name = at + mark_begin.size(), name_end = document.find(mark_end, name);
    if (name_end == std::string_view::npos) break;
    const std::size_t body = name_end + mark_end.size(), end = document.find(mark_last, body);
    if (end == std::string_view::npos) break;
    sections[std::string(document.substr(name, name_end - name))] = std::string(document.substr(body, end - body));
    at = end;
  }
  return sections;
}

std::string document_text(const std::map<std::string, std::string>& sections) {
  std::string text = preface, missing;
  for (const Item& item : reproduction_items()) {
    const auto section = sections.find(item.name);
    if (section == sections.end())
      missing += (missing.empty() ? "" : ", ") + std::string("`") + item.name + "`";
    else
      text +=
          std::string(mark_begin) + item.name + std::string(mark_end) + section->second + std::string(mark_last) + "\n";
  }
  if (!missing.empty()) text += "Not made yet: " + missing + " (`volute reproduce NAME --out docs`).\n\n";
  return text + left_out;
}

}  // namespace volute::app

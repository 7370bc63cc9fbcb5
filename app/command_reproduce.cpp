// volute reproduce: tables and figures of the papers, with the paper's value, ours, and what was assumed.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/commands.hpp"
#include "app/exit_status.hpp"
#include "app/report.hpp"
#include "app/reproduce/document.hpp"
#include "app/run_table.hpp"
#include "geometry/file.hpp"

namespace volute::app {

namespace {

using geometry::Result;

constexpr const char* document_name = "reproduction.md";
constexpr const char* figures_name = "figures/reproduction";

Result<std::vector<Item>> chosen_items(const std::vector<std::string>& names) {
  const std::vector<Item>& all = reproduction_items();
  if (names.empty()) return all;
  std::vector<Item> chosen;
  for (const std::string& name : names) {
    const auto found = std::find_if(all.begin(), all.end(), [&](const Item& item) { return name == item.name; });
    if (found == all.end())
      return geometry::bad_input("item-unknown", "reproduce: " + name + ": is none of " + reproduction_names());
    chosen.push_back(*found);
  }
  return chosen;
}

std::map<std::string, std::string> sections_written_before(const OutputFolder& out) {
  const auto text = geometry::read_file(out.file(document_name));
  return text ? sections_of(*text) : std::map<std::string, std::string>();
}

Json item_json(const Item& item, const ItemPage& page) {
  return {{"item", item.name}, {"source", item.source}, {"pictures", page.pictures}, {"tables", page.tables}};
}

Result<int> reproduce(const ReproduceArguments& arguments, Context& context) {
  const auto items = chosen_items(arguments.items);
  if (!items) return tl::unexpected(items.error());
  const auto out = OutputFolder::make(arguments.out.empty() ? path("reproduction") : arguments.out);
  if (!out) return tl::unexpected(out.error());
  auto figures = OutputFolder::make(out->file(figures_name));
  if (!figures) return tl::unexpected(figures.error());
  Workshop shop(context, std::move(*figures));
  Json made = Json::array();
  std::string text;
  for (const Item& item : *items) {
    const auto page = item.make(shop, item.name);
    if (!page) return tl::unexpected(page.error());
    auto sections = sections_written_before(*out);
    sections[item.name] = section_text(item, *page, figures_name);
    if (auto written = out->write(document_name, document_text(sections)); !written)
      return tl::unexpected(written.error());
    made.push_back(item_json(item, *page));
    text += table_row(item.name, std::string(item.source) + ": " + item.title);
  }
  context.print(made, text + table_row("document", out->file(document_name).string()));
  return exit_clean;
}

}  // namespace

int reproduce_command(const ReproduceArguments& arguments, Context& context) {
  const auto status = reproduce(arguments, context);
  return status ? *status : context.fail(status.error());
}

}  // namespace volute::app

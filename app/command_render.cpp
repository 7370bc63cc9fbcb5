// volute render: the pictures of a run again, from its files.
#include <nlohmann/json.hpp>

#include "app/commands.hpp"
#include "app/cspace_pictures.hpp"
#include "app/exit_status.hpp"
#include "app/report.hpp"
#include "app/run_table.hpp"
#include "view/run_view.hpp"

namespace volute::app {

int render_command(const RenderArguments& arguments, Context& context) {
  const auto view = view::load_view(arguments.folder);
  if (!view) return context.fail(view.error());
  auto pictures = view::write_pictures(*view, arguments.folder);
  if (!pictures) return context.fail(pictures.error());
  CspaceChoice choice = usual_choice(*view);
  choice.cut_points = arguments.points;
  if (arguments.narrowest) choice.narrowest = *arguments.narrowest;
  const auto maps = write_cspace_pictures(*view, choice, arguments.folder);
  if (!maps) return context.fail(maps.error());
  pictures->insert(pictures->end(), maps->begin(), maps->end());
  if (auto page = view::write_report_html(*view, arguments.folder / "report.html"); !page)
    return context.fail(page.error());
  std::string text;
  for (const std::string& picture : *pictures) text += table_row("picture", (arguments.folder / picture).string());
  context.print(Json{{"folder", arguments.folder.string()}, {"pictures", *pictures}}, text);
  return exit_clean;
}

}  // namespace volute::app

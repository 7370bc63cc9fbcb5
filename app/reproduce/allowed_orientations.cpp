// C-space maps along the path of [Sun2016] Fig. 19: what is allowed where the wall is near and where it is far.
#include "app/cspace_pictures.hpp"
#include "app/reproduce/item.hpp"
#include "geometry/number_text.hpp"

namespace volute::app {

using geometry::Result;
using geometry::short_text;

namespace {

constexpr const char* map_job = "figure-19";
constexpr int shown_start = 0, shown_narrowest = 1;

Result<std::vector<CspacePicture>> maps_of(Workshop& shop, const CspaceChoice& choice) {
  const auto inputs = shop.inputs(map_job);
  if (!inputs) return tl::unexpected(inputs.error());
  const auto plan = shop.plan(map_job, planner::Smoothing::corridor);
  if (!plan) return tl::unexpected(plan.error());
  view::RunView view = part_view(*inputs);
  view.profile = inputs->profile;
  view.setup = inputs->job.setup;
  view.tool_path = (*plan)->tool_path;
  view.orientation = orientation_rule(*inputs, **plan);
  return cspace_pictures(view, choice);
}

}  // namespace

Result<ItemPage> allowed_orientations(Workshop& shop, const std::string& name) {
  CspaceChoice choice;
  choice.cut_points = {shown_start};
  choice.narrowest = shown_narrowest;
  const auto maps = maps_of(shop, choice);
  if (!maps) return tl::unexpected(maps.error());
  ItemPage page;
  page.opening =
      "The allowed set at two CC points of the path of Fig. 19, over yaw and tilt and over the two rotary axes: at its "
      "start, far from the wall, and where the least is allowed. Green cells are free and coloured ones blocked for "
      "every orientation in them; the line is the path of `corridor` before and after, the ring the axis at the point.";
  TextTable table{
      {"CC point", "free share of the directions within the tilt limits", "not told apart, of the two areas"}};
  for (const CspacePicture& map : *maps) {
    const auto file = shop.keep(name + "-" + std::to_string(map.cut_point), {{"", map.image}}, 1);
    if (!file) return tl::unexpected(file.error());
    page.pictures.push_back(*file);
    table.push_back(
        {std::to_string(map.cut_point), short_text(100.0 * map.free_share, 3) + " %",
         short_text(100.0 * map.unsure_share[0], 2) + " %, " + short_text(100.0 * map.unsure_share[1], 2) + " %"});
  }
  page.tables = {table};
  page.assumed = {"Cells are halved down to " + short_text(choice.resolution.degrees(), 3) +
                  " degrees; what is then still neither proved free nor proved blocked is the white line between."};
  page.remarks = {
      "Neither paper shows such a map; [Sun2016] 6.1 speaks of the feasible range at a critical point. "
      "`volute render DIR --point N` draws it for any CC point of a run."};
  return page;
}

}  // namespace volute::app

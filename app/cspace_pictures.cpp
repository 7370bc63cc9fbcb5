#include "app/cspace_pictures.hpp"

#include <algorithm>

#include "geometry/file.hpp"
#include "planner/orientation_maps.hpp"
#include "view/cspace.hpp"

namespace volute::app {

using geometry::Result;

namespace {

planner::PlanRequest question_of(const view::RunView& view) {
  const view::OrientationRule& rule = *view.orientation;
  planner::PlanRequest request;
  request.surface = view.surface_P;
  request.tool = view.tool;
  request.scene.part = view.surface_P;
  const auto first_fixture = view.obstacles_P.end() - static_cast<std::ptrdiff_t>(rule.fixtures);
  request.scene.obstacles.assign(view.obstacles_P.begin(), first_fixture);
  request.scene.fixtures.assign(first_fixture, view.obstacles_P.end());
  request.scene.names = view.obstacle_names;
  request.scene.clearance_mm = rule.clearance_mm;
  request.scene.gouge_tolerance_mm = rule.gouge_tolerance_mm;
  request.orientation.tilt = rule.tilt;
  request.orientation.yaw = rule.yaw;
  request.orientation.tilt_min = rule.tilt_min;
  request.orientation.tilt_max = rule.tilt_max;
  request.orientation.clearance_mm = rule.clearance_mm;
  request.orientation.gouge_tolerance_mm = rule.gouge_tolerance_mm;
  request.machine = view.profile->machine;
  request.setup = view.setup;
  return request;
}

}  // namespace

Result<std::vector<CspacePicture>> cspace_pictures(const view::RunView& view, const CspaceChoice& choice) {
  if (!view.orientation || !view.profile || view.tool_path.points.empty())
    return geometry::bad_input("map-view", view.title +
                                               ": a C-space map asks what the plan was allowed to do, and there is no "
                                               "plan; name a folder that volute run wrote");
  planner::PlanResult plan;
  plan.tool_path = view.tool_path;
  plan.rotaries_rad = view.orientation->rotaries_rad;
  planner::MapRequest wanted;
  wanted.cut_points = choice.cut_points;
  wanted.worst = choice.narrowest;
  wanted.cspace.resolution = choice.resolution;
  const auto maps = planner::orientation_maps(question_of(view), plan, wanted);
  if (!maps) return tl::unexpected(maps.error());
  std::vector<CspacePicture> pictures;
  for (const kinematics::OrientationMap& map : *maps) {
    const std::string title = view.title + ": allowed orientations at CC point " + std::to_string(map.cc_point);
    pictures.push_back({map.cc_point,
                        map.free_share,
                        {view::unsure_share(map.lean), view::unsure_share(map.rotaries)},
                        view::draw_cspace_map(map, title)});
  }
  return pictures;
}

Result<std::vector<std::string>> write_cspace_pictures(const view::RunView& view, const CspaceChoice& choice,
                                                       const std::filesystem::path& folder) {
  std::vector<std::string> names;
  if (choice.cut_points.empty() && choice.narrowest == 0) return names;
  const auto pictures = cspace_pictures(view, choice);
  if (!pictures) return tl::unexpected(pictures.error());
  for (const CspacePicture& picture : *pictures) {
    const std::string name = "cspace-" + std::to_string(picture.cut_point) + ".png";
    if (std::find(names.begin(), names.end(), name) != names.end()) continue;
    if (auto written = geometry::write_file(folder / name, view::png_bytes(picture.image)); !written)
      return tl::unexpected(written.error());
    names.push_back(name);
  }
  return names;
}

CspaceChoice usual_choice(const view::RunView& view) {
  CspaceChoice choice;
  choice.narrowest = view.orientation && view.profile && !view.obstacles_P.empty() ? 1 : 0;
  return choice;
}

}  // namespace volute::app

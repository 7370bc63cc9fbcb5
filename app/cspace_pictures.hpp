// C-space maps of a run: asked of the planner, drawn by view.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "view/image.hpp"
#include "view/run_view.hpp"

namespace volute::app {

struct CspaceChoice {
  std::vector<int> cut_points;  ///< indices among the cutting points
  int narrowest = 0;            ///< and so many where the least is allowed
  geometry::Angle resolution = geometry::Angle::degrees(0.25);
};

struct CspacePicture {
  int cut_point = 0;
  double free_share = 0.0;
  std::array<double, 2> unsure_share{};  ///< of the areas: yaw and tilt, the rotaries
  view::Image image;
};

/// The maps in the order of the choice. Errors (bad_input): map-view (the run has no plan or no machine to ask),
/// map-point.
geometry::Result<std::vector<CspacePicture>> cspace_pictures(const view::RunView& view, const CspaceChoice& choice);

/// The same as files, cspace-POINT.png; returns their names.
geometry::Result<std::vector<std::string>> write_cspace_pictures(const view::RunView& view, const CspaceChoice& choice,
                                                                 const std::filesystem::path& folder);

/// What `run` and `render` draw without being asked: the narrowest place, where there are obstacles.
CspaceChoice usual_choice(const view::RunView& view);

}  // namespace volute::app

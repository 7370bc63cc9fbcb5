// The pictures of a run, each from the data that it needs.
#pragma once

#include "view/camera.hpp"
#include "view/image.hpp"
#include "view/overlay.hpp"
#include "view/renderer.hpp"
#include "view/run_view.hpp"

namespace volute::view {

constexpr int picture_width = 1600, picture_height = 1200;

/// The tool path on the part, coloured by turn of the spiral; rapids in grey. From the trace when nothing was planned
/// here.
Result<Image> path_picture(const RunView& view);
/// What colours the path. turn, tilt: of the plan; feed, limit (what holds the speed down), axis: of the run.
enum class PathColour { turn, tilt, feed, limit };
/// The path coloured by `colour`. Requires: a plan for turn and tilt, a trace for feed and limit.
Result<Image> coloured_path_picture(const RunView& view, PathColour colour);
/// Tool axes as strokes over the path, from the CC point towards the holder, coloured by tilt ([Sun2016] Fig. 19,
/// [Huang2016] Figs. 8-11). Requires: a plan.
Result<Image> orientation_picture(const RunView& view);
/// The map's triangles on their rectangle with the guide lines ([Sun2016] Figs. 4 and 5). Requires: view.map_triangles.
Result<Image> map_picture(const RunView& view);
/// Machine, tool and part at a moment of the run. `close`: only what is near the part. Requires: a profile and a trace.
Result<Image> machine_picture(const RunView& view, double time_s, bool close);
/// The moment that is worth a picture: the first finding's, else the middle of the run.
double shown_moment_s(const RunView& view);
/// The machined surface coloured by deviation. Requires: view.cut with vertex deviations.
Result<Image> machined_picture(const RunView& view);

// Shared by the sources of pictures.
Box part_box(const RunView& view);
void add_solids(Scene3d& scene, const RunView& view);
Result<Image> finished_picture(const Scene3d& scene, const Camera& camera, const Overlay& overlay);
Camera standard_camera(const Box& box);

}  // namespace volute::view

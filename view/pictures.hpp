// The pictures of a run, each from the data that it needs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "view/camera.hpp"
#include "view/image.hpp"
#include "view/overlay.hpp"
#include "view/renderer.hpp"
#include "view/run_view.hpp"

namespace volute::view {

constexpr int picture_width = 1600, picture_height = 1200;

/// How large a picture is and how much is written over it. The default is a picture of its own; sheets
/// (figure_sheet.hpp) take smaller ones without titles.
struct PictureStyle {
  int width_px = picture_width, height_px = picture_height;
  double text_scale = 1.0;  ///< times the size that suits 1200 pixels of height
  bool titled = true;
};

/// Lines on the part under one name and colour; without a name they are not in the list of colours.
struct NamedLines {
  std::string name;
  Colour colour{};
  std::vector<std::vector<Vec3>> lines_P_mm;
  double width_px = 3.0;
};
/// Part and obstacles with lines drawn on them; `shown`: only this place.
Result<Image> part_picture(const RunView& view, const std::vector<NamedLines>& lines, const PictureStyle& style = {},
                           const std::optional<Box>& shown = {});
/// The tool path on the part, coloured by turn of the spiral. The tip's way from the trace, coloured by time, when
/// nothing was planned here.
Result<Image> path_picture(const RunView& view, const PictureStyle& style = {});
/// What colours the path. turn, tilt: of the plan; feed, limit (what holds the speed down), axis: of the run.
enum class PathColour { turn, tilt, feed, limit };
/// The path coloured by `colour`. Requires: a plan for turn and tilt, a trace for feed and limit.
Result<Image> coloured_path_picture(const RunView& view, PathColour colour, const PictureStyle& style = {});
/// Which tool axes a picture shows, and how.
struct OrientationFocus {
  double strokes = 1400.0;               ///< about so many, evenly over the points
  double stroke_share = 0.07;            ///< length of a stroke, of the diagonal of part and obstacles
  std::vector<std::size_t> marked = {};  ///< points of the tool path whose axis is drawn thick and red (pins, keys)
  bool only_marked = false, with_path = false;
  float obstacle_opacity = 1.0F;
  std::optional<Vec2> turns = {};           ///< only points between these turns of the spiral
  std::optional<Vec2> tilt_range_deg = {};  ///< ends of the colour bar; for pictures that stand side by side
  std::optional<Box> box = {};              ///< only this place
};
/// Tool axes as strokes over the path, from the CC point towards the holder, coloured by tilt ([Sun2016] Fig. 19,
/// [Huang2016] Figs. 8-11). Requires: a plan.
Result<Image> orientation_picture(const RunView& view, const PictureStyle& style = {},
                                  const OrientationFocus& focus = {});
/// The map's triangles on their rectangle with the guide lines ([Sun2016] Figs. 4 and 5). Requires: view.map_triangles.
/// `sides`: drawn over it under their names, points (u, v, 0).
Result<Image> map_picture(const RunView& view, const PictureStyle& style = {},
                          const std::vector<NamedLines>& sides = {});
/// Machine, tool and part at a moment of the run. `close`: only what is near the part. Requires: a profile and a trace.
Result<Image> machine_picture(const RunView& view, double time_s, bool close, const PictureStyle& style = {});
/// The moment that is worth a picture: the first finding's, else the middle of the run.
double shown_moment_s(const RunView& view);
/// What a picture of the machined surface shows. Nothing set: the whole surface, coloured up to its own greatest
/// deviation.
struct MachinedFocus {
  std::optional<double> range_mm =
      {};                       ///< deviations at the ends of the colour bar; for pictures that stand side by side
  std::optional<Box> box = {};  ///< only this place
};
/// The machined surface coloured by deviation. Requires: view.cut with vertex deviations.
Result<Image> machined_picture(const RunView& view, const PictureStyle& style = {}, const MachinedFocus& focus = {});

// Shared by the sources of pictures.
void add_named_lines(Scene3d& scene, Overlay& overlay, const std::vector<NamedLines>& lines, double lift_mm);
Box part_box(const RunView& view);
void add_solids(Scene3d& scene, const RunView& view);
Result<Image> finished_picture(const Scene3d& scene, const Camera& camera, Overlay overlay, const PictureStyle& style);
/// What stands at the right of a picture and needs room.
enum class RightSide { empty, bar, keys };
Camera standard_camera(const Box& box, const PictureStyle& style, RightSide right);
/// At one place of the part, or at all of it; nothing of the part is cut off in depth.
Camera camera_at(const RunView& view, const std::optional<Box>& place, const PictureStyle& style, RightSide right);
/// Dark blue to yellow-green: the part of the sequential colours that stands out from a light surface.
Colour line_colour(double share);

}  // namespace volute::view

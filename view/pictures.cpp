#include "view/pictures.hpp"

#include <algorithm>
#include <cmath>

#include "view/colour_map.hpp"
#include "view/overlay.hpp"
#include "view/renderer.hpp"

namespace volute::view {

namespace {

const Vec3 default_view(-0.35, -0.9, 1.15);
constexpr Colour obstacle_colour{0.72F, 0.60F, 0.52F}, surface_colour{0.90F, 0.92F, 0.94F};
/// What a colour bar with its numbers, or a list of colours, takes at the right, in pixels of a picture 1200 high.
constexpr double bar_width = 190.0, keys_width = 330.0;
constexpr double titled_margin = 0.16, bare_margin = 0.06;
constexpr double brightest_line = 0.88, line_lift_share = 0.008;

}  // namespace

Box part_box(const RunView& view) {
  Box box;
  for (const Vec3& vertex : view.surface_P.vertices_mm) grow(box, vertex);
  for (const geometry::TriangleMesh& obstacle : view.obstacles_P)
    for (const Vec3& vertex : obstacle.vertices_mm) grow(box, vertex);
  if (view.surface_P.vertices_mm.empty())
    for (std::size_t i = 0; i < view.trace.poses_P.size(); ++i)
      if (view.trace.samples[i].cutting) grow(box, view.trace.poses_P[i].tip_P_mm);
  return box;
}

void add_solids(Scene3d& scene, const RunView& view) {
  if (!view.surface_P.triangles.empty()) scene.meshes.push_back({&view.surface_P, {}, surface_colour, 1.0F});
  for (const geometry::TriangleMesh& obstacle : view.obstacles_P)
    scene.meshes.push_back({&obstacle, {}, obstacle_colour, 1.0F});
}

namespace {

/// What the machine did, for programs of others: coloured by the share of the run's time.
std::vector<ColouredLine> traced_lines(const RunView& view) {
  std::vector<ColouredLine> lines;
  bool cutting = false;
  const double end_s = view.trace.samples.empty() ? 1.0 : view.trace.samples.back().time_s;
  for (std::size_t i = 0; i < view.trace.samples.size(); ++i) {
    const sim::AxisSample& sample = view.trace.samples[i];
    if (sample.cutting && !cutting) lines.push_back({{}, {}, {}, 1.4, 0.3});
    cutting = sample.cutting;
    if (!cutting) continue;
    lines.back().points.push_back(view.trace.poses_P[i].tip_P_mm);
    lines.back().colours.push_back(line_colour(sample.time_s / end_s));
  }
  return lines;
}

}  // namespace

Colour line_colour(double share) { return sequential_colour(brightest_line * std::clamp(share, 0.0, 1.0)); }

Result<Image> finished_picture(const Scene3d& scene, const Camera& camera, Overlay overlay, const PictureStyle& style) {
  overlay.text_scale = style.text_scale;
  if (!style.titled) {
    overlay.title.clear();
    overlay.notes.clear();
  }
  auto image = render(scene, camera, style.width_px, style.height_px);
  if (image) draw_overlay(*image, camera, overlay);
  return image;
}

Camera standard_camera(const Box& box, const PictureStyle& style, RightSide right) {
  const double aspect = static_cast<double>(style.width_px) / style.height_px;
  const double unit_px = style.text_scale * style.height_px / 1200.0;
  const double words_px = right == RightSide::bar ? bar_width : right == RightSide::keys ? keys_width : 0.0;
  const double room = words_px * unit_px / style.width_px;
  Camera camera = fit_camera(box, default_view, aspect * (1.0 - room), style.titled ? titled_margin : bare_margin);
  camera.aspect = aspect;
  camera.target += room * camera.half_height * aspect * camera.right;
  return camera;
}

Camera camera_at(const RunView& view, const std::optional<Box>& place, const PictureStyle& style, RightSide right) {
  const Box whole = part_box(view);
  Camera camera = standard_camera(place.value_or(whole), style, right);
  if (place) camera.half_depth += (whole.greatest - whole.least).norm();
  return camera;
}

void add_named_lines(Scene3d& scene, Overlay& overlay, const std::vector<NamedLines>& lines, double lift_mm) {
  for (const NamedLines& named : lines) {
    for (const std::vector<Vec3>& line : named.lines_P_mm)
      scene.lines.push_back({line, {}, named.colour, named.width_px, lift_mm});
    if (!named.name.empty()) overlay.keys.push_back({named.name, named.colour});
  }
}

Result<Image> part_picture(const RunView& view, const std::vector<NamedLines>& lines, const PictureStyle& style,
                           const std::optional<Box>& shown) {
  Scene3d scene;
  add_solids(scene, view);
  Overlay overlay{view.title, {"the part"}};
  const Box box = part_box(view);
  add_named_lines(scene, overlay, lines, line_lift_share * (box.greatest - box.least).norm());
  const RightSide right = overlay.keys.empty() ? RightSide::empty : RightSide::keys;
  return finished_picture(scene, camera_at(view, shown, style, right), overlay, style);
}

Result<Image> path_picture(const RunView& view, const PictureStyle& style) {
  if (!view.tool_path.points.empty()) return coloured_path_picture(view, PathColour::turn, style);
  Scene3d scene;
  add_solids(scene, view);
  scene.lines = traced_lines(view);
  const ColourBar bar{"time, s", 0.0, view.trace.samples.empty() ? 0.0 : view.trace.samples.back().time_s, line_colour};
  return finished_picture(scene, camera_at(view, {}, style, RightSide::bar),
                          {view.title, {"tool tip while cutting, coloured by time"}, &bar}, style);
}

Result<Image> machined_picture(const RunView& view, const PictureStyle& style, const MachinedFocus& focus) {
  Scene3d scene;
  double range = focus.range_mm.value_or(0.0);
  for (const double deviation : view.cut->vertex_deviation_mm)
    if (!focus.range_mm && std::isfinite(deviation)) range = std::max(range, std::abs(deviation));
  if (range <= 0.0) range = 1.0;
  ShadedMesh machined{&view.surface_P, {}, {}, 1.0F};
  for (const double deviation : view.cut->vertex_deviation_mm)
    machined.vertex_colours.push_back(std::isfinite(deviation) ? diverging_colour(deviation / range)
                                                               : Colour{0.15F, 0.15F, 0.15F});
  scene.meshes.push_back(std::move(machined));
  ColourBar bar{"deviation, mm", -range, range, [](double share) { return diverging_colour(2.0 * share - 1.0); }};
  return finished_picture(
      scene, camera_at(view, focus.box, style, RightSide::bar),
      {view.title,
       {"machined surface, the worst about each place: above zero is left, below is gouged; black: not reached"},
       &bar},
      style);
}

}  // namespace volute::view

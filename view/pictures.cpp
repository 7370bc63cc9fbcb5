#include "view/pictures.hpp"

#include <algorithm>
#include <cmath>

#include "view/colour_map.hpp"
#include "view/overlay.hpp"
#include "view/renderer.hpp"

namespace volute::view {

namespace {

using kinematics::MoveKind;

const Vec3 default_view(-0.35, -0.9, 1.15);
constexpr Colour obstacle_colour{0.72F, 0.60F, 0.52F};

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
  if (!view.surface_P.triangles.empty()) scene.meshes.push_back({&view.surface_P, {}, {0.80F, 0.83F, 0.86F}, 1.0F});
  for (const geometry::TriangleMesh& obstacle : view.obstacles_P)
    scene.meshes.push_back({&obstacle, {}, obstacle_colour, 1.0F});
}

namespace {

double greatest_turn(const RunView& view) {
  double most = 0.0;
  for (const kinematics::ToolPathPoint& point : view.tool_path.points) most = std::max(most, point.turn);
  return most;
}

/// Cutting moves on the surface, coloured by turn.
ColouredLine planned_line(const RunView& view, double turns) {
  ColouredLine line;
  line.width_px = 1.4;
  line.lift_mm = 0.3;
  for (const kinematics::ToolPathPoint& point : view.tool_path.points) {
    if (point.move != MoveKind::cut && point.move != MoveKind::link) continue;
    line.points.push_back(point.contact_P_mm);
    line.colours.push_back(point.move == MoveKind::link ? Colour{0.8F, 0.1F, 0.1F}
                                                        : sequential_colour(turns > 0.0 ? point.turn / turns : 0.0));
  }
  return line;
}

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
    lines.back().colours.push_back(sequential_colour(sample.time_s / end_s));
  }
  return lines;
}

}  // namespace

Result<Image> finished_picture(const Scene3d& scene, const Camera& camera, const Overlay& overlay) {
  auto image = render(scene, camera, picture_width, picture_height);
  if (image) draw_overlay(*image, camera, overlay);
  return image;
}

Camera standard_camera(const Box& box) {
  return fit_camera(box, default_view, static_cast<double>(picture_width) / picture_height, 0.22);
}

Result<Image> path_picture(const RunView& view) {
  Scene3d scene;
  add_solids(scene, view);
  const double turns = greatest_turn(view);
  const bool planned = !view.tool_path.points.empty();
  ColourBar bar{planned ? "turn" : "time, s", 0.0,
                planned ? turns : (view.trace.samples.empty() ? 0.0 : view.trace.samples.back().time_s),
                sequential_colour};
  if (planned)
    scene.lines.push_back(planned_line(view, turns));
  else
    scene.lines = traced_lines(view);
  const Camera camera = standard_camera(part_box(view));
  return finished_picture(scene, camera,
                          {view.title,
                           {planned ? "tool path on the surface, coloured by turn of the spiral"
                                    : "tool tip while cutting, coloured by time"},
                           &bar});
}

Result<Image> machined_picture(const RunView& view) {
  Scene3d scene;
  double range = 0.0;
  for (const double deviation : view.cut->vertex_deviation_mm)
    if (std::isfinite(deviation)) range = std::max(range, std::abs(deviation));
  if (range <= 0.0) range = 1.0;
  ShadedMesh machined{&view.surface_P, {}, {}, 1.0F};
  for (const double deviation : view.cut->vertex_deviation_mm)
    machined.vertex_colours.push_back(std::isfinite(deviation) ? diverging_colour(deviation / range)
                                                               : Colour{0.15F, 0.15F, 0.15F});
  scene.meshes.push_back(std::move(machined));
  ColourBar bar{"deviation, mm", -range, range, [](double share) { return diverging_colour(2.0 * share - 1.0); }};
  const Camera camera = standard_camera(part_box(view));
  return finished_picture(
      scene, camera,
      {view.title, {"machined surface: above zero is left, below is gouged; black: nothing came near"}, &bar});
}

}  // namespace volute::view

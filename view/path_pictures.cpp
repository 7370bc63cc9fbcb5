// The path in colours, tool axes as strokes, and the map that the path was made on.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "view/colour_map.hpp"
#include "view/pictures.hpp"

namespace volute::view {

namespace {

using geometry::Vec2;
using kinematics::MoveKind;
using kinematics::ToolPathPoint;

constexpr double degrees_per_radian = 180.0 / std::numbers::pi;
constexpr double least_tilt_span_deg = 1.0;
constexpr Colour marked_colour{0.80F, 0.05F, 0.05F};
constexpr std::array<const char*, 10> limit_names{"programmed feed", "axis velocity", "axis acceleration", "axis jerk",
                                                  "corner",          "block time",    "look-ahead",        "rapid",
                                                  "dwell",           "stop"};
/// Okabe and Ito's palette and greys: the page's colours of the same limits.
constexpr std::array<Colour, 10> limit_colours{{{0.00F, 0.62F, 0.45F},
                                                {0.00F, 0.45F, 0.70F},
                                                {0.84F, 0.37F, 0.00F},
                                                {0.80F, 0.47F, 0.65F},
                                                {0.90F, 0.62F, 0.00F},
                                                {0.34F, 0.71F, 0.91F},
                                                {0.54F, 0.43F, 0.23F},
                                                {0.60F, 0.60F, 0.60F},
                                                {0.33F, 0.33F, 0.33F},
                                                {0.00F, 0.00F, 0.00F}}};

double tilt_deg(const ToolPathPoint& point) {
  return std::acos(std::clamp(point.pose.axis_P.dot(point.normal_P), -1.0, 1.0)) * degrees_per_radian;
}

bool on_surface(const ToolPathPoint& point) { return point.move == MoveKind::cut || point.move == MoveKind::link; }

bool inside(const Vec2& range, double value) { return value >= range.x() && value <= range.y(); }

/// Values along a line and the bar that explains them.
struct Scale {
  double least = std::numeric_limits<double>::infinity(), greatest = -std::numeric_limits<double>::infinity();
  /// At least this far from end to end, so that rounding does not look like a difference.
  void widen(double span) {
    const double missing = 0.5 * (span - (greatest - least));
    if (missing <= 0.0) return;
    least -= missing;
    greatest += missing;
  }
  void take(double value) {
    least = std::min(least, value);
    greatest = std::max(greatest, value);
  }
  [[nodiscard]] Colour colour(double value) const {
    return line_colour(greatest > least ? (value - least) / (greatest - least) : 0.5);
  }
  [[nodiscard]] ColourBar bar(const std::string& label) const { return {label, least, greatest, line_colour}; }
};

template <class Value>
Scale scale_of(const RunView& view, const Value& value) {
  Scale scale;
  for (const ToolPathPoint& point : view.tool_path.points)
    if (on_surface(point)) scale.take(value(point));
  return scale;
}

/// The planned path on the surface, a line for every piece. Links, which belong to no pass, are red when `mark_links`.
template <class Value>
std::vector<ColouredLine> planned_lines(const RunView& view, const Scale& scale, const Value& value, bool mark_links) {
  std::vector<ColouredLine> lines;
  bool down = false;
  for (const ToolPathPoint& point : view.tool_path.points) {
    if (on_surface(point) && !down) lines.push_back({{}, {}, {}, 1.6, 0.3});
    down = on_surface(point);
    if (!down) continue;
    lines.back().points.push_back(point.contact_P_mm);
    lines.back().colours.push_back(mark_links && point.move == MoveKind::link ? marked_colour
                                                                              : scale.colour(value(point)));
  }
  return lines;
}

/// The tip's way while cutting, in as many pieces as it has; `colour` of a sample.
template <class ColourOf>
std::vector<ColouredLine> run_lines(const RunView& view, const ColourOf& colour) {
  std::vector<ColouredLine> lines;
  bool cutting = false;
  for (std::size_t i = 0; i < view.trace.samples.size(); ++i) {
    const sim::AxisSample& sample = view.trace.samples[i];
    if (sample.cutting && !cutting) lines.push_back({{}, {}, {}, 1.6, 0.3});
    cutting = sample.cutting;
    if (!cutting) continue;
    lines.back().points.push_back(view.trace.poses_P[i].tip_P_mm);
    lines.back().colours.push_back(colour(sample));
  }
  return lines;
}

Result<Image> planned_picture(const RunView& view, PathColour colour, const PictureStyle& style) {
  const auto value = [colour](const ToolPathPoint& point) {
    return colour == PathColour::turn ? point.turn : tilt_deg(point);
  };
  const Scale scale = scale_of(view, value);
  Scene3d scene;
  add_solids(scene, view);
  scene.lines = planned_lines(view, scale, value, colour == PathColour::turn);
  const ColourBar bar = scale.bar(colour == PathColour::turn ? "turn" : "tilt, deg");
  const char* note = colour == PathColour::turn
                         ? "tool path on the surface, coloured by turn of the spiral; links from pass to pass in red"
                         : "planned path, coloured by the tool's tilt from the surface normal";
  return finished_picture(scene, camera_at(view, {}, style, RightSide::bar), {view.title, {note}, &bar}, style);
}

Result<Image> feed_picture(const RunView& view, const PictureStyle& style) {
  Scale scale;
  scale.take(0.0);
  for (const sim::AxisSample& sample : view.trace.samples)
    if (sample.cutting) scale.take(sample.tip_speed_mm_s * 60.0);
  Scene3d scene;
  add_solids(scene, view);
  scene.lines =
      run_lines(view, [&](const sim::AxisSample& sample) { return scale.colour(sample.tip_speed_mm_s * 60.0); });
  const ColourBar bar = scale.bar("feed, mm/min");
  return finished_picture(scene, camera_at(view, {}, style, RightSide::bar),
                          {view.title, {"tool tip while cutting, coloured by the feed that the machine reached"}, &bar},
                          style);
}

Result<Image> limit_picture(const RunView& view, const PictureStyle& style) {
  Scene3d scene;
  add_solids(scene, view);
  std::array<bool, limit_names.size()> used{};
  scene.lines = run_lines(view, [&](const sim::AxisSample& sample) {
    const auto limit = static_cast<std::size_t>(sample.limit);
    used[limit] = true;
    return limit_colours[limit];
  });
  Overlay overlay{view.title, {"tool tip while cutting, coloured by what holds the speed down"}};
  for (std::size_t i = 0; i < used.size(); ++i)
    if (used[i]) overlay.keys.push_back({limit_names[i], limit_colours[i]});
  return finished_picture(scene, camera_at(view, {}, style, RightSide::keys), overlay, style);
}

Vec3 lifted(const Vec2& point) { return {point.x(), point.y(), 0.0}; }

/// Every edge of the map once, as one strip per triangle.
void add_map_edges(Scene3d& scene, const RunView& view) {
  for (const geometry::Triangle& triangle : view.map_triangles) {
    ColouredLine line{{}, {}, {0.58F, 0.62F, 0.66F}, 0.6, 0.0};
    for (const std::size_t corner : {0U, 1U, 2U, 0U})
      line.points.push_back(lifted(view.map_vertices[static_cast<std::size_t>(triangle[corner])]));
    scene.lines.push_back(std::move(line));
  }
}

}  // namespace

Result<Image> coloured_path_picture(const RunView& view, PathColour colour, const PictureStyle& style) {
  if (colour == PathColour::feed) return feed_picture(view, style);
  if (colour == PathColour::limit) return limit_picture(view, style);
  return planned_picture(view, colour, style);
}

Result<Image> orientation_picture(const RunView& view, const PictureStyle& style, const OrientationFocus& focus) {
  Scale scale = scale_of(view, tilt_deg);
  scale.widen(least_tilt_span_deg);
  if (focus.tilt_range_deg) scale = {focus.tilt_range_deg->x(), focus.tilt_range_deg->y()};
  const Box box = part_box(view);
  const double length_mm = focus.stroke_share * (box.greatest - box.least).norm();
  Scene3d scene;
  add_solids(scene, view);
  for (std::size_t i = scene.meshes.size() - view.obstacles_P.size(); i < scene.meshes.size(); ++i)
    scene.meshes[i].opacity = focus.obstacle_opacity;
  if (focus.with_path) scene.lines = planned_lines(view, scale, tilt_deg, false);
  std::vector<const ToolPathPoint*> cuts;
  if (!focus.only_marked)
    for (const ToolPathPoint& point : view.tool_path.points)
      if (on_surface(point) && (!focus.turns || inside(*focus.turns, point.turn))) cuts.push_back(&point);
  const auto stride =
      std::max<std::size_t>(1, static_cast<std::size_t>(static_cast<double>(cuts.size()) / focus.strokes));
  std::optional<Box> shown = box;
  for (std::size_t i = 0; i < cuts.size(); i += stride) {
    const ToolPathPoint& point = *cuts[i];
    const Vec3 end = point.contact_P_mm + length_mm * point.pose.axis_P;
    grow(*shown, end);
    scene.lines.push_back({{point.contact_P_mm, end}, {}, scale.colour(tilt_deg(point)), 1.5, 0.3});
  }
  for (const std::size_t index : focus.marked) {
    const kinematics::ToolPose& pose = view.tool_path.points[index].pose;
    const Vec3 contact_mm = view.tool_path.points[index].contact_P_mm;
    scene.lines.push_back({{contact_mm, contact_mm + 1.6 * length_mm * pose.axis_P}, {}, marked_colour, 5.0, 0.6});
    grow(*shown, contact_mm + 1.6 * length_mm * pose.axis_P);
  }
  const ColourBar bar = scale.bar("tilt, deg");
  const bool coloured = !focus.only_marked || focus.with_path;
  return finished_picture(
      scene, camera_at(view, focus.box ? focus.box : shown, style, coloured ? RightSide::bar : RightSide::empty),
      {view.title,
       {"tool axes from the CC points towards the holder, coloured by tilt from the surface normal"},
       coloured ? &bar : nullptr},
      style);
}

Result<Image> map_picture(const RunView& view, const PictureStyle& style, const std::vector<NamedLines>& sides) {
  Scene3d scene;
  add_map_edges(scene, view);
  Box box;
  for (const Vec2& vertex : view.map_vertices) grow(box, lifted(vertex));
  for (const auto& line : view.map_guide_lines)
    for (const Vec2& point : line) grow(box, lifted(point));
  const double height = std::max(box.greatest.z() - box.least.z(), 1e-3 * (box.greatest - box.least).norm());
  for (std::size_t i = 0; i < view.map_guide_lines.size(); ++i) {
    const double share = view.map_guide_lines.size() > 1
                             ? static_cast<double>(i) / static_cast<double>(view.map_guide_lines.size() - 1)
                             : 0.5;
    ColouredLine line{{}, {}, line_colour(share), 2.4, 0.5 * height};
    for (const Vec2& point : view.map_guide_lines[i]) line.points.push_back(lifted(point));
    scene.lines.push_back(std::move(line));
  }
  const Camera camera =
      fit_camera(box, Vec3::UnitZ(), static_cast<double>(style.width_px) / style.height_px, style.titled ? 0.22 : 0.04);
  Overlay overlay{view.title,
                  {view.map_guide_lines.empty() ? "the surface's triangles, mapped to the plane"
                                                : "the surface mapped to the plane (grey) and the lines that guide the "
                                                  "path, first to last from blue to green"}};
  add_named_lines(scene, overlay, sides, height);
  overlay.scale = false;  // the map has no millimetres
  overlay.triad = false;
  return finished_picture(scene, camera, overlay, style);
}

}  // namespace volute::view

// [Sun2016] Figs. 1 to 5: boundaries joined by bridges, the map of the ring onto a rectangle, and its guide lines.
#include "app/reproduce/item.hpp"
#include "geometry/number_text.hpp"
#include "planner/surface/annulus.hpp"
#include "planner/surface/surface_map.hpp"
#include "view/colour_map.hpp"
#include "view/pictures.hpp"

namespace volute::app {

namespace {

using geometry::fixed_text;
using geometry::Index;
using geometry::Result;
using geometry::Vec3;
using planner::Annulus;

constexpr view::Colour orange{0.90F, 0.60F, 0.00F}, green{0.00F, 0.62F, 0.45F}, blue{0.00F, 0.45F, 0.70F},
    vermilion{0.84F, 0.37F, 0.00F};
constexpr const char* three_holes = "plate-three-holes";
constexpr const char* two_holes = "plate-two-holes";
constexpr const char* ring_job = "disc-with-hole";
/// Fig. 5 shows few lines: a scallop that leaves about seven turns.
constexpr double coarse_scallop_mm = 1.2;
/// A rectangle that is flatter than this is drawn with a longer v.
constexpr double drawn_height_share = 0.42;

struct JoinedPart {
  JobInputs inputs;
  Annulus annulus;
};

Result<JoinedPart> joined_part(Workshop& shop, const char* job) {
  auto inputs = shop.inputs(job);
  if (!inputs) return tl::unexpected(inputs.error());
  auto annulus = planner::make_annulus(inputs->surface);
  if (!annulus) return tl::unexpected(annulus.error());
  return JoinedPart{std::move(*inputs), std::move(*annulus)};
}

std::vector<Vec3> points_of(const geometry::TriangleMesh& mesh, const std::vector<Index>& vertices) {
  std::vector<Vec3> points;
  for (const Index vertex : vertices) points.push_back(mesh.vertices_mm[static_cast<std::size_t>(vertex)]);
  return points;
}

std::vector<Vec3> closed_points(const geometry::TriangleMesh& mesh, std::vector<Index> loop) {
  loop.push_back(loop.front());
  return points_of(mesh, loop);
}

double length_mm(const std::vector<Vec3>& points) {
  double length = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) length += (points[i] - points[i - 1]).norm();
  return length;
}

std::string curve_name(Index curve) { return curve == 0 ? "C0 (outer)" : "C" + std::to_string(curve); }

std::vector<view::NamedLines> boundaries_and_bridges(const Annulus& annulus) {
  view::NamedLines outer{"outer boundary", orange, {}, 4.0}, holes{"holes", green, {}, 4.0},
      to_outer{"bridge Br_BG", vermilion, {}, 4.0}, between{"bridges Br_GG", blue, {}, 4.0};
  for (std::size_t i = 0; i < annulus.curves.size(); ++i)
    (i == 0 ? outer : holes).lines_P_mm.push_back(closed_points(annulus.whole, annulus.curves[i].vertices));
  for (const planner::Bridge& bridge : annulus.bridges)
    (bridge.from_curve == 0 ? to_outer : between).lines_P_mm.push_back(points_of(annulus.whole, bridge.vertices));
  return {outer, holes, to_outer, between};
}

view::Box box_about(const std::vector<Vec3>& points, double margin_mm) {
  view::Box box;
  for (const Vec3& point : points)
    for (const double sign : {-1.0, 1.0}) view::grow(box, point + Vec3::Constant(sign * margin_mm));
  return box;
}

/// The triangles' edges within a box, as lines.
view::NamedLines edges_within(const geometry::TriangleMesh& mesh, const view::Box& box) {
  view::NamedLines edges{"", {0.62F, 0.66F, 0.70F}, {}, 0.8};
  for (const geometry::Triangle& t : mesh.triangles) {
    const Vec3& a = mesh.vertices_mm[static_cast<std::size_t>(t[0])];
    if ((a.array() < box.least.array()).any() || (a.array() > box.greatest.array()).any()) continue;
    edges.lines_P_mm.push_back(points_of(mesh, {t[0], t[1], t[2], t[0]}));
  }
  return edges;
}

view::NamedLines side(const std::string& name, const view::Colour& colour, std::vector<Vec3> points) {
  return {name, colour, {std::move(points)}, 5.0};
}

/// The four sides of the rectangle, on the part or on the map.
template <class Points>
std::vector<view::NamedLines> four_sides(const Annulus& annulus, const Points& points) {
  return {side("bottom 1-2: outer", orange, points(annulus.bottom)),
          side("right 2-3: seam", vermilion, points(annulus.right)), side("top 3-4: holes", green, points(annulus.top)),
          side("left 4-1: seam", blue, points(annulus.left))};
}

view::RunView map_view(const JoinedPart& part, const planner::RectangleMap& map, double stretch) {
  view::RunView view = part_view(part.inputs);
  for (std::size_t i = 0; i < map.u_mm.size(); ++i) view.map_vertices.emplace_back(map.u_mm[i], stretch * map.v_mm[i]);
  view.map_triangles = part.annulus.sheet.triangles;
  return view;
}

Result<planner::CcPathResult> coarse_paper_path(const JobInputs& inputs, planner::Strategy strategy) {
  planner::PathOptions options = inputs.job.path;
  options.method = planner::Method::paper;
  options.strategy = strategy;
  options.scallop_mm = coarse_scallop_mm;
  return planner::plan_cc_path(inputs.surface, inputs.job.tool.cutter, options, inputs.job.orientation);
}

using MapLines = std::vector<std::vector<geometry::Vec2>>;

struct Rectangle {
  double width = 0.0, height = 0.0;
};

Rectangle rectangle_of(const planner::CcPathResult& made) {
  Rectangle rectangle;
  for (const geometry::Vec2& vertex : made.map.vertices) {
    rectangle.width = std::max(rectangle.width, vertex.x());
    rectangle.height = std::max(rectangle.height, vertex.y());
  }
  return rectangle;
}

/// Eq. 10: v = i times the increment, whole numbers of turns, and the inner boundary itself.
MapLines constant_lines(const planner::CcPathResult& made) {
  double turns = 1.0;
  for (const planner::CcPiece& piece : made.path.pieces)
    for (const planner::CcPoint& point : piece.points) turns = std::max(turns, point.turn);
  const Rectangle rectangle = rectangle_of(made);
  MapLines lines;
  for (double turn = 0.0; turn < turns; turn += 1.0) {
    const double v = rectangle.height * turn / turns;
    lines.push_back({{0.0, v}, {rectangle.width, v}});
  }
  lines.push_back({{0.0, rectangle.height}, {rectangle.width, rectangle.height}});
  return lines;
}

Result<void> add_guide_panels(std::vector<view::FigurePanel>& panels, const JobInputs& inputs,
                              const planner::CcPathResult& made, const MapLines& lines,
                              const std::string& lines_caption, const std::string& path_caption) {
  view::RunView view = path_view(inputs, made.path);
  const Rectangle box = rectangle_of(made);
  const double stretch = std::max(1.0, drawn_height_share * box.width / box.height);
  for (const std::vector<geometry::Vec2>& line : lines) {
    view.map_guide_lines.emplace_back();
    for (const geometry::Vec2& point : line) view.map_guide_lines.back().emplace_back(point.x(), stretch * point.y());
  }
  const double top = stretch * box.height;
  const view::NamedLines outline{
      "", {0.35F, 0.38F, 0.42F}, {{{0, 0, 0}, {box.width, 0, 0}, {box.width, top, 0}, {0, top, 0}, {0, 0, 0}}}, 2.0};
  if (auto added = add_panel(panels, lines_caption, view::map_picture(view, view::panel_style(), {outline})); !added)
    return added;
  return add_panel(panels, path_caption, view::path_picture(view, view::panel_style()));
}

}  // namespace

Result<ItemPage> boundary_tree(Workshop& shop, const std::string& name) {
  const auto part = joined_part(shop, three_holes);
  if (!part) return tl::unexpected(part.error());
  std::vector<view::FigurePanel> panels;
  if (auto added = add_panel(panels, "outer boundary, holes and the bridges between them",
                             view::part_picture(part_view(part->inputs), boundaries_and_bridges(part->annulus),
                                                view::panel_style(800, 560)));
      !added)
    return tl::unexpected(added.error());
  const auto file = shop.keep(name, panels, 1);
  if (!file) return tl::unexpected(file.error());
  TextTable tree{{"parent", "child", "kind", "length, mm", "points"}};
  for (const planner::Bridge& bridge : part->annulus.bridges)
    tree.push_back({curve_name(bridge.from_curve), curve_name(bridge.to_curve),
                    bridge.from_curve == 0 ? "Br_BG" : "Br_GG",
                    fixed_text(length_mm(points_of(part->annulus.whole, bridge.vertices)), 2),
                    std::to_string(bridge.vertices.size())});
  return ItemPage{
      "The outer boundary is the root; one hole is its child, every further hole hangs on the tree at the nearest "
      "place "
      "that is in it. The part is `plate-three-holes`.",
      {*file},
      {tree},
      {"The part: the paper's own models are not published.",
       "The child of the outer boundary is the nearest hole (the paper leaves it to the user, or takes nearest or "
       "farthest)."},
      {}};
}

Result<ItemPage> bridge_by_slicing(Workshop& shop, const std::string& name) {
  const auto part = joined_part(shop, three_holes);
  if (!part) return tl::unexpected(part.error());
  const planner::Bridge& bridge = part->annulus.bridges.back();
  const std::vector<Vec3> points = points_of(part->annulus.whole, bridge.vertices);
  const view::Box box = box_about(points, 1.5);
  std::vector<view::NamedLines> lines = boundaries_and_bridges(part->annulus);
  lines.push_back(edges_within(part->inputs.surface, box_about(points, 5.0)));
  view::RunView view = part_view(part->inputs);
  std::vector<view::FigurePanel> panels;
  if (auto added = add_panel(panels, "a bridge crosses the given triangles where the slicing plane does",
                             view::part_picture(view, lines, view::panel_style(640, 440), box));
      !added)
    return tl::unexpected(added.error());
  const auto file = shop.keep(name, panels, 1);
  if (!file) return tl::unexpected(file.error());
  int straight = 0;
  for (const planner::Bridge& one : part->annulus.bridges) straight += one.sliced ? 1 : 0;
  return ItemPage{
      "A bridge is where a plane through its two ends, along the mean of the normals there, cuts the surface "
      "(eqs. 1 and 2).",
      {*file},
      {{{"bridges of the part", "by slicing", "along edges because slicing stuck"},
        {std::to_string(part->annulus.bridges.size()), std::to_string(straight),
         std::to_string(static_cast<int>(part->annulus.bridges.size()) - straight)}}},
      {},
      {"The crossed triangles are split, so that the bridge becomes edges of the mesh; the surface does not "
       "move."}};
}

Result<ItemPage> connected_boundary_page(Workshop& shop, const std::string& name) {
  const auto part = joined_part(shop, three_holes);
  if (!part) return tl::unexpected(part.error());
  const Annulus& annulus = part->annulus;
  const std::vector<Index> boundary = planner::connected_boundary(annulus.curves, annulus.bridges);
  const auto segments = planner::segments_between(annulus.curves, annulus.bridges);
  std::vector<view::NamedLines> pieces;
  constexpr std::size_t shades = 40;
  const std::vector<Vec3> points = closed_points(annulus.whole, boundary);
  for (std::size_t k = 0; k < shades; ++k) {
    const std::size_t first = k * (points.size() - 1) / shades, last = (k + 1) * (points.size() - 1) / shades;
    const auto begin = points.begin() + static_cast<std::ptrdiff_t>(first);
    pieces.push_back({k == 0            ? "first"
                      : k == shades / 2 ? "half way"
                      : k == shades - 1 ? "last"
                                        : "",
                      view::line_colour(static_cast<double>(k) / (shades - 1)),
                      {{begin, begin + static_cast<std::ptrdiff_t>(last - first + 1)}},
                      4.0});
  }
  std::vector<view::FigurePanel> panels;
  if (auto added = add_panel(panels, "the one boundary, in the order in which it is walked",
                             view::part_picture(part_view(part->inputs), pieces, view::panel_style(800, 560)));
      !added)
    return tl::unexpected(added.error());
  const auto file = shop.keep(name, panels, 1);
  if (!file) return tl::unexpected(file.error());
  double curves_mm = 0.0, bridges_mm = 0.0;
  for (const geometry::BoundaryLoop& curve : annulus.curves)
    curves_mm += length_mm(closed_points(annulus.whole, curve.vertices));
  for (const planner::Bridge& bridge : annulus.bridges)
    bridges_mm += length_mm(points_of(annulus.whole, bridge.vertices));
  return ItemPage{
      "From the outer boundary over the bridges, children first, and back over the opposite bridges: one closed curve.",
      {*file},
      {{{"boundary curves", "bridges", "segments", "their lengths + twice the bridges, mm", "the one curve, mm"},
        {std::to_string(annulus.curves.size()), std::to_string(annulus.bridges.size()), std::to_string(segments.size()),
         fixed_text(curves_mm + 2.0 * bridges_mm, 3), fixed_text(length_mm(points), 3)}}},
      {},
      {}};
}

Result<ItemPage> map_and_part(Workshop& shop, const std::string& name) {
  const auto part = joined_part(shop, two_holes);
  if (!part) return tl::unexpected(part.error());
  const auto map = planner::rectangle_map(part->annulus);
  if (!map) return tl::unexpected(map.error());
  const double stretch = std::max(1.0, drawn_height_share * map->width_mm / map->height_mm);
  const auto on_part = [&](const std::vector<Index>& vertices) { return points_of(part->annulus.sheet, vertices); };
  const auto on_map = [&](const std::vector<Index>& vertices) {
    std::vector<Vec3> points;
    for (const Index v : vertices)
      points.emplace_back(map->u_mm[static_cast<std::size_t>(v)], stretch * map->v_mm[static_cast<std::size_t>(v)],
                          0.0);
    return points;
  };
  std::vector<view::FigurePanel> panels;
  const view::PictureStyle style = view::panel_style(640, 440);
  if (auto added = add_panel(panels, "(a) the surface, cut along the bridges",
                             view::part_picture(part_view(part->inputs), four_sides(part->annulus, on_part), style));
      !added)
    return tl::unexpected(added.error());
  if (auto added =
          add_panel(panels, "(b) its map on the rectangle, v drawn " + fixed_text(stretch, 1) + " times as long",
                    view::map_picture(map_view(*part, *map, stretch), style, four_sides(part->annulus, on_map)));
      !added)
    return tl::unexpected(added.error());
  const auto file = shop.keep(name, panels, 2);
  if (!file) return tl::unexpected(file.error());
  return ItemPage{
      "The ring between the outer boundary (orange, bottom) and the bridged holes (green, top), cut at the seam, goes "
      "onto a "
      "rectangle (eqs. 3 to 9).",
      {*file},
      {{{"rectangle, mm", "triangles", "flipped", "quasi-conformal error"},
        {fixed_text(map->width_mm, 1) + " x " + fixed_text(map->height_mm, 1),
         std::to_string(part->annulus.sheet.triangles.size()), std::to_string(map->quality.flips),
         fixed_text(map->quality.quasi_conformal_error, 3)}}},
      {"Cotangent weights for the elastic coefficients w_ij of eq. 4, which the paper does not give."},
      {"Triangles crowd where a bridge meets a hole: there the map's gradient tends to zero, which is what makes the "
       "single increment of eq. 13 so small (see figure-12)."}};
}

Result<ItemPage> guide_lines(Workshop& shop, const std::string& name) {
  const auto inputs = shop.inputs(ring_job);
  if (!inputs) return tl::unexpected(inputs.error());
  const auto contours = coarse_paper_path(*inputs, planner::Strategy::contour_parallel);
  if (!contours) return tl::unexpected(contours.error());
  const auto spiral = coarse_paper_path(*inputs, planner::Strategy::spiral);
  if (!spiral) return tl::unexpected(spiral.error());
  const MapLines constant = constant_lines(*contours);
  std::vector<view::FigurePanel> panels;
  if (auto added = add_guide_panels(panels, *inputs, *contours, constant, "(a) lines of constant v, eq. 10",
                                    "(b) contour-parallel path");
      !added)
    return tl::unexpected(added.error());
  if (auto added = add_guide_panels(panels, *inputs, *spiral, spiral->map.guide_lines, "(c) slanted lines, eq. 11",
                                    "(d) spiral path");
      !added)
    return tl::unexpected(added.error());
  const auto file = shop.keep(name, panels, 2);
  if (!file) return tl::unexpected(file.error());
  return ItemPage{
      "The idea of the paper: on the unrolled ring, circles become lines of constant v and a helix becomes slanted "
      "lines. "
      "Where the paper draws a cylinder, here is the disc of radius 50 mm with a hole of radius 18 mm.",
      {*file},
      {{{"", "guide lines", "path, mm", "linkings", "sharp corners"},
        {"contour-parallel", std::to_string(constant.size()), fixed_text(contours->report.length_mm, 0),
         std::to_string(contours->report.linkings), std::to_string(contours->report.sharp_corners)},
        {"spiral", std::to_string(spiral->map.guide_lines.size()), fixed_text(spiral->report.length_mm, 0),
         std::to_string(spiral->report.linkings), std::to_string(spiral->report.sharp_corners)}}},
      {"Scallop " + fixed_text(coarse_scallop_mm, 1) +
       " mm with R3, so that single lines can be told apart; v is drawn longer than it is."},
      {"Eq. 11 as printed leaves a wedge uncut along each boundary; half a turn along either boundary belongs to the "
       "path "
       "here."}};
}

}  // namespace volute::app

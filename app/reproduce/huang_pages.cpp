// [Huang2016]: basis functions, and the three cases with their figures and tables.
#include <array>
#include <cmath>

#include "app/reproduce/huang_cases.hpp"
#include "app/reproduce/item.hpp"
#include "geometry/number_text.hpp"
#include "view/pictures.hpp"

namespace volute::app {

namespace {

using geometry::fixed_text;
using geometry::Result;
using geometry::short_text;
using geometry::Vec2;
using geometry::Vec3;
using planner::BasisKind;
using planner::RadialBasis;

constexpr int plot_points = 400;

struct NamedBasis {
  std::string name;
  RadialBasis basis;
};

view::PlotPanel basis_panel(const std::string& label, double end, const std::vector<NamedBasis>& bases) {
  view::PlotPanel panel{label, {}, {}};
  for (std::size_t i = 0; i < bases.size(); ++i) {
    view::PlotSeries series{bases[i].name, view::plot_colours()[i % view::plot_colours().size()], {}};
    for (int k = 0; k <= plot_points; ++k) {
      const double t = end * k / plot_points;
      series.points.emplace_back(t, planner::basis_value(bases[i].basis, t));
    }
    panel.series.push_back(std::move(series));
  }
  return panel;
}

/// The case's surface with key axes or field axes as strokes; every normal of the strokes' points beside.
view::RunView field_view(const FieldCase& one, int rows, int columns) {
  view::RunView view;
  view.title = one.name;
  view.surface_P = mesh_of(one, rows, columns);
  view.obstacles_P = one.obstacles_P;
  return view;
}

void add_axis_point(view::RunView& view, const FieldCase& one, const Vec2& uv, const Vec3& axis) {
  kinematics::ToolPathPoint point;
  point.contact_P_mm = one.point_P_mm(uv);
  point.normal_P = one.normal_P(uv);
  point.pose = {point.contact_P_mm, axis.normalized()};
  view.tool_path.points.push_back(point);
}

struct Grid {
  int rows, columns;
};

template <class Axis>
Result<view::Image> field_picture(const FieldCase& one, const Grid& strokes, double stroke_share, const Axis& axis) {
  view::RunView view = field_view(one, 60, 90);
  for (int i = 0; i <= strokes.rows; ++i)
    for (int j = 0; j <= strokes.columns; ++j) {
      const Vec2 uv(static_cast<double>(i) / strokes.rows, static_cast<double>(j) / strokes.columns);
      add_axis_point(view, one, uv, axis(uv));
    }
  return view::orientation_picture(view, view::panel_style(), {1e9, stroke_share});
}

Result<view::Image> key_picture(const FieldCase& one, double stroke_share) {
  view::RunView view = field_view(one, 60, 90);
  std::vector<std::size_t> marked;
  for (const planner::FieldKey& key : one.keys) {
    marked.push_back(view.tool_path.points.size());
    add_axis_point(view, one, key.place.uv, key.axis_P);
  }
  return view::orientation_picture(view, view::panel_style(800, 560), {1.0, stroke_share, marked, true, false, 0.45F});
}

Result<ItemPage> one_picture(Workshop& shop, const std::string& name, const std::string& caption,
                             Result<view::Image> image) {
  std::vector<view::FigurePanel> panels;
  if (auto added = add_panel(panels, caption, std::move(image)); !added) return tl::unexpected(added.error());
  const auto file = shop.keep(name, panels, 1);
  if (!file) return tl::unexpected(file.error());
  return ItemPage{{}, {*file}, {}, {}, {}};
}

Result<ItemPage> field_page(Workshop& shop, const std::string& name, const FieldCase& one, const Grid& strokes) {
  const auto fields = fields_of(one);
  if (!fields) return tl::unexpected(fields.error());
  std::vector<view::FigurePanel> panels;
  const double share = 0.06;
  if (auto added =
          add_panel(panels, "(a) interpolation by radial basis functions",
                    field_picture(one, strokes, share,
                                  [&](const Vec2& uv) { return interpolated_axis(one, fields->interpolation, uv); }));
      !added)
    return tl::unexpected(added.error());
  if (auto added =
          add_panel(panels, "(b) RBF-spline approximation",
                    field_picture(one, strokes, share, [&](const Vec2& uv) { return fields->spline.value(uv); }));
      !added)
    return tl::unexpected(added.error());
  const auto file = shop.keep(name, panels, 2);
  if (!file) return tl::unexpected(file.error());
  return ItemPage{"Tool axes of both fields, coloured by the angle from the surface normal.", {*file}, {}, {}, {}};
}

struct PrintedIndexes {
  const char *rbf, *spline, *accuracy;
};

/// The indexes of both fields in every reading of eq. 9, beside the printed ones.
Result<TextTable> index_table(const FieldCase& one, const PrintedIndexes& printed) {
  const auto fields = fields_of(one);
  if (!fields) return tl::unexpected(fields.error());
  const auto rbf = planner::smoothness(
      planner::sample_grid([&](const Vec2& uv) { return interpolated_axis(one, fields->interpolation, uv); },
                           one.index_rows, one.index_columns));
  const auto spline = planner::smoothness(planner::sample_grid([&](const Vec2& uv) { return fields->spline.value(uv); },
                                                               one.index_rows, one.index_columns));
  std::vector<Vec3> keys, at_keys, unit_at_keys;
  for (const planner::FieldKey& key : one.keys) {
    keys.push_back(key.axis_P);
    at_keys.push_back(fields->spline.value(key.place.uv));
    unit_at_keys.push_back(at_keys.back().normalized());
  }
  return TextTable{
      {"", "RBF", "RBF-spline"},
      {"S_TD, paper", printed.rbf, printed.spline},
      {"**S_TD, sum of squared differences / 8**", short_text(rbf.s_td_sum, 6), short_text(spline.s_td_sum, 6)},
      {"S_TD, eq. 9 to the letter", short_text(rbf.s_td_literal, 4), short_text(spline.s_td_literal, 4)},
      {"S_TD, differences taken as derivatives, mean", short_text(rbf.s_td_derivative, 6),
       short_text(spline.s_td_derivative, 6)},
      {"mean of (T_u² + T_v²) / 2, without the cross term", short_text(rbf.dirichlet, 6),
       short_text(spline.dirichlet, 6)},
      {"I_fa, paper", "1", printed.accuracy},
      {"**I_fa, field as it is**", "1", fixed_text(planner::fitting_accuracy(keys, at_keys), 9)},
      {"I_fa, field brought to unit length", "1", fixed_text(planner::fitting_accuracy(keys, unit_at_keys), 9)},
      {"greatest angle from a key, deg", "0", fixed_text(planner::largest_angle(keys, at_keys).degrees(), 3)}};
}

const std::string reading_remark =
    "Eq. 9 cannot be meant as printed: multiplied by du and dv and averaged it gives a value many powers of ten below "
    "the "
    "table, and read as a mean of derivatives one that lies far off. Only the plain sum of squared differences over 8 "
    "comes near; "
    "that sum grows with the grid, so it compares fields on one grid and nothing else.";
const std::string cross_term_remark =
    "The squared sum of eq. 9 keeps the product of T_u and T_v: a field that turns by u - v has S_TD = 0. It is no "
    "measure of "
    "smoothness; the row without the cross term is.";

Result<ItemPage> indexes_page(const FieldCase& one, const PrintedIndexes& printed) {
  auto table = index_table(one, printed);
  if (!table) return tl::unexpected(table.error());
  return ItemPage{"Grid of " + std::to_string(one.index_rows) + " x " + std::to_string(one.index_columns) +
                      " points, " + std::to_string(one.keys.size()) + " keys.",
                  {},
                  {std::move(*table)},
                  {},
                  {reading_remark, cross_term_remark,
                   "I_fa is 1 minus half the mean square of the angle only for axes of unit length; a field that is "
                   "longer than 1 at a "
                   "key can bring it above 1. The greatest angle says more."}};
}

const std::string strip_assumed =
    "Radius of the oblique cylinders (5.91 mm), number of keys round each (6, half a spacing turned) and the distance "
    "(straight, "
    "in mm): not in the paper. The radius was chosen so that the first value of Table 1 comes out near; only the "
    "second value and I_fa "
    "say anything.";
const std::string pin_assumed =
    "Shape of the pin, place and radius of the rod, and all keys: not in the paper. The height is the one that gives "
    "the "
    "printed mu : mv = 0.646 : 1. Keys along the surface normal on rings away from the rod, along the rod round both "
    "its ends.";

}  // namespace

Result<ItemPage> open_bases(Workshop& shop, const std::string& name) {
  view::Plot plot{"Radial basis functions for open surfaces", "distance t", {}};
  plot.panels.push_back(basis_panel("Gaussian", 3.0,
                                    {{"a = 0.5", {BasisKind::gaussian, 0.5}},
                                     {"a = 1", {BasisKind::gaussian, 1.0}},
                                     {"a = 2", {BasisKind::gaussian, 2.0}}}));
  plot.panels.push_back(basis_panel("inverse multi-quadric", 3.0,
                                    {{"c = 0.8, beta = 1", {BasisKind::inverse_multiquadric, 0.8, 1.0}},
                                     {"c = 1, beta = 0.5", {BasisKind::inverse_multiquadric, 1.0, 0.5}},
                                     {"c = 1, beta = 1", {BasisKind::inverse_multiquadric, 1.0, 1.0}},
                                     {"c = 1, beta = 2", {BasisKind::inverse_multiquadric, 1.0, 2.0}}}));
  const auto file = shop.keep(name, plot);
  if (!file) return tl::unexpected(file.error());
  return ItemPage{
      "The two functions of section 2.2.1 with different coefficients.",
      {*file},
      {},
      {"The coefficients drawn."},
      {"The text asks for phi(0) = 1; the function of Table 1, (0.8² + t²)^-1, has phi(0) = 1.5625. That changes "
       "coefficients, not the field."}};
}

Result<ItemPage> half_open_bases(Workshop& shop, const std::string& name) {
  view::Plot plot{"Radial basis functions for half-open surfaces, eq. 5", "distance t, turns", {}};
  plot.panels.push_back(basis_panel("N = 2", 0.5,
                                    {{"a = 0.2", {BasisKind::half_open, 0.2, 1.0, 2}},
                                     {"a = 0.3", {BasisKind::half_open, 0.3, 1.0, 2}},
                                     {"a = 0.4", {BasisKind::half_open, 0.4, 1.0, 2}},
                                     {"a = 0.49", {BasisKind::half_open, 0.49, 1.0, 2}}}));
  plot.panels.push_back(basis_panel("a = 0.4", 0.5,
                                    {{"N = 1", {BasisKind::half_open, 0.4, 1.0, 1}},
                                     {"N = 2", {BasisKind::half_open, 0.4, 1.0, 2}},
                                     {"N = 3", {BasisKind::half_open, 0.4, 1.0, 3}}}));
  const auto file = shop.keep(name, plot);
  if (!file) return tl::unexpected(file.error());
  return ItemPage{"Zero from t = a < 0.5 on, so that it does not matter which way round a distance is taken.",
                  {*file},
                  {},
                  {"The coefficients drawn."},
                  {"The text asks for g(a) = 1; with the argument t / a of eq. 5 it must be g(1) = 1."}};
}

Result<ItemPage> strip_keys(Workshop& shop, const std::string& name) {
  auto page = one_picture(shop, name, "key axes (red) at the corners and round the three cylinders",
                          key_picture(arched_strip_case(), 0.10));
  if (page) {
    page->opening =
        "Case 1: part of a cylinder of radius 160 mm (eq. 12) with three oblique cylinders that the tool must lean "
        "along.";
    page->assumed = {strip_assumed};
  }
  return page;
}

Result<ItemPage> strip_fields(Workshop& shop, const std::string& name) {
  auto page = field_page(shop, name, arched_strip_case(), {30, 10});
  if (page) page->assumed = {strip_assumed};
  return page;
}

Result<ItemPage> strip_indexes(Workshop&, const std::string&) {
  auto page = indexes_page(arched_strip_case(), {"0.9227", "0.9056", "0.999982"});
  if (!page) return page;
  page->assumed = {
      strip_assumed,
      "The interpolation is brought to unit length before it is sampled: with a = 0.8 mm it falls to a few "
      "hundredths between the keys."};
  page->remarks.push_back(
      "Equal knots as eq. 3 prints them make cubic interpolation worse and worse (its Lebesgue constant is 4 for 8 "
      "intervals, 243 for 30): averaged knots are used.");
  page->remarks.push_back("The paper's text says that RBF has the smaller S_TD, its Table 1 says the larger.");
  return page;
}

Result<ItemPage> pin_keys(Workshop& shop, const std::string& name) {
  auto page = one_picture(shop, name, "key axes (red) on the pin and round the rod's ends",
                          key_picture(bowling_pin_case(), 0.10));
  if (page) {
    page->opening = "Case 2: a bowling pin with a rod through it, the example of a half-open surface.";
    page->assumed = {pin_assumed};
  }
  return page;
}

Result<ItemPage> pin_field(Workshop& shop, const std::string& name) {
  auto page = field_page(shop, name, bowling_pin_case(), {26, 30});
  if (page) page->assumed = {pin_assumed};
  return page;
}

Result<ItemPage> pin_indexes(Workshop&, const std::string&) {
  auto page = indexes_page(bowling_pin_case(), {"19.9887", "19.9079", "0.999999999986"});
  if (!page) return page;
  page->assumed = {pin_assumed};
  page->remarks.push_back(
      "Surface, obstacle and keys are unknown, so the values of the paper cannot come out; what can be compared is "
      "that "
      "the spline differs from the interpolation by less than one per cent.");
  return page;
}

Result<ItemPage> half_sphere_fields(Workshop& shop, const std::string& name) {
  auto page = field_page(shop, name, half_sphere_case(), {9, 40});
  if (!page) return page;
  page->opening =
      "Case 3: half-sphere of diameter 20 mm; the axes lean 10 degrees further from the pole than the surface normal "
      "does.";
  page->remarks = {
      "At the pole all keys of the first ring meet in one point and lean 10 degrees each its own way: there the "
      "field has no single value, in the paper as here."};
  return page;
}

Result<ItemPage> half_sphere_indexes(Workshop&, const std::string&) {
  auto page = indexes_page(half_sphere_case(), {"9.35568", "9.30947", "0.9999972"});
  if (!page) return page;
  page->assumed = {
      "Keys at u = i/10, v = j/41: with v = 0 and v = 1 both kept, keys would coincide and the system would be "
      "singular.",
      "mu : mv = R : 2 pi R = 1 : 2 pi, by the rule of section 2.2.2; the grid reaches u = v = 1; N = 2 in eq. 5."};
  page->remarks.push_back(
      "With this reading RBF comes within 0.3 % and the spline within 0.2 % of the table, but their difference "
      "comes out ten times smaller than printed. The exact field without any interpolation gives 9.327, so the "
      "agreement "
      "says nothing about the interpolation.");
  return page;
}

}  // namespace volute::app

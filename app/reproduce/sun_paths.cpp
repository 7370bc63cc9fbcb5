// [Sun2016] Figs. 11 to 14: spirals and contour-parallel paths on surfaces with one, two and three holes, and on two
// patches.
#include <optional>

#include "app/reproduce/item.hpp"
#include "geometry/number_text.hpp"
#include "view/pictures.hpp"

namespace volute::app {

namespace {

using geometry::fixed_text;
using geometry::Result;
using planner::CcPathResult;
using planner::Method;
using planner::Strategy;

/// The printed method's turns lie so close on these parts that a drawing is one patch of colour: it is drawn with a
/// cutter and a scallop of its own.
constexpr double drawn_radius_mm = 6.0, drawn_scallop_mm = 3.0;

JobInputs with_large_cutter(JobInputs inputs) {
  inputs.job.tool.cutter.radius_mm = inputs.job.tool.cutter.corner_radius_mm = drawn_radius_mm;
  inputs.job.path.scallop_mm = drawn_scallop_mm;
  return inputs;
}

Result<CcPathResult> path_by(const JobInputs& inputs, Strategy strategy, Method method) {
  planner::PathOptions options = inputs.job.path;
  options.strategy = strategy;
  options.method = method;
  return planner::plan_cc_path(inputs.surface, inputs.job.tool.cutter, options, inputs.job.orientation);
}

std::string ratio(const std::optional<double>& value) { return value ? fixed_text(*value, 2) : "-"; }

std::vector<std::string> row_of(const std::string& what, const planner::PathReport& report) {
  return {what,
          fixed_text(report.length_mm, 0),
          fixed_text(report.length_ratio, 2),
          std::to_string(report.rapid_traversals),
          std::to_string(report.linkings),
          std::to_string(report.sharp_corners) + " (" + std::to_string(report.sharp_corners_60) + ")",
          ratio(report.scallop_ratio_p9999) + " / " + ratio(report.scallop_ratio_max)};
}

const std::vector<std::string> path_heading{"path",
                                            "length, mm",
                                            "length / bound",
                                            "rapids",
                                            "linkings",
                                            "corners over 35 (60) deg",
                                            "scallop / allowed, 99.99 % / max"};

/// Surface, the paper's two paths, and the spiral that Volute takes by default.
Result<ItemPage> holes_page(Workshop& shop, const std::string& name, const char* job, const std::string& holes) {
  const auto inputs = shop.inputs(job);
  if (!inputs) return tl::unexpected(inputs.error());
  ItemPage page;
  std::vector<view::FigurePanel> panels;
  const view::PictureStyle style = view::panel_style();
  if (auto added = add_panel(panels, "(a) the surface, " + holes, view::part_picture(part_view(*inputs), {}, style));
      !added)
    return tl::unexpected(added.error());
  page.tables.push_back({path_heading});
  const struct {
    const char *caption, *row;
    Strategy strategy;
    Method method;
  } paths[] = {
      {"(b) spiral, as in the paper", "spiral, `paper`", Strategy::spiral, Method::paper},
      {"(c) contour-parallel, as in the paper", "contour-parallel, `paper`", Strategy::contour_parallel, Method::paper},
      {"(d) spiral by Volute's own method `even`", "spiral, `even`", Strategy::spiral, Method::even}};
  for (const auto& path : paths) {
    const auto made = path_by(*inputs, path.strategy, path.method);
    if (!made) return tl::unexpected(made.error());
    const bool printed = path.method == Method::paper;
    const auto drawn = printed ? path_by(with_large_cutter(*inputs), path.strategy, path.method) : made;
    if (!drawn) return tl::unexpected(drawn.error());
    if (auto added = add_panel(panels, path.caption, view::path_picture(path_view(*inputs, drawn->path), style));
        !added)
      return tl::unexpected(added.error());
    page.tables.back().push_back(row_of(path.row, made->report));
    for (const std::string& note : made->report.notes) page.remarks.push_back(std::string(path.row) + ": " + note);
  }
  const auto file = shop.keep(name, panels, 2);
  if (!file) return tl::unexpected(file.error());
  page.pictures = {*file};
  page.opening = "A surface with " + holes +
                 ", the paper's two kinds of path on it, and the spiral that `volute run` takes "
                 "when nothing else is asked. The paper gives no numbers here.";
  page.assumed = {
      "The part (`examples/" + std::string(job) +
          ".toml`), its triangles, and in the table R3 with a scallop of 0.2 mm.",
      "(b) and (c) are drawn for a ball of R6 and a scallop of 3 mm, so that the turns can be told apart; the paper "
      "does not say what its figures were drawn with. The table and (d) are for R3 and 0.2 mm."};
  return page;
}

}  // namespace

Result<ItemPage> paths_one_hole(Workshop& shop, const std::string& name) {
  return holes_page(shop, name, "plate-one-hole", "one hole");
}
Result<ItemPage> paths_two_holes(Workshop& shop, const std::string& name) {
  auto page = holes_page(shop, name, "plate-two-holes", "two holes");
  if (page)
    page->remarks.push_back(
        "Eq. 13 takes one increment for the whole surface, the least one. With two holes or more it tends to zero "
        "where a "
        "bridge meets a hole, the more the finer the triangles are; without leaving out a share of the area the path "
        "would have no end.");
  return page;
}
Result<ItemPage> paths_three_holes(Workshop& shop, const std::string& name) {
  return holes_page(shop, name, "plate-three-holes", "three holes");
}

Result<ItemPage> two_patches(Workshop& shop, const std::string& name) {
  ItemPage page;
  std::vector<view::FigurePanel> panels;
  page.tables.push_back({path_heading});
  const struct {
    const char *job, *caption, *row;
  } patches[] = {{"disc-wavy", "(a) a patch without a hole", "no hole"},
                 {"disc-with-hole", "(b) a patch with a hole", "one hole"}};
  for (const auto& patch : patches) {
    const auto inputs = shop.inputs(patch.job);
    if (!inputs) return tl::unexpected(inputs.error());
    const auto made = path_by(*inputs, Strategy::spiral, Method::even);
    if (!made) return tl::unexpected(made.error());
    if (auto added =
            add_panel(panels, patch.caption, view::path_picture(path_view(*inputs, made->path), view::panel_style()));
        !added)
      return tl::unexpected(added.error());
    page.tables.back().push_back(row_of(patch.row, made->report));
  }
  const auto file = shop.keep(name, panels, 2);
  if (!file) return tl::unexpected(file.error());
  page.pictures = {*file};
  page.opening =
      "A compound surface is machined patch by patch. In the paper the patch without a hole takes the spiral of an "
      "earlier "
      "work, that with a hole the new one; here the same method does both: a surface without a hole gets a short slit "
      "as "
      "its centre.";
  page.assumed = {"Two rippled discs of radius 50 mm instead of the football's patches, which are not published."};
  return page;
}

}  // namespace volute::app

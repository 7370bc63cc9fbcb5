// [Sun2016] Tables 1 and 2 and Figs. 15 to 18: three strategies on two parts, machined on the virtual machine.
#include <algorithm>
#include <array>
#include <cmath>

#include "app/machining_feed.hpp"
#include "app/reproduce/item.hpp"
#include "geometry/number_text.hpp"
#include "view/pictures.hpp"

namespace volute::app {

namespace {

using geometry::fixed_text;
using geometry::Result;
using geometry::short_text;
using planner::Strategy;

constexpr double per_minute = 60.0;
constexpr double close_up_mm = 9.0;

/// A row of Table 2 as printed.
struct PrintedRow {
  const char* path;
  Strategy ours;
  const char *rapids, *liftings, *linkings, *corners, *uncut, *feed, *loss;
  int interruptions;     ///< rapids and linkings, and the first approach with the last retract as one
  double lost_per_cent;  ///< the loss without its sign
};

struct PrintedPart {
  const char *figure, *job;
  std::array<PrintedRow, 3> rows;
};

const std::array<PrintedPart, 2> table_2{
    {{"Fig. 15(a)",
      "plate-two-holes",
      {{{"CP path", Strategy::contour_offset, "1", "4", "26", "92", "Y", "277.6", "-7.47", 28, 7.47},
        {"SP path", Strategy::projected_spiral, "46", "94", "0", "0", "N", "290.2", "-3.27", 47, 3.27},
        {"Proposed", Strategy::spiral, "0", "2", "0", "0", "N", "298.9", "-0.37", 1, 0.37}}}},
     {"Fig. 16(a)",
      "mouse",
      {{{"CP path", Strategy::contour_offset, "1", "4", "22", "24", "Y", "241.5", "-3.40", 24, 3.40},
        {"SP path", Strategy::projected_spiral, "259", "520", "0", "0", "Y", "232.4", "-7.04", 260, 7.04},
        {"Proposed", Strategy::spiral, "0", "2", "0", "0", "N", "249.1", "-0.36", 1, 0.36}}}}}};

std::vector<std::string> printed_cells(const PrintedPart& part, const PrintedRow& row) {
  return {part.figure,
          std::string(row.path) + ", paper",
          row.rapids,
          row.liftings,
          row.linkings,
          row.corners,
          row.uncut,
          row.feed,
          row.loss,
          "",
          ""};
}

/// Ours beside a printed row: strategy and axis.
std::string our_name(const PrintedRow& row, ComparedAxis axis) {
  return std::string(strategy_name(row.ours)) + (axis == ComparedAxis::normal ? ", axis normal" : "");
}

/// The axes that ours runs with beside a printed row: the baselines as a CAM system leaves them, too.
std::vector<ComparedAxis> our_axes(const PrintedRow& row) {
  if (row.ours == Strategy::spiral) return {ComparedAxis::as_job};
  return {ComparedAxis::normal, ComparedAxis::as_job};
}

std::vector<std::string> our_cells(const PrintedPart& part, const PrintedRow& row, ComparedAxis axis,
                                   const MadeRun& run) {
  const planner::PathReport& path = run.plan.cc.report;
  const auto feed = machining_feed(run.plan.tool_path, run.verified);
  return {"`" + std::string(part.job) + "`",
          "**" + our_name(row, axis) + ", ours**",
          std::to_string(path.rapid_traversals),
          std::to_string(path.liftings),
          std::to_string(path.linkings),
          std::to_string(path.sharp_corners),
          run.verified.cut && run.verified.cut->uncut ? "Y" : "N",
          fixed_text(run.verified.run.actual_feed_mm_s * per_minute, 1),
          fixed_text(run.verified.run.feed_loss_percent, 2),
          feed ? fixed_text(feed->loss_percent, 2) : "-",
          feed && feed->unlimited_jerk_loss_percent ? fixed_text(*feed->unlimited_jerk_loss_percent, 2) : "-"};
}

/// The loss with (37) read literally: seconds without path length, shared by what interrupts the cut. The paper prints
/// no length; its rows are reckoned with the length of ours.
std::vector<std::string> interruption_cells(const PrintedPart& part, const PrintedRow& row, const MadeRun& run) {
  const planner::PathReport& path = run.plan.cc.report;
  std::vector<std::string> cells{"`" + std::string(part.job) + "`",
                                 std::string(row.path) + "; " + strategy_name(row.ours)};
  const auto feed = machining_feed(run.plan.tool_path, run.verified);
  if (!feed) {
    cells.insert(cells.end(), 7, "-");
    return cells;
  }
  const double programmed_s = feed->cutting_length_mm / feed->programmed_mm_s;
  const double lost_share = row.lost_per_cent / 100.0;
  const double printed_s = programmed_s * lost_share / (1.0 - lost_share);
  const double ours_s = feed->cutting_length_mm / feed->actual_mm_s - programmed_s;
  const int ours = path.rapid_traversals + path.linkings + 1;
  for (const std::string& cell : {fixed_text(programmed_s, 0), std::string(row.loss), std::to_string(row.interruptions),
                                  fixed_text(printed_s / row.interruptions, 1), fixed_text(feed->loss_percent, 2),
                                  std::to_string(ours), fixed_text(ours_s / ours, 1)})
    cells.push_back(cell);
  return cells;
}

/// What the table does not print, and one wants to know.
std::vector<std::string> measured_cells(const PrintedPart& part, const PrintedRow& row, ComparedAxis axis,
                                        const MadeRun& run) {
  const auto& cut = run.verified.cut;
  return {"`" + std::string(part.job) + "`",
          our_name(row, axis),
          fixed_text(run.plan.cc.report.length_mm, 0),
          fixed_text(run.verified.run.cycle_time_s, 0),
          cut ? fixed_text(cut->scallop_max_mm, 3) : "-",
          cut ? fixed_text(cut->uncut_area_mm2, 1) : "-",
          std::to_string(run.verified.findings.size())};
}

Result<ItemPage> strategies_page(Workshop& shop, const std::string& name, const PrintedPart& part) {
  std::vector<view::FigurePanel> panels;
  const view::PictureStyle style = view::panel_style();
  constexpr std::array captions{"(b) contour-parallel as CAM systems do it (offsets)", "(c) spiral projected along z",
                                "(d) Volute's spiral"};
  for (std::size_t i = 0; i < part.rows.size(); ++i) {
    const auto run = shop.run(part.job, part.rows[i].ours);
    if (!run) return tl::unexpected(run.error());
    if (i == 0)
      if (auto added = add_panel(panels, "(a) the surface", view::part_picture(part_view((*run)->inputs), {}, style));
          !added)
        return tl::unexpected(added.error());
    if (auto added = add_panel(panels, captions[i], view::path_picture((*run)->view, style)); !added)
      return tl::unexpected(added.error());
  }
  const auto file = shop.keep(name, panels, 2);
  if (!file) return tl::unexpected(file.error());
  return ItemPage{"The three paths of Table 2 on this part; their counts stand there.",
                  {*file},
                  {},
                  {"The part `examples/" + std::string(part.job) + ".toml`: the paper's model is not published."},
                  {}};
}

/// A box about the vertex that deviates most.
std::optional<view::Box> worst_place(const view::RunView& view) {
  std::optional<std::size_t> worst;
  const auto& deviation = view.cut->vertex_deviation_mm;
  for (std::size_t i = 0; i < deviation.size(); ++i)
    if (std::isfinite(deviation[i]) && (!worst || std::abs(deviation[i]) > std::abs(deviation[*worst]))) worst = i;
  if (!worst) return std::nullopt;
  view::Box box;
  for (const double sign : {-1.0, 1.0})
    view::grow(box, view.surface_P.vertices_mm[*worst] + geometry::Vec3::Constant(sign * close_up_mm));
  return box;
}

struct MachinedPart {
  view::RunView view;
  std::string caption;
};

Result<ItemPage> machined_page(Workshop& shop, const std::string& name, const PrintedPart& part) {
  std::vector<MachinedPart> machined;
  constexpr std::array captions{"(a) Volute's spiral", "(b) contour-parallel (offsets)", "(c) projected spiral"};
  constexpr std::array<std::size_t, 3> order{2, 0, 1};
  double scallop_mm = 0.0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto run = shop.run(part.job, part.rows[order[i]].ours);
    if (!run) return tl::unexpected(run.error());
    machined.push_back({(*run)->view, captions[i]});
    scallop_mm = (*run)->inputs.job.path.scallop_mm;
  }
  std::vector<view::FigurePanel> panels;
  const view::PictureStyle style = view::panel_style();
  const double range_mm = 2.0 * scallop_mm;
  for (const MachinedPart& one : machined)
    if (auto added = add_panel(panels, one.caption, view::machined_picture(one.view, style, {range_mm, {}})); !added)
      return tl::unexpected(added.error());
  if (auto added =
          add_panel(panels, "(d) the worst place of (b)",
                    view::machined_picture(machined[1].view, style, {range_mm, worst_place(machined[1].view)}));
      !added)
    return tl::unexpected(added.error());
  const auto file = shop.keep(name, panels, 2);
  if (!file) return tl::unexpected(file.error());
  return ItemPage{
      "Where the paper has photographs, here is what the virtual machine leaves: deviation from the design surface, "
      "above "
      "zero left standing, below zero gouged, black where no cutter came near. One colour scale for all, up to twice "
      "the "
      "allowed scallop of " +
          short_text(scallop_mm) + " mm.",
      {*file},
      {},
      {"Part, machine and control: see table-2."},
      {"Marks of the cutter's entry and of lifting, which the photographs show, come from deflection and wear: the "
       "virtual "
       "machine is rigid."}};
}

}  // namespace

Result<ItemPage> process_parameters(Workshop& shop, const std::string&) {
  TextTable table{
      {"model surface", "", "cutter radius, mm", "scallop, mm", "tolerance, mm", "spindle, rpm", "feed, mm/min"}};
  const std::array<std::array<const char*, 5>, 2> printed{
      {{"3", "0.200", "0.010", "3000", "300"}, {"1", "0.100", "0.010", "5000", "250"}}};
  for (std::size_t i = 0; i < table_2.size(); ++i) {
    const auto inputs = shop.inputs(table_2[i].job);
    if (!inputs) return tl::unexpected(inputs.error());
    const Job& job = inputs->job;
    table.push_back(
        {table_2[i].figure, "paper", printed[i][0], printed[i][1], printed[i][2], printed[i][3], printed[i][4]});
    table.push_back({"`" + std::string(table_2[i].job) + "`", "**ours**", short_text(job.tool.cutter.radius_mm),
                     fixed_text(job.path.scallop_mm, 3), fixed_text(job.path.tolerance_mm, 3),
                     fixed_text(job.spindle_rpm, 0), fixed_text(job.process.feed_mm_s * per_minute, 0)});
  }
  return ItemPage{"The parameters stand in the job files and are read from there.",
                  {},
                  {table},
                  {"Ball noses, with lengths, shanks and holders as the job files say: the paper names a radius only."},
                  {}};
}

Result<ItemPage> strategies_compared(Workshop& shop, const std::string&) {
  TextTable table{{"model surface", "path", "rapids", "liftings", "linkings", "sharp corners", "uncut", "feed, mm/min",
                   "loss, %", "loss of the whole machining, %", "if no jerk were limited, %"}};
  TextTable measured{{"part", "path", "length, mm", "cycle, s", "greatest scallop, mm", "uncut, mm²", "findings"}};
  TextTable literal{{"part", "path", "programmed time of ours, s", "paper: loss, %", "interruptions", "s each",
                     "ours: loss of the whole machining, %", "interruptions", "s each"}};
  for (const PrintedPart& part : table_2)
    for (const PrintedRow& row : part.rows) {
      table.push_back(printed_cells(part, row));
      for (const ComparedAxis axis : our_axes(row)) {
        const auto run = shop.run(part.job, row.ours, axis);
        if (!run) return tl::unexpected(run.error());
        table.push_back(our_cells(part, row, axis, **run));
        measured.push_back(measured_cells(part, row, axis, **run));
        if (axis == ComparedAxis::as_job) literal.push_back(interruption_cells(part, row, **run));
      }
    }
  return ItemPage{
      "Three kinds of path on two parts: how often the tool lifts, turns sharply or leaves material, and how much of "
      "the "
      "programmed feed the machine reaches.",
      {},
      {table, literal, measured},
      {"Both parts: sizes and features like those of the paper's figures. CP is `contour-offset`, SP is "
       "`projected-spiral`: UG/CAM's own algorithms are not published. *Axis normal*: the axis stays along the surface "
       "normal, as CAM systems leave it unless told otherwise; the other rows have Volute's smoothed axes. The paper "
       "does not say how the axes of its CP and SP paths went.",
       "The machine and its control: travels, limits of speed, acceleration and jerk, look-ahead, corner tolerance of "
       "the "
       "profile `ac-head-fanuc`; the paper names neither.",
       "A corner counts when chords of half a path interval turn by more than 35 degrees; material counts as uncut "
       "above 1.1 "
       "times the scallop plus the tolerance. The paper defines neither."},
      {"The counts of CP and SP belong to other algorithms on other parts and cannot agree. What can be compared is "
       "the "
       "order: the spiral does not lift, keeps its feed, and leaves nothing.",
       "*Feed* and *loss* are those of the feed moves: their length over their time. Eq. 37 says length of tool path "
       "over "
       "actual machining time; *loss of the whole machining* reads it so: everything from the first feed move to the "
       "end "
       "of the last is time, only the cutting passes are length. The virtual control keeps jerk by an average, which "
       "uses less of a rotary's acceleration than a control that plans jerk along the path: such a control lies "
       "between "
       "that column and the last one.",
       "With the axis along the normal both baselines lose several per cent on both parts: C holds them up, most on "
       "the "
       "plate, whose normals are near the pole of A and C. The spiral with its axes planned in A and C loses next to "
       "nothing.",
       "The second table takes the paper's losses apart: an interruption (rapid with its leads, linking; first "
       "approach "
       "and last retract as one) is time without length. They are a few seconds for every linking, under one for every "
       "rapid; its feeds do not need a machine that can hardly brake. See [the virtual control](virtual-control.md).",
       "The text of section 7.3 counts 94 sharp corners for CP on Fig. 15(a), the table 92."}};
}

Result<ItemPage> strategies_two_holes(Workshop& shop, const std::string& name) {
  return strategies_page(shop, name, table_2[0]);
}
Result<ItemPage> strategies_mouse(Workshop& shop, const std::string& name) {
  return strategies_page(shop, name, table_2[1]);
}
Result<ItemPage> machined_two_holes(Workshop& shop, const std::string& name) {
  return machined_page(shop, name, table_2[0]);
}
Result<ItemPage> machined_mouse(Workshop& shop, const std::string& name) {
  return machined_page(shop, name, table_2[1]);
}

}  // namespace volute::app

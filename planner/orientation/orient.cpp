#include "planner/orientation/orient.hpp"

#include <algorithm>
#include <cmath>

#include <tbb/parallel_for.h>

#include "geometry/check.hpp"
#include "geometry/number_text.hpp"
#include "planner/orientation/allowed_set.hpp"
#include "planner/orientation/branch.hpp"
#include "planner/orientation/corridor.hpp"
#include "planner/orientation/field_loop.hpp"
#include "planner/orientation/motion.hpp"
#include "planner/orientation/neighbours.hpp"
#include "planner/orientation/pin_loop.hpp"
#include "planner/orientation/reference.hpp"

namespace volute::planner {

using geometry::Angle;
using geometry::bad_input;
using geometry::short_text;

namespace {

// Paths without turns: the reference axis is averaged over this length.
constexpr double reference_window_mm = 20.0;

std::string smoothing_name(Smoothing smoothing) {
  switch (smoothing) {
    case Smoothing::none:
      return "none";
    case Smoothing::velocity:
      return "velocity";
    case Smoothing::acceleration:
      return "acceleration";
    case Smoothing::field:
      return "field";
    case Smoothing::corridor:
      return "corridor";
  }
  return "none";
}

int count(const std::vector<char>& marks) { return static_cast<int>(std::count(marks.begin(), marks.end(), 1)); }

/// Everything that the steps of orienting one piece share.
struct Orienting {
  const CcPiece& piece;
  const kinematics::Tool& tool;
  const OrientationOptions& options;
  double feed_mm_s;
  RotaryChart chart;
  std::vector<Station> stations;
  OrientationReport report;
  const TurnMeans* turns = nullptr;  ///< of the whole path, where the piece is one of several

  [[nodiscard]] int points() const { return static_cast<int>(stations.size()); }
};

std::string point_name(const Orienting& work, int i) {
  return std::to_string(work.stations[static_cast<std::size_t>(i)].source);
}

void note_lifts(Orienting& work) {
  int lifted = 0, between = 0;
  double most = 0.0;
  for (const Station& station : work.stations) {
    if (station.lift_mm <= 0.0 && !station.between) continue;
    ++(station.between ? between : lifted);
    most = std::max(most, station.lift_mm);
  }
  if (lifted + between == 0) return;
  work.report.notes.push_back(std::to_string(lifted) + " CC points lifted and " + std::to_string(between) +
                              " put in between, by up to " + short_text(most, 3) +
                              " mm: the ball does not fit there without gouging");
}

std::vector<Rotaries> rotaries_along(const Orienting& work, const std::vector<Vec3>& axes) {
  std::vector<PlacedAxis> placed;
  placed.reserve(axes.size());
  for (std::size_t i = 0; i < axes.size(); ++i) placed.push_back({axes[i], work.stations[i].s_mm, false});
  const BranchChoice choice = choose_branches(work.chart, placed);
  return choice.unreachable >= 0 ? std::vector<Rotaries>{} : filled(choice, placed);
}

/// A rotary whose travel cannot hold the winding of the path is released: solve_path puts rewinds in.
void release_wound_axes(Orienting& work, const std::vector<Vec3>& axes) {
  std::vector<PlacedAxis> placed;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    if (work.chart.reaches(axes[i])) placed.push_back({axes[i], work.stations[i].s_mm, false});
  }
  const BranchChoice choice = choose_branches(work.chart, placed);
  if (choice.jump_max_rad < 1.5 * std::numbers::pi) return;
  for (int k = 0; k < 2; ++k) {
    const kinematics::Axis& axis = work.chart.axis(k);
    if (work.chart.is_endless(k) || *axis.travel_max - *axis.travel_min < 2.0 * std::numbers::pi) continue;
    work.chart.release(k);
    work.report.notes.push_back(std::string("the travel of ") + axis.letter +
                                " cannot hold the winding of the path: the axis path needs rewinds");
  }
}

std::vector<char> blocked_marks(const AllowedSet& allowed, const std::vector<Vec3>& axes) {
  std::vector<char> marks(axes.size(), 0);
  tbb::parallel_for(std::size_t{0}, axes.size(), [&](std::size_t i) {
    marks[i] = allowed.blocked(static_cast<int>(i), axes[i]) == Blocked::no ? 0 : 1;
  });
  return marks;
}

/// Swings the axis only where it must: to the nearest allowed one ([Sun2016] 7.4, the traditional way). Points without
/// any: `none`.
std::vector<Vec3> dodged(const AllowedSet& allowed, std::vector<Vec3> axes, const std::vector<char>& blocked,
                         std::vector<int>& none) {
  std::vector<char> found(axes.size(), 1);
  tbb::parallel_for(std::size_t{0}, axes.size(), [&](std::size_t i) {
    if (blocked[i] == 0) return;
    const auto axis = allowed.nearest(static_cast<int>(i), axes[i], Angle());
    found[i] = axis ? 1 : 0;
    if (axis) axes[i] = *axis;
  });
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (found[i] == 0) none.push_back(static_cast<int>(i));
  }
  return axes;
}

tl::unexpected<geometry::Error> no_orientation(const Orienting& work, const AllowedSet& allowed,
                                               const std::vector<int>& none, const std::vector<Vec3>& wanted) {
  std::vector<char> marks(work.stations.size(), 0);
  for (const int i : none) marks[static_cast<std::size_t>(i)] = 1;
  std::string where;
  const std::vector<BlockedArea> areas = blocked_areas(marks);
  for (std::size_t k = 0; k < std::min<std::size_t>(areas.size(), 8); ++k) {
    where += (where.empty() ? "" : ", ") + point_name(work, areas[k].first);
    if (areas[k].last > areas[k].first) where += " to " + point_name(work, areas[k].last);
  }
  if (areas.size() > 8) where += " and " + std::to_string(areas.size() - 8) + " more runs";
  const std::string what = allowed.what_blocks(none.front(), wanted[static_cast<std::size_t>(none.front())]);
  return bad_input("orientation-none",
                   "CC points " + where + ": no tool orientation is allowed; in the way: " + what +
                       "; use a longer or slimmer tool, a smaller clearance, wider tilt limits, or move the obstacle");
}

std::vector<FixedPin> user_pins(const Orienting& work) {
  std::vector<FixedPin> pins;
  for (const KeyOrientation& key : work.options.keys) {
    if (!key.path_fraction) continue;
    const double s = *key.path_fraction * work.stations.back().s_mm;
    const auto place = std::lower_bound(work.stations.begin(), work.stations.end(), s,
                                        [](const Station& a, double value) { return a.s_mm < value; });
    const auto index = std::min<std::ptrdiff_t>(place - work.stations.begin(), work.points() - 1);
    pins.push_back({static_cast<int>(index), key.axis_P.normalized()});
  }
  return pins;
}

OrientedPath finished(Orienting& work, const AllowedSet& allowed, const std::vector<Rotaries>& at,
                      std::vector<int> pins) {
  OrientedPath path;
  std::vector<Vec3> axes;
  std::vector<double> s;
  for (int i = 0; i < work.points(); ++i) {
    const Station& station = work.stations[static_cast<std::size_t>(i)];
    axes.push_back(work.chart.axis_P(at[static_cast<std::size_t>(i)]));
    s.push_back(station.s_mm);
    path.tool_path.points.push_back({allowed.pose(i, axes.back()),
                                     station.link ? kinematics::MoveKind::link : kinematics::MoveKind::cut,
                                     work.feed_mm_s, station.contact_P_mm, station.normal_P, station.turn});
  }
  const auto column = [&](std::size_t k) {
    std::vector<double> values;
    for (const Rotaries& r : at) values.push_back(r[k]);
    return values;
  };
  work.report.first_letter = work.chart.axis(0).letter;
  work.report.second_letter = work.chart.axis(1).letter;
  work.report.first = motion_peaks(s, column(0), work.feed_mm_s);
  work.report.second = motion_peaks(s, column(1), work.feed_mm_s);
  work.report.neighbour_turn_max_rad = neighbour_turn_max_rad(work.stations, axes, neighbour_reach_mm);
  work.report.pins = static_cast<int>(pins.size());
  path.rotaries_rad = at;
  path.pins = std::move(pins);
  path.report = std::move(work.report);
  return path;
}

Result<OrientedPath> orient_traditionally(Orienting& work, const AllowedSet& allowed, const std::vector<Vec3>& planned,
                                          const std::vector<char>& blocked) {
  std::vector<int> none;
  const std::vector<Vec3> axes = dodged(allowed, planned, blocked, none);
  if (!none.empty()) return no_orientation(work, allowed, none, planned);
  const std::vector<Rotaries> at = rotaries_along(work, axes);
  VOLUTE_CHECK(!at.empty(), axes.size());
  const std::vector<char> bad = check_path(allowed, at, false);
  work.report.interferences_after = count(bad);
  if (count(bad) > 0)
    work.report.notes.push_back("swinging only to dodge leaves " + std::to_string(count(bad)) +
                                " motions between CC points that touch: use a smoothing");
  return finished(work, allowed, at, {});
}

tl::unexpected<geometry::Error> no_chain(const Orienting& work, const AllowedSet& allowed,
                                         const CorridorResult& corridor, const std::vector<Vec3>& wanted) {
  if (!corridor.empty.empty()) return no_orientation(work, allowed, corridor.empty, wanted);
  const std::string where = corridor.stuck < 0 ? "some CC points" : "CC point " + point_name(work, corridor.stuck);
  return bad_input("orientation-unreached",
                   where +
                       ": allowed tool orientations exist at every CC point, but no motion from one to the next was "
                       "found with the rotary axes 1.9 degrees apart; use a longer or slimmer tool, a smaller "
                       "clearance, wider tilt limits, or move the obstacle");
}

std::string why(const AllowedSet& allowed, int i, const Vec3& axis_P) {
  switch (allowed.blocked(i, axis_P)) {
    case Blocked::travel:
      return "the rotary axes cannot reach it";
    case Blocked::tilt:
      return "its tilt from the surface normal is outside the limits";
    case Blocked::width:
      return "the cut would be narrower than the path was planned for";
    default:
      return "something touches there";
  }
}

/// The first key that is not allowed where it stands.
std::optional<geometry::Error> refused_key(const Orienting& work, const AllowedSet& allowed,
                                           const std::vector<FixedPin>& fixed) {
  for (const FixedPin& pin : fixed) {
    if (allowed.blocked(pin.index, pin.axis_P) == Blocked::no) continue;
    const auto text = [&](Eigen::Index k) { return short_text(pin.axis_P[k], 4); };
    return bad_input("orientation-key-blocked", "orientation.keys: axis [" + text(0) + ", " + text(1) + ", " + text(2) +
                                                    "] at CC point " + point_name(work, pin.index) +
                                                    " is not allowed: " + why(allowed, pin.index, pin.axis_P) +
                                                    "; choose another axis there, or another place")
        .value();
  }
  return std::nullopt;
}

struct PinnedPath {
  PinLoopResult loop;
  std::vector<FixedPin> fixed;
  std::optional<CorridorResult> corridor;  ///< where something stands in the way of the reference
};

/// The pins come from a calm row of allowed axes: the reference where nothing is in its way, else the corridor's curve.
Result<PinnedPath> pinned(const Orienting& work, const AllowedSet& allowed, const OrientationOptions& options) {
  std::vector<Vec3> axes = reference_axes(allowed, reference_window_mm, work.turns);
  const std::vector<char> blocked = blocked_marks(allowed, axes);
  PinnedPath path;
  path.fixed = user_pins(work);
  if (auto error = refused_key(work, allowed, path.fixed)) return tl::unexpected(*error);
  // Keys of the user are the critical points then; the loop adds what they leave touching.
  const std::vector<int> critical =
      path.fixed.empty() ? critical_points(work.points(), blocked_areas(blocked)) : std::vector<int>{};
  if (count(blocked) > 0) {
    path.corridor = run_corridor(allowed, axes);
    if (path.corridor->at.empty()) return no_chain(work, allowed, *path.corridor, axes);
    for (std::size_t i = 0; i < axes.size(); ++i) axes[i] = work.chart.axis_P(path.corridor->at[i]);
  }
  path.loop = run_pin_loop(allowed, axes, std::vector<char>(axes.size(), 0), critical, path.fixed, options);
  return path;
}

Result<OrientedPath> orient_by_pins(Orienting& work, const AllowedSet& allowed) {
  const auto path = pinned(work, allowed, work.options);
  if (!path) return tl::unexpected(path.error());
  work.report.iterations = path->loop.iterations;
  work.report.solve_s = path->loop.solve_s;
  if (!path->loop.free) {
    return bad_input(
        "orientation-not-converged",
        "after " + std::to_string(path->loop.iterations) +
            " rounds of pinning some CC points still touch; use smoothing = \"corridor\", or raise iterations_max");
  }
  return finished(work, allowed, path->loop.at, path->loop.pins);
}

/// At the pole a key holds one rotary and leaves the other free.
std::vector<HeldStation> held_by(const Orienting& work, const PinnedPath& path) {
  std::vector<HeldStation> held;
  for (const FixedPin& pin : path.fixed) {
    held.push_back({pin.index, path.loop.at[static_cast<std::size_t>(pin.index)], {true, true}});
    for (const RotaryChoice& choice : work.chart.choices(pin.axis_P)) {
      if (choice.free_axis >= 0) held.back().rotary[static_cast<std::size_t>(choice.free_axis)] = false;
    }
  }
  return held;
}

/// Of the curve in the corridor and the pinned curve lowered the one with the lower peaks; never above the pinned one.
CorridorResult lowest_curve(const AllowedSet& allowed, const PinnedPath& path, const std::vector<HeldStation>& held) {
  if (path.corridor && held.empty()) {
    CorridorResult result = *path.corridor;
    // The corridor's own work is counted once, by the caller.
    result.iterations = 0, result.solve_s = 0.0;
    if (auto still = standing_still(allowed, result.at)) {
      result.at = std::move(*still);
      return result;
    }
    if (!path.loop.free || no_peak_above(peaks_per_mm(allowed, result.at), peaks_per_mm(allowed, path.loop.at)))
      return result;
  }
  return lower_peaks(allowed, path.loop.at, held);
}

Result<OrientedPath> orient_in_corridor(Orienting& work, const AllowedSet& allowed) {
  OrientationOptions options = work.options;
  options.smoothing = Smoothing::acceleration;
  auto path = pinned(work, allowed, options);
  if (!path) return tl::unexpected(path.error());
  const std::vector<HeldStation> held = held_by(work, *path);
  if (!path->loop.free && !held.empty())
    return bad_input("orientation-not-converged",
                     "no curve through the " + std::to_string(held.size()) +
                         " key orientations stays clear of everything; move a key, or leave some out");
  if (!path->corridor && held.empty()) {
    const std::vector<Vec3> reference = reference_axes(allowed, reference_window_mm, work.turns);
    path->corridor = run_corridor(allowed, reference);
    if (path->corridor->at.empty() && !path->loop.free) return no_chain(work, allowed, *path->corridor, reference);
    if (path->corridor->at.empty()) path->corridor.reset();
  }
  const CorridorResult lowest = lowest_curve(allowed, *path, held);
  work.report.iterations = lowest.iterations + (path->corridor ? path->corridor->iterations : 0);
  work.report.solve_s = lowest.solve_s + (path->corridor ? path->corridor->solve_s : 0.0);
  std::vector<int> pins;
  for (const HeldStation& one : held) pins.push_back(one.station);
  return finished(work, allowed, lowest.at, std::move(pins));
}

/// [Huang2016] Fig. 2: the axes follow a field through key axes, with keys added until every point is allowed.
Result<OrientedPath> orient_by_field(Orienting& work, const AllowedSet& allowed) {
  const auto loop =
      run_field_loop(allowed, reference_axes(allowed, reference_window_mm, work.turns), user_pins(work), work.options);
  if (!loop) return tl::unexpected(loop.error());
  work.report.iterations = loop->iterations;
  work.report.solve_s = loop->solve_s;
  work.report.notes.push_back("orientation field through " + std::to_string(loop->keys) + " key axes");
  const std::vector<Rotaries> at = loop->allowed ? rotaries_along(work, loop->axes_P) : std::vector<Rotaries>{};
  const int touching = at.empty() ? 0 : count(check_path(allowed, at, false));
  if (at.empty() || touching > 0)
    return bad_input("orientation-not-converged",
                     "the orientation field through " + std::to_string(loop->keys) +
                         " key axes still touches or leaves the limits after " + std::to_string(loop->iterations) +
                         " rounds; add keys near the obstacle, widen tilt_max_deg, or use smoothing = \"corridor\"");
  return finished(work, allowed, at, {});
}

}  // namespace

Result<OrientedPath> orient(const CcPiece& piece, const kinematics::Tool& tool, const kinematics::Machine& machine,
                            const kinematics::Setup& setup, const Interference& interference,
                            const OrientationOptions& options, double feed_mm_s, const AmongPieces& among) {
  Orienting work{
      piece, tool,       options, feed_mm_s, RotaryChart(machine, setup), make_stations(piece, feed_window_mm),
      {},    among.turns};
  if (work.points() < 2)
    return bad_input("orientation-path-short",
                     "a piece of the path has fewer than two CC points; lower the scallop or check the surface");
  work.report.smoothing = smoothing_name(options.smoothing);
  if (among.rotaries_before_rad)
    work.chart.come_from(
        {*among.rotaries_before_rad, (work.stations.front().contact_P_mm - among.point_before_P_mm).norm()});
  lift_out_of_part(work.stations, tool.cutter, interference, options.gouge_tolerance_mm);
  note_lifts(work);
  const AllowedSet allowed(work.stations, tool, work.chart, interference, options);

  std::vector<Vec3> planned(work.stations.size());
  tbb::parallel_for(0, work.points(), [&](int i) { planned[static_cast<std::size_t>(i)] = allowed.planned_axis(i); });
  release_wound_axes(work, planned);
  const std::vector<char> blocked = blocked_marks(allowed, planned);
  work.report.interferences_before = count(blocked);
  if (options.smoothing == Smoothing::none) return orient_traditionally(work, allowed, planned, blocked);
  if (options.smoothing == Smoothing::corridor) return orient_in_corridor(work, allowed);
  if (options.smoothing == Smoothing::field) return orient_by_field(work, allowed);
  return orient_by_pins(work, allowed);
}

}  // namespace volute::planner

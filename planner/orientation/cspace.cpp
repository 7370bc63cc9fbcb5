#include "planner/orientation/cspace.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace volute::planner {

using kinematics::OrientationCell;
using kinematics::OrientationChart;
using kinematics::OrientationMap;
using kinematics::OrientationState;

namespace {

constexpr double pi = std::numbers::pi;
// First cells: small enough that none of them spans what cannot be told apart (a turn of the pole).
constexpr double first_cell_rad = pi / 12.0;
constexpr double blocked_cell_rad = pi / 90.0;
// Below this tilt the ball that holds a flat bottom is too large to be told from its tangent plane.
constexpr double least_tilt_rad = 1e-3;
constexpr double margin_step_rad = pi / 18000.0;

double angle_between(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

using Pair = std::array<double, 2>;

struct Box {
  Pair least, greatest;
  [[nodiscard]] Pair middle() const { return {0.5 * (least[0] + greatest[0]), 0.5 * (least[1] + greatest[1])}; }
  [[nodiscard]] Pair half() const { return {0.5 * (greatest[0] - least[0]), 0.5 * (greatest[1] - least[1])}; }
};

/// How a chart's angles point the tool.
class ChartShape {
 public:
  virtual ~ChartShape() = default;
  [[nodiscard]] virtual Vec3 axis_P(const Pair& at) const = 0;
  /// Least and greatest tilt from the normal in the box (or beyond).
  [[nodiscard]] virtual Pair tilts(const Box& box) const = 0;
  /// How far the assembly turns about the contact from the middle of the box to any other place of it.
  [[nodiscard]] virtual TurnBound turn(const Box& box) const = 0;
  [[nodiscard]] virtual bool in_travel(const Pair& at) const = 0;
  [[nodiscard]] virtual std::optional<RotaryPair> rotaries(const Pair& at) const = 0;
};

/// What both charts ask of the cutter: where the contact holds it. Every change of orientation at a contact turns the
/// tool about the middle of the tube (of corner or ball) there; its spin about its own axis does not count.
struct Pivot {
  Vec3 contact_P_mm, normal_P;
  double tube_mm, circle_mm;  ///< radii of the tube and of the circle of its middle: the flat bottom, 0 for balls
};

Pivot pivot_of(const AllowedSet& allowed, int i) {
  const kinematics::Cutter& cutter = allowed.tool().cutter;
  const Station& station = allowed.stations()[static_cast<std::size_t>(i)];
  const bool is_bull = cutter.shape == kinematics::CutterShape::bull;
  const bool is_flat = cutter.shape == kinematics::CutterShape::flat;
  const double tube_mm = is_flat ? 0.0 : is_bull ? cutter.corner_radius_mm : cutter.radius_mm;
  return {station.contact_P_mm, station.normal_P, tube_mm, is_flat || is_bull ? cutter.radius_mm - tube_mm : 0.0};
}

struct Turning {
  double axis_rad;           ///< turn of the axis
  double tilt_rad, yaw_rad;  ///< changes of tilt and yaw
  Pair tilts;                ///< tilt stays between these
};

/// The middle of the flat bottom is carried round the normal by the yaw. At a tilt t the disc of radius c that the tube
/// runs round lies in the ball of radius c / sin t that touches the plane through the pivot there; so does what stands
/// on the disc up to 2 c cot t; the cutter reaches a tube's radius farther.
TurnBound turn_bound(const Pivot& pivot, const Turning& turning) {
  const double round_rad = turning.tilt_rad + turning.yaw_rad;
  TurnBound bound;
  bound.pivot_mm = pivot.contact_P_mm + pivot.tube_mm * pivot.normal_P;
  bound.slope_mm_per_mm = round_rad;
  // What stands r from the pivot stands no farther than r + circle from the middle of the bottom.
  bound.offset_mm = pivot.circle_mm * (round_rad + turning.axis_rad);
  bound.far_slope_mm_per_mm = turning.axis_rad;
  if (pivot.circle_mm <= 0.0 || turning.tilts[0] < least_tilt_rad || turning.tilts[1] >= 0.5 * pi) return bound;
  bound.ball_radius_mm = pivot.circle_mm / std::sin(turning.tilts[0]) + pivot.tube_mm;
  bound.ball_centre_mm = pivot.contact_P_mm + bound.ball_radius_mm * pivot.normal_P;
  bound.within_mm = std::max(2.0 * pivot.circle_mm / std::tan(turning.tilts[1]) - pivot.tube_mm, 0.0);
  return bound;
}

/// The axis turns by `turn_rad`, whichever way.
TurnBound any_turn(const Pivot& pivot, double turn_rad, const Pair& tilts) {
  const double yaw_rad = tilts[0] > 0.0 ? std::min(pi, turn_rad / std::sin(std::min(tilts[0], 0.5 * pi))) : pi;
  return turn_bound(pivot, {turn_rad, turn_rad, yaw_rad, tilts});
}

/// Yaw across, tilt up. A change of yaw turns the axis by no more than sin(tilt) of it.
class LeanShape final : public ChartShape {
 public:
  LeanShape(const AllowedSet& allowed, int i, const Pivot& pivot)
      : allowed_(allowed),
        frame_(feed_frame(allowed.stations()[static_cast<std::size_t>(i)].feed_P,
                          allowed.stations()[static_cast<std::size_t>(i)].normal_P)),
        pivot_(pivot) {}
  [[nodiscard]] Vec3 axis_P(const Pair& at) const override {
    return tool_axis(frame_, Angle::radians(at[1]), Angle::radians(at[0]));
  }
  [[nodiscard]] Pair tilts(const Box& box) const override { return {box.least[1], box.greatest[1]}; }
  [[nodiscard]] TurnBound turn(const Box& box) const override {
    const Pair half = box.half();
    const double steepest = std::sin(std::min(box.greatest[1], 0.5 * pi));
    return turn_bound(pivot_, {half[1] + steepest * half[0], half[1], half[0], tilts(box)});
  }
  [[nodiscard]] bool in_travel(const Pair& at) const override { return allowed_.chart().reaches(axis_P(at)); }
  [[nodiscard]] std::optional<RotaryPair> rotaries(const Pair&) const override { return std::nullopt; }

 private:
  const AllowedSet& allowed_;
  FeedFrame frame_;
  Pivot pivot_;
};

/// axes[4] across, axes[3] up. A rotary carries the axis round its line on a circle of radius sin(angle to the line),
/// which the other rotary changes by no more than its own turn.
class RotaryShape final : public ChartShape {
 public:
  RotaryShape(const AllowedSet& allowed, int i, const Pivot& pivot)
      : allowed_(allowed), normal_P_(allowed.stations()[static_cast<std::size_t>(i)].normal_P), pivot_(pivot) {}
  [[nodiscard]] Vec3 axis_P(const Pair& at) const override { return allowed_.chart().axis_P({at[1], at[0]}); }
  [[nodiscard]] Pair tilts(const Box& box) const override {
    const double tilt = angle_between(axis_P(box.middle()), normal_P_), turn = turn_rad(box);
    return {tilt - turn, tilt + turn};
  }
  [[nodiscard]] TurnBound turn(const Box& box) const override { return any_turn(pivot_, turn_rad(box), tilts(box)); }
  [[nodiscard]] bool in_travel(const Pair& at) const override { return allowed_.chart().in_travel({at[1], at[0]}); }
  [[nodiscard]] std::optional<RotaryPair> rotaries(const Pair& at) const override { return RotaryPair{at[1], at[0]}; }

 private:
  [[nodiscard]] double turn_rad(const Box& box) const {
    const Pair middle = box.middle(), half = box.half();
    double turn = 0.0;
    for (std::size_t k = 0; k < 2; ++k) {
      Pair opposite = middle;
      opposite[k] += pi;
      const double radius = 0.5 * (axis_P(opposite) - axis_P(middle)).norm();
      turn += half[k] * std::min(1.0, radius + half[1 - k]);
    }
    return turn;
  }
  const AllowedSet& allowed_;
  Vec3 normal_P_;
  Pivot pivot_;
};

class ChartBuilder {
 public:
  ChartBuilder(const AllowedSet& allowed, int i, const ChartShape& shape, double resolution_rad, OrientationMap& map)
      : allowed_(allowed), i_(i), shape_(shape), resolution_rad_(resolution_rad), map_(map) {}

  /// Rows break where the limits of tilt do, when `rows_at` holds them.
  std::vector<OrientationCell> cells(const Pair& least, const Pair& greatest, const std::vector<double>& rows_at) {
    std::vector<double> columns = steps(least[0], greatest[0]), rows;
    double from = least[1];
    for (const double to : rows_at) {
      if (to <= from || to >= greatest[1]) continue;
      const std::vector<double> band = steps(from, to);
      rows.insert(rows.end(), band.begin(), band.end() - 1);
      from = to;
    }
    const std::vector<double> last = steps(from, greatest[1]);
    rows.insert(rows.end(), last.begin(), last.end());
    for (std::size_t r = 0; r + 1 < rows.size(); ++r) {
      for (std::size_t c = 0; c + 1 < columns.size(); ++c)
        add({{columns[c], rows[r]}, {columns[c + 1], rows[r + 1]}}, allowed_.interference().open_pairs());
    }
    return std::move(cells_);
  }

 private:
  static std::vector<double> steps(double from, double to) {
    const int count = std::max(1, static_cast<int>(std::ceil((to - from) / first_cell_rad - 1e-9)));
    std::vector<double> places;
    for (int k = 0; k <= count; ++k) places.push_back(from + (to - from) * k / count);
    return places;
  }

  static double width(const Box& box) { return 2.0 * std::max(box.half()[0], box.half()[1]); }
  [[nodiscard]] bool is_last(const Box& box) const { return width(box) <= resolution_rad_; }
  /// What blocks is told of the middle, so blocked cells stay small enough to show where it changes.
  static bool is_small(const Box& box) { return width(box) <= blocked_cell_rad; }

  /// `open`: what is not settled for a box that holds this one.
  void add(const Box& box, OpenPairs open) {
    OrientationCell cell{box.least, box.greatest};
    const bool decided = judge(box, open, cell) && (cell.state != OrientationState::blocked || is_small(box));
    if (decided || is_last(box)) {
      cells_.push_back(cell);
      return;
    }
    const Pair half = box.half();
    const std::size_t k = half[0] >= half[1] ? 0 : 1;
    Box low = box, high = box;
    low.greatest[k] = high.least[k] = box.middle()[k];
    add(low, open);
    add(high, std::move(open));
  }

  /// True: the state holds for the whole cell.
  bool judge(const Box& box, OpenPairs& open, OrientationCell& cell) {
    const Pair middle = box.middle(), tilts = shape_.tilts(box);
    const Vec3 axis = shape_.axis_P(middle);
    const auto [least_tilt, most_tilt] = allowed_.tilt_limits();
    const bool inside = tilts[0] >= least_tilt - 1e-9 && tilts[1] <= most_tilt + 1e-9;
    const bool outside = tilts[1] <= least_tilt || tilts[0] >= most_tilt;
    const Blocked limit = shape_.in_travel(middle) ? allowed_.process_limit(i_, axis) : Blocked::travel;
    if (outside || limit == Blocked::tilt) {
      cell.state = OrientationState::tilt_limit;
      return outside;
    }
    if (limit != Blocked::no) {
      cell.state = limit == Blocked::width ? OrientationState::width_limit : OrientationState::travel_limit;
      return inside && corners_share(box, limit);
    }
    const bool settled = judge_interference(box, axis, open, cell);
    return settled && inside && corners_share(box, Blocked::no);
  }

  bool judge_interference(const Box& box, const Vec3& axis, OpenPairs& open, OrientationCell& cell) {
    const kinematics::ToolPose pose = allowed_.pose(i_, axis);
    const Interference& checks = allowed_.interference();
    TurnVerdict verdict = checks.verdict(pose, shape_.turn(box), open);
    open = std::move(verdict.open);
    // What will be halved anyway needs no hit of its own.
    if (!verdict.free && !is_last(box) && !(open.surely_blocked && is_small(box))) return false;
    auto hit = verdict.free ? std::nullopt : checks.first_open_hit(pose, open);
    const bool by_assembly = hit.has_value();
    if (!hit) {
      if (const auto rotaries = shape_.rotaries(box.middle())) hit = checks.first_link_hit(pose, *rotaries);
    }
    cell.centre_free = !hit;
    if (hit) cell.blocker = blocker(hit->tool_part + " against " + hit->scene_part);
    const bool proved = hit ? !by_assembly || open.surely_blocked : verdict.free;
    cell.state = !proved ? OrientationState::unsure : (hit ? OrientationState::blocked : OrientationState::free);
    return proved && (by_assembly || !hit);
  }

  [[nodiscard]] bool corners_share(const Box& box, Blocked limit) const {
    for (const double x : {box.least[0], box.greatest[0]}) {
      for (const double y : {box.least[1], box.greatest[1]}) {
        const Blocked at =
            shape_.in_travel({x, y}) ? allowed_.process_limit(i_, shape_.axis_P({x, y})) : Blocked::travel;
        // A corner may stand on the limit of tilt itself.
        if (at != limit && at != Blocked::tilt) return false;
      }
    }
    return true;
  }

  int blocker(const std::string& name) {
    const auto found = std::find(map_.blockers.begin(), map_.blockers.end(), name);
    if (found == map_.blockers.end()) {
      map_.blockers.push_back(name);
      return static_cast<int>(map_.blockers.size()) - 1;
    }
    return static_cast<int>(found - map_.blockers.begin());
  }

  const AllowedSet& allowed_;
  int i_;
  const ChartShape& shape_;
  double resolution_rad_;
  OrientationMap& map_;
  std::vector<OrientationCell> cells_;
};

/// By solid angle; what the limits forbid does not count.
double free_share_of(const OrientationChart& lean) {
  double free = 0.0, all = 0.0;
  for (const OrientationCell& cell : lean.cells) {
    const double solid_angle =
        (cell.greatest[0] - cell.least[0]) * (std::cos(cell.least[1]) - std::cos(cell.greatest[1]));
    if (cell.state == OrientationState::tilt_limit) continue;
    all += solid_angle;
    if (cell.centre_free) free += solid_angle;
  }
  return all > 0.0 ? free / all : 0.0;
}

Pair travel_of(const RotaryChart& chart, int k) {
  if (chart.is_endless(k)) return {-pi, pi};
  return {*chart.axis(k).travel_min, *chart.axis(k).travel_max};
}

}  // namespace

OrientationMap orientation_map(const AllowedSet& allowed, int i, const CspaceOptions& options) {
  const Station& station = allowed.stations()[static_cast<std::size_t>(i)];
  OrientationMap map;
  map.cc_point = station.source;
  map.contact_P_mm = station.contact_P_mm;
  map.normal_P = station.normal_P;
  map.resolution_rad = options.resolution.radians();
  const Pivot pivot = pivot_of(allowed, i);
  const auto [least_tilt, most_tilt] = allowed.tilt_limits();
  const LeanShape lean(allowed, i, pivot);
  map.lean.names = {"yaw", "tilt"};
  map.lean.cells = ChartBuilder(allowed, i, lean, map.resolution_rad, map)
                       .cells({-pi, 0.0}, {pi, 0.5 * pi}, {least_tilt, most_tilt});
  const RotaryShape rotary(allowed, i, pivot);
  const RotaryChart& chart = allowed.chart();
  const Pair first = travel_of(chart, 0), second = travel_of(chart, 1);
  map.rotaries.names = {std::string(1, chart.axis(1).letter), std::string(1, chart.axis(0).letter)};
  map.rotaries.cells =
      ChartBuilder(allowed, i, rotary, map.resolution_rad, map).cells({second[0], first[0]}, {second[1], first[1]}, {});
  map.free_share = free_share_of(map.lean);
  return map;
}

double free_turn_rad(const AllowedSet& allowed, int i, const Vec3& axis_P) {
  const kinematics::ToolPose pose = allowed.pose(i, axis_P);
  const double tilt = angle_between(axis_P, allowed.stations()[static_cast<std::size_t>(i)].normal_P);
  const Pivot pivot = pivot_of(allowed, i);
  double free = 0.0, blocked = 0.5 * pi;
  while (blocked - free > margin_step_rad) {
    const double turn = 0.5 * (free + blocked);
    (allowed.interference().stays_free(pose, any_turn(pivot, turn, {tilt - turn, tilt + turn})) ? free : blocked) =
        turn;
  }
  return free;
}

}  // namespace volute::planner

// Between near pieces: up to the safe distance, across with the turn of the axis, down.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/check.hpp"
#include "kinematics/inverse/inverse.hpp"
#include "planner/leads.hpp"

namespace volute::planner {

using kinematics::MoveKind;
using kinematics::RotarySolution;
using kinematics::ToolPath;
using kinematics::ToolPathPoint;
using kinematics::ToolPose;

namespace {

constexpr double rise_step_mm = 0.5;
/// Rotaries in step are followed in parts so small that each is a great circle: over this turn a rotary's path bows by
/// turn^2 / 8 = 0.001 rad at most.
constexpr double part_turn_rad = 0.08;

bool winds(const kinematics::Axis& axis) {
  return !axis.travel_min || !axis.travel_max || *axis.travel_max - *axis.travel_min > 2.0 * std::numbers::pi;
}

/// The angle's place in the travel; a rotary that winds takes any.
std::optional<double> place_of(const kinematics::Axis& axis, double angle_rad) {
  if (winds(axis)) return angle_rad;
  const double middle_rad = 0.5 * (*axis.travel_min + *axis.travel_max);
  const double place_rad = middle_rad + std::remainder(angle_rad - middle_rad, 2.0 * std::numbers::pi);
  if (place_rad < *axis.travel_min || place_rad > *axis.travel_max) return std::nullopt;
  return place_rad;
}

double turn_of(const std::array<RotaryPair, 2>& way) {
  return std::abs(way[1][0] - way[0][0]) + std::abs(way[1][1] - way[0][1]);
}

bool is_shorter_than_over_the_top(const ToolPose& from, const ToolPose& to, double rise_mm, double top_z_mm) {
  const double across_mm = (to.tip_P_mm - from.tip_P_mm).norm();
  const double top_mm =
      2.0 * top_z_mm - from.tip_P_mm.z() - to.tip_P_mm.z() + (to.tip_P_mm - from.tip_P_mm).head<2>().norm();
  return 2.0 * rise_mm + across_mm < top_mm;
}

}  // namespace

/// A lead as short as links take it, and from its end along `rise` until the assembly keeps the safe distance.
std::optional<Leads::Lead> Leads::link_lead(const ToolPathPoint& point, const Vec3& away, const Vec3& rise) const {
  const bool tip_counts = interference_->is_free(point.pose);
  for (Lead& shape : lead_shapes(point, away, link_radius_mm_)) {
    const auto end = end_of_free_lead(point, shape, tip_counts);
    if (!end) continue;
    const double far_mm = std::max(0.0, clearance_z_mm_ - end->tip_P_mm.z());
    for (double up_mm = 0.0; up_mm <= far_mm; up_mm += rise_step_mm) {
      const ToolPose raised{end->tip_P_mm + up_mm * rise, end->axis_P};
      if (!beyond_safe_distance_->is_free(raised)) continue;
      if (!is_free_way(*end, raised.tip_P_mm, tip_counts)) break;
      shape.way_up_mm = {raised.tip_P_mm - point.pose.tip_P_mm};
      return shape;
    }
  }
  return std::nullopt;
}

/// A rewind lifts the tool along its axis and then straight to the top of Z.
bool Leads::can_be_rewound(const ToolPose& pose) const {
  const ToolPose lifted{pose.tip_P_mm + kinematics::AxisPathOptions().rewind_retract_mm * pose.axis_P, pose.axis_P};
  const Vec3 top(lifted.tip_P_mm.x(), lifted.tip_P_mm.y(), std::max(lifted.tip_P_mm.z(), safe_tip_z_mm(pose.axis_P)));
  return is_free_way(pose, lifted.tip_P_mm, true) && is_free_way(lifted, top, true);
}

bool Leads::is_free_step(const ToolMotion& motion) const {
  return beyond_safe_distance_->motion_is_free({motion.from, motion.to, {}}) && interference_->motion_is_free(motion);
}

/// From every solution for the first axis to every one for the second, by the smaller turn of what winds: which of them
/// the axis path takes depends on what lies before and after. Nothing at the pole, where one rotary could stand
/// anywhere; empty without a machine.
std::optional<std::vector<std::array<RotaryPair, 2>>> Leads::turns_between(const Vec3& from_P, const Vec3& to_P) const {
  std::vector<std::array<RotaryPair, 2>> ways;
  if (machine_ == nullptr) return ways;
  const bool turns = (from_P - to_P).norm() > 1e-12;
  const auto solutions = [&](const Vec3& axis_P) -> std::optional<std::vector<RotaryPair>> {
    std::vector<RotaryPair> pairs;
    for (const RotarySolution& at : kinematics::solve_rotaries(*machine_, setup_->part_in_machine.linear() * axis_P)) {
      if (at.at_pole && turns) return std::nullopt;
      const auto first = place_of(machine_->axes[3], at.first_rad), second = place_of(machine_->axes[4], at.second_rad);
      if (first && second) pairs.push_back({*first, *second});
    }
    return pairs.empty() ? std::nullopt : std::optional(pairs);
  };
  const auto begins = solutions(from_P), ends = solutions(to_P);
  if (!begins || !ends) return std::nullopt;
  for (const RotaryPair& from : *begins)
    for (RotaryPair to : *ends) {
      for (std::size_t k = 0; k < 2; ++k)
        if (winds(machine_->axes[3 + k])) to[k] = from[k] + std::remainder(to[k] - from[k], 2.0 * std::numbers::pi);
      ways.push_back({from, to});
    }
  return ways;
}

/// Tip straight, both rotaries even over the way.
bool Leads::is_free_in_step(const ToolPose& from, const ToolPose& to, const std::array<RotaryPair, 2>& rotaries) const {
  const int parts = std::max(1, static_cast<int>(std::ceil(turn_of(rotaries) / part_turn_rad)));
  const auto rotaries_at = [&](double share) {
    return RotaryPair{rotaries[0][0] + share * (rotaries[1][0] - rotaries[0][0]),
                      rotaries[0][1] + share * (rotaries[1][1] - rotaries[0][1])};
  };
  const auto pose_at = [&](double share) {
    kinematics::AxisVector q = kinematics::AxisVector::Zero();
    const RotaryPair at = rotaries_at(share);
    q[3] = at[0];
    q[4] = at[1];
    return ToolPose{from.tip_P_mm + share * (to.tip_P_mm - from.tip_P_mm),
                    kinematics::tool_pose(*machine_, *setup_, tool_->gauge_length_mm, q).axis_P};
  };
  for (int k = 0; k < parts; ++k) {
    const double begin = static_cast<double>(k) / parts, end = static_cast<double>(k + 1) / parts;
    if (!is_free_step({pose_at(begin), pose_at(end), std::array{rotaries_at(begin), rotaries_at(end)}})) return false;
  }
  return true;
}

bool Leads::is_free_across(const ToolPose& from, const ToolPose& to) const {
  const auto ways = turns_between(from.axis_P, to.axis_P);
  if (!ways) return false;
  return is_free_step({from, to, {}}) &&
         std::all_of(ways->begin(), ways->end(), [&](const auto& way) { return is_free_in_step(from, to, way); });
}

std::optional<ToolPath> Leads::link(const ToolPath& before, const ToolPath& after) const {
  VOLUTE_CHECK(before.points.size() >= 2 && after.points.size() >= 2, before.points.size(), after.points.size());
  const ToolPathPoint &last = before.points.back(), &first = after.points.front();
  const Vec3 away_out = tangent_away(last, before.points[before.points.size() - 2]);
  const Vec3 away_in = tangent_away(first, after.points[1]);
  const double top_z_mm = std::max(safe_tip_z_mm(last.pose.axis_P), safe_tip_z_mm(first.pose.axis_P));
  for (const bool along_axis : {true, false}) {
    const Vec3 rise_out = along_axis ? last.pose.axis_P : Vec3(Vec3::UnitZ());
    const Vec3 rise_in = along_axis ? first.pose.axis_P : Vec3(Vec3::UnitZ());
    auto out = link_lead(last, away_out, rise_out), in = link_lead(first, away_in, rise_in);
    if (!out || !in) continue;
    const ToolPose low_out{last.pose.tip_P_mm + out->way_up_mm.back(), last.pose.axis_P};
    const ToolPose low_in{first.pose.tip_P_mm + in->way_up_mm.back(), first.pose.axis_P};
    for (double rise_mm = 0.0; is_shorter_than_over_the_top(low_out, low_in, rise_mm, top_z_mm);
         rise_mm = std::max(2.0 * rise_mm, process_->safe_distance_mm)) {
      const ToolPose high_out{low_out.tip_P_mm + rise_mm * rise_out, low_out.axis_P};
      const ToolPose high_in{low_in.tip_P_mm + rise_mm * rise_in, low_in.axis_P};
      if (!is_free_step({low_out, high_out, {}}) || !is_free_step({low_in, high_in, {}})) break;
      if (!is_free_across(high_out, high_in) || !can_be_rewound(high_out) || !can_be_rewound(high_in)) continue;
      out->way_up_mm = {high_out.tip_P_mm - last.pose.tip_P_mm};
      in->way_up_mm = {high_in.tip_P_mm - first.pose.tip_P_mm};
      ToolPath way;
      go_out(last, *out, way);
      come_in(first, *in, way);
      return way;
    }
  }
  return std::nullopt;
}

geometry::Result<ToolPath> Leads::join(const std::vector<ToolPath>& pieces) const {
  ToolPath whole, run;
  int first_number = 1;
  const auto finish = [&](int last_number) -> geometry::Result<void> {
    const auto path = with_leads(run, first_number, last_number);
    if (!path) return tl::unexpected(path.error());
    append(whole, *path);
    return {};
  };
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const int number = static_cast<int>(k) + 1;
    auto between = k > 0 ? link(pieces[k - 1], pieces[k]) : std::nullopt;
    if (k > 0 && !between) {
      if (auto done = finish(number - 1); !done) return tl::unexpected(done.error());
      run.points.clear();
      first_number = number;
    }
    if (between) run.points.insert(run.points.end(), between->points.begin(), between->points.end());
    const std::size_t begin = run.points.size();
    run.points.insert(run.points.end(), pieces[k].points.begin(), pieces[k].points.end());
    if (between) {
      run.points[begin].move = MoveKind::approach;
      run.points[begin].feed_mm_s = approach_feed_mm_s();
    }
  }
  if (auto done = pieces.empty() ? geometry::Result<void>() : finish(static_cast<int>(pieces.size())); !done)
    return tl::unexpected(done.error());
  return whole;
}

}  // namespace volute::planner

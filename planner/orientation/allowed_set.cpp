#include "planner/orientation/allowed_set.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace volute::planner {

using geometry::Angle;
using kinematics::CutterShape;

namespace {

constexpr Angle ring_step = Angle::degrees(2.0);
constexpr Angle ring_last = Angle::degrees(150.0);
constexpr Angle tilt_margin = Angle::degrees(2.0);
// Rounding of a tilt that stands on its limit.
constexpr double tilt_slack_rad = 1e-9;
// A cut may be this much narrower than planned: the scallop stays within 2 per cent of what was asked.
constexpr double narrower_share = 0.98;
// Without a clearance there is nothing that bounds the step between checks.
constexpr double motion_step_without_clearance_mm = 0.1, motion_step_max_mm = 0.5;

double angle_between(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

std::vector<Vec3> make_rings() {
  std::vector<Vec3> directions = {Vec3::UnitZ()};
  const int rings = static_cast<int>(ring_last / ring_step);
  for (int r = 1; r <= rings; ++r) {
    const Angle polar = r * ring_step;
    const int count =
        std::max(6, static_cast<int>(std::ceil(2.0 * std::numbers::pi * sin(polar) / ring_step.radians())));
    for (int k = 0; k < count; ++k) {
      const double a = 2.0 * std::numbers::pi * k / count;
      directions.emplace_back(sin(polar) * std::cos(a), sin(polar) * std::sin(a), cos(polar));
    }
  }
  return directions;
}

bool is_ball(const kinematics::Cutter& cutter) {
  return cutter.shape == CutterShape::ball || cutter.shape == CutterShape::taper_ball;
}

}  // namespace

AllowedSet::AllowedSet(std::span<const Station> stations, const kinematics::Tool& tool, const RotaryChart& chart,
                       const Interference& interference, const OrientationOptions& options)
    : stations_(stations),
      tool_(&tool),
      chart_(&chart),
      interference_(&interference),
      options_(&options),
      motion_step_mm_(options.clearance_mm > 0.0 ? std::min(options.clearance_mm, motion_step_max_mm)
                                                 : motion_step_without_clearance_mm),
      least_width_mm_(
          is_ball(tool.cutter) ? 0.0 : narrower_share * effective_radius_mm(tool.cutter, options.tilt, options.yaw)),
      rings_(make_rings()) {}

Vec3 AllowedSet::planned_axis(int i) const {
  const Station& station = stations_[static_cast<std::size_t>(i)];
  return tool_axis(feed_frame(station.feed_P, station.normal_P), options_->tilt, options_->yaw);
}

kinematics::ToolPose AllowedSet::pose(int i, const Vec3& axis_P) const {
  const Station& station = stations_[static_cast<std::size_t>(i)];
  return contact_pose(tool_->cutter, station.contact_P_mm, station.normal_P, axis_P);
}

Blocked AllowedSet::process_limit(int i, const Vec3& axis_P) const {
  const Station& station = stations_[static_cast<std::size_t>(i)];
  const double tilt = angle_between(axis_P, station.normal_P);
  const double most = std::min(options_->tilt_max.radians(), 0.5 * std::numbers::pi - 1e-6);
  if (tilt < options_->tilt_min.radians() - tilt_slack_rad || tilt > most + tilt_slack_rad) return Blocked::tilt;
  if (least_width_mm_ > 0.0) {
    const FeedFrame frame = feed_frame(station.feed_P, station.normal_P);
    const Angle yaw = Angle::radians(std::atan2(axis_P.dot(frame.across_P), axis_P.dot(frame.feed_P)));
    if (effective_radius_mm(tool_->cutter, Angle::radians(tilt), yaw) < least_width_mm_) return Blocked::width;
  }
  return Blocked::no;
}

bool AllowedSet::is_well_within_limits(int i, const Vec3& axis_P) const {
  const double least = options_->tilt_min.radians(),
               most = std::min(options_->tilt_max.radians(), 0.5 * std::numbers::pi - 1e-6);
  const double margin = std::min(tilt_margin.radians(), 0.25 * (most - least));
  const double cosine = axis_P.dot(stations_[static_cast<std::size_t>(i)].normal_P);
  if (cosine < std::cos(most - margin) || (least > 0.0 && cosine > std::cos(least + margin))) return false;
  return process_limit(i, axis_P) == Blocked::no;
}

Blocked AllowedSet::limit(int i, const Rotaries& at) const {
  return chart_->in_travel(at) ? process_limit(i, chart_->axis_P(at)) : Blocked::travel;
}

Blocked AllowedSet::blocked(int i, const Vec3& axis_P) const {
  const Blocked limit = process_limit(i, axis_P);
  if (limit != Blocked::no) return limit;
  if (!chart_->reaches(axis_P)) return Blocked::travel;
  return is_free(i, axis_P) ? Blocked::no : Blocked::interference;
}

Blocked AllowedSet::blocked(int i, const Rotaries& at) const {
  const Blocked cheap = limit(i, at);
  if (cheap != Blocked::no) return cheap;
  return is_free(i, chart_->axis_P(at)) ? Blocked::no : Blocked::interference;
}

bool AllowedSet::motion_is_free(int i, const Rotaries& from, const Rotaries& to) const {
  const kinematics::ToolPose a = pose(i, chart_->axis_P(from)), b = pose(i + 1, chart_->axis_P(to));
  const double turn = std::hypot(to[0] - from[0], to[1] - from[1]);
  // The axis never turns more than both rotaries together.
  const double most = (b.tip_P_mm - a.tip_P_mm).norm() +
                      interference_->reach_mm() *
                          std::min(turn * std::numbers::sqrt2, std::abs(to[0] - from[0]) + std::abs(to[1] - from[1]));
  const int steps = static_cast<int>(std::ceil(most / motion_step_mm_));
  for (int k = 1; k < steps; ++k) {
    const double t = static_cast<double>(k) / steps;
    const Rotaries at = {from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1])};
    if (!interference_->is_free_but_tip({a.tip_P_mm + t * (b.tip_P_mm - a.tip_P_mm), chart_->axis_P(at)})) return false;
  }
  return true;
}

std::optional<Vec3> AllowedSet::nearest(int i, const Vec3& wanted_P, Angle margin) const {
  const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), wanted_P);
  for (const Vec3& direction : rings_) {
    const Vec3 axis = turn * direction;
    if (blocked(i, axis) != Blocked::no) continue;
    const Vec3 pivot = wanted_P.cross(axis);
    if (margin.radians() <= 0.0 || pivot.norm() < 1e-9) return axis;
    const Vec3 further = Eigen::AngleAxisd(margin.radians(), pivot.normalized()) * axis;
    return blocked(i, further) == Blocked::no ? further : axis;
  }
  return std::nullopt;
}

Vec3 AllowedSet::within_tilt(int i, const Vec3& axis_P) const {
  const Vec3& normal = stations_[static_cast<std::size_t>(i)].normal_P;
  const double least = options_->tilt_min.radians(),
               most = std::min(options_->tilt_max.radians(), 0.5 * std::numbers::pi - 1e-6);
  const double margin = std::min(tilt_margin.radians(), 0.25 * (most - least));
  const double tilt = angle_between(axis_P, normal);
  const double wanted = std::clamp(tilt, least > 0.0 ? least + margin : 0.0, most - margin);
  if (wanted == tilt) return axis_P;
  Vec3 pivot = normal.cross(axis_P);
  if (pivot.norm() < 1e-9) pivot = normal.cross(planned_axis(i));
  if (pivot.norm() < 1e-9) pivot = normal.cross(stations_[static_cast<std::size_t>(i)].feed_P);
  return Eigen::AngleAxisd(wanted, pivot.normalized()) * normal;
}

std::string AllowedSet::what_blocks(int i, const Vec3& wanted_P) const {
  std::map<std::string, int> counts;
  const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), wanted_P);
  for (const Vec3& direction : rings_) {
    const Vec3 axis = turn * direction;
    const Blocked why = blocked(i, axis);
    if (why == Blocked::travel) ++counts["travel of the rotary axes"];
    if (why != Blocked::interference) continue;
    // The ball against the part is left out of the verdict, so it is left out of the reason.
    const auto hit = interference_->first_hit_but_tip(pose(i, axis));
    if (hit) ++counts[hit->tool_part + " against " + hit->scene_part];
  }
  std::string text;
  for (const auto& [what, count] : counts) text += (text.empty() ? "" : ", ") + what;
  return text.empty() ? "the tilt limits" : text;
}

}  // namespace volute::planner

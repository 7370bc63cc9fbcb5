#include "planner/orientation/allowed_set.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "geometry/turn.hpp"

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
  return is_free(i, at) ? Blocked::no : Blocked::interference;
}

bool AllowedSet::is_free(int i, const Vec3& axis_P) const {
  const kinematics::ToolPose at = pose(i, axis_P);
  if (!interference_->is_free_but_tip(at)) return false;
  if (!interference_->has_machine()) return true;
  for (const RotaryChoice& choice : chart_->choices(axis_P)) {
    const bool in_travel = !chart_->turns(0, choice.at[0]).empty() && !chart_->turns(1, choice.at[1]).empty();
    if (in_travel && interference_->links_are_free(at, choice.at)) return true;
  }
  return false;
}

bool AllowedSet::is_free(int i, const Rotaries& at) const {
  const kinematics::ToolPose there = pose(i, chart_->axis_P(at));
  return interference_->is_free_but_tip(there) && interference_->links_are_free(there, at);
}

bool AllowedSet::motion_is_free(int i, const Rotaries& from, const Rotaries& to) const {
  return interference_->motion_is_free(
      {pose(i, chart_->axis_P(from)), pose(i + 1, chart_->axis_P(to)), std::array{from, to}});
}

std::optional<Vec3> AllowedSet::nearest(int i, const Vec3& wanted_P, Angle margin) const {
  const Eigen::Quaterniond turn = geometry::turn_from_z(wanted_P);
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
  const Eigen::Quaterniond turn = geometry::turn_from_z(wanted_P);
  for (const Vec3& direction : rings_) {
    const Vec3 axis = turn * direction;
    const Blocked why = blocked(i, axis);
    if (why == Blocked::travel) ++counts["travel of the rotary axes"];
    if (why != Blocked::interference) continue;
    // The ball against the part is left out of the verdict, so it is left out of the reason.
    auto hit = interference_->first_hit_but_tip(pose(i, axis));
    for (const RotaryChoice& choice : chart_->choices(axis)) {
      if (!hit) hit = interference_->first_link_hit(pose(i, axis), choice.at);
    }
    if (hit) ++counts[hit->tool_part + " against " + hit->scene_part];
  }
  std::string text;
  for (const auto& [what, count] : counts) text += (text.empty() ? "" : ", ") + what;
  return text.empty() ? "the tilt limits" : text;
}

}  // namespace volute::planner

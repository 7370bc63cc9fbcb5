// The arc that LinuxCNC's planner puts into a corner of lines and arcs: as large as tolerance, lengths and speed ask
// for.
//
// The corner is first taken as one of two straight legs with the half angle theta between them: an arc of radius R
// touches both legs at R / tan(theta) from the corner and passes it at R / sin(theta) - R. Where a leg is an arc
// itself, a chord stands for it, and the centre is then moved to where the arc touches the true curves.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/controller/linuxcnc/corner.hpp"

namespace volute::sim::linuxcnc {

namespace {

constexpr double pi = std::numbers::pi;

struct Leg {
  bool arc = false, convex = false;  ///< convex: the arc bends away from the other leg
  Vec3 tangent, direction;           ///< at the corner; of the chord that stands for the leg
  Vec3 centre = Vec3::Zero();        ///< of the circle that fits the arc at the corner
  double radius = 0.0;
  double angle_most = 0.0;   ///< that the blend may take of the arc
  double length_most = 0.0;  ///< that the blend may take of the leg
};

struct CornerGeometry {
  Vec3 corner, normal, binormal;
  Leg in, out;
  double half_angle = 0.0;
};

struct Plan {
  double tolerance = 0.0, half_angle = 0.0, turn = 0.0;
  double across_most = 0.0, acceleration = 0.0;
  double speed_requested = 0.0, speed = 0.0, radius = 0.0, reach = 0.0;
};

/// Contact points, and how much each leg loses (mm of a line, rad of an arc).
struct Touch {
  Vec3 centre = Vec3::Zero(), start = Vec3::Zero(), end = Vec3::Zero();
  double cut_in = 0.0, cut_out = 0.0;
};

/// The largest circle in a plane that keeps every axis's bound.
double in_plane_bound(const Vec3& plane_normal, const Vec3& bound) {
  double least = no_limit;
  for (int i = 0; i < 3; ++i) {
    Vec3 share = -plane_normal[i] * plane_normal;
    share[i] += 1.0;
    share = share.cwiseAbs().cwiseMax(1e-12);
    if (bound[i] != 0.0) least = std::min(least, bound[i] / share.norm());
  }
  return least;
}

std::optional<CornerGeometry> geometry_of(const Segment& before, const Segment& after) {
  CornerGeometry g;
  g.in.tangent = g.in.direction = before.end_tangent();
  g.out.tangent = g.out.direction = after.start_tangent();
  g.corner = after.shape == Shape::line    ? after.line.start
             : before.shape == Shape::line ? before.line.end
                                           : after.arc.at_angle(0.0);
  g.half_angle = 0.5 * std::acos(-std::clamp(g.in.tangent.dot(g.out.tangent), -1.0, 1.0));
  if (0.5 * pi - g.half_angle < angle_epsilon || g.half_angle < angle_epsilon) return std::nullopt;
  g.binormal = g.in.tangent.cross(g.out.tangent).normalized();
  g.normal = (g.out.tangent - g.in.tangent).normalized();
  return g;
}

/// The circle that fits a spiral at the corner: its centre is moved along the tangent by the change of radius per
/// radian.
void fit_circle(Leg& leg, const Arc& arc, const Vec3& corner) {
  leg.arc = true;
  leg.centre = arc.centre + (arc.spiral / arc.angle) * leg.tangent;
  leg.radius = (corner - leg.centre).norm();
}

bool parallel(const Vec3& a, const Vec3& b) {
  constexpr double epsilon_sq = angle_epsilon * angle_epsilon;
  return (a - b).squaredNorm() < epsilon_sq || (a + b).squaredNorm() < epsilon_sq;
}

/// Prepares the legs that are arcs. False: the arcs do not lie in the corner's plane.
bool prepare_arcs(CornerGeometry& g, const Segment& before, const Segment& after, double& theta) {
  theta = g.half_angle;
  if (before.shape == Shape::arc) {
    fit_circle(g.in, before.arc, g.corner);
    g.in.convex = (g.corner - g.in.centre).dot(g.out.tangent) < 0.0;
    g.in.angle_most = std::min(before.arc.angle * 2.0 / 3.0, g.in.convex ? g.half_angle : 0.5 * pi);
    if (g.in.convex) {
      g.in.direction = (g.corner - before.arc.at_angle(before.arc.angle - 0.5 * g.in.angle_most)).normalized();
      theta = std::min(theta, g.half_angle - 0.25 * g.in.angle_most);
    }
    g.in.length_most = g.in.convex ? std::sin(0.25 * g.in.angle_most) * g.in.radius : g.in.angle_most * g.in.radius;
    if (!parallel(g.binormal, before.arc.normal)) return false;
  }
  if (after.shape == Shape::arc) {
    fit_circle(g.out, after.arc, g.corner);
    g.out.convex = !((g.corner - g.out.centre).dot(g.in.tangent) < 0.0);
    g.out.angle_most = std::min(after.arc.angle / 3.0, g.out.convex ? g.half_angle : 0.5 * pi);
    if (g.out.convex) {
      g.out.direction = (after.arc.at_angle(0.5 * g.out.angle_most) - g.corner).normalized();
      theta = std::min(theta, g.half_angle - 0.25 * g.out.angle_most);
    }
    g.out.length_most =
        g.out.convex ? std::sin(0.25 * g.out.angle_most) * g.out.radius : g.out.angle_most * g.out.radius;
    if (!parallel(g.binormal, after.arc.normal)) return false;
  }
  if (before.shape == Shape::line) g.in.length_most = std::min(before.length, 0.5 * before.nominal_length);
  if (after.shape == Shape::line)
    g.out.length_most = 0.5 * (before.shape == Shape::line ? after.length : after.nominal_length);
  return true;
}

double tolerance_of(const Segment& before, const Segment& after) {
  const double first = before.tolerance == 0.0 ? 0.25 * before.nominal_length : before.tolerance;
  const double second = after.tolerance == 0.0 ? 0.25 * after.nominal_length : after.tolerance;
  return std::min({first, second, 0.25 * before.nominal_length, 0.25 * after.nominal_length});
}

/// The speed at which the velocity polygon between both legs can be passed: lines only.
double altitude_speed(const CornerGeometry& g, const Segment& before, const Segment& after, double turn) {
  const double flat = std::cos(std::min(turn, 0.49 * pi));
  const double v_in = std::min(before.speed_max, after.speed_max / flat),
               v_out = std::min(after.speed_max, before.speed_max / flat);
  return v_in * v_out * std::sin(turn) / (v_out * g.out.direction - v_in * g.in.direction).norm();
}

// A blend on short legs is only as large as a parabolic one would be in time: long enough to turn, not the largest that
// fits.
std::optional<Plan> plan_of(const CornerGeometry& g, double theta, const Segment& before, const Segment& after,
                            const PlannerLimits& limits) {
  Plan plan;
  plan.half_angle = theta;
  plan.turn = pi - 2.0 * theta;
  plan.tolerance = tolerance_of(before, after);
  plan.acceleration = in_plane_bound(g.binormal, limits.acceleration);
  plan.across_most = plan.acceleration * normal_share;
  plan.speed_requested = std::max(before.speed_target(), after.speed_target());
  double speed_goal = in_plane_bound(g.binormal, limits.velocity);
  if (!g.in.arc && !g.out.arc) speed_goal = std::max(speed_goal, altitude_speed(g, before, after, plan.turn));
  speed_goal = std::min(plan.speed_requested, speed_goal);

  const double reach_by_tolerance = std::cos(theta) * plan.tolerance / (1.0 - std::sin(theta));
  const double reach_most = std::min({g.in.length_most, g.out.length_most, reach_by_tolerance});
  const double radius_most = std::tan(theta) * reach_most;
  plan.speed = std::min(std::sqrt(plan.across_most * radius_most), speed_goal);
  const double half = 0.5 * plan.acceleration;
  const double blend_s = std::min(std::sqrt(2.0 * half * reach_most), plan.speed) / half;
  const double radius_by_time = std::min(blend_s * plan.speed / plan.turn, radius_most);
  plan.radius = std::max(plan.speed * plan.speed / plan.across_most, radius_by_time);
  plan.reach = plan.radius / std::tan(theta);
  if (plan.radius < position_epsilon || plan.radius * plan.turn < 1e-6) return std::nullopt;
  return plan;
}

/// The angle of an arc between the corner and where the blend touches it.
double cut_angle(const Vec3& corner, const Vec3& blend_centre, const Vec3& arc_centre) {
  return std::acos(
      std::clamp((blend_centre - arc_centre).normalized().dot((corner - arc_centre).normalized()), -1.0, 1.0));
}

double centre_distance(const Leg& leg, double radius) { return leg.convex ? leg.radius - radius : leg.radius + radius; }

/// The blend's centre at distance R from a line and touching a circle; `along` is how far from the corner the line is
/// touched.
std::optional<Vec3> centre_line_arc(const CornerGeometry& g, const Plan& plan, bool line_first, double& along) {
  const Leg& line = line_first ? g.in : g.out;
  const Leg& arc = line_first ? g.out : g.in;
  const Vec3 side = g.binormal.cross(line.direction).normalized();
  const Vec3 to_centre = arc.centre - g.corner;
  const double u = to_centre.dot(line.direction), n = to_centre.dot(side), d = centre_distance(arc, plan.radius);
  const double b = 2.0 * u, c = u * u - d * d + (plan.radius - n) * (plan.radius - n);
  const double root_sq = b * b - 4.0 * c;
  if (root_sq < 0.0) return std::nullopt;
  const double root = std::sqrt(root_sq);
  along = std::min(std::abs(0.5 * (-b + root)), std::abs(0.5 * (-b - root)));
  return g.corner + (line_first ? -along : along) * line.direction + plan.radius * side;
}

/// The blend's centre touching both circles, on the side of the corner.
Vec3 centre_arc_arc(const CornerGeometry& g, const Plan& plan) {
  const double d1 = centre_distance(g.in, plan.radius), d2 = centre_distance(g.out, plan.radius);
  const Vec3 between = g.out.centre - g.in.centre;
  const double apart = between.norm();
  const double x = (d1 * d1 - d2 * d2 + apart * apart) / (2.0 * apart);
  const double y = std::sqrt(std::max(0.0, d1 * d1 - x * x));
  const Vec3 u = between / apart, n = g.binormal.cross(u).normalized();
  const Vec3 foot = g.in.centre + x * u;
  const Vec3 one = foot + y * n, other = foot - y * n;
  return (other - g.corner).norm() < (one - g.corner).norm() ? other : one;
}

std::optional<Touch> touch_of(const CornerGeometry& g, const Plan& plan) {
  Touch touch;
  if (!g.in.arc && !g.out.arc) {
    touch.centre = g.corner + plan.radius / std::sin(plan.half_angle) * g.normal;
    touch.cut_in = touch.cut_out = plan.reach;
    return touch;
  }
  double along = 0.0;
  if (g.in.arc && g.out.arc) {
    touch.centre = centre_arc_arc(g, plan);
  } else {
    const auto centre = centre_line_arc(g, plan, !g.in.arc, along);
    if (!centre) return std::nullopt;
    touch.centre = *centre;
  }
  if ((touch.centre - g.corner).norm() - plan.radius > plan.tolerance) return std::nullopt;
  touch.cut_in = g.in.arc ? cut_angle(g.corner, touch.centre, g.in.centre) : along;
  touch.cut_out = g.out.arc ? cut_angle(g.corner, touch.centre, g.out.centre) : along;
  if ((g.in.arc && touch.cut_in > g.in.angle_most) || (g.out.arc && touch.cut_out > g.out.angle_most))
    return std::nullopt;
  return touch;
}

/// Takes `cut` off one end of a leg; the new end is the blend's. False: nothing would be left.
bool cut_leg(Segment& segment, double cut, bool at_start, Vec3& contact) {
  if (segment.shape == Shape::arc) {
    if (!segment.arc.shorten(segment.arc.angle - cut, at_start)) return false;
    contact = segment.arc.at_angle(at_start ? 0.0 : segment.arc.angle);
    segment.arc.fit_length();
    segment.length = segment.arc.length();
    return true;
  }
  const double kept = segment.length - cut;
  if (kept <= 1e-16) return false;
  contact = at_start ? Vec3(segment.line.end - kept * segment.line.direction)
                     : Vec3(segment.line.start + kept * segment.line.direction);
  segment.line = at_start ? Straight<Vec3>(contact, segment.line.end) : Straight<Vec3>(segment.line.start, contact);
  segment.length = segment.line.length;
  return true;
}

/// Between two lines the contact points lie at the planned reach, also where nothing is left of the line before.
void cut_lines(ArcBlend& blend, const CornerGeometry& g, Touch& touch) {
  touch.start = g.corner - touch.cut_in * g.in.direction;
  touch.end = g.corner + touch.cut_out * g.out.direction;
  blend.before.line = Straight<Vec3>(blend.before.line.start, touch.start);
  blend.before.length = blend.before.line.length;
  blend.after.line = Straight<Vec3>(touch.end, blend.after.line.end);
  blend.after.length = blend.after.line.length;
}

bool tangent_enough(const BlendArc& arc, const Plan& plan, const Segment& leg, bool at_end, double cycle_s) {
  const Vec3 along = at_end ? leg.arc.tangent(0.0) : leg.arc.tangent(leg.arc.angle);
  const double kink = std::acos(std::clamp(along.dot(arc.tangent(at_end)), -1.0, 1.0));
  return kink <= normal_share * 0.25 * plan.acceleration * cycle_s / plan.speed;
}

bool make_arc(ArcBlend& blend, const CornerGeometry& g, const Plan& plan, const Touch& touch, double lead_length) {
  BlendArc& arc = blend.segment.blend;
  arc.centre = touch.centre;
  arc.start = touch.start;
  arc.to_start = touch.start - touch.centre;
  arc.to_end = touch.end - touch.centre;
  arc.radius = arc.to_start.norm();
  const double end_radius = arc.to_end.norm();
  if (arc.radius < 1e-12 || end_radius < 1e-12) return false;
  arc.angle = std::acos(std::clamp(arc.to_start.dot(arc.to_end) / (arc.radius * end_radius), -1.0, 1.0));
  arc.spiral = end_radius - arc.radius;
  arc.binormal = g.binormal;
  arc.lead_direction = g.in.tangent;
  arc.lead_length = lead_length;
  if (arc.angle < 1e-6) return false;
  Segment& segment = blend.segment;
  segment.shape = Shape::blend;
  segment.end = EndMode::tangent;
  segment.speed_requested = plan.speed_requested;
  segment.speed_max = plan.speed;
  segment.acceleration = plan.acceleration;
  segment.length = segment.nominal_length = arc.length();
  return true;
}

}  // namespace

std::optional<ArcBlend> arc_between(const Segment& before, const Segment& after, const PlannerLimits& limits) {
  auto g = geometry_of(before, after);
  double theta = 0.0;
  if (!g || !prepare_arcs(*g, before, after, theta)) return std::nullopt;
  if (g->in.arc && g->out.arc && theta < pi / 12.0) return std::nullopt;
  const auto plan = plan_of(*g, theta, before, after, limits);
  if (!plan) return std::nullopt;
  auto touch = touch_of(*g, *plan);
  if (!touch) return std::nullopt;

  ArcBlend blend;
  blend.before = before;
  blend.after = after;
  double lead_length = 0.0;
  if (before.shape == Shape::line) {
    const double left = before.length - touch->cut_in;
    blend.consumed = left / plan->speed < limits.gap_cycles * before.cycle_s && !before.parabolic_before &&
                     !before.waits_for_spindle;
    if (blend.consumed) lead_length = left;
  }
  if (!g->in.arc && !g->out.arc)
    cut_lines(blend, *g, *touch);
  else if (!cut_leg(blend.before, touch->cut_in, false, touch->start) ||
           !cut_leg(blend.after, touch->cut_out, true, touch->end))
    return std::nullopt;
  if (!make_arc(blend, *g, *plan, *touch, lead_length)) return std::nullopt;
  if (g->in.arc && !tangent_enough(blend.segment.blend, *plan, blend.before, false, limits.cycle_s))
    return std::nullopt;
  if (g->out.arc && !tangent_enough(blend.segment.blend, *plan, blend.after, true, limits.cycle_s)) return std::nullopt;
  blend.segment.cycle_s = before.cycle_s;
  blend.segment.rapid = before.rapid;
  blend.segment.block = before.block;
  blend.segment.rotary = before.rotary;
  blend.segment.rotary.none = true;
  blend.segment.tolerance = after.tolerance;
  blend.segment.length_final = false;
  blend.segment.fix_length();
  return blend;
}

}  // namespace volute::sim::linuxcnc

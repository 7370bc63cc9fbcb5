#include "planner/leads.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/check.hpp"
#include "geometry/number_text.hpp"

namespace volute::planner {

using kinematics::MoveKind;
using kinematics::ToolPath;
using kinematics::ToolPathPoint;
using kinematics::ToolPose;

namespace {

constexpr int arc_points = 12;
constexpr double check_step_mm = 0.5;
constexpr double axis_retract_min_mm = 2.0;
/// A tenth of the cutter's diameter: long enough to touch the surface in a tangent, short beside the rapid.
constexpr double link_lead_share = 0.2;

ToolPathPoint with_offset(const ToolPathPoint& at, const Vec3& offset, MoveKind move, double feed_mm_s) {
  return {{at.pose.tip_P_mm + offset, at.pose.axis_P}, move, feed_mm_s, at.contact_P_mm, at.normal_P, at.turn};
}

}  // namespace

Vec3 tangent_away(const ToolPathPoint& at, const ToolPathPoint& next) {
  const Vec3 d = at.pose.tip_P_mm - next.pose.tip_P_mm;
  const Vec3 t = d - d.dot(at.normal_P) * at.normal_P;
  return t.norm() > 1e-9 ? Vec3(t.normalized()) : at.normal_P.unitOrthogonal();
}

double highest_point_mm(const Scene& scene) {
  bool any = false;
  double z = 0.0;
  const auto look = [&](const geometry::TriangleMesh& mesh) {
    for (const Vec3& v : mesh.vertices_mm) {
      z = any ? std::max(z, v.z()) : v.z();
      any = true;
    }
  };
  look(scene.part);
  for (const auto& mesh : scene.obstacles) look(mesh);
  for (const auto& mesh : scene.fixtures) look(mesh);
  return z;
}

Scene rapid_scene(const Scene& scene, const std::optional<geometry::TriangleMesh>& stock_P, double safe_distance_mm) {
  Scene rapid;
  rapid.obstacles.push_back(scene.part);
  rapid.obstacles.insert(rapid.obstacles.end(), scene.obstacles.begin(), scene.obstacles.end());
  if (stock_P) rapid.obstacles.push_back(*stock_P);
  rapid.fixtures = scene.fixtures;
  rapid.clearance_mm = safe_distance_mm;
  return rapid;
}

Leads::Leads(const kinematics::Tool& tool, const Interference& interference, const Interference& beyond_safe_distance,
             const ProcessOptions& process, double clearance_z_mm, const kinematics::Machine* machine,
             const kinematics::Setup* setup)
    : tool_(&tool),
      interference_(&interference),
      beyond_safe_distance_(&beyond_safe_distance),
      process_(&process),
      clearance_z_mm_(clearance_z_mm),
      radius_mm_(process.lead_radius_mm > 0.0 ? process.lead_radius_mm : tool.cutter.radius_mm),
      link_radius_mm_(process.link_lead_radius_mm > 0.0 ? process.link_lead_radius_mm
                                                        : link_lead_share * tool.cutter.radius_mm),
      machine_(machine),
      setup_(setup) {
  VOLUTE_CHECK(process.ramp_angle.radians() > 0.0 && process.ramp_angle.radians() < 0.5 * std::numbers::pi,
               process.ramp_angle.radians());
  VOLUTE_CHECK(process.safe_distance_mm > 0.0, process.safe_distance_mm);
}

/// The shape asked for, smaller by halves, to both sides; then the other shape; then straight along the normal and
/// along the axis.
std::vector<Leads::Lead> Leads::lead_shapes(const ToolPathPoint& point, const Vec3& away, double radius_mm) const {
  const auto arc = [&](double radius, double side) {
    Lead lead;
    for (int k = 1; k <= arc_points; ++k) {
      const double a = 0.5 * std::numbers::pi * k / arc_points;
      lead.offsets_mm.push_back(radius * (side * std::sin(a) * away + (1.0 - std::cos(a)) * point.normal_P));
    }
    return lead;
  };
  const double run = 1.0 / std::tan(process_->ramp_angle.radians());
  const auto ramp = [&](double height, double side) {
    return Lead{{height * (side * run * away + point.normal_P)}, {}};
  };
  std::vector<Lead> shapes;
  const bool ramp_first = process_->lead_shape == LeadShape::ramp;
  for (const bool as_ramp : {ramp_first, !ramp_first})
    for (const double share : {1.0, 0.5, 0.25})
      for (const double side : {1.0, -1.0})
        shapes.push_back(as_ramp ? ramp(share * radius_mm, side) : arc(share * radius_mm, side));
  shapes.push_back({{radius_mm * point.normal_P}, {}});
  shapes.push_back({{radius_mm * point.pose.axis_P}, {}});
  return shapes;
}

bool Leads::is_free_way(const ToolPose& from, const Vec3& to_P_mm, bool tip_counts) const {
  const double length = (to_P_mm - from.tip_P_mm).norm();
  const int steps = std::max(1, static_cast<int>(std::ceil(length / check_step_mm)));
  for (int k = 1; k <= steps; ++k) {
    const double t = static_cast<double>(k) / steps;
    const ToolPose pose{from.tip_P_mm + t * (to_P_mm - from.tip_P_mm), from.axis_P};
    if (!(tip_counts ? interference_->is_free(pose) : interference_->is_free_but_tip(pose))) return false;
  }
  return true;
}

/// How high the tip must stand so that the whole assembly, leaning as it does, is above the clearance height.
double Leads::safe_tip_z_mm(const Vec3& axis_P) const {
  const double across = std::sqrt(std::max(1.0 - axis_P.z() * axis_P.z(), 0.0));
  double dip = 0.0;
  const auto look = [&](double z, double radius) { dip = std::max(dip, radius * across - z * axis_P.z()); };
  look(0.0, tool_->cutter.radius_mm);
  look(tool_->stick_out_mm, tool_->shank_radius_mm);
  for (const kinematics::ConeSegment& cone : tool_->holder) {
    look(cone.z_mm, cone.bottom_radius_mm);
    look(cone.z_mm + cone.length_mm, cone.top_radius_mm);
  }
  return clearance_z_mm_ + dip;
}

/// From the end of a lead to clearance height: straight up when free, else out along the axis first. Empty: neither is
/// free.
std::vector<Vec3> Leads::way_up(const ToolPose& from, bool tip_counts) const {
  const auto above = [&](const Vec3& p) { return Vec3(p.x(), p.y(), std::max(safe_tip_z_mm(from.axis_P), p.z())); };
  if (is_free_way(from, above(from.tip_P_mm), tip_counts)) return {above(from.tip_P_mm)};
  for (double out = axis_retract_min_mm; out <= 256.0; out *= 2.0) {
    const Vec3 aside = from.tip_P_mm + out * from.axis_P;
    if (!is_free_way(from, aside, tip_counts)) return {};
    if (is_free_way({aside, from.axis_P}, above(aside), tip_counts)) return {aside, above(aside)};
  }
  return {};
}

/// Where the tool stands at the lead's outer end; nothing when it is not free.
std::optional<ToolPose> Leads::end_of_free_lead(const ToolPathPoint& point, const Lead& lead, bool tip_counts) const {
  ToolPose pose = point.pose;
  for (const Vec3& offset : lead.offsets_mm) {
    const Vec3 to = point.pose.tip_P_mm + offset;
    if (!is_free_way(pose, to, tip_counts)) return std::nullopt;
    pose.tip_P_mm = to;
  }
  return pose;
}

std::optional<Leads::Lead> Leads::free_lead(const ToolPathPoint& point, const Vec3& away) const {
  // Where the ball does not fit the surface at the contact itself, no lead from there can be held to more.
  const bool tip_counts = interference_->is_free(point.pose);
  for (Lead& shape : lead_shapes(point, away, radius_mm_)) {
    const auto end = end_of_free_lead(point, shape, tip_counts);
    if (!end) continue;
    const std::vector<Vec3> up = way_up(*end, tip_counts);
    if (up.empty()) continue;
    for (const Vec3& p : up) shape.way_up_mm.push_back(p - point.pose.tip_P_mm);
    return shape;
  }
  return std::nullopt;
}

geometry::Result<ToolPath> Leads::with_leads(const ToolPath& piece, int piece_number,
                                             std::optional<int> last_number) const {
  VOLUTE_CHECK(piece.points.size() >= 2, piece.points.size());
  const ToolPathPoint& first = piece.points.front();
  const ToolPathPoint& last = piece.points.back();
  const auto lead_in = free_lead(first, tangent_away(first, piece.points[1]));
  const auto lead_out = free_lead(last, tangent_away(last, piece.points[piece.points.size() - 2]));
  if (!lead_in || !lead_out) {
    const Vec3& p = (lead_in ? last : first).contact_P_mm;
    return geometry::bad_input(
        "lead-blocked", "piece " + std::to_string(lead_in ? last_number.value_or(piece_number) : piece_number) +
                            ": no way " + (lead_in ? "away from" : "to") + " its " + (lead_in ? "last" : "first") +
                            " point (" + geometry::short_text(p.x()) + ", " + geometry::short_text(p.y()) + ", " +
                            geometry::short_text(p.z()) + ") is free; lower lead_radius_mm, or start elsewhere");
  }
  ToolPath path;
  come_in(first, *lead_in, path);
  const std::size_t in = path.points.size();
  path.points.insert(path.points.end(), piece.points.begin(), piece.points.end());
  path.points[in].move = MoveKind::approach;
  path.points[in].feed_mm_s = approach_feed_mm_s();
  go_out(last, *lead_out, path);
  return path;
}

double Leads::approach_feed_mm_s() const {
  return process_->approach_feed_mm_s > 0.0 ? process_->approach_feed_mm_s : process_->feed_mm_s;
}

/// How much of the straight way can be made in rapid: up to where the assembly comes nearer than the safe distance. A
/// step is no longer than that distance, so nothing is met between two places that keep it.
double Leads::rapid_share(const ToolPose& from, const Vec3& to_P_mm) const {
  const Vec3 way = to_P_mm - from.tip_P_mm;
  const int steps =
      std::max(1, static_cast<int>(std::ceil(way.norm() / std::min(check_step_mm, process_->safe_distance_mm))));
  for (int k = 0; k <= steps; ++k)
    if (!beyond_safe_distance_->is_free({from.tip_P_mm + (static_cast<double>(k) / steps) * way, from.axis_P}))
      return static_cast<double>(std::max(0, k - 1)) / steps;
  return 1.0;
}

/// The highest point and the way down to the safe distance in rapid, the rest of it and the lead at feed.
void Leads::come_in(const ToolPathPoint& first, const Lead& lead, ToolPath& path) const {
  const auto add = [&](const Vec3& offset, MoveKind move) {
    path.points.push_back(with_offset(first, offset, move, move == MoveKind::rapid ? 0.0 : approach_feed_mm_s()));
  };
  std::vector<Vec3> down(lead.way_up_mm.rbegin(), lead.way_up_mm.rend());
  down.push_back(lead.offsets_mm.back());
  add(down.front(), MoveKind::rapid);
  bool rapid = true;
  for (std::size_t k = 1; k < down.size(); ++k) {
    const Vec3 &from = down[k - 1], &to = down[k];
    const double share =
        rapid ? rapid_share({first.pose.tip_P_mm + from, first.pose.axis_P}, first.pose.tip_P_mm + to) : 0.0;
    if (share > 0.0) add(from + share * (to - from), MoveKind::rapid);
    rapid = share == 1.0;
    if (!rapid) add(to, MoveKind::approach);
  }
  for (std::size_t k = lead.offsets_mm.size() - 1; k-- > 0;) add(lead.offsets_mm[k], MoveKind::approach);
}

/// The lead and a way aside at feed, up in rapid.
void Leads::go_out(const ToolPathPoint& last, const Lead& lead, ToolPath& path) const {
  const auto retract = [&](const Vec3& offset) {
    path.points.push_back(with_offset(last, offset, MoveKind::retract, process_->feed_mm_s));
  };
  for (const Vec3& offset : lead.offsets_mm) retract(offset);
  for (std::size_t k = 0; k + 1 < lead.way_up_mm.size(); ++k) retract(lead.way_up_mm[k]);
  path.points.push_back(with_offset(last, lead.way_up_mm.back(), MoveKind::rapid, 0.0));
}

void Leads::append(ToolPath& whole, const ToolPath& piece) const {
  if (!whole.points.empty()) {
    // Turning in the air: as high as the worst lean between the two axes asks for.
    const ToolPathPoint& from = whole.points.back();
    const ToolPathPoint& to = piece.points.front();
    double z = std::max(from.pose.tip_P_mm.z(), to.pose.tip_P_mm.z());
    for (int degrees = 0; degrees <= 180; degrees += 5) {
      const double a = degrees * std::numbers::pi / 180.0;
      const double least = std::min(from.pose.axis_P.z(), to.pose.axis_P.z());
      if (std::cos(a) >= least) z = std::max(z, safe_tip_z_mm(Vec3(std::sin(a), 0.0, std::cos(a))));
    }
    ToolPathPoint up = from, over = to;
    up.move = over.move = MoveKind::rapid;
    up.feed_mm_s = over.feed_mm_s = 0.0;
    up.pose.tip_P_mm.z() = over.pose.tip_P_mm.z() = z;
    whole.points.push_back(up);
    whole.points.push_back(over);
  }
  whole.points.insert(whole.points.end(), piece.points.begin(), piece.points.end());
}

}  // namespace volute::planner

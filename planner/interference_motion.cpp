// The way between two poses, proved free pair by pair.
//
// A pair that stands d apart in the middle of a stretch cannot meet on it when no point of the two moves more than d
// from there. So most pairs of most motions take one question; the others are halved.
#include <cmath>
#include <numbers>

#include <Eigen/LU>

#include "kinematics/inverse/inverse.hpp"
#include "planner/interference_trees.hpp"

namespace volute::planner {

using kinematics::ToolPose;

namespace {

// As the axis path: between its points the control stays this close to the great circle.
const double rotary_tolerance_rad = kinematics::AxisPathOptions().rotary_tolerance_rad;
constexpr int divisions_max = 10;
// Halvings of a stretch: 1 m becomes 1 nm; only a bound that does not shrink could come here.
constexpr int halvings_max = 30;

double angle_between(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

/// On the great circle; opposite axes have none: through any axis square to them.
Vec3 axis_between(const Vec3& from, const Vec3& to, double share) {
  const double angle = angle_between(from, to);
  if (angle < 1e-12) return from;
  Vec3 pivot = from.cross(to);
  if (pivot.norm() < 1e-12) pivot = from.unitOrthogonal();
  return Eigen::AngleAxisd(share * angle, pivot.normalized()) * from;
}

/// A part of the way, with what stands at its ends.
struct Stretch {
  ToolPose from, to;
  RotaryPair rotaries_from{}, rotaries_to{};
  double share_from = 0.0, share_to = 1.0;

  [[nodiscard]] ToolPose middle_pose() const {
    return {0.5 * (from.tip_P_mm + to.tip_P_mm), axis_between(from.axis_P, to.axis_P, 0.5)};
  }
  [[nodiscard]] RotaryPair middle_rotaries() const {
    return {0.5 * (rotaries_from[0] + rotaries_to[0]), 0.5 * (rotaries_from[1] + rotaries_to[1])};
  }
  [[nodiscard]] std::array<Stretch, 2> halves(const ToolPose& pose, const RotaryPair& rotaries) const {
    const double share = 0.5 * (share_from + share_to);
    return {Stretch{from, pose, rotaries_from, rotaries, share_from, share},
            Stretch{pose, to, rotaries, rotaries_to, share, share_to}};
  }
};

}  // namespace

class MotionCheck {
 public:
  MotionCheck(const Interference& interference, const ToolMotion& motion)
      : trees_(*interference.trees_), with_links_(motion.rotaries && interference.has_machine()) {
    Stretch whole{motion.from, motion.to, {}, {}, 0.0, 1.0};
    if (with_links_) {
      whole.rotaries_from = (*motion.rotaries)[0];
      whole.rotaries_to = (*motion.rotaries)[1];
      divide(whole, 0);
    } else {
      stretches_.push_back(whole);
    }
  }

  [[nodiscard]] std::optional<Interference::MotionHit> first_hit() const {
    const std::size_t pairs = with_links_ ? trees_.pairs.size() : trees_.assembly_pairs;
    for (const Stretch& stretch : stretches_) {
      const Stand middle = stand_in_middle(stretch, with_links_);
      for (std::size_t p = 0; p < pairs; ++p) {
        const WatchedPair& pair = trees_.pairs[p];
        if (pair.is_tip_at_part) continue;
        if (const auto share = follow(pair, stretch, middle, 0))
          return Interference::MotionHit{trees_.names(pair), *share};
      }
    }
    return std::nullopt;
  }

 private:
  /// Halves while the rotaries, moved linearly, would leave the great circle: next to the pole.
  void divide(const Stretch& stretch, int depth) {
    const ToolPose pose = stretch.middle_pose();
    const RotaryPair linear = stretch.middle_rotaries();
    if (depth < divisions_max && angle_between(axis_at(linear), pose.axis_P) > rotary_tolerance_rad) {
      if (const auto rotaries = nearest_rotaries(pose.axis_P, linear)) {
        for (const Stretch& half : stretch.halves(pose, *rotaries)) divide(half, depth + 1);
        return;
      }
    }
    stretches_.push_back(stretch);
  }

  [[nodiscard]] Vec3 axis_at(const RotaryPair& rotaries) const {
    kinematics::AxisVector q = kinematics::AxisVector::Zero();
    q[3] = rotaries[0];
    q[4] = rotaries[1];
    return kinematics::tool_pose(*trees_.machine, trees_.setup, trees_.tool_length_mm, q).axis_P;
  }

  [[nodiscard]] std::optional<RotaryPair> nearest_rotaries(const Vec3& axis_P, const RotaryPair& near) const {
    std::optional<RotaryPair> nearest;
    double least = 0.0;
    const Vec3 axis_M = trees_.setup.part_in_machine.linear() * axis_P;
    for (const kinematics::RotarySolution& solution : kinematics::solve_rotaries(*trees_.machine, axis_M)) {
      if (solution.at_pole) continue;
      RotaryPair at = {solution.first_rad, solution.second_rad};
      for (std::size_t k = 0; k < 2; ++k) at[k] = near[k] + std::remainder(at[k] - near[k], 2.0 * std::numbers::pi);
      const double far = std::hypot(at[0] - near[0], at[1] - near[1]);
      if (!nearest || far < least) nearest = at, least = far;
    }
    return nearest;
  }

  [[nodiscard]] Stand stand_in_middle(const Stretch& stretch, bool with_links) const {
    if (with_links) return trees_.stand(stretch.middle_pose(), stretch.middle_rotaries());
    return {stretch.middle_pose(), {}, {}};
  }

  /// Where the pair meets, as a share of the whole way.
  [[nodiscard]] std::optional<double> follow(const WatchedPair& pair, const Stretch& stretch, const Stand& middle,
                                             int depth) const {
    const double moved = moved_mm(pair, stretch, middle);
    const double share = 0.5 * (stretch.share_from + stretch.share_to);
    if (moved <= trees_.motion_tolerance_mm || depth >= halvings_max)
      return trees_.touches(pair, middle) ? std::optional(share) : std::nullopt;
    if (std::isfinite(moved) && trees_.is_clear(pair, middle, moved)) return std::nullopt;
    const bool with_links = pair.kind != WatchedPair::Kind::piece_body;
    for (const Stretch& half : stretch.halves(middle.pose, with_links ? middle.rotaries : RotaryPair{})) {
      if (const auto hit = follow(pair, half, stand_in_middle(half, with_links), depth + 1)) return hit;
    }
    return std::nullopt;
  }

  /// How far the two may come nearer between the middle and an end of the stretch.
  [[nodiscard]] double moved_mm(const WatchedPair& pair, const Stretch& stretch, const Stand& middle) const {
    using Kind = WatchedPair::Kind;
    switch (pair.kind) {
      case Kind::piece_body:
        return piece_moved_mm(trees_.pieces[pair.a].shape_for(trees_.bodies[pair.b]), stretch);
      case Kind::piece_link:
        return piece_moved_mm(trees_.pieces[pair.a].at_others, stretch) + link_moved_mm(pair.b, stretch, middle);
      case Kind::link_body:
        return link_moved_mm(pair.a, stretch, middle);
      case Kind::link_link:
        return link_moved_mm(pair.a, stretch, middle) + link_moved_mm(pair.b, stretch, middle);
    }
    return 0.0;
  }

  static double piece_moved_mm(const PlacedShape& shape, const Stretch& stretch) {
    return 0.5 * ((stretch.to.tip_P_mm - stretch.from.tip_P_mm).norm() +
                  angle_between(stretch.from.axis_P, stretch.to.axis_P) * shape.reach_mm());
  }

  /// A point's velocity is that of the linear axes plus, for each rotary, its velocity times the distance from its
  /// line. The linear axes keep the tip on its way, which bounds them. Distances grow by no more than the motion
  /// itself, hence the division.
  [[nodiscard]] double link_moved_mm(std::size_t index, const Stretch& stretch, const Stand& middle) const {
    const LinkBody& link = trees_.links[index];
    const kinematics::Machine& machine = *trees_.machine;
    const Vec3 centre_M_mm = trees_.X_M_link(index, middle) * link.centre_mm;
    const Vec3 tip_M_mm = trees_.setup.part_in_machine * middle.pose.tip_P_mm;
    double turned = 0.0, linear = 0.5 * (stretch.to.tip_P_mm - stretch.from.tip_P_mm).norm(), by_rotaries = 0.0;
    bool carries_linear = false;
    for (std::size_t j = 0; j < machine.chain.size(); ++j) {
      const auto axis_index = static_cast<std::size_t>(machine.chain[j]);
      const kinematics::Axis& axis = machine.axes[axis_index];
      const bool before_link = static_cast<int>(j) < link.place;
      if (axis.kind == kinematics::AxisKind::linear) {
        carries_linear = carries_linear || before_link;
        continue;
      }
      const std::size_t k = axis_index - 3;
      const double delta = 0.5 * std::abs(stretch.rotaries_to[k] - stretch.rotaries_from[k]);
      const geometry::Transform& X = middle.X_M_place[j];
      const Vec3 point_M_mm = X * axis.point_M_mm, direction_M = X.linear() * axis.direction_M;
      const auto arm_mm = [&](const Vec3& p) { return (p - point_M_mm).cross(direction_M).norm(); };
      turned += delta;
      linear += delta * arm_mm(tip_M_mm);
      if (before_link) by_rotaries += delta * (arm_mm(centre_M_mm) + link.radius_mm);
    }
    if (turned >= 0.5) return std::numeric_limits<double>::infinity();
    const double grown = 1.0 / (1.0 - turned);
    return grown * (by_rotaries + (carries_linear ? grown * trees_.linear_gain * linear : 0.0));
  }

  const Interference::Trees& trees_;
  bool with_links_;
  std::vector<Stretch> stretches_;
};

std::optional<Interference::MotionHit> Interference::first_hit_on(const ToolMotion& motion) const {
  return MotionCheck(*this, motion).first_hit();
}

bool Interference::motion_is_free(const ToolMotion& motion) const { return !first_hit_on(motion); }

}  // namespace volute::planner

// Free or blocked for every turn about a pivot within bounds: what the cells of a C-space map are proved by.
//
// When the tool turns about the point where it cuts, what is near that point hardly moves. A bound by distance from the
// pivot therefore proves what no single clearance can: a flat end stands 0 from the part where it cuts.
#include <algorithm>

#include "planner/interference_trees.hpp"

namespace volute::planner {

using kinematics::ToolPose;

namespace {

/// Disc of a bull cutter's corner.
AxialCone disc_of(const PlacedShape& shape, const ToolPose& pose) {
  return {pose.tip_P_mm, pose.axis_P, shape.disc_z_mm, shape.disc_z_mm, shape.disc_radius_mm, shape.disc_radius_mm};
}

Vec3 ball_centre_mm(const PlacedShape& shape, const ToolPose& pose) {
  return pose.tip_P_mm + shape.centre_z_mm * pose.axis_P;
}

bool shape_stays_clear(const PlacedShape& shape, const ToolPose& pose, const SphereTree& tree, const TurnBound& turn) {
  if (shape.is_ball) {
    const Vec3 centre = ball_centre_mm(shape, pose);
    const double needed = shape.radius_mm() + turn.moved_mm((centre - turn.pivot_mm).norm()) + distance_rounding_mm;
    return tree.point_distance_mm(centre, needed) >= needed;
  }
  return shape.has_disc ? tree.is_clear_of_turn(disc_of(shape, pose), shape.outer_arc_mm, turn)
                        : tree.is_clear_of_turn(cone_round(shape, pose), 0.0, turn);
}

bool shape_stays_met(const PlacedShape& shape, const ToolPose& pose, const SphereTree& tree, const TurnBound& turn) {
  if (shape.is_ball) {
    const Vec3 centre = ball_centre_mm(shape, pose);
    const double within = shape.radius_mm() - turn.moved_mm((centre - turn.pivot_mm).norm()) - distance_rounding_mm;
    return within > 0.0 && tree.point_distance_mm(centre, within) < within;
  }
  if (shape.has_disc) return tree.is_inside_for_turn(disc_of(shape, pose), shape.inner_arc_mm, turn);
  AxialCone inner = cone_round(shape, pose);
  inner.bottom_radius_mm *= shape.inner_share;
  inner.top_radius_mm *= shape.inner_share;
  return shape.inner_share > 0.0 && tree.is_inside_for_turn(inner, 0.0, turn);
}

}  // namespace

bool Interference::pair_stays_clear(std::size_t p, const ToolPose& pose, const TurnBound& given) const {
  const WatchedPair& pair = trees_->pairs[p];
  const SceneBody& body = trees_->bodies[pair.b];
  const AssemblyPiece& piece = trees_->pieces[pair.a];
  TurnBound turn = given;
  // The ball is of the true cutter; as it may stand in the part it is shrunk by the gouge tolerance.
  if (body.is_part && piece.part == "cutter")
    turn.ball_radius_mm -= trees_->gouge_tolerance_mm;
  else
    turn.within_mm = 0.0;
  return shape_stays_clear(piece.shape_for(body), pose, body.tree, turn);
}

bool Interference::pair_stays_met(std::size_t p, const ToolPose& pose, const TurnBound& turn) const {
  const WatchedPair& pair = trees_->pairs[p];
  const SceneBody& body = trees_->bodies[pair.b];
  return shape_stays_met(trees_->pieces[pair.a].shape_for(body), pose, body.tree, turn);
}

bool Interference::stays_free(const ToolPose& pose, const TurnBound& turn) const {
  for (std::size_t p = 0; p < trees_->assembly_pairs; ++p) {
    if (!trees_->pairs[p].is_tip_at_part && !pair_stays_clear(p, pose, turn)) return false;
  }
  return trees_->swallowing(pose) == nullptr;
}

bool Interference::stays_blocked(const ToolPose& pose, const TurnBound& turn) const {
  for (std::size_t p = 0; p < trees_->assembly_pairs; ++p) {
    if (!trees_->pairs[p].is_tip_at_part && pair_stays_met(p, pose, turn)) return true;
  }
  return false;
}

OpenPairs Interference::open_pairs() const {
  OpenPairs open;
  for (std::size_t p = 0; p < trees_->assembly_pairs; ++p) {
    if (!trees_->pairs[p].is_tip_at_part) open.pairs.push_back(p);
  }
  return open;
}

TurnVerdict Interference::verdict(const ToolPose& pose, const TurnBound& turn, const OpenPairs& open) const {
  if (open.surely_blocked) return {false, open};
  TurnVerdict verdict;
  auto& left = verdict.open.pairs;
  std::copy_if(open.pairs.begin(), open.pairs.end(), std::back_inserter(left),
               [&](std::size_t p) { return !pair_stays_clear(p, pose, turn); });
  verdict.open.surely_blocked =
      std::any_of(left.begin(), left.end(), [&](std::size_t p) { return pair_stays_met(p, pose, turn); });
  verdict.free = left.empty() && trees_->swallowing(pose) == nullptr;
  return verdict;
}

std::optional<InterferenceHit> Interference::first_open_hit(const ToolPose& pose, const OpenPairs& open) const {
  const Stand at{pose, {}, {}};
  for (const std::size_t p : open.pairs) {
    if (trees_->touches(trees_->pairs[p], at)) return trees_->names(trees_->pairs[p]);
  }
  if (const SceneBody* body = trees_->swallowing(pose)) return InterferenceHit{trees_->pieces.back().part, body->name};
  return std::nullopt;
}

}  // namespace volute::planner

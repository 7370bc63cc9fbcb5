#include "planner/interference.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/check.hpp"
#include "geometry/turn.hpp"
#include "planner/interference_trees.hpp"

namespace volute::planner {

using kinematics::ToolPose;

namespace {

/// Every edge has two triangles that run along it in opposite directions.
bool is_closed(const geometry::TriangleMesh& mesh) {
  std::vector<std::pair<geometry::Index, geometry::Index>> forward, backward;
  for (const geometry::Triangle& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      forward.emplace_back(t[k], t[(k + 1) % 3]);
      backward.emplace_back(t[(k + 1) % 3], t[k]);
    }
  }
  std::sort(forward.begin(), forward.end());
  std::sort(backward.begin(), backward.end());
  return !forward.empty() && forward == backward;
}

ToolPose seen_from(const geometry::Transform& X_from, const geometry::Transform& X_pose, const ToolPose& pose) {
  const geometry::Transform X = X_from.inverse() * X_pose;
  return {X * pose.tip_P_mm, X.linear() * pose.axis_P};
}

fcl::Transform3d placement(const PlacedShape& shape, const ToolPose& pose) {
  fcl::Transform3d X = fcl::Transform3d::Identity();
  X.linear() = geometry::turn_from_z(pose.axis_P).toRotationMatrix();
  X.translation() = pose.tip_P_mm + shape.centre_z_mm * pose.axis_P;
  return X;
}

/// Spheres decide what they can; FCL decides the rest, triangle by triangle. (FCL's own collide() of a Convex and a
/// BVHModel<OBB> is not to be had: its box round a Convex has extents and axes that do not belong together.)
bool shape_touches(const PlacedShape& shape, const ToolPose& pose, const SphereTree& tree) {
  if (shape.is_ball) {
    const Vec3 centre = pose.tip_P_mm + shape.centre_z_mm * pose.axis_P;
    return tree.point_distance_mm(centre, shape.radius_mm()) < shape.radius_mm();
  }
  const fcl::Transform3d X = placement(shape, pose);
  return tree.any_meets(cone_round(shape, pose), shape.is_cone,
                        [&](const Vec3& a, const Vec3& b, const Vec3& c) { return meets_triangle(shape, X, a, b, c); });
}

double shape_slack_mm(const PlacedShape& shape, const ToolPose& pose, const SphereTree& tree, double cap_mm) {
  if (shape.is_ball) {
    const Vec3 centre = pose.tip_P_mm + shape.centre_z_mm * pose.axis_P;
    return tree.point_distance_mm(centre, shape.radius_mm() + cap_mm) - shape.radius_mm() - distance_rounding_mm;
  }
  return tree.clearance_mm(cone_round(shape, pose), cap_mm) - distance_rounding_mm;
}

/// How deep the mesh reaches into the shape.
double shape_depth_mm(const PlacedShape& shape, const ToolPose& pose, const SphereTree& tree) {
  if (shape.is_ball) {
    const Vec3 centre = pose.tip_P_mm + shape.centre_z_mm * pose.axis_P;
    return shape.radius_mm() - tree.point_distance_mm(centre, shape.radius_mm());
  }
  return shape.inner_share > 0.0
             ? tree.depth_mm({pose.tip_P_mm, pose.axis_P, shape.z_min_mm, shape.z_max_mm,
                              shape.inner_share * shape.bottom_radius_mm, shape.inner_share * shape.top_radius_mm})
             : 0.0;
}

/// Solids that hold each other without their surfaces meeting.
bool holds(bool closed, const SphereTree& solid, const SphereTree& other, const geometry::Transform& X_solid_other) {
  return closed && !other.is_empty() && solid.contains(X_solid_other * other.any_point_mm());
}

}  // namespace

void Interference::Trees::add_body(const geometry::TriangleMesh& mesh, std::string name, bool is_part) {
  if (mesh.triangles.empty()) return;
  bodies.push_back({std::move(name), is_part, is_closed(mesh), SphereTree(mesh)});
}

void Interference::Trees::add_scene(const Scene& scene) {
  motion_tolerance_mm = scene.motion_tolerance_mm;
  gouge_tolerance_mm = scene.gouge_tolerance_mm;
  add_body(scene.part, "part", true);
  std::size_t index = 0;
  const auto name = [&](const char* kind) {
    const std::size_t k = index++;
    return k < scene.names.size() ? scene.names[k] : std::string(kind) + " " + std::to_string(k + 1);
  };
  for (const geometry::TriangleMesh& mesh : scene.obstacles) add_body(mesh, name("obstacle"), false);
  for (const geometry::TriangleMesh& mesh : scene.fixtures) add_body(mesh, name("fixture"), false);
}

void Interference::Trees::add_tool(const kinematics::Tool& tool, const Scene& scene) {
  tool_length_mm = tool.gauge_length_mm;
  for (const ToolPiece& piece : tool_pieces(tool)) {
    const bool cuts = piece.part == "cutter";
    const bool tip = piece.kind == ToolPiece::Kind::ball;
    pieces.push_back({piece.part, tip, placed_shape(piece, cuts ? -scene.gouge_tolerance_mm : scene.clearance_mm),
                      placed_shape(piece, scene.clearance_mm)});
    top_mm = std::max(top_mm, piece.z_max_mm);
    if (tip) ball_radius_mm = piece.bottom_radius_mm;
    reach_mm = std::max(reach_mm, pieces.back().at_others.reach_mm());
  }
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    for (std::size_t p = 0; p < pieces.size(); ++p)
      pairs.push_back({WatchedPair::Kind::piece_body, p, b, 0.0, pieces[p].is_tip && bodies[b].is_part});
  }
  assembly_pairs = pairs.size();
}

bool Interference::Trees::touches(const WatchedPair& pair, const Stand& at) const {
  using Kind = WatchedPair::Kind;
  switch (pair.kind) {
    case Kind::piece_body: {
      const SceneBody& body = bodies[pair.b];
      return shape_touches(pieces[pair.a].shape_for(body), at.pose, body.tree);
    }
    case Kind::piece_link: {
      const ToolPose pose = seen_from(X_M_link(pair.b, at), setup.part_in_machine, at.pose);
      return shape_touches(pieces[pair.a].at_others, pose, links[pair.b].tree);
    }
    case Kind::link_body: {
      const LinkBody& link = links[pair.a];
      const SceneBody& body = bodies[pair.b];
      const geometry::Transform X = X_M_link(pair.a, at).inverse() * setup.part_in_machine;
      const double far = pair.apart_mm + distance_rounding_mm;
      return link.tree.mesh_distance_mm(body.tree, X, far) < far || holds(true, link.tree, body.tree, X) ||
             holds(body.closed, body.tree, link.tree, X.inverse());
    }
    case Kind::link_link: {
      const geometry::Transform X = X_M_link(pair.a, at).inverse() * X_M_link(pair.b, at);
      const double far = pair.apart_mm + distance_rounding_mm;
      return links[pair.a].tree.mesh_distance_mm(links[pair.b].tree, X, far) < far;
    }
  }
  return false;
}

double Interference::Trees::slack_mm(const WatchedPair& pair, const Stand& at, double cap_mm) const {
  using Kind = WatchedPair::Kind;
  const auto meshes = [&](const SphereTree& a, const SphereTree& b, const geometry::Transform& X) {
    return a.mesh_distance_mm(b, X, cap_mm + pair.apart_mm) - pair.apart_mm - distance_rounding_mm;
  };
  switch (pair.kind) {
    case Kind::piece_body:
      return shape_slack_mm(pieces[pair.a].shape_for(bodies[pair.b]), at.pose, bodies[pair.b].tree, cap_mm);
    case Kind::piece_link:
      return shape_slack_mm(pieces[pair.a].at_others, seen_from(X_M_link(pair.b, at), setup.part_in_machine, at.pose),
                            links[pair.b].tree, cap_mm);
    case Kind::link_body:
      return meshes(links[pair.a].tree, bodies[pair.b].tree, X_M_link(pair.a, at).inverse() * setup.part_in_machine);
    case Kind::link_link:
      return meshes(links[pair.a].tree, links[pair.b].tree, X_M_link(pair.a, at).inverse() * X_M_link(pair.b, at));
  }
  return 0.0;
}

bool Interference::Trees::is_clear(const WatchedPair& pair, const Stand& at, double by_mm) const {
  using Kind = WatchedPair::Kind;
  const auto shape_is_clear = [&](const PlacedShape& shape, const ToolPose& pose, const SphereTree& tree) {
    return shape.is_ball ? shape_slack_mm(shape, pose, tree, by_mm) >= by_mm - distance_rounding_mm
                         : tree.is_clear(cone_round(shape, pose), by_mm);
  };
  if (pair.kind == Kind::piece_body)
    return shape_is_clear(pieces[pair.a].shape_for(bodies[pair.b]), at.pose, bodies[pair.b].tree);
  if (pair.kind == Kind::piece_link)
    return shape_is_clear(pieces[pair.a].at_others, seen_from(X_M_link(pair.b, at), setup.part_in_machine, at.pose),
                          links[pair.b].tree);
  return slack_mm(pair, at, by_mm + distance_rounding_mm) >= by_mm;
}

InterferenceHit Interference::Trees::names(const WatchedPair& pair) const {
  using Kind = WatchedPair::Kind;
  const bool of_tool = pair.kind == Kind::piece_body || pair.kind == Kind::piece_link;
  const bool of_scene = pair.kind == Kind::piece_body || pair.kind == Kind::link_body;
  return {of_tool ? pieces[pair.a].part : links[pair.a].name, of_scene ? bodies[pair.b].name : links[pair.b].name};
}

const SceneBody* Interference::Trees::swallowing(const ToolPose& pose) const {
  for (const SceneBody& body : bodies) {
    if (body.closed && body.tree.contains(pose.tip_P_mm + top_mm * pose.axis_P)) return &body;
  }
  return nullptr;
}

Interference::Interference(const Scene& scene, const kinematics::Tool& tool, const kinematics::Machine* machine,
                           const kinematics::Setup* setup) {
  VOLUTE_CHECK(scene.clearance_mm >= 0.0 && scene.gouge_tolerance_mm >= 0.0 && scene.motion_tolerance_mm > 0.0,
               scene.clearance_mm, scene.gouge_tolerance_mm, scene.motion_tolerance_mm);
  auto trees = std::make_unique<Trees>();
  trees->add_scene(scene);
  trees->add_tool(tool, scene);
  if (machine != nullptr && setup != nullptr) trees->add_machine(*machine, *setup, scene);
  trees_ = std::move(trees);
}

Interference::~Interference() = default;
Interference::Interference(Interference&&) noexcept = default;
Interference& Interference::operator=(Interference&&) noexcept = default;

/// Whether, not where: what touched last on this thread is asked first, since neighbouring poses touch the same things.
bool Interference::is_hit(const ToolPose& pose, bool with_tip) const {
  thread_local std::size_t last = 0;
  const Stand at{pose, {}, {}};
  const auto hits = [&](std::size_t p) {
    return (with_tip || !trees_->pairs[p].is_tip_at_part) && trees_->touches(trees_->pairs[p], at);
  };
  if (last < trees_->assembly_pairs && hits(last)) return true;
  for (std::size_t p = 0; p < trees_->assembly_pairs; ++p) {
    if (p == last || !hits(p)) continue;
    last = p;
    return true;
  }
  return trees_->swallowing(pose) != nullptr;
}

std::optional<InterferenceHit> Interference::assembly_hit(const ToolPose& pose, bool with_tip) const {
  const Stand at{pose, {}, {}};
  for (std::size_t p = 0; p < trees_->assembly_pairs; ++p) {
    const WatchedPair& pair = trees_->pairs[p];
    if ((with_tip || !pair.is_tip_at_part) && trees_->touches(pair, at)) return trees_->names(pair);
  }
  if (const SceneBody* body = trees_->swallowing(pose)) return InterferenceHit{trees_->pieces.back().part, body->name};
  return std::nullopt;
}

bool Interference::is_free(const ToolPose& pose) const { return !is_hit(pose, true); }
bool Interference::is_free_but_tip(const ToolPose& pose) const { return !is_hit(pose, false); }
std::optional<InterferenceHit> Interference::first_hit(const ToolPose& pose) const { return assembly_hit(pose, true); }
std::optional<InterferenceHit> Interference::first_hit_but_tip(const ToolPose& pose) const {
  return assembly_hit(pose, false);
}
bool Interference::has_machine() const { return trees_->machine.has_value() && !trees_->links.empty(); }
double Interference::reach_mm() const { return trees_->reach_mm; }
double Interference::motion_tolerance_mm() const { return trees_->motion_tolerance_mm; }

double Interference::clearance_mm(const ToolPose& pose, double cap_mm) const {
  double least = cap_mm;
  const Stand at{pose, {}, {}};
  for (std::size_t p = 0; p < trees_->assembly_pairs && least > 0.0; ++p) {
    if (!trees_->pairs[p].is_tip_at_part) least = std::min(least, trees_->slack_mm(trees_->pairs[p], at, least));
  }
  return least <= 0.0 || trees_->swallowing(pose) != nullptr ? 0.0 : least;
}

double Interference::depth_mm(const ToolPose& pose) const {
  double depth = 0.0;
  for (std::size_t p = 0; p < trees_->assembly_pairs; ++p) {
    const WatchedPair& pair = trees_->pairs[p];
    const SceneBody& body = trees_->bodies[pair.b];
    if (!pair.is_tip_at_part)
      depth = std::max(depth, shape_depth_mm(trees_->pieces[pair.a].shape_for(body), pose, body.tree));
  }
  return depth;
}

double Interference::tip_depth_mm(const ToolPose& pose) const {
  const double r = trees_->ball_radius_mm;
  double depth = 0.0;
  if (r <= 0.0) return depth;
  for (const SceneBody& body : trees_->bodies) {
    if (body.is_part) depth = std::max(depth, r - body.tree.point_distance_mm(pose.tip_P_mm + r * pose.axis_P, r));
  }
  return depth;
}

}  // namespace volute::planner

#include "planner/interference.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/narrowphase/collision.h>

#include "geometry/check.hpp"
#include "planner/interference_shapes.hpp"
#include "planner/sphere_tree.hpp"

namespace volute::planner {

using kinematics::ToolPose;

namespace {

using Bvh = fcl::BVHModel<fcl::OBBd>;

// Rounding of the sphere tree's distances: what it calls clear by this much is clear.
constexpr double rounding_mm = 1e-7;

std::shared_ptr<const Bvh> bvh_of(const geometry::TriangleMesh& mesh) {
  std::vector<fcl::Vector3d> points(mesh.vertices_mm.begin(), mesh.vertices_mm.end());
  std::vector<fcl::Triangle> triangles;
  triangles.reserve(mesh.triangles.size());
  for (const geometry::Triangle& t : mesh.triangles) {
    triangles.emplace_back(static_cast<std::size_t>(t[0]), static_cast<std::size_t>(t[1]),
                           static_cast<std::size_t>(t[2]));
  }
  auto model = std::make_shared<Bvh>();
  model->beginModel(static_cast<int>(triangles.size()), static_cast<int>(points.size()));
  model->addSubModel(points, triangles);
  model->endModel();
  return model;
}

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

/// One body of the scene.
struct Body {
  std::string name;
  bool is_part = false, closed = false;
  std::shared_ptr<const Bvh> bvh;
  SphereTree tree;
};

/// One piece of the assembly, grown for the part and for everything else.
struct Piece {
  std::string part;
  bool is_tip = false;
  PlacedShape at_part, at_others;
  [[nodiscard]] const PlacedShape& shape_for(const Body& body) const { return body.is_part ? at_part : at_others; }
};

/// Machine link that moves, or the base.
struct Link {
  int link;
  bool with_tool;
  std::string name;
  std::shared_ptr<const Bvh> bvh;
};

AxialCone cone_round(const PlacedShape& shape, const ToolPose& pose) {
  return {pose.tip_P_mm, pose.axis_P, shape.z_min_mm, shape.z_max_mm, shape.bottom_radius_mm, shape.top_radius_mm};
}

fcl::Transform3d placement(const PlacedShape& shape, const ToolPose& pose) {
  fcl::Transform3d X = fcl::Transform3d::Identity();
  X.linear() = Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), pose.axis_P).toRotationMatrix();
  X.translation() = pose.tip_P_mm + shape.centre_z_mm * pose.axis_P;
  return X;
}

bool collides(const fcl::CollisionGeometryd& a, const fcl::Transform3d& X_a, const fcl::CollisionGeometryd& b,
              const fcl::Transform3d& X_b) {
  fcl::CollisionRequestd request(1, false);
  request.gjk_solver_type = fcl::GST_LIBCCD;
  fcl::CollisionResultd result;
  fcl::collide(&a, X_a, &b, X_b, request, result);
  return result.isCollision();
}

/// Spheres and corners decide what they can; FCL decides the rest.
bool touches(const PlacedShape& shape, const ToolPose& pose, const Body& body) {
  if (shape.is_ball) {
    const Vec3 centre = pose.tip_P_mm + shape.centre_z_mm * pose.axis_P;
    const double far = shape.radius_mm() + rounding_mm;
    if (body.tree.point_distance_mm(centre, far) >= far) return false;
  } else {
    const SphereTree::Meeting meeting = body.tree.meeting(cone_round(shape, pose), rounding_mm);
    if (meeting == SphereTree::Meeting::apart) return false;
    if (meeting == SphereTree::Meeting::touching && shape.is_cone) return true;
  }
  return collides(*shape.shape, placement(shape, pose), *body.bvh, fcl::Transform3d::Identity());
}

}  // namespace

struct Interference::Trees {
  std::vector<Body> bodies;
  std::vector<Piece> pieces;
  std::vector<PlacedShape> bare_pieces;  ///< not grown, for machine links
  std::vector<Link> links;
  std::set<std::pair<std::size_t, std::size_t>> joined_links;
  std::optional<kinematics::Machine> machine;
  kinematics::Setup setup;
  double tool_length_mm = 0.0, top_mm = 0.0, reach_mm = 0.0, ball_radius_mm = 0.0;

  void add_body(const geometry::TriangleMesh& mesh, std::string name, bool is_part) {
    if (mesh.triangles.empty()) return;
    bodies.push_back({std::move(name), is_part, is_closed(mesh), bvh_of(mesh), SphereTree(mesh)});
  }
  void add_scene(const Scene& scene);
  void add_tool(const kinematics::Tool& tool, const Scene& scene);
  void add_machine(const kinematics::Machine& from, const kinematics::Setup& at);
  [[nodiscard]] std::optional<InterferenceHit> assembly_hit(const ToolPose& pose, bool with_tip) const;
  [[nodiscard]] bool is_hit(const ToolPose& pose, bool with_tip) const;
  [[nodiscard]] std::optional<InterferenceHit> link_hit(const ToolPose& pose, const kinematics::AxisVector& q) const;
};

void Interference::Trees::add_scene(const Scene& scene) {
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
    bare_pieces.push_back(placed_shape(piece, 0.0));
    top_mm = std::max(top_mm, piece.z_max_mm);
    if (tip) ball_radius_mm = piece.bottom_radius_mm;
    const double widest = std::max(piece.bottom_radius_mm, piece.top_radius_mm);
    reach_mm = std::max(reach_mm, std::hypot(piece.z_max_mm, widest));
  }
}

void Interference::Trees::add_machine(const kinematics::Machine& from, const kinematics::Setup& at) {
  machine = from;
  setup = at;
  for (const kinematics::LinkShape& shape : from.shapes) {
    if (shape.mesh_M.triangles.empty()) continue;
    const auto place = std::find(from.chain.begin(), from.chain.end(), shape.link);
    const bool with_tool = shape.link >= 0 && place - from.chain.begin() >= from.table_axes;
    links.push_back({shape.link, with_tool, shape.name, bvh_of(shape.mesh_M)});
  }
  // Links that touch where the machine stands at zero are joined by design.
  const fcl::Transform3d zero = fcl::Transform3d::Identity();
  for (std::size_t a = 0; a < links.size(); ++a) {
    for (std::size_t b = a + 1; b < links.size(); ++b) {
      if (collides(*links[a].bvh, zero, *links[b].bvh, zero)) joined_links.insert({a, b});
    }
  }
}

std::optional<InterferenceHit> Interference::Trees::assembly_hit(const ToolPose& pose, bool with_tip) const {
  for (const Body& body : bodies) {
    for (const Piece& piece : pieces) {
      if (piece.is_tip && body.is_part && !with_tip) continue;
      if (touches(piece.shape_for(body), pose, body)) return InterferenceHit{piece.part, body.name};
    }
    // A surface says nothing of what lies wholly inside it; the assembly is one body, so one of its points tells.
    if (body.closed && body.tree.contains(pose.tip_P_mm + top_mm * pose.axis_P))
      return InterferenceHit{pieces.back().part, body.name};
  }
  return std::nullopt;
}

/// Whether, not where: what touched last on this thread is asked first, since neighbouring poses touch the same things.
bool Interference::Trees::is_hit(const ToolPose& pose, bool with_tip) const {
  thread_local std::size_t last_body = 0, last_piece = 0;
  const auto hits = [&](std::size_t b, std::size_t p) {
    if (pieces[p].is_tip && bodies[b].is_part && !with_tip) return false;
    return touches(pieces[p].shape_for(bodies[b]), pose, bodies[b]);
  };
  if (last_body < bodies.size() && last_piece < pieces.size() && hits(last_body, last_piece)) return true;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    for (std::size_t p = 0; p < pieces.size(); ++p) {
      if ((b == last_body && p == last_piece) || !hits(b, p)) continue;
      last_body = b;
      last_piece = p;
      return true;
    }
    if (bodies[b].closed && bodies[b].tree.contains(pose.tip_P_mm + top_mm * pose.axis_P)) return true;
  }
  return false;
}

std::optional<InterferenceHit> Interference::Trees::link_hit(const ToolPose& pose,
                                                             const kinematics::AxisVector& q) const {
  const geometry::Transform& X_MP = setup.part_in_machine;
  std::vector<fcl::Transform3d> X_links;
  for (const Link& link : links) X_links.emplace_back(kinematics::link_motion(*machine, link.link, q));
  for (std::size_t a = 0; a < links.size(); ++a) {
    if (links[a].with_tool) {
      for (const Body& body : bodies) {
        if (collides(*links[a].bvh, X_links[a], *body.bvh, X_MP)) return InterferenceHit{links[a].name, body.name};
      }
    } else {
      for (std::size_t k = 0; k < pieces.size(); ++k) {
        if (collides(*bare_pieces[k].shape, X_MP * placement(bare_pieces[k], pose), *links[a].bvh, X_links[a])) {
          return InterferenceHit{pieces[k].part, links[a].name};
        }
      }
    }
    for (std::size_t b = a + 1; b < links.size(); ++b) {
      if (links[a].link == links[b].link || joined_links.count({a, b}) != 0) continue;
      if (collides(*links[a].bvh, X_links[a], *links[b].bvh, X_links[b]))
        return InterferenceHit{links[a].name, links[b].name};
    }
  }
  return std::nullopt;
}

Interference::Interference(const Scene& scene, const kinematics::Tool& tool, const kinematics::Machine* machine,
                           const kinematics::Setup* setup) {
  VOLUTE_CHECK(scene.clearance_mm >= 0.0 && scene.gouge_tolerance_mm >= 0.0, scene.clearance_mm,
               scene.gouge_tolerance_mm);
  auto trees = std::make_unique<Trees>();
  trees->add_scene(scene);
  trees->add_tool(tool, scene);
  if (machine != nullptr && setup != nullptr) trees->add_machine(*machine, *setup);
  trees_ = std::move(trees);
}

Interference::~Interference() = default;
Interference::Interference(Interference&&) noexcept = default;
Interference& Interference::operator=(Interference&&) noexcept = default;

bool Interference::is_free(const ToolPose& pose) const { return !trees_->is_hit(pose, true); }
bool Interference::is_free_but_tip(const ToolPose& pose) const { return !trees_->is_hit(pose, false); }
std::optional<InterferenceHit> Interference::first_hit(const ToolPose& pose) const {
  return trees_->assembly_hit(pose, true);
}
bool Interference::has_machine() const { return trees_->machine.has_value() && !trees_->links.empty(); }
std::optional<InterferenceHit> Interference::first_hit_but_tip(const ToolPose& pose) const {
  return trees_->assembly_hit(pose, false);
}
double Interference::reach_mm() const { return trees_->reach_mm; }

bool Interference::is_free(const ToolPose& pose, const kinematics::AxisVector& q) const {
  return is_free(pose) && (!has_machine() || !trees_->link_hit(pose, q));
}

double Interference::clearance_mm(const ToolPose& pose, double cap_mm) const {
  double least = cap_mm;
  for (const Body& body : trees_->bodies) {
    for (const Piece& piece : trees_->pieces) {
      if (least <= 0.0) return 0.0;
      if (piece.is_tip && body.is_part) continue;
      least = std::min(least, body.tree.clearance_mm(cone_round(piece.shape_for(body), pose), least));
    }
    if (body.closed && body.tree.contains(pose.tip_P_mm + trees_->top_mm * pose.axis_P)) return 0.0;
  }
  return std::max(least - rounding_mm, 0.0);
}

double Interference::tip_depth_mm(const ToolPose& pose) const {
  const double r = trees_->ball_radius_mm;
  double depth = 0.0;
  if (r <= 0.0) return depth;
  for (const Body& body : trees_->bodies) {
    if (body.is_part) depth = std::max(depth, r - body.tree.point_distance_mm(pose.tip_P_mm + r * pose.axis_P, r));
  }
  return depth;
}

}  // namespace volute::planner

// What an Interference is made of: bodies, pieces of the tool, links of the machine, and the pairs that may not meet.
// Private to the module.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "planner/interference.hpp"
#include "planner/interference_shapes.hpp"
#include "planner/sphere_tree.hpp"

namespace volute::planner {

/// Rounding of distances: what is called clear by this much is clear.
constexpr double distance_rounding_mm = 1e-7;

/// One body of the scene, in P.
struct SceneBody {
  std::string name;
  bool is_part = false, closed = false;
  SphereTree tree;
};

/// One piece of the assembly, grown for the part and for everything else.
struct AssemblyPiece {
  std::string part;
  bool is_tip = false;
  PlacedShape at_part, at_others;
  [[nodiscard]] const PlacedShape& shape_for(const SceneBody& body) const { return body.is_part ? at_part : at_others; }
};

/// A solid that moves with a link of the machine; `place`: how many axes of the chain stand between it and the
/// workpiece.
struct LinkBody {
  int place = 0;
  std::string name;
  SphereTree tree;
  Vec3 centre_mm = Vec3::Zero();  ///< of a ball round it, at zero pose
  double radius_mm = 0.0;
};

/// Two things that may not come nearer than `apart_mm` (pieces carry their growth themselves).
struct WatchedPair {
  enum class Kind { piece_body, link_body, piece_link, link_link };
  Kind kind = Kind::piece_body;
  std::size_t a = 0, b = 0;
  double apart_mm = 0.0;
  bool is_tip_at_part = false;
};

/// The cone round the shape of a tool at `pose`.
inline AxialCone cone_round(const PlacedShape& shape, const kinematics::ToolPose& pose) {
  return {pose.tip_P_mm, pose.axis_P, shape.z_min_mm, shape.z_max_mm, shape.bottom_radius_mm, shape.top_radius_mm};
}

/// Where everything stands. X_M_place[k]: the motion of what stands behind k axes of the chain.
struct Stand {
  kinematics::ToolPose pose;
  RotaryPair rotaries{};
  std::array<geometry::Transform, kinematics::axis_count + 1> X_M_place;
};

struct Interference::Trees {
  std::vector<SceneBody> bodies;
  std::vector<AssemblyPiece> pieces;
  std::vector<LinkBody> links;
  std::vector<WatchedPair> pairs;  ///< those of the assembly first
  std::size_t assembly_pairs = 0;
  std::optional<kinematics::Machine> machine;
  kinematics::Setup setup;
  double tool_length_mm = 0.0, top_mm = 0.0, reach_mm = 0.0, ball_radius_mm = 0.0, motion_tolerance_mm = 0.0,
         gouge_tolerance_mm = 0.0;
  double linear_gain = 1.0;  ///< how far the linear axes go for a mm of the tip at most: 1 when they are square

  void add_body(const geometry::TriangleMesh& mesh, std::string name, bool is_part);
  void add_scene(const Scene& scene);
  void add_tool(const kinematics::Tool& tool, const Scene& scene);
  void add_machine(const kinematics::Machine& from, const kinematics::Setup& at, const Scene& scene);

  /// Where the links stand when the tool is at the pose with these rotaries.
  [[nodiscard]] Stand stand(const kinematics::ToolPose& pose, const RotaryPair& rotaries) const;
  /// Exact (FCL): does the pair meet, or come nearer than it may?
  [[nodiscard]] bool touches(const WatchedPair& pair, const Stand& at) const;
  /// Surely so far apart that either may move by_mm nearer: quicker than slack_mm.
  [[nodiscard]] bool is_clear(const WatchedPair& pair, const Stand& at, double by_mm) const;
  /// A lower bound on how far the pair may come nearer, at most cap_mm; not above 0: nothing is known.
  [[nodiscard]] double slack_mm(const WatchedPair& pair, const Stand& at, double cap_mm) const;
  [[nodiscard]] InterferenceHit names(const WatchedPair& pair) const;
  /// The body that holds the whole assembly, when there is one: its surface says nothing of what lies inside.
  [[nodiscard]] const SceneBody* swallowing(const kinematics::ToolPose& pose) const;
  [[nodiscard]] const geometry::Transform& X_M_link(std::size_t link, const Stand& at) const {
    return at.X_M_place[static_cast<std::size_t>(links[link].place)];
  }
};

}  // namespace volute::planner

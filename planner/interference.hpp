// Does the tool touch what it must not? FCL on the planner's side; shared read-only by all threads.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geometry/mesh.hpp"
#include "kinematics/model/machine.hpp"

namespace volute::planner {

/// Everything that the tool could hit, in the part frame.
struct Scene {
  geometry::TriangleMesh part;
  std::vector<geometry::TriangleMesh> obstacles;  ///< post.stl ...; kept clear by `clearance_mm`
  std::vector<geometry::TriangleMesh> fixtures;   ///< likewise
  std::vector<std::string> names;                 ///< of obstacles, then fixtures
  double clearance_mm = 1.0;
  double gouge_tolerance_mm = 0.01;
};

struct InterferenceHit {
  std::string tool_part;   ///< "cutter" "shank" "holder" or a machine link
  std::string scene_part;  ///< "part" or the obstacle's name
};

class Interference {
 public:
  /// Builds the trees once. `machine` and `setup` may be null: then only the tool assembly is checked.
  Interference(const Scene& scene, const kinematics::Tool& tool, const kinematics::Machine* machine,
               const kinematics::Setup* setup);
  ~Interference();
  Interference(Interference&&) noexcept;
  Interference& operator=(Interference&&) noexcept;

  /// Nothing touches: the cutter goes no deeper than the gouge tolerance into the part and stays clear of the rest;
  /// shank and holder keep the clearance to everything. Thread-safe.
  [[nodiscard]] bool is_free(const kinematics::ToolPose& pose) const;
  /// The first hit in a fixed order, or nothing.
  [[nodiscard]] std::optional<InterferenceHit> first_hit(const kinematics::ToolPose& pose) const;
  /// With the machine's links at q too (null machine: as is_free).
  [[nodiscard]] bool is_free(const kinematics::ToolPose& pose, const kinematics::AxisVector& q) const;
  /// As is_free, but without the ball of a ball or taper-ball cutter against the part: where that ball sits depends on
  /// the contact alone, so no orientation can mend it. For flat and bull cutters the same as is_free.
  [[nodiscard]] bool is_free_but_tip(const kinematics::ToolPose& pose) const;
  [[nodiscard]] std::optional<InterferenceHit> first_hit_but_tip(const kinematics::ToolPose& pose) const;
  /// How far every point of the assembly may move before is_free_but_tip could become false: a lower bound, at most
  /// `cap_mm`, 0 when the pose is not known to be free.
  [[nodiscard]] double clearance_mm(const kinematics::ToolPose& pose, double cap_mm) const;
  /// How deep the ball of a ball or taper-ball cutter goes into the part surface, mm; 0 when it does not, and for other
  /// shapes.
  [[nodiscard]] double tip_depth_mm(const kinematics::ToolPose& pose) const;
  /// Are machine links looked at too?
  [[nodiscard]] bool has_machine() const;
  /// Farthest point of the assembly from the tip, mm: bounds how far anything moves when the axis turns.
  [[nodiscard]] double reach_mm() const;

 private:
  struct Trees;
  std::unique_ptr<const Trees> trees_;
};

}  // namespace volute::planner

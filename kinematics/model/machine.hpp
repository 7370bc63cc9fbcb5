// A machine as data: a chain of five axes from the workpiece to the tool, their limits, links, masses.
//
// Chain. Every axis moves what follows it (towards the tool) relative to what comes before it (towards the workpiece),
// and a positive value always means motion of the TOOL relative to the WORKPIECE in the positive direction (ISO 841),
// whether the axis carries the table or the head. So one product gives the pose: X_MT(q) = prod_i exp(axis_i, q_i) *
// X_MT(0), i from workpiece to tool. Frame M is fixed to the workpiece's table and coincides with the machine's frame
// when every axis stands at zero.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "geometry/angle.hpp"
#include "geometry/mesh.hpp"
#include "geometry/result.hpp"
#include "geometry/vector.hpp"
#include "kinematics/model/tool.hpp"
#include "kinematics/model/tool_path.hpp"

namespace volute::kinematics {

using geometry::Transform;
using geometry::Vec3;

constexpr int axis_count = 5;
/// Positions of all axes in the order of Machine::axes: mm for linear, rad for rotary. 0..2 are X Y Z, 3 and 4 the
/// rotaries.
using AxisVector = Eigen::Matrix<double, axis_count, 1>;
/// d(tip mm, rotation vector rad)/dq.
using Jacobian = Eigen::Matrix<double, 6, axis_count>;

enum class AxisKind : std::uint8_t { linear, rotary };

struct Axis {
  char letter = 'X';
  AxisKind kind = AxisKind::linear;
  /// Unit direction of positive motion (linear) or right-hand axis of positive rotation (rotary) of the tool relative
  /// to the workpiece, in M, all axes at zero; the file's `sign` is already applied.
  Vec3 direction_M = Vec3::UnitX();
  Vec3 point_M_mm = Vec3::Zero();  ///< rotary: a point on the line, all axes at zero
  double zero = 0.0;  ///< value shown by the control at which the chain stands at its zero pose (mm or rad)
  /// Travel in mm or rad; nothing: endless (rotary).
  std::optional<double> travel_min, travel_max;
  double velocity_max = 0.0;           ///< mm/s or rad/s
  double acceleration_max = 0.0;       ///< mm/s^2 or rad/s^2
  double jerk_max = 0.0;               ///< mm/s^3 or rad/s^3
  double position_gain_per_s = 0.0;    ///< Kv of the position loop
  double velocity_feed_forward = 0.0;  ///< 0 to 1
  double moved_mass_kg = 0.0;          ///< of this link alone
  Eigen::Matrix3d inertia_kg_m2 =
      Eigen::Matrix3d::Zero();              ///< of this link about its centre of mass, axes of M at zero
  Vec3 centre_of_mass_M_mm = Vec3::Zero();  ///< at zero pose
  double viscous_friction = 0.0;            ///< N s/mm or Nm s/rad
  double coulomb_friction = 0.0;            ///< N or Nm
  std::optional<double> force_max;          ///< N or Nm
  bool assumed = true;                      ///< some number here has no published source
};

/// Solid geometry that moves with one link, for collision and pictures. link: -1 the machine's base, else index into
/// Machine::axes.
struct LinkShape {
  int link = -1;
  std::string name;
  geometry::TriangleMesh mesh_M;  ///< at zero pose
};

struct Machine {
  std::string name;   ///< "ac-head"
  std::string title;  ///< one line for people
  std::string kind;   ///< "head-head" | "table-table" | "head-table"
  std::filesystem::path file;
  std::array<Axis, axis_count> axes;    ///< X Y Z and the rotaries in letter order
  std::array<int, axis_count> chain{};  ///< indices into axes, from workpiece to tool
  int table_axes = 0;                   ///< how many of `chain` stand between workpiece and base
  Transform gauge_at_zero_M =
      Transform::Identity();  ///< spindle gauge line at zero pose: z along the tool axis, tip to spindle
  std::vector<LinkShape> shapes;
  std::vector<std::string> controls;  ///< controls that this machine is built with; empty: any
  double rapid_mm_s = 0.0;            ///< path velocity of rapids when the axes allow it

  [[nodiscard]] int axis_index(char letter) const;  ///< -1 when there is none
};

/// Where the part stands: part origin and axes in M.
struct Setup {
  Transform part_in_machine = Transform::Identity();  ///< X_MP
};

/// Reads one machine file. Errors (bad_input), naming file, line and key: machine-*.
geometry::Result<Machine> load_machine(const std::filesystem::path& file);

/// Pose of the tool tip frame T in M: product of the chain. `tool_length_mm` = Tool::gauge_length_mm.
Transform forward(const Machine& machine, double tool_length_mm, const AxisVector& q);
/// The same as a pose in the part.
ToolPose tool_pose(const Machine& machine, const Setup& setup, double tool_length_mm, const AxisVector& q);
/// Rows 0..2 tip (mm per mm or rad), rows 3..5 rotation vector (rad per rad); both in M.
Jacobian jacobian(const Machine& machine, double tool_length_mm, const AxisVector& q);
/// Where link `axis` (-1: base) stands relative to M of the table: X_M,link(q) * (link at zero)^-1, for shapes given at
/// zero pose.
Transform link_motion(const Machine& machine, int link, const AxisVector& q);

/// The value of the linear axes that the control calls X0 Y0 Z0 with work offset and tool length active: the tip of the
/// tool stands at the part's origin there, all rotaries at zero. Words of a program without TCP are q - this, rotaries
/// unchanged.
AxisVector program_zero(const Machine& machine, const Setup& setup, double tool_length_mm);

}  // namespace volute::kinematics

// Inverse dynamics of a machine's chain, prepared once for the many samples of a run.
#pragma once

#include <array>

#include "kinematics/model/machine.hpp"

namespace volute::sim {

/// What sim::drive_forces tells (loads.hpp says what that is), for one machine and many states: the links' constants in
/// metres, and no work for what stands still (a linear axis before any rotary neither turns nor is turned).
class ChainDynamics {
 public:
  explicit ChainDynamics(const kinematics::Machine& machine);
  /// Force (N) or torque (Nm) of each drive. `velocity` and `acceleration` per s and s^2 of q's units.
  [[nodiscard]] kinematics::AxisVector drive_forces(const kinematics::AxisVector& q,
                                                    const kinematics::AxisVector& velocity,
                                                    const kinematics::AxisVector& acceleration) const;

 private:
  struct Joint {
    int axis = 0;
    bool linear = true;
    double zero = 0.0, scale = 1.0;  ///< from mm or rad of the tool's motion to m or rad of the body's
    double sign = 1.0;               ///< -1 for a table axis, whose body moves against the tool's motion
    geometry::Vec3 direction, point_m, mass_centre_m;
    geometry::Mat3 cross, cross_sq;  ///< of the direction: a x v as a matrix, and its square
    double mass_kg = 0.0;
    geometry::Mat3 inertia_kg_m2;  ///< about the centre of mass
  };
  struct Frame;
  struct Load;
  using Side = std::array<Joint, kinematics::axis_count>;
  static Load cross(const Joint& joint, double position, double velocity, double acceleration, Frame& frame);
  static void add_side(const Side& side, int count, const kinematics::AxisVector& q,
                       const kinematics::AxisVector& velocity, const kinematics::AxisVector& acceleration,
                       kinematics::AxisVector& load);

  Side head_, table_;  ///< from the base outwards
  int head_count_ = 0, table_count_ = 0;
  kinematics::AxisVector viscous_, coulomb_;
};

}  // namespace volute::sim

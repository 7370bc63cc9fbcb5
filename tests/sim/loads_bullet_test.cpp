// Drive loads against Bullet's dynamics: the forces that we compute, put on the joints of Bullet's own multibody
// (articulated-body algorithm), must give back the accelerations that we asked for.
#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <gtest/gtest.h>

#include <memory>

#include "sim/loads.hpp"
#include "tests/cases.hpp"
#include "tests/sim/drive_states.hpp"

namespace volute::sim {
namespace {

using geometry::Vec3;
using kinematics::Axis;
using kinematics::AxisKind;
using kinematics::Machine;

btVector3 metres(const Vec3& mm) { return {mm.x() / 1000, mm.y() / 1000, mm.z() / 1000}; }

double unit_of(const Axis& axis) { return axis.kind == AxisKind::linear ? 1e-3 : 1.0; }

/// One side of the machine from the base outwards; a table axis moves its body against the tool's motion.
std::unique_ptr<btMultiBody> side(const Machine& m, const std::vector<int>& axes, double sign) {
  auto body = std::make_unique<btMultiBody>(static_cast<int>(axes.size()), 0.0, btVector3(0, 0, 0), true, false);
  Vec3 parent_mm = Vec3::Zero();
  for (int k = 0; k < static_cast<int>(axes.size()); ++k) {
    const Axis& axis = m.axes[static_cast<std::size_t>(axes[static_cast<std::size_t>(k)])];
    const Vec3 d = sign * axis.direction_M, centre_mm = axis.centre_of_mass_M_mm;
    const btVector3 direction(d.x(), d.y(), d.z());
    EXPECT_TRUE(axis.inertia_kg_m2.isDiagonal()) << "Bullet's links want principal axes";
    const btVector3 inertia(axis.inertia_kg_m2(0, 0), axis.inertia_kg_m2(1, 1), axis.inertia_kg_m2(2, 2));
    const btQuaternion still = btQuaternion::getIdentity();
    if (axis.kind == AxisKind::linear)
      body->setupPrismatic(k, axis.moved_mass_kg, inertia, k - 1, still, direction, metres(centre_mm - parent_mm),
                           btVector3(0, 0, 0), false);
    else
      body->setupRevolute(k, axis.moved_mass_kg, inertia, k - 1, still, direction, metres(axis.point_M_mm - parent_mm),
                          metres(centre_mm - axis.point_M_mm), false);
    parent_mm = centre_mm;
  }
  body->setLinearDamping(0.0);
  body->setAngularDamping(0.0);
  body->setUseGyroTerm(true);
  body->setMaxCoordinateVelocity(1e12);
  body->finalizeMultiDof();
  return body;
}

/// The accelerations that the loads (less friction) bring about, in q's units.
void compare(const Machine& m, const std::vector<int>& axes, double sign, const AxisVector& q, const AxisVector& v,
             const AxisVector& a, const AxisVector& load) {
  if (axes.empty()) return;
  const auto body = side(m, axes, sign);
  for (int k = 0; k < static_cast<int>(axes.size()); ++k) {
    const int i = axes[static_cast<std::size_t>(k)];
    const Axis& axis = m.axes[static_cast<std::size_t>(i)];
    body->setJointPos(k, unit_of(axis) * (q[i] - axis.zero));
    body->setJointVel(k, unit_of(axis) * v[i]);
    const double lost = axis.viscous_friction * v[i] + (v[i] > 0 ? 1 : -1) * axis.coulomb_friction;
    body->addJointTorque(k, load[i] - lost);
    body->addLinkForce(k, btVector3(0, 0, -9.80665 * axis.moved_mass_kg));
  }
  btAlignedObjectArray<btScalar> r;
  btAlignedObjectArray<btVector3> vectors;
  btAlignedObjectArray<btMatrix3x3> matrices;
  btAlignedObjectArray<btQuaternion> turns;
  btAlignedObjectArray<btVector3> origins;
  body->forwardKinematics(turns, origins);
  // A step of one second adds the acceleration to the velocity.
  body->computeAccelerationsArticulatedBodyAlgorithmMultiDof(1.0, r, vectors, matrices, false, false, false);
  for (int k = 0; k < static_cast<int>(axes.size()); ++k) {
    const int i = axes[static_cast<std::size_t>(k)];
    const Axis& axis = m.axes[static_cast<std::size_t>(i)];
    const double gained = body->getJointVel(k) / unit_of(axis) - v[i];
    EXPECT_NEAR(gained, a[i], 1e-7 * (1.0 + std::abs(a[i]))) << m.name << " " << axis.letter;
  }
}

TEST(DriveForces, GiveBackTheirAccelerationsInBulletOnEveryMachine) {
  test::for_both_sides_of_every_machine(cases(100), 52, compare);
}

}  // namespace
}  // namespace volute::sim

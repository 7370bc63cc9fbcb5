// Drive loads against another program: the recursive Newton-Euler solver of Orocos KDL.
#include <gtest/gtest.h>

#include <kdl/chain.hpp>
#include <kdl/chainidsolver_recursive_newton_euler.hpp>

#include "sim/loads.hpp"
#include "tests/cases.hpp"
#include "tests/sim/drive_states.hpp"

namespace volute::sim {
namespace {

using geometry::Vec3;
using kinematics::AxisKind;
using kinematics::Machine;

KDL::Vector metres(const Vec3& mm) { return {mm.x() / 1000, mm.y() / 1000, mm.z() / 1000}; }

/// One side of the machine, from the base outwards; a table axis moves its body against the tool's motion.
KDL::Chain side(const Machine& m, const std::vector<int>& axes, double sign) {
  KDL::Chain chain;
  for (const int i : axes) {
    const auto& axis = m.axes[static_cast<std::size_t>(i)];
    const Vec3 d = sign * axis.direction_M;
    const KDL::Joint joint(std::string(1, axis.letter), metres(axis.point_M_mm), KDL::Vector(d.x(), d.y(), d.z()),
                           axis.kind == AxisKind::linear ? KDL::Joint::TransAxis : KDL::Joint::RotAxis);
    const auto& I = axis.inertia_kg_m2;
    const KDL::RotationalInertia inertia(I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2));
    chain.addSegment(
        KDL::Segment(std::string(1, axis.letter), joint, KDL::Frame::Identity(),
                     KDL::RigidBodyInertia(axis.moved_mass_kg, metres(axis.centre_of_mass_M_mm), inertia)));
  }
  return chain;
}

void compare(const Machine& m, const std::vector<int>& axes, double sign, const AxisVector& q, const AxisVector& v,
             const AxisVector& a, const AxisVector& load) {
  if (axes.empty()) return;
  const KDL::Chain chain = side(m, axes, sign);
  KDL::ChainIdSolver_RNE solver(chain, KDL::Vector(0, 0, -9.80665));
  const auto n = static_cast<unsigned>(axes.size());
  KDL::JntArray jq(n), jv(n), ja(n), torque(n);
  for (unsigned k = 0; k < n; ++k) {
    const auto& axis = m.axes[static_cast<std::size_t>(axes[k])];
    const double unit = axis.kind == AxisKind::linear ? 1e-3 : 1.0;
    jq(k) = unit * (q[axes[k]] - axis.zero);
    jv(k) = unit * v[axes[k]];
    ja(k) = unit * a[axes[k]];
  }
  ASSERT_EQ(solver.CartToJnt(jq, jv, ja, KDL::Wrenches(n), torque), 0);
  for (unsigned k = 0; k < n; ++k) {
    const auto& axis = m.axes[static_cast<std::size_t>(axes[k])];
    const double speed = v[axes[k]];
    const double lost = axis.viscous_friction * speed + (speed > 0 ? 1 : -1) * axis.coulomb_friction;
    EXPECT_NEAR(load[axes[k]] - lost, torque(k), 1e-9 * (1.0 + std::abs(torque(k)))) << m.name << " " << axis.letter;
  }
}

TEST(DriveForces, EqualsKdlOnEveryMachine) { test::for_both_sides_of_every_machine(cases(200), 51, compare); }

}  // namespace
}  // namespace volute::sim

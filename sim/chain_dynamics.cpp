// Recursive Newton-Euler on the machine's chain, seen from the base: the head's axes outwards one way, the table's the
// other. Lengths in m.
#include "sim/chain_dynamics.hpp"

#include <cmath>

namespace volute::sim {

using geometry::Mat3;
using geometry::Vec3;
using kinematics::Axis;
using kinematics::AxisKind;
using kinematics::AxisVector;

namespace {

constexpr double mm_per_m = 1000.0;
constexpr double gravity_m_s2 = 9.80665;

}  // namespace

/// Motion of the frame that a joint stands on.
struct ChainDynamics::Frame {
  bool turned = false;         // a rotary has been passed: before it, rotation and angular motion are nothing
  Mat3 rotation;               // of the frame's bodies since the zero pose; set once turned
  Vec3 translation{0, 0, 0};   // of the same
  Vec3 point{0, 0, 0};         // where `acceleration` is told
  Vec3 acceleration{0, 0, 0};  // of the frame's material there
  Vec3 angular_velocity{0, 0, 0}, angular_acceleration{0, 0, 0};

  [[nodiscard]] Vec3 direction(const Vec3& v) const { return turned ? Vec3(rotation * v) : v; }
  [[nodiscard]] Vec3 place(const Vec3& p) const { return direction(p) + translation; }
  [[nodiscard]] Vec3 acceleration_at(const Vec3& p) const {
    if (!turned) return acceleration;
    const Vec3 r = p - point;
    return acceleration + angular_acceleration.cross(r) + angular_velocity.cross(angular_velocity.cross(r));
  }
};

/// What a body needs to move as it does, and the joint that carries it.
struct ChainDynamics::Load {
  Vec3 direction, joint_m;  // of the body's own motion for positive q; a point on the joint's line
  Vec3 force, moment;       // the moment about the base's origin
};

ChainDynamics::ChainDynamics(const kinematics::Machine& machine) {
  const auto joint = [&](int place, double sign) {
    const int index = machine.chain[static_cast<std::size_t>(place)];
    const Axis& axis = machine.axes[static_cast<std::size_t>(index)];
    Joint out;
    out.axis = index;
    out.linear = axis.kind == AxisKind::linear;
    out.zero = axis.zero;
    out.sign = sign;
    out.scale = sign / (out.linear ? mm_per_m : 1.0);
    out.direction = axis.direction_M;
    out.point_m = axis.point_M_mm / mm_per_m;
    out.mass_centre_m = axis.centre_of_mass_M_mm / mm_per_m;
    const Vec3& d = axis.direction_M;
    out.cross << 0.0, -d.z(), d.y(), d.z(), 0.0, -d.x(), -d.y(), d.x(), 0.0;
    out.cross_sq = out.cross * out.cross;
    out.mass_kg = axis.moved_mass_kg;
    out.inertia_kg_m2 = axis.inertia_kg_m2;
    return out;
  };
  for (int k = machine.table_axes; k < kinematics::axis_count; ++k)
    head_[static_cast<std::size_t>(head_count_++)] = joint(k, 1.0);
  for (int k = machine.table_axes - 1; k >= 0; --k) table_[static_cast<std::size_t>(table_count_++)] = joint(k, -1.0);
  for (int i = 0; i < kinematics::axis_count; ++i) {
    viscous_[i] = machine.axes[static_cast<std::size_t>(i)].viscous_friction;
    coulomb_[i] = machine.axes[static_cast<std::size_t>(i)].coulomb_friction;
  }
}

/// Passes over one joint: `frame` becomes the motion of the body behind it.
ChainDynamics::Load ChainDynamics::cross(const Joint& joint, double position, double velocity, double acceleration,
                                         Frame& frame) {
  const double shift = joint.scale * (position - joint.zero), rate = joint.scale * velocity,
               rate2 = joint.scale * acceleration;
  const Vec3 along = frame.direction(joint.direction);
  Load load;
  load.direction = joint.sign * along;
  load.joint_m = frame.place(joint.point_m);
  if (joint.linear) {
    // Material of the body that stands at point + r is carried by the frame and slides along `along`.
    const Vec3 r = shift * along;
    frame.acceleration = frame.acceleration_at(frame.point + r) + rate2 * along;
    if (frame.turned) frame.acceleration += 2.0 * rate * frame.angular_velocity.cross(along);
    frame.point += r;
    frame.translation += r;
  } else {
    frame.acceleration = frame.acceleration_at(load.joint_m);
    frame.point = load.joint_m;
    frame.angular_acceleration += rate2 * along + rate * frame.angular_velocity.cross(along);
    frame.angular_velocity += rate * along;
    const Mat3 turn =
        Mat3::Identity() + std::sin(shift) * joint.cross + (1.0 - std::cos(shift)) * joint.cross_sq;  // Rodrigues
    frame.rotation = frame.turned ? Mat3(frame.rotation * turn) : turn;
    frame.turned = true;
    frame.translation = load.joint_m - frame.rotation * joint.point_m;
  }
  const Vec3 centre = frame.place(joint.mass_centre_m);
  load.force = joint.mass_kg * (frame.acceleration_at(centre) + Vec3(0.0, 0.0, gravity_m_s2));
  load.moment = centre.cross(load.force);
  if (frame.turned) {
    const Mat3& R = frame.rotation;
    const Vec3& w = frame.angular_velocity;
    const auto inertia_times = [&](const Vec3& v) -> Vec3 { return R * (joint.inertia_kg_m2 * (R.transpose() * v)); };
    load.moment += inertia_times(frame.angular_acceleration) + w.cross(inertia_times(w));
  }
  return load;
}

/// Outwards over the joints, then inwards: force and moment (about the base's origin) that each joint passes on to its
/// body and all behind it.
void ChainDynamics::add_side(const Side& side, int count, const AxisVector& q, const AxisVector& velocity,
                             const AxisVector& acceleration, AxisVector& load) {
  std::array<Load, kinematics::axis_count> needed;
  Frame frame;
  for (int k = 0; k < count; ++k) {
    const Joint& joint = side[static_cast<std::size_t>(k)];
    needed[static_cast<std::size_t>(k)] =
        cross(joint, q[joint.axis], velocity[joint.axis], acceleration[joint.axis], frame);
  }
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
  for (int k = count - 1; k >= 0; --k) {
    const Load& body = needed[static_cast<std::size_t>(k)];
    const Joint& joint = side[static_cast<std::size_t>(k)];
    force += body.force;
    moment += body.moment;
    load[joint.axis] =
        joint.linear ? body.direction.dot(force) : body.direction.dot(moment - body.joint_m.cross(force));
  }
}

AxisVector ChainDynamics::drive_forces(const AxisVector& q, const AxisVector& velocity,
                                       const AxisVector& acceleration) const {
  AxisVector load = AxisVector::Zero();
  add_side(head_, head_count_, q, velocity, acceleration, load);
  add_side(table_, table_count_, q, velocity, acceleration, load);
  for (int i = 0; i < kinematics::axis_count; ++i) {
    const double dry = velocity[i] > 0.0 ? coulomb_[i] : (velocity[i] < 0.0 ? -coulomb_[i] : 0.0);
    load[i] += viscous_[i] * velocity[i] + dry;
  }
  return load;
}

}  // namespace volute::sim

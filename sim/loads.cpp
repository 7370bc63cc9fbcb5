// Recursive Newton-Euler on the machine's chain, seen from the base: the head's axes outwards one way, the table's the
// other.
#include "sim/loads.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/check.hpp"
#include "geometry/number_text.hpp"

namespace volute::sim {
namespace {

using geometry::Mat3;
using geometry::Vec3;
using kinematics::Axis;
using kinematics::AxisKind;
using kinematics::Machine;

constexpr double mm_per_m = 1000.0;
constexpr double gravity_m_s2 = 9.80665;

/// One moving body in the base frame: lengths in m.
struct Body {
  int axis = 0;
  Vec3 direction = Vec3::UnitX();  // of the body's own motion for positive q
  Vec3 joint_m = Vec3::Zero();     // a point on the joint's line
  Vec3 mass_centre_m = Vec3::Zero();
  Mat3 inertia = Mat3::Zero();  // about the centre of mass
  Vec3 angular_velocity = Vec3::Zero(), angular_acceleration = Vec3::Zero();
  Vec3 mass_centre_acceleration = Vec3::Zero();
};

/// Motion of the frame that a joint stands on, told at the base's origin.
struct FrameMotion {
  geometry::Transform place = geometry::Transform::Identity();  // of the frame's bodies since the zero pose; m
  Vec3 velocity = Vec3::Zero(), acceleration = Vec3::Zero();    // of the frame's material point at `point`
  Vec3 point = Vec3::Zero();
  Vec3 angular_velocity = Vec3::Zero(), angular_acceleration = Vec3::Zero();

  [[nodiscard]] Vec3 velocity_at(const Vec3& p) const { return velocity + angular_velocity.cross(p - point); }
  [[nodiscard]] Vec3 acceleration_at(const Vec3& p) const {
    const Vec3 r = p - point;
    return acceleration + angular_acceleration.cross(r) + angular_velocity.cross(angular_velocity.cross(r));
  }
};

/// The bodies from the base to one end of the chain, outwards.
struct Side {
  std::array<Body, kinematics::axis_count> bodies;
  int count = 0;
};

struct JointState {
  double position, velocity, acceleration;
};  // mm or rad

/// Passes over one joint: `frame` becomes the motion of the body behind it. `sign`: -1 for a table axis, whose body
/// moves against the tool's motion.
Body cross_joint(const Axis& axis, int index, double sign, const JointState& state, FrameMotion& frame) {
  const bool linear = axis.kind == AxisKind::linear;
  const double scale = sign / (linear ? mm_per_m : 1.0);
  const double shift = scale * (state.position - axis.zero), rate = scale * state.velocity,
               rate2 = scale * state.acceleration;
  Body body;
  body.axis = index;
  body.direction = sign * (frame.place.linear() * axis.direction_M);
  body.joint_m = frame.place * (axis.point_M_mm / mm_per_m);
  const Vec3 along = frame.place.linear() * axis.direction_M;
  FrameMotion next = frame;
  if (linear) {
    // Material of the body that stands at frame.point + r is carried by the frame and slides along `along`.
    const Vec3 r = shift * along;
    next.point = frame.point + r;
    next.velocity = frame.velocity_at(next.point) + rate * along;
    next.acceleration =
        frame.acceleration_at(next.point) + rate2 * along + 2.0 * frame.angular_velocity.cross(rate * along);
    next.place.translation() += r;
  } else {
    next.point = body.joint_m;
    next.velocity = frame.velocity_at(body.joint_m);
    next.acceleration = frame.acceleration_at(body.joint_m);
    next.angular_velocity = frame.angular_velocity + rate * along;
    next.angular_acceleration = frame.angular_acceleration + rate2 * along + frame.angular_velocity.cross(rate * along);
    next.place.linear() = frame.place.linear() * Eigen::AngleAxisd(shift, axis.direction_M).toRotationMatrix();
    next.place.translation() = body.joint_m - next.place.linear() * (axis.point_M_mm / mm_per_m);
  }
  body.mass_centre_m = next.place * (axis.centre_of_mass_M_mm / mm_per_m);
  body.inertia = next.place.linear() * axis.inertia_kg_m2 * next.place.linear().transpose();
  body.angular_velocity = next.angular_velocity;
  body.angular_acceleration = next.angular_acceleration;
  body.mass_centre_acceleration = next.acceleration_at(body.mass_centre_m);
  frame = next;
  return body;
}

/// Inwards: force and moment (about the base's origin) that each joint passes on to its body and all behind it.
void add_forces(const Machine& machine, const Side& side, AxisVector& load) {
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
  for (int k = side.count - 1; k >= 0; --k) {
    const Body* body = &side.bodies[static_cast<std::size_t>(k)];
    const Axis& axis = machine.axes[static_cast<std::size_t>(body->axis)];
    const Vec3 weight(0.0, 0.0, -gravity_m_s2 * axis.moved_mass_kg);
    const Vec3 needed = axis.moved_mass_kg * body->mass_centre_acceleration - weight;
    const Vec3& w = body->angular_velocity;
    force += needed;
    moment +=
        body->mass_centre_m.cross(needed) + body->inertia * body->angular_acceleration + w.cross(body->inertia * w);
    load[body->axis] = axis.kind == AxisKind::linear ? body->direction.dot(force)
                                                     : body->direction.dot(moment - body->joint_m.cross(force));
  }
}

Side walk(const Machine& machine, int from, int step, int count, double sign, const AxisVector& q,
          const AxisVector& velocity, const AxisVector& acceleration) {
  Side side;
  FrameMotion frame;
  for (int k = 0, place = from; k < count; ++k, place += step) {
    const int axis = machine.chain[static_cast<std::size_t>(place)];
    side.bodies[static_cast<std::size_t>(side.count++)] =
        (cross_joint(machine.axes[static_cast<std::size_t>(axis)], axis, sign,
                     {q[axis], velocity[axis], acceleration[axis]}, frame));
  }
  return side;
}

double friction(const Axis& axis, double velocity) {
  const double dry = velocity > 0.0 ? axis.coulomb_friction : (velocity < 0.0 ? -axis.coulomb_friction : 0.0);
  return axis.viscous_friction * velocity + dry;
}

bool masses_known(const Machine& machine) {
  for (const Axis& axis : machine.axes) {
    if (axis.moved_mass_kg > 0.0 || !axis.inertia_kg_m2.isZero()) return true;
  }
  return false;
}

}  // namespace

bool rests_on_assumptions(const Machine& machine, int axis) {
  const auto at = std::find(machine.chain.begin(), machine.chain.end(), axis);
  const bool table = at - machine.chain.begin() < machine.table_axes;
  // A table axis carries those before it in the chain, a head axis those behind it.
  const auto first = table ? machine.chain.begin() : at, last = table ? at + 1 : machine.chain.end();
  return std::any_of(first, last, [&](int i) { return machine.axes[static_cast<std::size_t>(i)].assumed; });
}

AxisVector drive_forces(const Machine& machine, const AxisVector& q, const AxisVector& velocity,
                        const AxisVector& acceleration) {
  AxisVector load = AxisVector::Zero();
  const int table = machine.table_axes;
  add_forces(machine, walk(machine, table, 1, kinematics::axis_count - table, 1.0, q, velocity, acceleration), load);
  add_forces(machine, walk(machine, table - 1, -1, table, -1.0, q, velocity, acceleration), load);
  for (int i = 0; i < kinematics::axis_count; ++i)
    load[i] += friction(machine.axes[static_cast<std::size_t>(i)], velocity[i]);
  return load;
}

LoadsMeter::LoadsMeter(const Machine& machine) : machine_(&machine) { report_.known = masses_known(machine); }

void LoadsMeter::add(std::span<const AxisSample> samples) {
  if (!report_.known) return;
  for (const AxisSample& sample : samples) {
    const AxisVector load = drive_forces(*machine_, sample.position, sample.velocity, sample.acceleration);
    for (int i = 0; i < kinematics::axis_count; ++i) take(i, load[i], sample);
    ++count_;
  }
}

void LoadsMeter::take(int axis, double load, const AxisSample& sample) {
  const auto i = static_cast<std::size_t>(axis);
  square_sum_[i] += load * load;
  if (std::abs(load) <= report_.axes[i].peak) return;
  report_.axes[i].peak = std::abs(load);
  peak_line_[i] = sample.line;
  peak_time_s_[i] = sample.time_s;
  peak_q_[i] = sample.position;
}

Finding LoadsMeter::overload(std::size_t i, bool assumed) const {
  const Axis& axis = machine_->axes[i];
  const double peak = report_.axes[i].peak;
  const char* unit = axis.kind == AxisKind::linear ? " N" : " Nm";
  Finding finding{"limit", peak_line_[i], peak_time_s_[i], std::string(1, axis.letter), peak, *axis.force_max, ""};
  finding.text = "line " + std::to_string(peak_line_[i]) + ": the " + axis.letter + " drive needs " +
                 geometry::short_text(peak, 4) + unit + "; it has " + geometry::short_text(*axis.force_max, 4) + unit;
  if (assumed)
    finding.text += ", by numbers that " + machine_->file.filename().string() +
                    " assumes: give the masses and the limit of your machine to have this judged";
  finding.axes = peak_q_[i];
  return finding;
}

LoadsReport LoadsMeter::report() const {
  LoadsReport report = report_;
  for (std::size_t i = 0; i < kinematics::axis_count; ++i) {
    const Axis& axis = machine_->axes[i];
    if (count_ > 0) report.axes[i].rms = std::sqrt(square_sum_[i] / static_cast<double>(count_));
    if (!axis.force_max || report.axes[i].peak <= *axis.force_max) continue;
    const bool assumed = rests_on_assumptions(*machine_, static_cast<int>(i));
    (assumed ? report.warnings : report.findings).push_back(overload(i, assumed));
  }
  return report;
}

}  // namespace volute::sim

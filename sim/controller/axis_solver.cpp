#include "sim/controller/axis_solver.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace volute::sim {

namespace {

constexpr double two_pi = 2.0 * std::numbers::pi;

/// `angle` moved by whole turns to stand nearest to `reference`.
double nearest_turn(double angle, double reference) {
  return angle - two_pi * std::round((angle - reference) / two_pi);
}

/// Newton ends when the axis points within this of the target (rad).
constexpr double direction_accuracy_rad = 1e-12;

}  // namespace

AxisSolver::AxisSolver(const kinematics::Machine& machine, const kinematics::Setup& setup, double tool_length_mm)
    : machine_(machine),
      part_in_machine_(setup.part_in_machine),
      machine_in_part_(setup.part_in_machine.inverse()),
      tip_at_zero_M_mm_(machine.gauge_at_zero_M * Vec3(0.0, 0.0, -tool_length_mm)),
      tool_at_zero_M_(machine.gauge_at_zero_M.linear().col(2)) {
  for (const int axis : machine.chain) {
    if (axis < 3) continue;
    master_ = axis;
    slave_ = 7 - axis;
    break;
  }
  slave_at_pole_rad_ = pole_of_slave();
}

// Every axis moves what follows it, so the motion before it turns its direction and carries its point.
AxisSolver::Walk AxisSolver::walk(const AxisVector& q) const {
  Walk walk;
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  Vec3 shift = Vec3::Zero();
  for (const int axis : machine_.chain) {
    const auto i = static_cast<std::size_t>(axis);
    const kinematics::Axis& a = machine_.axes[i];
    const double way = q[axis] - a.zero;
    walk.direction[i].noalias() = turn * a.direction_M;
    if (a.kind == kinematics::AxisKind::linear) {
      shift += way * walk.direction[i];
      continue;
    }
    walk.point[i] = turn * a.point_M_mm + shift;
    const double c = std::cos(way), s = std::sin(way);
    const Vec3& d = walk.direction[i];
    for (int k = 0; k < 3; ++k) {
      const Vec3 column = turn.col(k);
      turn.col(k) = c * column + s * d.cross(column) + (1.0 - c) * d.dot(column) * d;
    }
    shift = walk.point[i] - turn * a.point_M_mm;
  }
  walk.tip = turn * tip_at_zero_M_mm_ + shift;
  walk.tool.noalias() = turn * tool_at_zero_M_;
  return walk;
}

TipRates AxisSolver::rates_of(const Walk& walk) const {
  TipRates rates;
  for (int axis = 0; axis < kinematics::axis_count; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    if (machine_.axes[i].kind == kinematics::AxisKind::linear)
      rates.col(axis) = walk.direction[i];
    else
      rates.col(axis) = walk.direction[i].cross(walk.tip - walk.point[i]);
  }
  return rates;
}

AxisSolver::State AxisSolver::state(const AxisVector& q) const {
  const Walk at = walk(q);
  return {machine_in_part_ * at.tip, machine_in_part_.linear() * at.tool, rates_of(at)};
}

std::optional<AxisVector> AxisSolver::with_tip(const Vec3& tip_P_mm, const AxisVector& q, TipRates* tip_rates) const {
  Walk at = walk(q);
  Eigen::Matrix3d linear;
  for (std::size_t i = 0; i < 3; ++i) linear.col(static_cast<int>(i)) = at.direction[i];
  if (std::abs(linear.determinant()) < 1e-9) return std::nullopt;
  const Vec3 tip_M_mm = part_in_machine_ * tip_P_mm;
  const Vec3 step = linear.inverse() * (tip_M_mm - at.tip);
  AxisVector solved = q;
  solved.head<3>() += step;
  if (!tip_rates) return solved;
  // A linear axis carries the tip and the lines of the rotaries that follow it.
  at.tip = tip_M_mm;
  Vec3 carried = Vec3::Zero();
  for (const int axis : machine_.chain) {
    const auto i = static_cast<std::size_t>(axis);
    if (machine_.axes[i].kind == kinematics::AxisKind::linear)
      carried += step[axis] * at.direction[i];
    else
      at.point[i] += carried;
  }
  *tip_rates = rates_of(at);
  return solved;
}

// Turning the master does not change the angle between the tool and the master's line, so the slave alone decides it.
// The slave position where that angle is least is the mirror of the two branches.
double AxisSolver::pole_of_slave() const {
  AxisVector q = AxisVector::Zero();
  q[slave_] = machine_.axes[static_cast<std::size_t>(slave_)].zero;
  const Walk at = walk(q);
  const Vec3& master_line = at.direction[static_cast<std::size_t>(master_)];
  const Vec3& slave_line = at.direction[static_cast<std::size_t>(slave_)];
  const Vec3& tool = at.tool;
  // master . (rotation of tool about slave_line by t) = const + a cos t + b sin t: greatest at atan2(b, a), least half
  // a turn on.
  const double a = master_line.dot(tool) - master_line.dot(slave_line) * slave_line.dot(tool);
  const double b = master_line.dot(slave_line.cross(tool));
  const double pole = q[slave_] + std::atan2(b, a);
  const double other = pole + std::numbers::pi;
  return std::abs(std::remainder(pole, two_pi)) <= std::abs(std::remainder(other, two_pi)) ? pole : other;
}

// Levenberg's damping keeps the step bounded where the master's column vanishes; there the least-norm step leaves the
// master alone.
std::optional<std::array<double, 2>> AxisSolver::newton(const Vec3& axis_M, AxisVector q) const {
  for (int iteration = 0; iteration < 60; ++iteration) {
    const Walk at = walk(q);
    const Vec3 tool = at.tool;
    const double error = (tool - axis_M).norm();
    if (error <= direction_accuracy_rad) return std::array<double, 2>{q[3], q[4]};
    Eigen::Matrix<double, 3, 2> columns;
    columns.col(0) = at.direction[3].cross(tool);
    columns.col(1) = at.direction[4].cross(tool);
    Eigen::Matrix2d normal = columns.transpose() * columns;
    normal.diagonal().array() += error > 0.1 ? 1e-3 : 1e-6 * error * error + 1e-24;
    Eigen::Vector2d step = normal.inverse() * (columns.transpose() * (axis_M - tool));
    const double length = step.norm();
    if (length > 0.5) step *= 0.5 / length;
    q[3] += step[0];
    q[4] += step[1];
  }
  return std::nullopt;
}

std::optional<std::array<double, 2>> AxisSolver::rotaries_along(const Vec3& axis_P, const AxisVector& q) const {
  const Vec3 axis_M = (part_in_machine_.linear() * axis_P).normalized();
  AxisVector mirrored = q;
  mirrored[master_] += std::numbers::pi;
  mirrored[slave_] = 2.0 * slave_at_pole_rad_ - q[slave_];
  std::optional<std::array<double, 2>> best;
  const std::size_t m = static_cast<std::size_t>(master_ - 3), s = 1 - m;
  const auto better = [&](const std::array<double, 2>& a, const std::array<double, 2>& b) {
    constexpr double same = 1e-9;
    const double master_a = std::abs(a[m] - q[master_]), master_b = std::abs(b[m] - q[master_]);
    if (std::abs(master_a - master_b) > same) return master_a < master_b;
    const double slave_a = std::abs(a[s] - q[slave_]), slave_b = std::abs(b[s] - q[slave_]);
    if (std::abs(slave_a - slave_b) > same) return slave_a < slave_b;
    return std::abs(a[m]) + same < std::abs(b[m]);
  };
  for (const AxisVector& from : {q, mirrored}) {
    auto found = newton(axis_M, from);
    if (!found) continue;
    for (const std::size_t i : {std::size_t{0}, std::size_t{1}})
      (*found)[i] = nearest_turn((*found)[i], q[static_cast<int>(i) + 3]);
    if (!best || better(*found, *best)) best = found;
  }
  return best;
}

}  // namespace volute::sim

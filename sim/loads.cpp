#include "sim/loads.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/number_text.hpp"

namespace volute::sim {
namespace {

using kinematics::Axis;
using kinematics::AxisKind;
using kinematics::Machine;

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
  return ChainDynamics(machine).drive_forces(q, velocity, acceleration);
}

LoadsMeter::LoadsMeter(const Machine& machine) : machine_(&machine), dynamics_(machine) {
  report_.known = masses_known(machine);
}

void LoadsMeter::add(std::span<const AxisSample> samples) {
  if (!report_.known) return;
  for (const AxisSample& sample : samples) {
    const AxisVector load = dynamics_.drive_forces(sample.position, sample.velocity, sample.acceleration);
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

// What the verifier keeps of a run while it goes by: never all samples.
#pragma once

#include <span>
#include <vector>

#include "sim/collision.hpp"
#include "sim/loads.hpp"
#include "sim/machining/pose_thinner.hpp"
#include "sim/trace_thinner.hpp"

namespace volute::sim {

/// A machine state's place: linear axes as they are, rotaries by what they move at `reach_mm`.
struct StatePlace {
  using Point = AxisVector;
  double reach_mm = 0.0;
  [[nodiscard]] Point point(const MachineState& s) const {
    Point out = s.q;
    out.tail<2>() *= reach_mm;
    return out;
  }
  [[nodiscard]] bool same_stretch(const MachineState& a, const MachineState& b) const {
    return a.rapid == b.rapid && a.cutting == b.cutting;
  }
};

/// Takes the samples of a run and keeps: the cutter's moves, machine states for collisions, loads, and a view for
/// drawing.
class RunWatch {
 public:
  struct Bounds {
    double move_chord_mm = 0.0005;  ///< of the swept cutter between kept poses
    double state_chord_mm = 0.005;  ///< of machine states between kept ones
    std::size_t trace_samples_max = 200'000;
  };
  /// Machine, setup and tool must outlive the watch.
  RunWatch(const kinematics::Machine& machine, const kinematics::Setup& setup, const kinematics::Tool& tool,
           const Bounds& bounds);
  void add(std::span<const AxisSample> samples);

  std::vector<SweptPose> moves() { return moves_.finish(); }
  std::vector<MachineState> states() { return states_.finish(); }
  [[nodiscard]] LoadsReport loads() const { return loads_.report(); }
  [[nodiscard]] std::vector<AxisSample> trace() const { return trace_.finish(); }

 private:
  const kinematics::Machine* machine_;
  const kinematics::Setup* setup_;
  const kinematics::Tool* tool_;
  PoseThinner moves_;
  ChordThinner<MachineState, StatePlace> states_;
  LoadsMeter loads_;
  TraceThinner trace_;
  std::vector<kinematics::ToolPose> poses_;
};

}  // namespace volute::sim

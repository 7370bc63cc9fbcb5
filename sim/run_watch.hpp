// What the verifier keeps of a run while it goes by: never all samples.
#pragma once

#include <tbb/task_group.h>

#include <optional>
#include <span>
#include <vector>

#include "sim/collision.hpp"
#include "sim/limit_peaks.hpp"
#include "sim/loads.hpp"
#include "sim/machining/pose_thinner.hpp"
#include "sim/tool_motion.hpp"
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

/// The time from the first sample of a feed move with the spindle on to the last, rapids between them included.
class MachiningSpan {
 public:
  void add(std::span<const AxisSample> samples);
  /// Nothing: no such sample.
  [[nodiscard]] std::optional<double> time_s() const;

 private:
  std::optional<double> begin_s_, end_s_;
};

/// Takes the samples of a run and keeps: the cutter's moves, machine states for collisions, loads, and a view for
/// drawing. It works beside the run: while one lot of samples is looked at, the run fills the next. Property: what is
/// kept does not depend on the number of threads nor on how the samples come in portions.
class RunWatch {
 public:
  struct Bounds {
    double move_chord_mm = 0.0005;  ///< of the swept cutter between kept poses
    double state_chord_mm = 0.005;  ///< of machine states between kept ones
    std::size_t trace_samples_max = 200'000;
  };
  /// Machine and tool must outlive the watch.
  RunWatch(const kinematics::Machine& machine, const kinematics::Setup& setup, const kinematics::Tool& tool,
           const Bounds& bounds);
  ~RunWatch();
  RunWatch(const RunWatch&) = delete;
  RunWatch& operator=(const RunWatch&) = delete;
  void add(std::span<const AxisSample> samples);
  /// After the last sample and before anything is asked for.
  void finish();

  std::vector<SweptPose> moves() { return moves_.finish(); }
  std::vector<MachineState> states() { return states_.finish(); }
  [[nodiscard]] std::optional<double> machining_time_s() const { return machining_.time_s(); }
  [[nodiscard]] const LimitPeaks& limit_peaks() const { return limit_peaks_; }
  [[nodiscard]] LoadsReport loads() const { return loads_.report(); }
  [[nodiscard]] std::vector<AxisSample> trace() const { return trace_.finish(); }

 private:
  void hand_over();
  void look_at(std::span<const AxisSample> samples);

  ToolMotion motion_;
  PoseThinner moves_;
  ChordThinner<MachineState, StatePlace> states_;
  LimitPeaks limit_peaks_;
  LoadsMeter loads_;
  TraceThinner trace_;
  MachiningSpan machining_;
  std::vector<AxisSample> filling_, seen_;
  std::vector<kinematics::ToolPose> poses_;
  tbb::task_group looking_;
};

}  // namespace volute::sim

// Motion blocks as polygons in axis space: what TCP, arcs and vectors mean for the axes.
#pragma once

#include <deque>
#include <functional>
#include <optional>
#include <vector>

#include "kinematics/model/control.hpp"
#include "sim/controller/axis_solver.hpp"
#include "sim/controller/path_point.hpp"
#include "sim/controller/rapid_line.hpp"
#include "sim/interpreter/program.hpp"

namespace volute::sim {

/// What one motion block becomes.
struct BlockPath {
  bool stop_before = false;  ///< the axes come to rest before this block (G0 against G1, exact stop, dwell)
  std::vector<PathPoint> points;
  double dwell_s = 0.0;
  bool stop_after = false;
  std::optional<RapidLine> rapid;  ///< of a straight rapid
};

/// Follows the program's positions and turns each block into points. A block without TCP is straight in the axes (arcs:
/// in the linear axes); under TCP the tip goes straight while the rotaries turn evenly, or the axis vector follows the
/// great circle, and points are put in between so that the polygon leaves the curve of the axes by no more than
/// `chord_tolerance_mm`.
class BlockGeometry {
 public:
  BlockGeometry(const kinematics::Machine& machine, const kinematics::Control& control, const kinematics::Setup& setup,
                double tool_length_mm, const AxisVector& start);

  /// `info` must outlive the points. Errors (bad_input): pose-unreachable, naming the line.
  geometry::Result<BlockPath> path_of(const MotionBlock& block, BlockInfo& info);

  [[nodiscard]] const AxisVector& position() const { return q_; }
  /// The tip there, in the part.
  [[nodiscard]] const Vec3& tip() const { return state_.tip_P_mm; }

  /// Where a block ends.
  struct Target {
    AxisVector q;            ///< rotaries always; linear axes when !tcp
    Vec3 tip_P_mm;           ///< when tcp
    bool by_vector = false;  ///< the axis vector follows the great circle
    Vec3 axis_P = Vec3::UnitZ();
  };
  /// Errors (bad_input): pose-unreachable.
  [[nodiscard]] geometry::Result<Target> target_of(const MotionBlock& block) const;
  /// Goes there without making a path. Errors as path_of.
  geometry::Result<void> go_to(const MotionBlock& block, const Target& target);
  /// What the linear axes show where the block's coordinates are zero (not for TCP and machine coordinates).
  [[nodiscard]] const AxisVector& zero_of(const MotionBlock& block) const {
    return block.tool_length_active ? zero_with_tool_ : zero_without_tool_;
  }
  [[nodiscard]] const AxisSolver& solver() const { return solver_; }
  /// The axes at a share of the way under TCP, the rotaries next to those of `near_q`. Nothing: no position of the axes
  /// is there.
  [[nodiscard]] std::optional<AxisVector> axes_on(const RapidLine& line, double share, const AxisVector& near_q) const;

 private:
  void turn_by_vector(const MotionBlock& block, Target& target) const;
  void add_straight(const MotionBlock& block, const Target& target, BlockPath& path);
  geometry::Result<void> add_tcp(const MotionBlock& block, const Target& target, BlockPath& path);
  [[nodiscard]] int tcp_pieces(const AxisVector& to_rotaries_q, const Vec3& tip_P_mm) const;
  geometry::Result<void> add_tcp_piece(const MotionBlock& block, const Vec3& tip_P_mm,
                                       const std::array<double, 2>& rotaries, BlockPath& path);
  geometry::Result<void> add_vector(const MotionBlock& block, const Target& target, BlockPath& path);
  geometry::Result<void> add_arc(const MotionBlock& block, const Target& target, BlockPath& path);
  geometry::Result<void> add_tcp_point(const MotionBlock& block, const Vec3& tip_P_mm, const AxisVector& rotaries_q,
                                       BlockPath& path);
  [[nodiscard]] RapidLine rapid_line(const MotionBlock& block, const Target& target, const AxisVector& from_q,
                                     const Vec3& from_tip, double least_time_s) const;
  [[nodiscard]] bool turns_about_the_tip(const MotionBlock& block, const Target& target) const;
  void add_axis_point(const AxisVector& q, BlockPath& path);
  void set_speed(const MotionBlock& block, const AxisVector& from_q, const Vec3& from_tip, BlockInfo& info,
                 BlockPath& path) const;
  void set_tolerances(const MotionBlock& block, BlockPath& path) const;
  [[nodiscard]] double feed_measure(const MotionBlock& block, const AxisVector& from_q, const BlockPath& path,
                                    const BlockInfo& info) const;

  const kinematics::Machine& machine_;
  const kinematics::Control& control_;
  AxisSolver solver_;
  AxisVector zero_with_tool_, zero_without_tool_;
  double chord_tolerance_mm_;
  AxisVector q_;
  AxisSolver::State state_;
  BlockInfo* info_ = nullptr;
  std::optional<bool> was_rapid_, was_feed_average_;
  bool stop_pending_ = false;
};

}  // namespace volute::sim

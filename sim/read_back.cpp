#include "sim/read_back.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/number_text.hpp"

namespace volute::sim {
namespace {

using kinematics::AxisVector;
using kinematics::ToolPose;

/// Takes words to poses; keeps what a block leaves as it was.
class WordTracker {
 public:
  WordTracker(const kinematics::Machine& machine, const kinematics::Setup& setup, double tool_length_mm)
      : machine_(machine),
        setup_(setup),
        tool_length_mm_(tool_length_mm),
        zero_(kinematics::program_zero(machine, setup, tool_length_mm)) {}

  /// The pose at the block's end; nothing while the text has not told every coordinate.
  std::optional<ToolPose> take(const MotionBlock& block) {
    if (block.machine_coordinates) {
      linear_known_ = {};
      rotary_known_ = {};
      if (block.axis_vector || block.rotary_programmed[0] || block.rotary_programmed[1]) vector_.reset();
      return std::nullopt;
    }
    if (block.tcp != tcp_) linear_known_ = {};
    tcp_ = block.tcp;
    for (std::size_t i = 0; i < 3; ++i) {
      if (block.xyz_relative[i]) {
        xyz_[static_cast<Eigen::Index>(i)] += block.xyz_mm[static_cast<Eigen::Index>(i)];
      } else if (block.xyz_known[i] || block.xyz_programmed[i]) {
        xyz_[static_cast<Eigen::Index>(i)] = block.xyz_mm[static_cast<Eigen::Index>(i)];
        linear_known_[i] = true;
      }
    }
    take_orientation(block);
    const bool oriented = vector_ || (rotary_known_[0] && rotary_known_[1]);
    if (!oriented || !(linear_known_[0] && linear_known_[1] && linear_known_[2])) return std::nullopt;
    return pose();
  }

 private:
  // A vector says nothing of the rotaries, and holds until another one or rotary words come.
  void take_orientation(const MotionBlock& block) {
    if (block.axis_vector) {
      vector_ = block.axis_vector;
      rotary_known_ = {};
      return;
    }
    for (std::size_t i = 0; i < 2; ++i) {
      if (block.rotary_programmed[i]) vector_.reset();
      if (block.rotary_relative[i]) {
        rotary_[i] += block.rotary_rad[i];
      } else if (block.rotary_known[i] || block.rotary_programmed[i]) {
        rotary_[i] = block.rotary_rad[i];
        rotary_known_[i] = true;
      }
    }
  }

  [[nodiscard]] std::optional<ToolPose> pose() const {
    AxisVector q = zero_;
    q.tail<2>() = Eigen::Vector2d(rotary_[0], rotary_[1]);
    if (!tcp_) {
      if (vector_) return std::nullopt;  // where the rotaries stand is the control's choice
      q.head<3>() += xyz_;
      return kinematics::tool_pose(machine_, setup_, tool_length_mm_, q);
    }
    const geometry::Mat3 R_PM = setup_.part_in_machine.linear().transpose();
    const Vec3 axis_P =
        vector_ ? Vec3(R_PM * *vector_) : kinematics::tool_pose(machine_, setup_, tool_length_mm_, q).axis_P;
    return ToolPose{R_PM * xyz_, axis_P};
  }

  const kinematics::Machine& machine_;
  const kinematics::Setup& setup_;
  double tool_length_mm_;
  AxisVector zero_;
  bool tcp_ = false;
  Vec3 xyz_ = Vec3::Zero();
  std::array<double, 2> rotary_{};
  std::array<bool, 3> linear_known_{};
  std::array<bool, 2> rotary_known_{};
  std::optional<Vec3> vector_;  ///< the tool axis in the work frame, where the program gives it so
};

struct Deviation {
  double tip_mm, axis_rad;
};

Deviation deviation(const ToolPose& a, const ToolPose& b) {
  return {(a.tip_P_mm - b.tip_P_mm).norm(), 2.0 * std::asin(std::min(1.0, 0.5 * (a.axis_P - b.axis_P).norm()))};
}

Finding missing_pose(std::size_t index, std::int64_t line, const Deviation& best, const ReadBackTolerance& tolerance) {
  Finding finding{"disagreement", line, 0.0, "program-path", best.tip_mm, tolerance.tip_mm, ""};
  finding.text = "line " + std::to_string(line) + ": path point " + std::to_string(index + 1) +
                 " is not met by the program; the nearest block is off by " + geometry::short_text(best.tip_mm, 4) +
                 " mm and " + geometry::short_text(geometry::Angle::radians(best.axis_rad).degrees(), 4) +
                 " deg, allowed are " + geometry::short_text(tolerance.tip_mm, 4) + " mm and " +
                 geometry::short_text(geometry::Angle::radians(tolerance.axis_rad).degrees(), 4) + " deg";
  return finding;
}

}  // namespace

geometry::Result<std::vector<CommandedPose>> commanded_poses(ProgramReader& program, const kinematics::Machine& machine,
                                                             const kinematics::Setup& setup, double tool_length_mm) {
  std::vector<CommandedPose> out;
  WordTracker tracker(machine, setup, tool_length_mm);
  for (;;) {
    auto block = program.next();
    if (!block) return tl::unexpected(block.error());
    if (!*block) return out;
    const MotionBlock& motion = **block;
    if (motion.kind == MotionKind::dwell || motion.kind == MotionKind::stop) continue;
    const auto pose = tracker.take(motion);
    if (pose && motion.kind != MotionKind::rapid) out.push_back({*pose, motion.line});
  }
}

std::vector<Finding> compare_poses(const std::vector<ToolPose>& expected, const std::vector<CommandedPose>& commanded,
                                   const ReadBackTolerance& tolerance) {
  constexpr std::size_t window = 2000, findings_max = 20;
  std::vector<Finding> findings;
  std::size_t next = 0, missing = 0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    Deviation best{std::numeric_limits<double>::infinity(), 0.0};
    std::size_t nearest = next;
    bool met = false;
    for (std::size_t j = next; j < std::min(next + window, commanded.size()) && !met; ++j) {
      const Deviation off = deviation(expected[i], commanded[j].pose);
      met = off.tip_mm <= tolerance.tip_mm && off.axis_rad <= tolerance.axis_rad;
      if (!met && off.tip_mm >= best.tip_mm) continue;
      best = off;
      nearest = j;
    }
    if (met) {
      next = nearest;  // two points of the path may be one block
      continue;
    }
    ++missing;
    if (findings.size() < findings_max) {
      const std::int64_t line = nearest < commanded.size() ? commanded[nearest].line : 0;
      findings.push_back(missing_pose(i, line, best, tolerance));
    }
  }
  if (missing > findings.size())
    findings.back().text += "; and " + std::to_string(missing - findings.size()) + " more points";
  return findings;
}

}  // namespace volute::sim

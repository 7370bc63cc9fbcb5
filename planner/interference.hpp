// Does the tool touch what it must not? FCL on the planner's side; shared read-only by all threads.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "geometry/mesh.hpp"
#include "kinematics/model/machine.hpp"
#include "planner/sphere_tree.hpp"

namespace volute::planner {

/// Everything that the tool could hit, in the part frame.
struct Scene {
  geometry::TriangleMesh part;
  std::vector<geometry::TriangleMesh> obstacles;  ///< post.stl ...; kept clear by `clearance_mm`
  std::vector<geometry::TriangleMesh> fixtures;   ///< likewise
  std::vector<std::string> names;                 ///< of obstacles, then fixtures
  double clearance_mm = 1.0;
  double gouge_tolerance_mm = 0.01;
  /// Between CC points no point of tool and machine moves further than this from a place that was looked at.
  double motion_tolerance_mm = 0.1;
};

struct InterferenceHit {
  std::string tool_part;   ///< "cutter" "shank" "holder" or a machine link
  std::string scene_part;  ///< "part", the obstacle's name, or a machine link
};

/// Positions of axes[3] and axes[4], rad.
using RotaryPair = std::array<double, 2>;

/// The way from one pose to the next as the axis path makes it: the tip straight, the tool axis on the great circle
/// (the control's own interpolation stays within AxisPathOptions' tolerances of that). `rotaries`: at both ends; then
/// the machine's links are looked at too, in between at the rotaries that point the tool along the great circle.
struct ToolMotion {
  kinematics::ToolPose from, to;
  std::optional<std::array<RotaryPair, 2>> rotaries;
};

/// What may still meet when the assembly turns (without the ball against the part). What is settled for a turn is
/// settled for every part of it, so whoever halves turns hands this on and asks less and less.
struct OpenPairs {
  std::vector<std::size_t> pairs;
  bool surely_blocked = false;
};

/// What is known of a pose and of all turns about it within a bound.
struct TurnVerdict {
  bool free = false;  ///< throughout
  OpenPairs open;     ///< surely_blocked: throughout
};

/// Pairs: every piece of cutter, shank and holder with part, obstacles and fixtures; with a machine also every link
/// with those, every piece with every link but the one that carries the tool, and links with links, unless they are
/// neighbours in the chain or touch where the machine stands at zero (joints).
///
/// Properties, each with a test of that name: 1. CutterMayTouchButNotGouge. 2. HolderKeepsTheClearance.
/// 3. ClearanceBoundsMotion. 4. MotionAgreesWithDenseSampling: what is told free is free at every one of many samples.
/// 5. LinksKeepTheClearance. 6. StaysFreeHoldsForEveryTurn. 7. StaysBlockedHoldsForEveryTurn.
/// 8. VerdictsAreThoseOfTheSingleQuestions.
class Interference {
 public:
  /// Builds the trees once. `machine` and `setup` may be null: then only the tool assembly is checked.
  Interference(const Scene& scene, const kinematics::Tool& tool, const kinematics::Machine* machine,
               const kinematics::Setup* setup);
  ~Interference();
  Interference(Interference&&) noexcept;
  Interference& operator=(Interference&&) noexcept;

  /// Nothing of the assembly touches: the cutter goes no deeper than the gouge tolerance into the part and stays clear
  /// of the rest; shank and holder keep the clearance to everything. Thread-safe, like all that follows.
  [[nodiscard]] bool is_free(const kinematics::ToolPose& pose) const;
  /// The first hit in a fixed order, or nothing.
  [[nodiscard]] std::optional<InterferenceHit> first_hit(const kinematics::ToolPose& pose) const;
  /// As is_free, but without the ball of a ball or taper-ball cutter against the part: where that ball sits depends on
  /// the contact alone, so no orientation can mend it. For flat and bull cutters the same as is_free.
  [[nodiscard]] bool is_free_but_tip(const kinematics::ToolPose& pose) const;
  [[nodiscard]] std::optional<InterferenceHit> first_hit_but_tip(const kinematics::ToolPose& pose) const;

  /// The machine's links alone, where the linear axes bring the tip to the pose with these rotaries: they keep the
  /// clearance to part, obstacles and fixtures, and the motion tolerance to each other. True without a machine.
  [[nodiscard]] bool links_are_free(const kinematics::ToolPose& pose, const RotaryPair& rotaries) const;
  [[nodiscard]] std::optional<InterferenceHit> first_link_hit(const kinematics::ToolPose& pose,
                                                              const RotaryPair& rotaries) const;

  /// The motion without the ball against the part: what the clearance of a pair in the middle of a stretch proves is
  /// free, the rest is halved until no point of it moves further than the motion tolerance from the middle, and looked
  /// at there. Requires: the ends are free (they are looked at no more closely than what lies between).
  [[nodiscard]] bool motion_is_free(const ToolMotion& motion) const;
  struct MotionHit {
    InterferenceHit hit;
    double at_share = 0.0;  ///< of the way, 0 to 1
  };
  /// The first pair in a fixed order that touches on the way.
  [[nodiscard]] std::optional<MotionHit> first_hit_on(const ToolMotion& motion) const;
  [[nodiscard]] double motion_tolerance_mm() const;

  /// How far every point of the assembly may move before is_free_but_tip could become false: a lower bound, at most
  /// `cap_mm`, 0 when the pose is not known to be free.
  [[nodiscard]] double clearance_mm(const kinematics::ToolPose& pose, double cap_mm) const;
  /// How deep the assembly surely stands in something it must not touch (without the ball against the part): every pose
  /// whose points all lie nearer than this to where they are here touches too. A lower bound, 0 when nothing is known.
  [[nodiscard]] double depth_mm(const kinematics::ToolPose& pose) const;
  /// Is the assembly surely free (but for the ball against the part) wherever within `turn` it turns? `turn.pivot_mm`
  /// in P, its ball that of the true cutter at the part. A flat or bull cutter that turns about its contact can be told
  /// free, which clearance_mm never does. False where it is not known.
  [[nodiscard]] bool stays_free(const kinematics::ToolPose& pose, const TurnBound& turn) const;
  /// Does the assembly surely touch what it must not (without the ball against the part), wherever within `turn` it
  /// turns? False where it is not known.
  [[nodiscard]] bool stays_blocked(const kinematics::ToolPose& pose, const TurnBound& turn) const;
  /// All pairs of the assembly but the ball against the part.
  [[nodiscard]] OpenPairs open_pairs() const;
  /// stays_free and stays_blocked in one, asking only for what is open. Requires: `open` is open_pairs(), or that of
  /// the verdict on a turn that holds this one.
  [[nodiscard]] TurnVerdict verdict(const kinematics::ToolPose& pose, const TurnBound& turn,
                                    const OpenPairs& open) const;
  /// first_hit_but_tip among what is open. Requires: `open` is that of a verdict on a turn that holds the pose.
  [[nodiscard]] std::optional<InterferenceHit> first_open_hit(const kinematics::ToolPose& pose,
                                                              const OpenPairs& open) const;
  /// How deep the ball of a ball or taper-ball cutter goes into the part surface, mm; 0 when it does not, and for other
  /// shapes.
  [[nodiscard]] double tip_depth_mm(const kinematics::ToolPose& pose) const;
  /// Are machine links looked at too?
  [[nodiscard]] bool has_machine() const;
  /// Farthest point of the assembly, as grown for the clearance, from the tip, mm: bounds how far anything moves when
  /// the axis turns.
  [[nodiscard]] double reach_mm() const;

 private:
  struct Trees;
  [[nodiscard]] bool is_hit(const kinematics::ToolPose& pose, bool with_tip) const;
  [[nodiscard]] std::optional<InterferenceHit> assembly_hit(const kinematics::ToolPose& pose, bool with_tip) const;
  [[nodiscard]] bool pair_stays_clear(std::size_t pair, const kinematics::ToolPose& pose, const TurnBound& turn) const;
  [[nodiscard]] bool pair_stays_met(std::size_t pair, const kinematics::ToolPose& pose, const TurnBound& turn) const;
  friend class MotionCheck;
  std::unique_ptr<const Trees> trees_;
};

}  // namespace volute::planner

// How the tool comes to the part and leaves it, in the air and clear of everything.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "geometry/result.hpp"
#include "planner/interference.hpp"
#include "planner/options.hpp"

namespace volute::planner {

/// Adds to an oriented piece what goes before its first and after its last cut, the axis held as it is there:
/// a rapid at clearance height, a rapid down to the safe distance, at feed down to above the lead, and a tangent arc or
/// a straight ramp onto the surface (where that is not free: a smaller one, to the other side, the other shape,
/// straight along the normal or the tool axis). To leave, the lead at feed, then the rapid up. Properties:
/// 1. An arc is a quarter circle that is tangent to path and surface at the CC point.
/// 2. A ramp stands at ramp_angle to the surface.
/// 3. No pose of a lead, sampled every 0.5 mm, touches anything; the tip's ball counts where it fits the contact.
/// 4. Rapids between pieces keep the whole assembly above the clearance height while the axis turns.
/// 5. The rapid down ends before any of the assembly is nearer than the safe distance to anything; without a step of
///    such a rapid being free, at clearance height.
/// 6. Between two pieces the tool lifts only to the safe distance where the way across is proved free there (`link`):
///    smaller leads, up along the tool axis (else along z) until everything is beyond the safe distance, one rapid with
///    the turn of the axis, down. Each pose of it but the leads and the last way down keeps the safe distance.
class Leads {
 public:
  /// `beyond_safe_distance`: of rapid_scene. `clearance_z_mm`: nothing of part, obstacles and fixtures stands higher.
  /// `machine`, `setup`: whose rotaries turn between pieces; may be null: then only the great circle is looked at.
  /// Arguments outlive it. Requires: 0 < ramp_angle < 90 degrees; safe_distance > 0.
  Leads(const kinematics::Tool& tool, const Interference& interference, const Interference& beyond_safe_distance,
        const ProcessOptions& process, double clearance_z_mm, const kinematics::Machine* machine = nullptr,
        const kinematics::Setup* setup = nullptr);

  /// All pieces with leads as one path: linked where `link` finds a way, else over clearance height. Requires: two
  /// points a piece. Errors: those of with_leads.
  [[nodiscard]] geometry::Result<kinematics::ToolPath> join(const std::vector<kinematics::ToolPath>& pieces) const;

  /// From the last point of one piece to the first of the next, both left out: lead, up, across, down, lead. Nothing
  /// when no such way is proved free, or none is shorter than that over clearance height.
  /// The way across is looked at as controls make it: tip straight, axis on the great circle, and also the rotaries in
  /// step from each solution of the machine to each, then with the machine's links. Whatever rotary has to be rewound
  /// there can be: from both places the tool can go out along its axis and straight up.
  [[nodiscard]] std::optional<kinematics::ToolPath> link(const kinematics::ToolPath& before,
                                                         const kinematics::ToolPath& after) const;

  /// `last_number`: of the last piece in it, when several are linked. Requires: two points at least. Errors
  /// (bad_input): lead-blocked (no lead is free: where, and the remedy).
  [[nodiscard]] geometry::Result<kinematics::ToolPath> with_leads(const kinematics::ToolPath& piece, int piece_number,
                                                                  std::optional<int> last_number = {}) const;
  /// Rapids at clearance height from the end of one piece to the start of the next, so high that no axis on the way
  /// dips below it.
  void append(kinematics::ToolPath& whole, const kinematics::ToolPath& piece) const;

 private:
  /// From the surface outwards, relative to the tip: the lead and the way from it to clearance height.
  struct Lead {
    std::vector<Vec3> offsets_mm, way_up_mm;
  };
  [[nodiscard]] std::vector<Lead> lead_shapes(const kinematics::ToolPathPoint& point, const Vec3& away,
                                              double radius_mm) const;
  [[nodiscard]] std::optional<kinematics::ToolPose> end_of_free_lead(const kinematics::ToolPathPoint& point,
                                                                     const Lead& lead, bool tip_counts) const;
  [[nodiscard]] std::optional<Lead> free_lead(const kinematics::ToolPathPoint& point, const Vec3& away) const;
  [[nodiscard]] bool is_free_way(const kinematics::ToolPose& from, const Vec3& to_P_mm, bool tip_counts) const;
  [[nodiscard]] double rapid_share(const kinematics::ToolPose& from, const Vec3& to_P_mm) const;
  [[nodiscard]] std::optional<Lead> link_lead(const kinematics::ToolPathPoint& point, const Vec3& away,
                                              const Vec3& rise) const;
  [[nodiscard]] bool can_be_rewound(const kinematics::ToolPose& pose) const;
  [[nodiscard]] bool is_free_across(const kinematics::ToolPose& from, const kinematics::ToolPose& to) const;
  [[nodiscard]] bool is_free_step(const ToolMotion& motion) const;
  [[nodiscard]] bool is_free_in_step(const kinematics::ToolPose& from, const kinematics::ToolPose& to,
                                     const std::array<RotaryPair, 2>& rotaries) const;
  [[nodiscard]] std::optional<std::vector<std::array<RotaryPair, 2>>> turns_between(const Vec3& from_P,
                                                                                    const Vec3& to_P) const;
  void come_in(const kinematics::ToolPathPoint& first, const Lead& lead, kinematics::ToolPath& path) const;
  void go_out(const kinematics::ToolPathPoint& last, const Lead& lead, kinematics::ToolPath& path) const;
  [[nodiscard]] double approach_feed_mm_s() const;
  [[nodiscard]] std::vector<Vec3> way_up(const kinematics::ToolPose& from, bool tip_counts) const;
  [[nodiscard]] double safe_tip_z_mm(const Vec3& axis_P) const;

  const kinematics::Tool* tool_;
  const Interference* interference_;
  const Interference* beyond_safe_distance_;
  const ProcessOptions* process_;
  double clearance_z_mm_, radius_mm_, link_radius_mm_;
  const kinematics::Machine* machine_;
  const kinematics::Setup* setup_;
};

/// Unit direction from the first point away from the second, in the tangent plane of the first.
Vec3 tangent_away(const kinematics::ToolPathPoint& at, const kinematics::ToolPathPoint& next);

/// Highest point of everything in the scene, mm; 0 when it is empty.
double highest_point_mm(const Scene& scene);

/// What a rapid keeps `safe_distance_mm` from with all of the tool: part, obstacles, fixtures and stock as obstacles.
Scene rapid_scene(const Scene& scene, const std::optional<geometry::TriangleMesh>& stock_P, double safe_distance_mm);

}  // namespace volute::planner

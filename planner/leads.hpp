// How the tool comes to the part and leaves it, in the air and clear of everything.
#pragma once

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
class Leads {
 public:
  /// `beyond_safe_distance`: of rapid_scene. `clearance_z_mm`: nothing of part, obstacles and fixtures stands higher.
  /// Arguments outlive it. Requires: 0 < ramp_angle < 90 degrees; safe_distance > 0.
  Leads(const kinematics::Tool& tool, const Interference& interference, const Interference& beyond_safe_distance,
        const ProcessOptions& process, double clearance_z_mm);

  /// Requires: two points at least. Errors (bad_input): lead-blocked (no lead is free: where, and the remedy).
  [[nodiscard]] geometry::Result<kinematics::ToolPath> with_leads(const kinematics::ToolPath& piece,
                                                                  int piece_number) const;
  /// Rapids at clearance height from the end of one piece to the start of the next, so high that no axis on the way
  /// dips below it.
  void append(kinematics::ToolPath& whole, const kinematics::ToolPath& piece) const;

 private:
  /// From the surface outwards, relative to the tip: the lead and the way from it to clearance height.
  struct Lead {
    std::vector<Vec3> offsets_mm, way_up_mm;
  };
  [[nodiscard]] std::vector<Lead> lead_shapes(const kinematics::ToolPathPoint& point, const Vec3& away) const;
  [[nodiscard]] std::optional<Lead> free_lead(const kinematics::ToolPathPoint& point, const Vec3& away) const;
  [[nodiscard]] bool is_free_way(const kinematics::ToolPose& from, const Vec3& to_P_mm, bool tip_counts) const;
  [[nodiscard]] double rapid_share(const kinematics::ToolPose& from, const Vec3& to_P_mm) const;
  void come_in(const kinematics::ToolPathPoint& first, const Lead& lead, kinematics::ToolPath& path) const;
  void go_out(const kinematics::ToolPathPoint& last, const Lead& lead, kinematics::ToolPath& path) const;
  [[nodiscard]] double approach_feed_mm_s() const;
  [[nodiscard]] std::vector<Vec3> way_up(const kinematics::ToolPose& from, bool tip_counts) const;
  [[nodiscard]] double safe_tip_z_mm(const Vec3& axis_P) const;

  const kinematics::Tool* tool_;
  const Interference* interference_;
  const Interference* beyond_safe_distance_;
  const ProcessOptions* process_;
  double clearance_z_mm_, radius_mm_;
};

/// Highest point of everything in the scene, mm; 0 when it is empty.
double highest_point_mm(const Scene& scene);

/// What a rapid keeps `safe_distance_mm` from with all of the tool: part, obstacles, fixtures and stock as obstacles.
Scene rapid_scene(const Scene& scene, const std::optional<geometry::TriangleMesh>& stock_P, double safe_distance_mm);

}  // namespace volute::planner

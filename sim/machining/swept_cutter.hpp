// The cutter swept along a run, and how low a line of sight on the surface meets it.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "sim/machining/box_tree.hpp"
#include "sim/machining/cut_surface.hpp"
#include "sim/machining/cutter_profile.hpp"

namespace volute::sim {

/// Where a line enters the swept cutter.
struct SweptEntry {
  double height_mm = 0.0;  ///< along the line's direction; negative: the cutter reaches below the line's start
  std::int32_t pose = 0;   ///< index of the swept pose at the END of the move that does it
};

/// A ball's centre runs straight from `from_mm` to `to_mm`: the least height at which the line point + t * direction
/// enters the capsule that the ball sweeps, when the capsule holds some point with 0 <= t <= limit_mm. Exact.
std::optional<double> capsule_entry_mm(const Vec3& from_mm, const Vec3& to_mm, double radius_mm, const Vec3& point_mm,
                                       const Vec3& direction, double limit_mm);

/// Balls are swept exactly, move by move. Everything else (flanks, flat and bull noses) stands at places so close
/// together that the cusps between them stay below the tolerance, and the lowest entry is then sought between its
/// neighbours.
class SweptCutter {
 public:
  SweptCutter(const kinematics::Cutter& cutter, const std::vector<SweptPose>& poses, double tolerance_mm);

  /// What could touch the ball (centre, radius); to be used for lines that stay inside it.
  struct Near {
    /// A place as lines in one direction see it.
    struct Stand {
      Vec3 axis;
      double along_mm = 0.0;   ///< of the tip, on the axis
      double rise = 0.0;       ///< of the axis in the lines' direction
      double lowest_mm = 0.0;  ///< of the cutter, in the lines' direction
      std::int32_t place = 0;
    };
    std::vector<std::int32_t> moves, places;
    std::vector<Stand> stands;  ///< of the places, the lowest first
    void clear() {
      moves.clear();
      places.clear();
      stands.clear();
    }
  };
  /// What lines along `normal` from points within `size_mm` of the middle can meet up to `height_mm`. Flanks that such
  /// a line can only meet after the ball are left out.
  void near(const Vec3& middle_mm, double size_mm, const Vec3& normal, double height_mm, Near& out) const;

  /// The lowest entry with height <= limit_mm. Where one is as low as `enough_mm` the search ends: what is returned is
  /// then no higher than that, and need not be the lowest. Requires: near things for this normal.
  [[nodiscard]] std::optional<SweptEntry> entry(const Vec3& point_mm, const Vec3& normal, double limit_mm,
                                                const Near& near,
                                                double enough_mm = -std::numeric_limits<double>::infinity()) const;

  [[nodiscard]] bool ball_nose() const { return ball_nose_; }
  [[nodiscard]] const CutterProfile& profile() const { return profile_; }
  [[nodiscard]] std::size_t place_count() const { return places_.size(); }
  [[nodiscard]] const StandingCutter& place(std::int32_t i) const {
    return places_[static_cast<std::size_t>(i)].cutter;
  }

 private:
  struct Place {
    StandingCutter cutter;
    std::int32_t pose = 0;
  };
  void make_places(const std::vector<SweptPose>& poses, double tolerance_mm);
  void make_trees();
  void entry_of_places(const Vec3& point_mm, const Vec3& normal, double limit_mm, double enough_mm, const Near& near,
                       std::optional<SweptEntry>& best) const;
  void find_near(const Vec3& centre_mm, double radius_mm, Near& out) const;
  void refine(std::int32_t place, double height_mm, const Vec3& point_mm, const Vec3& normal,
              std::optional<SweptEntry>& best) const;
  /// Is any point of the stretch up to the limit within the cutter's greatest radius of its axis?
  [[nodiscard]] bool within_reach(const StandingCutter& cutter, const Vec3& point_mm, const Vec3& normal,
                                  double limit_mm) const;

  CutterProfile profile_;
  bool ball_nose_ = false;
  double ball_radius_mm_ = 0.0;
  double slack_mm_ = 0.0;      // how much lower the cutter can stand between two places
  std::vector<Vec3> centres_;  // of the ball, one a pose
  std::vector<Place> places_;
  BoxTree move_tree_, place_tree_;
};

}  // namespace volute::sim

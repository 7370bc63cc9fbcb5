// The stretch of a line that lies inside a standing tool: closed forms for balls, cylinders and cones.
#pragma once

#include <optional>

#include "sim/machining/cutter_profile.hpp"

namespace volute::sim {

/// Heights from `low_mm` to `high_mm` along a line.
struct Span {
  double low_mm = 0.0, high_mm = 0.0;
};

/// A cutter or a cone of a holder, standing: how lines of one direction pass through it.
/// The solid is convex, so that stretch is one span. Exact for balls, flats, tapers and cones; bull noses within 1e-9
/// mm by Newton.
class LineSpans {
 public:
  /// `direction`: unit, of all lines asked for.
  LineSpans(const kinematics::Cutter& cutter, const CutterProfile& profile, const StandingCutter& stand,
            const Vec3& direction);
  LineSpans(const kinematics::ConeSegment& segment, const StandingCutter& stand, const Vec3& direction);

  /// The span of the line point + t * direction; nothing where it passes by.
  [[nodiscard]] std::optional<Span> of(const Vec3& point_mm) const;

 private:
  /// The part of a cone |away from axis| <= radius + slope * z between two heights.
  struct Cone {
    double z_low = 0.0, z_high = 0.0, radius_at_tip = 0.0, slope = 0.0;
  };
  [[nodiscard]] std::optional<Span> of_ball(const Vec3& w) const;
  [[nodiscard]] std::optional<Span> of_cone(const Vec3& w) const;
  [[nodiscard]] std::optional<Span> of_bull(const Vec3& point_mm) const;

  StandingCutter stand_;
  Vec3 direction_;
  double along_ = 0.0;  // direction . axis
  double ball_radius_mm_ = 0.0;
  Cone cone_;
  const CutterProfile* bull_ = nullptr;
};

}  // namespace volute::sim

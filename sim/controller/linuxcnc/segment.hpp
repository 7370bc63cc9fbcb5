// One segment in the queue of LinuxCNC's planner: its curve, its speeds and the state of its motion.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include "geometry/vector.hpp"
#include "sim/controller/path_point.hpp"

namespace volute::sim::linuxcnc {

constexpr double deg_per_rad = 180.0 / std::numbers::pi;
/// What is smaller is nothing to this control.
constexpr double fuzz = 1e-8;
/// Of the acceleration, across an arc: half is kept along it.
inline const double normal_share = std::sqrt(1.0 - 0.25);

/// X Y Z in mm and the two rotaries in degrees, as this control counts them: thresholds and feeds of rotary motion are
/// in degrees.
struct Position {
  Vec3 xyz = Vec3::Zero();
  geometry::Vec2 rotary_deg = geometry::Vec2::Zero();
};

/// How a segment ends: standing still, standing still unless tangent, overlapping with the next, at speed.
enum class EndMode : std::uint8_t { stop, exact, parabolic, tangent };
enum class Shape : std::uint8_t { line, arc, blend };

/// From start to end; of no length below 1e-8 in every coordinate.
template <class Vector>
struct Straight {
  Vector start = Vector::Zero(), end = Vector::Zero(), direction = Vector::UnitX();
  double length = 0.0;
  bool none = true;

  Straight() = default;
  Straight(const Vector& from, const Vector& to);
  [[nodiscard]] Vector at(double travelled) const { return none ? end : Vector(start + travelled * direction); }
};

/// A circular arc, a helix or a spiral (radius changes evenly with the angle); its length as a function of the angle is
/// a fitted quadratic.
struct Arc {
  Vec3 centre = Vec3::Zero(), normal = Vec3::UnitZ();
  Vec3 to_start = Vec3::Zero(), ahead = Vec3::Zero();  ///< centre to start; normal x that
  Vec3 rise = Vec3::Zero();                            ///< along the normal, over the whole arc
  double radius = 0.0, angle = 0.0, spiral = 0.0;      ///< spiral: end radius - start radius
  double fit_quadratic = 0.0, fit_linear = 0.0, flat_length = 0.0;
  bool inward = false;

  /// `turns`: whole turns beyond the first, counted -1, -2, ... clockwise.
  static Arc through(const Vec3& start, const Vec3& end, const Vec3& centre, const Vec3& normal, int turns);
  void fit_length();
  [[nodiscard]] double length() const;
  [[nodiscard]] Vec3 at_angle(double at) const;
  [[nodiscard]] Vec3 at(double travelled) const;
  [[nodiscard]] Vec3 tangent(double at_angle) const;
  /// Keeps `kept` of the angle, at the end (true) or at the start. False: a helix, or nothing left.
  bool shorten(double kept, bool keep_end);
  [[nodiscard]] double least_radius_of_curvature() const;
};

/// The arc put into a corner, with what is left of the line before it where that was too short to live on its own.
struct BlendArc {
  Vec3 centre = Vec3::Zero(), start = Vec3::Zero(), to_start = Vec3::Zero(), to_end = Vec3::Zero(),
       lead_direction = Vec3::UnitX();
  Vec3 binormal = Vec3::UnitZ();
  double radius = 0.0, angle = 0.0, spiral = 0.0, lead_length = 0.0;

  [[nodiscard]] double length() const { return radius * angle + lead_length; }
  [[nodiscard]] Vec3 at(double travelled) const;
  [[nodiscard]] Vec3 tangent(bool at_end) const;
};

struct Segment {
  Shape shape = Shape::line;
  Straight<Vec3> line;
  Arc arc;
  BlendArc blend;
  Straight<geometry::Vec2> rotary;  ///< lines and arcs; a blend stands still at rotary.end
  double length = 0.0, nominal_length = 0.0;

  double speed_requested = 0.0, speed_max = 0.0, acceleration = 0.0;
  double tolerance = 0.0;  ///< 0: none given
  EndMode end = EndMode::stop;
  bool parabolic_before = false;
  double kink_speed = -1.0;                        ///< at its end, where it is near tangent; negative: none
  double kink_loss = 0.0, kink_loss_before = 0.0;  ///< shares of the acceleration kept for the kinks at both ends
  double along_arc_share = 0.5;
  double speed_final = 0.0;
  bool rapid = false, waits_for_spindle = false;
  bool length_final = false, at_peak = false, active = false, ramped = false;

  double progress = 0.0, speed = 0.0, cycle_s = 0.0, speed_at_split = 0.0, blend_speed = 0.0;
  bool splitting = false, done = false, overlapping = false, braking_to_end = false;
  BlockInfo* block = nullptr;

  [[nodiscard]] bool turns_rotaries() const { return shape == Shape::blend || !rotary.none; }
  [[nodiscard]] bool only_rotary() const { return shape == Shape::line && line.none; }
  [[nodiscard]] Position position() const;
  [[nodiscard]] Position end_position() const;
  [[nodiscard]] Vec3 start_tangent() const;
  [[nodiscard]] Vec3 end_tangent() const;
  /// Directions in which the tool accelerates at the ends: for an arc's start turned towards its centre.
  [[nodiscard]] Vec3 start_pull() const;
  [[nodiscard]] Vec3 end_pull() const;
  /// What is left of the acceleration for the path as a whole, and along it.
  [[nodiscard]] double acceleration_left() const;
  [[nodiscard]] double acceleration_along() const;
  [[nodiscard]] double speed_target() const;
  [[nodiscard]] double to_go() const { return length - progress; }

  /// A segment lasts a cycle at least.
  void cap_speed_by_length();
  /// The length can no longer change: an arc's speed and acceleration share are settled.
  void fix_length();
};

/// How the end of `before` meets `after`.
void set_end(Segment& before, Segment* after, EndMode mode);

constexpr double position_epsilon = 1e-12, speed_epsilon = 1e-8, time_epsilon = 1e-12, angle_epsilon = 1e-6;

}  // namespace volute::sim::linuxcnc

#include "sim/machining/line_span.hpp"

#include <algorithm>
#include <cmath>

namespace volute::sim {

using kinematics::CutterShape;

LineSpans::LineSpans(const kinematics::Cutter& cutter, const CutterProfile& profile, const StandingCutter& stand,
                     const Vec3& direction)
    : stand_(stand), direction_(direction), along_(direction.dot(stand.axis)) {
  const Vec2 start = profile.flank_start();
  const double rise = profile.length_mm() - start.y();
  const double slope = rise > 0.0 ? (profile.greatest_radius_mm() - start.x()) / rise : 0.0;
  cone_ = {start.y(), profile.length_mm(), start.x() - slope * start.y(), slope};
  if (cutter.shape == CutterShape::ball || cutter.shape == CutterShape::taper_ball) ball_radius_mm_ = cutter.radius_mm;
  if (cutter.shape == CutterShape::bull && cutter.corner_radius_mm > 0.0) bull_ = &profile;
}

LineSpans::LineSpans(const kinematics::ConeSegment& segment, const StandingCutter& stand, const Vec3& direction)
    : stand_(stand), direction_(direction), along_(direction.dot(stand.axis)) {
  const double slope =
      segment.length_mm > 0.0 ? (segment.top_radius_mm - segment.bottom_radius_mm) / segment.length_mm : 0.0;
  cone_ = {segment.z_mm, segment.z_mm + segment.length_mm, segment.bottom_radius_mm - slope * segment.z_mm, slope};
}

std::optional<Span> LineSpans::of_ball(const Vec3& w) const {
  const Vec3 from_centre = w - ball_radius_mm_ * stand_.axis;
  const double middle = -from_centre.dot(direction_);
  const double square = ball_radius_mm_ * ball_radius_mm_ - (from_centre + middle * direction_).squaredNorm();
  if (square < 0.0) return std::nullopt;
  const double half = std::sqrt(square);
  Span span{middle - half, middle + half};
  // Flutes shorter than the ball end it early.
  const double over = w.dot(stand_.axis) - cone_.z_high;
  if (along_ > 0.0) span.high_mm = std::min(span.high_mm, -over / along_);
  if (along_ < 0.0) span.low_mm = std::max(span.low_mm, -over / along_);
  if (along_ == 0.0 && over > 0.0) return std::nullopt;
  return span.low_mm < span.high_mm ? std::optional<Span>(span) : std::nullopt;
}

std::optional<Span> LineSpans::of_cone(const Vec3& w) const {
  constexpr double level = 1e-12, big = 1e9;
  const double z = w.dot(stand_.axis);
  // Between the two planes ...
  double low = -big, high = big;
  if (std::abs(along_) > level) {
    const double t1 = (cone_.z_low - z) / along_, t2 = (cone_.z_high - z) / along_;
    low = std::min(t1, t2);
    high = std::max(t1, t2);
  } else if (z < cone_.z_low || z > cone_.z_high) {
    return std::nullopt;
  }
  // ... where a t^2 + 2 b t + c <= 0: |away|^2 - radius(z)^2 along the line.
  const double radius = cone_.radius_at_tip + cone_.slope * z, growth = cone_.slope * along_;
  const double a = 1.0 - along_ * along_ - growth * growth;
  const double b = w.dot(direction_) - z * along_ - radius * growth;
  const double c = w.squaredNorm() - z * z - radius * radius;
  if (std::abs(a) < level) {
    if (std::abs(b) < level) return c <= 0.0 ? std::optional<Span>(Span{low, high}) : std::nullopt;
    const double root = -0.5 * c / b;
    (b > 0.0 ? high : low) = b > 0.0 ? std::min(high, root) : std::max(low, root);
  } else {
    const double square = b * b - a * c;
    if (square < 0.0) {
      if (a > 0.0) return std::nullopt;
    } else {
      const double half = std::sqrt(square), t1 = (-b - half) / a, t2 = (-b + half) / a;
      if (a > 0.0) {
        low = std::max(low, t1);
        high = std::min(high, t2);
      } else {
        // Outside the roots: the solid is convex, so the stretch between the planes keeps one side only.
        const double first = std::min(t1, t2), second = std::max(t1, t2);
        if (low < first)
          high = std::min(high, first);
        else
          low = std::max(low, second);
      }
    }
  }
  return low < high ? std::optional<Span>(Span{low, high}) : std::nullopt;
}

std::optional<Span> LineSpans::of_bull(const Vec3& point_mm) const {
  // Wide enough to begin outside on both sides.
  const Vec3 middle = stand_.tip_mm + 0.5 * bull_->length_mm() * stand_.axis;
  const double reach = bull_->length_mm() + bull_->greatest_radius_mm();
  const double nearest = (middle - point_mm).dot(direction_);
  const Vec3 start = point_mm + (nearest - reach) * direction_, end = point_mm + (nearest + reach) * direction_;
  const auto low = line_entry_mm(*bull_, stand_, start, direction_, 2.0 * reach);
  if (!low) return std::nullopt;
  const auto high = line_entry_mm(*bull_, stand_, end, -direction_, 2.0 * reach);
  if (!high) return std::nullopt;
  return Span{nearest - reach + *low, nearest + reach - *high};
}

std::optional<Span> LineSpans::of(const Vec3& point_mm) const {
  if (bull_ != nullptr) return of_bull(point_mm);
  const Vec3 w = point_mm - stand_.tip_mm;
  const auto cone = of_cone(w);
  if (ball_radius_mm_ == 0.0) return cone;
  const auto ball = of_ball(w);
  if (!ball) return cone;
  if (!cone) return ball;
  return Span{std::min(ball->low_mm, cone->low_mm), std::max(ball->high_mm, cone->high_mm)};
}

}  // namespace volute::sim

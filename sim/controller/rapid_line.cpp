#include "sim/controller/rapid_line.hpp"

#include <cmath>

#include "sim/controller/block_geometry.hpp"

namespace volute::sim {

namespace {
/// Between directions nearer than this no great circle is told from rounding.
constexpr double same_direction_rad = 1e-8;
}  // namespace

Vec3 on_circle(const Vec3& from, const Vec3& to, double share) {
  const double angle = std::atan2(from.cross(to).norm(), from.dot(to));
  return (std::sin((1.0 - share) * angle) * from + std::sin(share * angle) * to) / std::sin(angle);
}

RapidLine BlockGeometry::rapid_line(const MotionBlock& block, const Target& target, const AxisVector& from_q,
                                    const Vec3& from_tip, double least_time_s) const {
  RapidLine line{block.tcp && !block.machine_coordinates, from_tip, state_.tip_P_mm, from_q, q_, least_time_s};
  if (!target.by_vector) return line;
  const Vec3 from_axis = solver_.state(from_q).axis_P;
  if (from_axis.cross(target.axis_P).norm() > same_direction_rad) line.circle_P = {from_axis, target.axis_P};
  return line;
}

std::optional<AxisVector> BlockGeometry::axes_on(const RapidLine& line, double share, const AxisVector& near_q) const {
  AxisVector q = line.from_q;
  if (line.circle_P) {
    const auto rotaries = solver_.rotaries_along(on_circle((*line.circle_P)[0], (*line.circle_P)[1], share), near_q);
    if (!rotaries) return std::nullopt;
    q.tail<2>() << (*rotaries)[0], (*rotaries)[1];
  } else {
    q.tail<2>() += share * (line.to_q - line.from_q).tail<2>();
  }
  return solver_.with_tip(line.from_tip_P_mm + share * (line.to_tip_P_mm - line.from_tip_P_mm), q);
}

}  // namespace volute::sim

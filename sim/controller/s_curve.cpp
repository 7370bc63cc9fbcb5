#include "sim/controller/s_curve.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "geometry/check.hpp"

namespace volute::sim {

// Four phases of jerk last u each, two of even acceleration e, one of even speed v: jerk u (u + e) is the greatest
// speed, and that times (v + 2 u + e) the way.
SCurve::SCurve(double jerk_share, double even_share) {
  VOLUTE_CHECK(jerk_share > 0.0 && jerk_share <= 1.0 && even_share >= 0.0 && even_share <= 1.0, jerk_share, even_share);
  const double u = 0.25 * jerk_share, e = 0.5 * even_share * (1.0 - jerk_share);
  const double v = (1.0 - even_share) * (1.0 - jerk_share);
  const double jerk = 1.0 / (u * (u + e) * (v + 2.0 * u + e));
  const std::array<double, phases> last{u, e, u, v, u, e, u};
  const std::array<double, 4> jerks{jerk, 0.0, -jerk, 0.0};
  for (std::size_t k = 0; k < last.size(); ++k) begin_[k + 1] = begin_[k] + last[k];
  begin_[phases] = 1.0;
  start_[0].jerk = jerk;
  for (std::size_t k = 1; k < start_.size(); ++k) {
    start_[k] = at(static_cast<int>(k) - 1, begin_[k]);
    start_[k].jerk = jerks[k];
  }
  start_[3].acceleration = 0.0;  // what is left of it is rounding
}

// The second half is the first one seen from the end: so the end itself is exact.
Progress SCurve::at(int phase, double time) const {
  if (phase > phases / 2) {
    const Progress mirror = at(phases - 1 - phase, 1.0 - time);
    return {1.0 - mirror.way, mirror.speed, -mirror.acceleration, mirror.jerk};
  }
  const Progress& start = start_[static_cast<std::size_t>(phase)];
  const double t = time - begin_[static_cast<std::size_t>(phase)];
  return {start.way + t * (start.speed + t * (start.acceleration / 2.0 + t * start.jerk / 6.0)),
          start.speed + t * (start.acceleration + t * start.jerk / 2.0), start.acceleration + t * start.jerk,
          start.jerk};
}

Progress SCurve::at(double time) const {
  const auto next = std::upper_bound(begin_.begin() + 1, begin_.end() - 1, time);
  return at(static_cast<int>(next - begin_.begin()) - 1, time);
}

SCurveShape quickest_shape(double speed, double acceleration, double jerk) {
  VOLUTE_CHECK(speed > 0.0 && acceleration > 0.0 && jerk > 0.0 && std::isfinite(jerk), speed, acceleration, jerk);
  double u = std::min({acceleration / jerk, std::sqrt(speed / jerk), std::cbrt(0.5 / jerk)});
  double e = 0.0, v = 0.0;
  const double peak = jerk * u;
  if (u >= acceleration / jerk * (1.0 - 1e-12)) {  // (u + e) (2 u + e) = 1 / peak without a phase of even speed
    e = std::max(0.0, 0.5 * (std::sqrt(u * u + 4.0 / peak) - 3.0 * u));
    e = std::min(e, std::max(0.0, speed / peak - u));
  }
  const double top = peak * (u + e);
  v = std::max(0.0, 1.0 / top - 2.0 * u - e);
  const double time = 4.0 * u + 2.0 * e + v;
  return {std::min(1.0, 4.0 * u / time), e + v > 0.0 ? std::min(1.0, 2.0 * e / (2.0 * e + v)) : 0.0};
}

}  // namespace volute::sim

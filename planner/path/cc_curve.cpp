#include "planner/path/cc_curve.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "geometry/check.hpp"
#include "planner/path/path_spline.hpp"

namespace volute::planner {

namespace {

constexpr double fairness = 1e-4;
constexpr int refinements_max = 8;
constexpr int fine_per_step = 16;

/// Columns of the spline's data: point, normal, turn.
constexpr Eigen::Index normal_column = 3, turn_column = 6, columns = 7;

/// Without points that stand on their predecessor; the last one stays.
std::vector<RawPoint> without_repeats(std::span<const RawPoint> raw, double least_mm) {
  std::vector<RawPoint> kept{raw.front()};
  for (const RawPoint& p : raw.subspan(1))
    if ((p.point_mm - kept.back().point_mm).norm() > least_mm) kept.push_back(p);
  const bool last_dropped = (kept.back().point_mm - raw.back().point_mm).norm() > 0.0;
  if (last_dropped && kept.size() > 1) kept.back() = raw.back();
  if (last_dropped && kept.size() == 1) kept.push_back(raw.back());
  return kept;
}

/// Points on the chord where two neighbours that stand on the mesh itself are farther apart than a mesh fit for the
/// path would have them: a spline through both alone would bulge off the triangle between.
std::vector<RawPoint> with_long_chords_filled(const std::vector<RawPoint>& raw, double step_mm) {
  constexpr double longest_steps = 1.5, filled_steps = 0.5;
  std::vector<RawPoint> filled{raw.front()};
  for (const RawPoint& p : std::span(raw).subspan(1)) {
    const RawPoint from = filled.back();
    const double chord_mm = (p.point_mm - from.point_mm).norm();
    const bool on_mesh = from.edge_tangent.isZero() && p.edge_tangent.isZero();
    const int parts =
        on_mesh && chord_mm > longest_steps * step_mm ? static_cast<int>(chord_mm / (filled_steps * step_mm)) : 1;
    for (int k = 1; k < parts; ++k) {
      const double share = static_cast<double>(k) / parts;
      filled.push_back({from.point_mm + share * (p.point_mm - from.point_mm),
                        ((1.0 - share) * from.normal + share * p.normal).normalized(),
                        from.turn + share * (p.turn - from.turn), Vec3::Zero()});
    }
    filled.push_back(p);
  }
  return filled;
}

/// Quasi arc length: the chords added up.
std::vector<double> chord_parameters(const std::vector<RawPoint>& raw) {
  std::vector<double> s{0.0};
  for (std::size_t i = 1; i < raw.size(); ++i) s.push_back(s.back() + (raw[i].point_mm - raw[i - 1].point_mm).norm());
  return s;
}

/// Each point stands for half of the chords beside it.
std::vector<double> chord_weights(const std::vector<double>& s) {
  std::vector<double> w(s.size());
  for (std::size_t i = 0; i < s.size(); ++i) w[i] = 0.5 * (s[std::min(i + 1, s.size() - 1)] - s[i > 0 ? i - 1 : 0]);
  return w;
}

double median_step(const std::vector<double>& s) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < s.size(); ++i) steps.push_back(s[i] - s[i - 1]);
  std::nth_element(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2), steps.end());
  return steps[steps.size() / 2];
}

std::vector<double> even_knots(double last, double spacing) {
  const int spans = std::max(1, static_cast<int>(std::ceil(last / spacing)));
  std::vector<double> knots;
  for (int i = 0; i <= spans; ++i) knots.push_back(last * i / spans);
  return knots;
}

Eigen::MatrixXd data_of(const std::vector<RawPoint>& raw) {
  Eigen::MatrixXd data(static_cast<Eigen::Index>(raw.size()), columns);
  for (std::size_t i = 0; i < raw.size(); ++i)
    data.row(static_cast<Eigen::Index>(i)) << raw[i].point_mm.transpose(), raw[i].normal.transpose(), raw[i].turn;
  return data;
}

/// Knots with the spans halved in which a raw point lies too far off; empty when none does.
std::vector<double> refined(const std::vector<double>& knots, const PathSpline& spline,
                            const std::vector<RawPoint>& raw, const std::vector<double>& s, double tolerance_mm,
                            double least_mm) {
  std::vector<char> halve(knots.size(), 0);
  bool any = false;
  for (std::size_t i = 0; i < raw.size(); ++i) {
    const Vec3 off = spline.value(s[i]).head<3>().transpose() - raw[i].point_mm;
    if (off.norm() <= tolerance_mm && std::abs(off.dot(raw[i].normal)) <= 0.25 * tolerance_mm) continue;
    const auto above = std::upper_bound(knots.begin() + 1, knots.end() - 1, s[i]);
    const auto span = static_cast<std::size_t>(above - knots.begin()) - 1;
    // The span before and behind too: a spline's span reaches over its neighbours.
    for (std::size_t k = span > 0 ? span - 1 : 0; k <= std::min(span + 1, knots.size() - 2); ++k) {
      if (halve[k] || knots[k + 1] - knots[k] < 2.0 * least_mm) continue;
      halve[k] = 1;
      any = true;
    }
  }
  std::vector<double> finer;
  for (std::size_t k = 0; any && k < knots.size(); ++k) {
    finer.push_back(knots[k]);
    if (halve[k]) finer.push_back(0.5 * (knots[k] + knots[k + 1]));
  }
  return finer;
}

/// Eq. 19: across the edge's curve and the path, on the side of the normal given. Where both are nearly parallel the
/// normal stays.
void normals_across(std::vector<RawPoint>& raw, const std::vector<double>& s, const PathSpline& spline) {
  constexpr double least_sine = 0.34;  // 20 degrees
  for (std::size_t i = 0; i < raw.size(); ++i) {
    if (raw[i].edge_tangent.isZero()) continue;
    const Vec3 feed = spline.derivative(s[i]).head<3>().transpose().normalized();
    const Vec3 across = raw[i].edge_tangent.normalized().cross(feed);
    if (across.norm() < least_sine) continue;
    raw[i].normal = across.normalized() * (across.dot(raw[i].normal) < 0.0 ? -1.0 : 1.0);
  }
}

PathSpline fit(std::vector<RawPoint>& raw, const CurveOptions& options) {
  const std::vector<double> s = chord_parameters(raw), w = chord_weights(s);
  const double step = median_step(s);
  std::vector<double> knots = even_knots(s.back(), std::max(2.0 * step, 0.25 * options.step_max_mm));
  PathSpline spline(s, data_of(raw), w, knots, fairness);
  for (int round = 0; round < refinements_max; ++round) {
    auto finer = refined(knots, spline, raw, s, options.tolerance_mm, 0.2 * step);
    if (finer.empty()) break;
    knots = std::move(finer);
    spline = PathSpline(s, data_of(raw), w, knots, fairness);
  }
  const bool by_edges = std::any_of(raw.begin(), raw.end(), [](const RawPoint& p) { return !p.edge_tangent.isZero(); });
  if (!by_edges) return spline;
  normals_across(raw, s, spline);
  return PathSpline(s, data_of(raw), w, knots, fairness);
}

/// A place on the curve: contact, ball centre and tool axis.
struct FinePoint {
  CcPoint contact;
  Vec3 centre_mm, axis;
};

FinePoint fine_point(const PathSpline& spline, double s, const CurveOptions& options) {
  const PathSpline::Row value = spline.value(s);
  FinePoint p;
  p.contact.point_P_mm = value.head<3>().transpose();
  p.contact.normal_P = value.segment<3>(normal_column).transpose().normalized();
  p.contact.turn = value[turn_column];
  p.centre_mm = p.contact.point_P_mm + options.radius_mm * p.contact.normal_P;
  const Vec3 n = p.contact.normal_P, along = spline.derivative(s).head<3>().transpose();
  const Vec3 feed = (along - along.dot(n) * n).normalized(), side = n.cross(feed);
  p.axis = geometry::cos(options.tilt) * n +
           geometry::sin(options.tilt) * (geometry::cos(options.yaw) * feed + geometry::sin(options.yaw) * side);
  return p;
}

/// How far the tool strays between fine points i and j when its tip runs straight and its axis turns evenly.
double strays_mm(const std::vector<FinePoint>& fine, std::size_t i, std::size_t j, double radius_mm) {
  const Vec3 chord = fine[j].centre_mm - fine[i].centre_mm;
  const double length_sq = chord.squaredNorm();
  double worst_sq = 0.0;
  for (std::size_t k = i + 1; k < j; ++k) {
    const Vec3 off = fine[k].centre_mm - fine[i].centre_mm;
    const double share = length_sq > 0.0 ? std::clamp(off.dot(chord) / length_sq, 0.0, 1.0) : 0.0;
    worst_sq = std::max(worst_sq, (off - share * chord).squaredNorm());
  }
  const double turn_rad = std::atan2(fine[i].axis.cross(fine[j].axis).norm(), fine[i].axis.dot(fine[j].axis));
  return std::sqrt(worst_sq) + radius_mm * turn_rad * turn_rad / 8.0;
}

/// Step-forward: the farthest fine point that keeps the tolerance; the remainder is shared so that no short step is
/// left.
std::vector<CcPoint> step_forward(const std::vector<FinePoint>& fine, const CurveOptions& options) {
  std::vector<CcPoint> points{fine.front().contact};
  for (std::size_t i = 0; i + 1 < fine.size();) {
    std::size_t j = i + 1;
    while (j + 1 < fine.size() && j - i < fine_per_step &&
           strays_mm(fine, i, j + 1, options.radius_mm) <= 0.5 * options.tolerance_mm)
      ++j;
    const std::size_t left = fine.size() - 1 - j;
    if (left > 0 && left < (j - i) / 2) j = i + (j - i + left + 1) / 2;
    points.push_back(fine[j].contact);
    i = j;
  }
  return points;
}

/// Too few points for a spline.
std::vector<CcPoint> plain_points(const std::vector<RawPoint>& raw) {
  std::vector<CcPoint> points;
  for (const RawPoint& p : raw) points.push_back({p.point_mm, p.normal, p.turn, false});
  return points;
}

}  // namespace

CurveOptions curve_options(const kinematics::Cutter& cutter, const PathOptions& path,
                           const OrientationOptions& orientation, const IntervalRule& rule) {
  return {path.tolerance_mm, rule.interval_mm(0.0), std::max(cutter.corner_radius_mm, 0.0), orientation.tilt,
          orientation.yaw};
}

std::vector<CcPoint> smooth_curve(std::span<const RawPoint> raw, const CurveOptions& options) {
  VOLUTE_CHECK(raw.size() >= 2, raw.size());
  std::vector<RawPoint> kept =
      with_long_chords_filled(without_repeats(raw, 0.02 * options.step_max_mm), options.step_max_mm);
  if (kept.size() < 5) return plain_points(kept);
  const PathSpline spline = fit(kept, options);
  const double length = spline.last();
  const auto spans = static_cast<std::size_t>(std::ceil(length / options.step_max_mm * fine_per_step));
  std::vector<FinePoint> fine(spans + 1);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, fine.size(), 512), [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i)
      fine[i] = fine_point(spline, length * static_cast<double>(i) / static_cast<double>(spans), options);
  });
  fine.front().contact.point_P_mm = raw.front().point_mm;
  fine.back().contact.point_P_mm = raw.back().point_mm;
  return step_forward(fine, options);
}

std::vector<RawPoint> raw_points(std::span<const CcPoint> points) {
  std::vector<RawPoint> raw;
  for (const CcPoint& p : points) raw.push_back({p.point_P_mm, p.normal_P, p.turn, Vec3::Zero()});
  return raw;
}

}  // namespace volute::planner

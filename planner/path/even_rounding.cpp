#include "planner/path/even_rounding.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/check.hpp"

namespace volute::planner {
namespace {

/// A piece by its length.
class ByLength {
 public:
  explicit ByLength(const CcPiece& piece) : points_(piece.points) {
    length_mm_.push_back(0.0);
    for (std::size_t i = 1; i < points_.size(); ++i)
      length_mm_.push_back(length_mm_.back() + (points_[i].point_P_mm - points_[i - 1].point_P_mm).norm());
  }
  [[nodiscard]] double total_mm() const { return length_mm_.back(); }
  [[nodiscard]] double at_mm(std::size_t i) const { return length_mm_[i]; }

  [[nodiscard]] CcPoint point(double s_mm) const {
    const auto above = std::upper_bound(length_mm_.begin() + 1, length_mm_.end() - 1, s_mm);
    const auto i = static_cast<std::size_t>(above - length_mm_.begin());
    const CcPoint &a = points_[i - 1], &b = points_[i];
    const double share = share_at(i, s_mm);
    CcPoint out = a;
    out.point_P_mm += share * (b.point_P_mm - a.point_P_mm);
    out.normal_P = ((1.0 - share) * a.normal_P + share * b.normal_P).normalized();
    out.turn += share * (b.turn - a.turn);
    return out;
  }

  /// Positions and turns at even steps from the start.
  struct Place {
    Vec3 point_P_mm;
    double turn;
  };
  [[nodiscard]] std::vector<Place> evenly(double step_mm) const {
    const auto count = static_cast<std::size_t>(total_mm() / step_mm) + 1;
    std::vector<Place> out;
    out.reserve(count);
    for (std::size_t k = 0, i = 1; k < count; ++k) {
      const double s_mm = static_cast<double>(k) * step_mm;
      while (i + 1 < length_mm_.size() && length_mm_[i] <= s_mm) ++i;
      const CcPoint &a = points_[i - 1], &b = points_[i];
      const double share = share_at(i, s_mm);
      out.push_back({a.point_P_mm + share * (b.point_P_mm - a.point_P_mm), a.turn + share * (b.turn - a.turn)});
    }
    return out;
  }

  /// Mean over the path within `half_mm` of s.
  [[nodiscard]] CcPoint mean(double s_mm, double half_mm) const {
    constexpr int samples = 8;
    CcPoint out = point(s_mm);
    if (half_mm <= 0.0) return out;
    out.point_P_mm.setZero();
    for (int k = 0; k < samples; ++k)
      out.point_P_mm += point(s_mm + half_mm * ((k + 0.5) * 2.0 / samples - 1.0)).point_P_mm / samples;
    return out;
  }

 private:
  /// Of the way from point i - 1 to point i.
  [[nodiscard]] double share_at(std::size_t i, double s_mm) const {
    const double span = length_mm_[i] - length_mm_[i - 1];
    return span > 0.0 ? std::clamp((s_mm - length_mm_[i - 1]) / span, 0.0, 1.0) : 0.0;
  }

  const std::vector<CcPoint>& points_;
  std::vector<double> length_mm_;
};

constexpr std::size_t steps_per_interval = 16;

/// Places of the sharpest angle in each run of sharp ones, mm along the path.
std::vector<double> corners_mm(const ByLength& path, double interval_mm, double angle_rad) {
  constexpr std::size_t chord = steps_per_interval / 2;
  const double step_mm = interval_mm / static_cast<double>(steps_per_interval), chord_mm = 0.5 * interval_mm;
  const auto places = path.evenly(step_mm);
  std::vector<double> out;
  double sharpest = 0.0;
  for (std::size_t i = 2 * chord; i + 2 * chord < places.size(); ++i) {
    const Vec3& here = places[i].point_P_mm;
    const Vec3 before = here - places[i - chord].point_P_mm, after = places[i + chord].point_P_mm - here;
    const double angle = std::atan2(before.cross(after).norm(), before.dot(after));
    if (angle <= angle_rad || places[i].turn <= 0.0) continue;
    const double s = static_cast<double>(i) * step_mm;
    if (out.empty() || s - out.back() > 2.0 * chord_mm) {
      out.push_back(s);
      sharpest = angle;
    } else if (angle > sharpest) {
      out.back() = s;
      sharpest = angle;
    }
  }
  return out;
}

}  // namespace

std::vector<char> round_corners(CcPiece& piece, double interval_mm, const RoundingOptions& options) {
  VOLUTE_CHECK(interval_mm > 0.0, interval_mm);
  std::vector<char> moved(piece.points.size(), 0);
  if (piece.points.size() < 3) return moved;
  const double step_mm = interval_mm / 12.0;
  for (int round = 0; round < options.rounds; ++round) {
    const ByLength path(piece);
    const auto corners = corners_mm(path, interval_mm, options.angle_rad);
    if (corners.empty()) break;
    const auto half_mm = [&](double s) {
      double widest = 0.0;
      for (auto c = std::lower_bound(corners.begin(), corners.end(), s - options.window_intervals * interval_mm);
           c != corners.end() && *c < s + options.window_intervals * interval_mm; ++c) {
        const double off = (s - *c) / (options.window_intervals * interval_mm), share = 1.0 - off * off;
        widest = std::max(widest, share * share * options.reach_intervals * interval_mm);
      }
      if (widest <= 0.0) return 0.0;
      return path.point(s).turn > 0.0 ? std::min({widest, s, path.total_mm() - s}) : 0.0;
    };
    CcPiece rounded;
    std::vector<char> now;
    const auto append = [&](double s, char was_moved) {
      const double half = half_mm(s);
      rounded.points.push_back(path.mean(s, half));
      now.push_back(was_moved != 0 || half > 0.0 ? 1 : 0);
    };
    for (std::size_t i = 0; i < piece.points.size(); ++i) {
      if (half_mm(path.at_mm(i)) > 0.0) {
        append(path.at_mm(i), moved[i]);
      } else {
        rounded.points.push_back(piece.points[i]);
        now.push_back(moved[i]);
      }
      if (i + 1 == piece.points.size()) break;
      const double span = path.at_mm(i + 1) - path.at_mm(i);
      const int parts = static_cast<int>(std::ceil(span / step_mm));
      for (int k = 1; k < parts; ++k) {
        const double s = path.at_mm(i) + span * k / parts;
        if (half_mm(s) > 0.0) append(s, 0);
      }
    }
    piece = std::move(rounded);
    moved = std::move(now);
  }
  return moved;
}

void fill_bends(CcPiece& piece, double interval_mm) {
  VOLUTE_CHECK(interval_mm > 0.0, interval_mm);
  constexpr double bend_rad = 0.2;
  const double spacing_mm = 0.1 * interval_mm;
  const auto& points = piece.points;
  std::vector<char> filled(points.size(), 0);  // the chord behind each point
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const Vec3 before = points[i].point_P_mm - points[i - 1].point_P_mm;
    const Vec3 after = points[i + 1].point_P_mm - points[i].point_P_mm;
    if (std::atan2(before.cross(after).norm(), before.dot(after)) > bend_rad) filled[i] = filled[i + 1] = 1;
  }
  CcPiece out;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (filled[i] != 0) {
      const CcPoint &a = points[i - 1], &b = points[i];
      const auto parts = std::ceil((b.point_P_mm - a.point_P_mm).norm() / spacing_mm);
      for (double k = 1.0; k < parts; ++k) {
        const double share = k / parts;
        out.points.push_back({a.point_P_mm + share * (b.point_P_mm - a.point_P_mm),
                              ((1.0 - share) * a.normal_P + share * b.normal_P).normalized(),
                              a.turn + share * (b.turn - a.turn), b.link});
      }
    }
    out.points.push_back(points[i]);
  }
  piece = std::move(out);
}

std::vector<Vec3> sharp_places_mm(const CcPiece& piece, double interval_mm, double angle_rad) {
  VOLUTE_CHECK(interval_mm > 0.0, interval_mm);
  std::vector<Vec3> out;
  if (piece.points.size() < 3) return out;
  const ByLength path(piece);
  for (double s : corners_mm(path, interval_mm, angle_rad)) out.push_back(path.point(s).point_P_mm);
  return out;
}

}  // namespace volute::planner

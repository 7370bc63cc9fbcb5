#include "planner/path/finish_path.hpp"

#include <algorithm>

#include "geometry/number_text.hpp"

namespace volute::planner {

using geometry::bad_input;

Sense sense_of(CutDirection direction) {
  return direction == CutDirection::climb ? Sense::clockwise : Sense::counter_clockwise;
}

Result<void> keep_turns(std::vector<RawStretch>& stretches, const PathOptions& options) {
  if (!options.from_turn && !options.to_turn) return {};
  double greatest = 0.0;
  for (const RawStretch& stretch : stretches)
    for (const RawPoint& p : stretch.points) greatest = std::max(greatest, p.turn);
  const double from = options.from_turn.value_or(0.0), to = options.to_turn.value_or(greatest);
  // The boundaries' own half turns stand at turn 0 and at the last one: they stay only where nothing is cut off there.
  const auto outside = [&](const RawPoint& p) {
    return (options.from_turn && p.turn < from - 1e-9) || (options.to_turn && p.turn > to + 1e-9);
  };
  std::vector<RawStretch> kept;
  for (RawStretch& stretch : stretches) {
    std::erase_if(stretch.points, outside);
    if (stretch.points.size() >= 2 && !(kept.empty() && stretch.link)) kept.push_back(std::move(stretch));
  }
  while (!kept.empty() && kept.back().link) kept.pop_back();
  if (kept.empty())
    return bad_input("path-turns", "no part of the path lies between turns " + geometry::short_text(from) + " and " +
                                       geometry::short_text(to) + ": it has " + geometry::short_text(greatest) +
                                       " turns");
  stretches = std::move(kept);
  return {};
}

CcPiece finished_piece(std::vector<RawStretch> stretches, const PathOptions& options, const CurveOptions& curve) {
  if (options.direction == Direction::outward) {
    std::reverse(stretches.begin(), stretches.end());
    for (RawStretch& stretch : stretches) std::reverse(stretch.points.begin(), stretch.points.end());
  }
  CcPiece piece;
  for (const RawStretch& stretch : stretches) {
    std::vector<CcPoint> points = smooth_curve(stretch.points, curve);
    for (CcPoint& p : points) p.link = stretch.link;
    const bool joins =
        !piece.points.empty() && (piece.points.back().point_P_mm - points.front().point_P_mm).norm() < 1e-9;
    piece.points.insert(piece.points.end(), points.begin() + (joins ? 1 : 0), points.end());
  }
  return piece;
}

TriangleMesh mirrored(const TriangleMesh& surface) {
  TriangleMesh mirror_image = surface;
  for (Vec3& v : mirror_image.vertices_mm) v.x() = -v.x();
  for (geometry::Triangle& t : mirror_image.triangles) std::swap(t[1], t[2]);
  return mirror_image;
}

void mirror(CcPathResult& result) {
  for (CcPiece& piece : result.path.pieces)
    for (CcPoint& p : piece.points) {
      p.point_P_mm.x() = -p.point_P_mm.x();
      p.normal_P.x() = -p.normal_P.x();
    }
  for (auto& bridge : result.map.bridges_P)
    for (Vec3& p : bridge) p.x() = -p.x();
}

}  // namespace volute::planner

// How the height of each crest between passes changes when the passes beside it move.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "planner/path/cc_path.hpp"
#include "planner/path/point_grid.hpp"
#include "planner/surface/operators.hpp"

namespace volute::planner {

using geometry::TriangleMesh;

/// A surface with what heights and nearest points need.
struct MendSurface {
  const TriangleMesh& mesh;
  std::span<const Vec3> vertex_normals;
  const std::vector<TriangleOperator>& operators;
};

/// A piece at short even steps: contact, the ball's centre, the normal, the length up to there, the turn.
struct BallSteps {
  std::vector<Vec3> contact_mm, centre_mm, normal;
  std::vector<double> s_mm, turn;
};

/// Requires: step_mm > 0.
BallSteps ball_steps(const CcPiece& piece, double radius_mm, double step_mm);

/// To first order the height over the allowed one is ratio + sum by_shift . shift(s).
struct CrestRow {
  double ratio = 0.0;
  std::vector<std::pair<double, Vec3>> by_shift;  ///< s in mm; allowed heights per interval of shift
};

/// A place on a crest between passes, where several balls enter the normal at about the same height: with weights that
/// sum to 1 their slopes along the surface cancel, or nearly so, and with these weights their changes make that of the
/// crest, wherever along the surface it goes. A place beside one pass alone (at the boundary) follows that pass. Shifts
/// are along the surface. Requires: radius_mm > scallop_mm > 0; what is given outlives this.
/// Property: rows agree with the difference of two measures of a shifted path to first order.
class Crests {
 public:
  Crests(const BallSteps& steps, const MendSurface& surface, double radius_mm, double scallop_mm);

  /// Of a place in a triangle, with the height measured there; without passes near it the row is empty.
  [[nodiscard]] CrestRow row(std::size_t triangle, const Vec3& place, double ratio) const;

 private:
  /// A pass beside a place: its step whose ball enters lowest, that height, and how the height grows with a shift of
  /// the ball and with the place.
  struct Foot {
    std::size_t step = 0;
    double height_mm = 0.0;
    Vec3 by_shift, by_place;
  };
  [[nodiscard]] Vec3 normal_at(std::size_t triangle, const Vec3& place) const;
  [[nodiscard]] std::vector<Foot> feet_of(std::size_t triangle, const Vec3& place) const;
  [[nodiscard]] Foot foot(std::size_t i, double height_mm, const Vec3& from_centre, const Vec3& normal) const;
  [[nodiscard]] static std::vector<double> balanced(const std::vector<Foot>& feet);

  const BallSteps& steps_;
  const MendSurface& surface_;
  double radius_mm_, scallop_mm_, interval_mm_;
  PointGrid grid_;
};

}  // namespace volute::planner

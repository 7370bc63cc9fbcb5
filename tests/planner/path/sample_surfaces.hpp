// Surfaces for tests: plates with round holes, flat or curved, with the faults of real meshes; rings and balls in
// closed form.
#pragma once

#include <cstdint>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "geometry/mesh.hpp"
#include "tests/cases.hpp"

namespace volute::planner::samples {

using geometry::TriangleMesh;
using geometry::Vec3;

struct Hole {
  double x_mm = 0.0, y_mm = 0.0, radius_mm = 5.0;
};

struct PlateOptions {
  double width_mm = 40.0, depth_mm = 40.0;
  int columns = 40, rows = 40;
  std::vector<Hole> holes;
  bool bricks = false;   ///< every second row shifted by half a cell: obtuse triangles where cells are flat
  double density = 1.0;  ///< cells in the last corner are this much larger, along both sides, than in the first
  double jitter = 0.0;   ///< inner vertices move by up to this share of a cell
  bool random_diagonals = false;
  std::function<double(double x, double y)> height;  ///< empty: flat
  double noise_mm = 0.0;                             ///< along z
  std::uint32_t seed = 1;
};

/// A rectangle about the origin. Vertices near a hole's rim are moved onto it; triangles inside are left out.
TriangleMesh plate(const PlateOptions& options);

/// A flat plate of cells up to 25 to 1 in bricks (angles from 4 to 171 degrees), or of cells up to 12 times larger at
/// one corner than at the other, with up to 4 holes. The same seed gives the same surface.
TriangleMesh stretched_plate(std::uint32_t seed, int holes);

/// A flat ring about the origin, `around` by `across` cells, outer loop counter-clockwise.
TriangleMesh ring(double inner_mm, double outer_mm, int around, int across);

/// The upper part of a ball about the origin down to z = 0, with a round opening of half angle `opening_rad` at the
/// top.
TriangleMesh dome(double radius_mm, double opening_rad, int around, int across);

/// A plate with that many holes (0 to 8), with grading, noise, bumps, jitter and cells stretched up to 4 to 1. The same
/// seed gives the same surface.
TriangleMesh random_plate(std::uint32_t seed, int holes);

}  // namespace volute::planner::samples

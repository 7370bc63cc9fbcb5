// The cut surface as a picture: a finer mesh with the deviation of every vertex, and its colours.
#pragma once

#include <array>
#include <vector>

#include "sim/machining/cut_surface.hpp"

namespace volute::sim {

struct CutPicture {
  geometry::TriangleMesh mesh;
  std::vector<double> deviation_mm;                   ///< one a vertex; NaN where nothing came near
  std::vector<std::array<unsigned char, 3>> colours;  ///< one a vertex
};

/// Blue (gouge limit and deeper) over white (on the surface) to red (uncut limit and higher); grey where nothing came
/// near.
std::array<unsigned char, 3> deviation_colour(double deviation_mm, double gouge_limit_mm, double uncut_limit_mm);

/// Cuts every triangle into as many as keep edges at `edge_mm` and measures at their corners, along the normal of the
/// triangle. Triangles do not share corners: a sharp edge has two sides. `vertices_max` widens the edge where needed;
/// three corners a triangle of the surface there are at least.
CutPicture cut_picture(const geometry::TriangleMesh& surface, const kinematics::Cutter& cutter,
                       const std::vector<SweptPose>& poses, const CutSurfaceOptions& options, double edge_mm,
                       std::size_t vertices_max = 2'000'000);

}  // namespace volute::sim

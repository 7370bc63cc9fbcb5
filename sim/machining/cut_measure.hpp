// The passes of measure_cut_surface: samples, then zooming in where the extremes can be.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/machining/surface_samples.hpp"
#include "sim/machining/swept_cutter.hpp"

namespace volute::sim {

/// Heights along the normal; NaN and pose -1 where nothing came near.
struct Deviations {
  std::vector<double> height_mm;
  std::vector<std::int32_t> pose;
};

/// A place found by zooming.
struct Extreme {
  double height_mm = 0.0;
  std::int32_t pose = -1;
  Vec3 point_mm = Vec3::Zero();
};

/// `near_height_mm`: most samples find their entry below it; the others are searched again up to `search_height_mm`.
struct SearchHeights {
  double near_height_mm = 0.0, search_height_mm = 0.0;
};

Deviations measure_samples(const SweptCutter& cutter, const SurfaceSamples& samples, const SearchHeights& heights);
/// For each vertex the worst sample of the triangles about it: one that nothing came near (NaN), else the one farthest
/// from the surface. A picture drawn from these shows how high the scallops are however far apart its vertices stand;
/// the deviations at the vertices themselves beat against the scallops where their spacings are alike.
std::vector<double> worst_about_vertices(const geometry::TriangleMesh& mesh, const SurfaceSamples& samples,
                                         const Deviations& deviations);

enum class Sought { highest, deepest };
/// Zooms into the cells of the samples listed: three times eight by eight points, ever closer. One result a sample, in
/// order.
std::vector<Extreme> zoom(const SweptCutter& cutter, const SurfaceSamples& samples,
                          const std::vector<std::int64_t>& where, const SearchHeights& heights, Sought sought);

}  // namespace volute::sim

#include "sim/machining/cut_picture.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "geometry/check.hpp"
#include "geometry/mesh_measure.hpp"
#include "sim/machining/surface_samples.hpp"
#include "sim/machining/swept_cutter.hpp"

namespace volute::sim {

namespace {

/// The deviations of those corners that have none yet, up to a height.
void measure_corners(const SweptCutter& swept, const std::array<Vec3, 3>& corners, const Vec3& normal, double height_mm,
                     SweptCutter::Near& near, std::span<double> out) {
  if (std::none_of(out.begin(), out.end(), [](double d) { return std::isnan(d); })) return;
  const Vec3 middle = (corners[0] + corners[1] + corners[2]) / 3.0;
  double size = 0.0;
  for (const Vec3& p : corners) size = std::max(size, (p - middle).norm());
  swept.near(middle, size, normal, height_mm, near);
  for (std::size_t k = 0; k < 3; ++k) {
    if (!std::isnan(out[k])) continue;
    if (const auto entry = swept.entry(corners[k], normal, height_mm, near)) out[k] = entry->height_mm;
  }
}

}  // namespace

std::array<unsigned char, 3> deviation_colour(double deviation_mm, double gouge_limit_mm, double uncut_limit_mm) {
  if (std::isnan(deviation_mm)) return {96, 96, 96};
  const double share =
      std::clamp(deviation_mm < 0.0 ? -deviation_mm / gouge_limit_mm : deviation_mm / uncut_limit_mm, 0.0, 1.0);
  const auto pale = static_cast<unsigned char>(std::lround(255.0 * (1.0 - share)));
  return deviation_mm < 0.0 ? std::array<unsigned char, 3>{pale, pale, 255}
                            : std::array<unsigned char, 3>{255, pale, pale};
}

CutPicture cut_picture(const geometry::TriangleMesh& surface, const kinematics::Cutter& cutter,
                       const std::vector<SweptPose>& poses, const CutSurfaceOptions& options, double edge_mm,
                       std::size_t vertices_max) {
  VOLUTE_CHECK(edge_mm > 0.0 && vertices_max > 0, edge_mm, vertices_max);
  // Three vertices a child: the area of a child is about 0.4 edge^2.
  const double least_edge_mm = std::sqrt(geometry::area_mm2(surface) * 3.0 / (0.4 * static_cast<double>(vertices_max)));
  double edge_used_mm = std::max(edge_mm, least_edge_mm);
  SurfaceSamples samples(surface, 1e9, edge_used_mm);
  while (3 * samples.patches().size() > vertices_max && samples.patches().size() > surface.triangles.size()) {
    edge_used_mm *= 1.1;
    samples = SurfaceSamples(surface, 1e9, edge_used_mm);
  }
  const SweptCutter swept(cutter, poses, options.sweep_tolerance_mm);
  const double search = options.search_height_mm > 0.0 ? options.search_height_mm : cutter.radius_mm;

  CutPicture picture;
  const std::size_t count = samples.patches().size();
  picture.mesh.vertices_mm.resize(3 * count);
  picture.mesh.triangles.resize(count);
  picture.deviation_mm.assign(3 * count, std::numeric_limits<double>::quiet_NaN());
  picture.colours.resize(3 * count);
  // Most corners find their entry below the first height; the others are searched again up to the last.
  const std::array<double, 2> heights{std::min(search, 1.5 * options.uncut_limit_mm), search};
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count), [&](const auto& range) {
    SweptCutter::Near near;
    for (std::size_t i = range.begin(); i != range.end(); ++i) {
      const auto& patch = samples.patches()[i];
      const Cell cell = samples.patch_cell(patch);
      const std::array<Vec3, 3> corners{cell.a, cell.b, cell.c};
      for (std::size_t k = 0; k < 3; ++k) {
        picture.mesh.vertices_mm[3 * i + k] = corners[k];
        picture.mesh.triangles[i][k] = static_cast<geometry::Index>(3 * i + k);
      }
      const std::span<double> out(&picture.deviation_mm[3 * i], 3);
      for (const double height_mm : heights)
        measure_corners(swept, corners, samples.normal(patch.triangle), height_mm, near, out);
      for (std::size_t k = 0; k < 3; ++k)
        picture.colours[3 * i + k] = deviation_colour(out[k], options.gouge_limit_mm, options.uncut_limit_mm);
    }
  });
  return picture;
}

}  // namespace volute::sim

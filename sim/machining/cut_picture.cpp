#include "sim/machining/cut_picture.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/check.hpp"
#include "geometry/mesh_measure.hpp"
#include "sim/machining/surface_samples.hpp"
#include "sim/machining/swept_cutter.hpp"

namespace volute::sim {

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
  const SurfaceSamples samples(surface, 1e9, std::max(edge_mm, least_edge_mm));
  const SweptCutter swept(cutter, poses, options.sweep_tolerance_mm);
  const double search = options.search_height_mm > 0.0 ? options.search_height_mm : cutter.radius_mm;

  CutPicture picture;
  const std::size_t count = samples.patches().size();
  picture.mesh.vertices_mm.resize(3 * count);
  picture.mesh.triangles.resize(count);
  picture.deviation_mm.assign(3 * count, std::numeric_limits<double>::quiet_NaN());
  picture.colours.resize(3 * count);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count), [&](const auto& range) {
    SweptCutter::Near near;
    for (std::size_t i = range.begin(); i != range.end(); ++i) {
      const auto& patch = samples.patches()[i];
      const Cell cell = samples.patch_cell(patch);
      const Vec3& normal = samples.normal(patch.triangle);
      const Vec3 middle = cell.centroid() + 0.5 * search * normal;
      const double size = std::max({(cell.a - cell.b).norm(), (cell.b - cell.c).norm(), (cell.c - cell.a).norm()});
      swept.near(middle, std::hypot(size, 0.5 * search), near);
      swept.keep_facing(normal, near);
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t v = 3 * i + k;
        picture.mesh.vertices_mm[v] = k == 0 ? cell.a : k == 1 ? cell.b : cell.c;
        picture.mesh.triangles[i][k] = static_cast<geometry::Index>(v);
        if (const auto entry = swept.entry(picture.mesh.vertices_mm[v], normal, search, near))
          picture.deviation_mm[v] = entry->height_mm;
        picture.colours[v] = deviation_colour(picture.deviation_mm[v], options.gouge_limit_mm, options.uncut_limit_mm);
      }
    }
  });
  return picture;
}

}  // namespace volute::sim

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/index.hpp"
#include "geometry/mesh_measure.hpp"
#include "planner/path/even_centre.hpp"
#include "planner/path/even_resample.hpp"
#include "planner/surface/condition.hpp"

namespace volute::planner {

using geometry::at;
namespace {

/// The vertices off the boundaries, or on them.
std::vector<Index> vertices_of(const EvenSurface& surface, bool inside) {
  std::vector<Index> out;
  for (Index v = 0; v < static_cast<Index>(surface.mesh.vertices_mm.size()); ++v) {
    if (surface.topology.is_boundary_vertex(v) != inside) out.push_back(v);
  }
  return out;
}

}  // namespace

double promised_length_mm(const EvenDomain& domain, const IntervalRule& rule, std::span<const Vec2> slopes) {
  constexpr double settled_share = 0.93;  // of the needed gradient, reached on all but 0.5 % of the path
  double along_mm = 0.0;
  std::vector<std::pair<double, double>> reached;  // of the needed gradient, and the path length there
  for (std::size_t t = 0; t < slopes.size(); ++t) {
    const double slope = slopes[t].norm(), part_mm = domain.operators[t].area_mm2 * slope;
    const Vec3 direction = domain.operators[t].to_space(slopes[t] / std::max(slope, 1e-12));
    reached.emplace_back(slope * domain.interval_mm(rule, static_cast<Index>(t), direction), part_mm);
    along_mm += part_mm;
  }
  std::sort(reached.begin(), reached.end());
  double passed_mm = 0.0, share = 1.0;
  for (const auto& [ratio, part_mm] : reached) {
    passed_mm += part_mm;
    share = ratio;
    if (passed_mm >= 0.005 * along_mm) break;
  }
  const double ends_mm = 0.5 * (domain.outer.length_mm + domain.centre.length_mm);
  return (ends_mm + along_mm) / std::min(1.0, std::max(share, 0.05) / settled_share);
}

Result<EvenSurface> coarse_surface(const EvenSurface& surface, int triangles) {
  const double edge_mm = 1.25 * std::sqrt(geometry::area_mm2(surface.mesh) / triangles);
  const CoarseMesh coarse = coarser(surface.mesh, edge_mm, 0.1 * edge_mm);
  auto conditioned = condition(coarse.mesh, {.dihedral_max_rad = 0.8, .deviation_max_mm = 0.2 * edge_mm});
  if (!conditioned) return tl::unexpected(conditioned.error());
  return EvenSurface::build(conditioned->mesh);
}

Index nearest_vertex(const TriangleMesh& mesh, std::span<const Index> pool, const Vec3& place) {
  Index out = geometry::no_index;
  double least = std::numeric_limits<double>::infinity();
  for (Index v : pool) {
    const double d = (mesh.vertices_mm[at(v)] - place).squaredNorm();
    if (d >= least) continue;
    least = d;
    out = v;
  }
  return out;
}

Centre moved_centre(const EvenSurface& from, const Centre& centre, const EvenSurface& to) {
  const auto inside = vertices_of(to, true), rim = vertices_of(to, false);
  const auto moved = [&](Index v) {
    return nearest_vertex(to.mesh, from.topology.is_boundary_vertex(v) ? rim : inside, from.mesh.vertices_mm[at(v)]);
  };
  Centre out;
  for (const Arm& arm : centre.arms) {
    const Arm there{moved(arm.from), moved(arm.to)};
    if (there.from != there.to) out.arms.push_back(there);
  }
  for (const Fold& fold : centre.folds) {
    const Fold there{moved(fold.from), moved(fold.to)};
    if (there.from != there.to) out.folds.push_back(there);
  }
  if (!centre.has_loop()) return out;
  const auto& loop = from.topology.boundary_loops()[at(centre.loop)];
  const Index vertex = moved(loop.vertices.front());
  const auto& loops = to.topology.boundary_loops();
  for (Index l = 1; l < static_cast<Index>(loops.size()); ++l) {
    const auto& v = loops[at(l)].vertices;
    if (std::find(v.begin(), v.end(), vertex) != v.end()) out.loop = l;
  }
  return out;
}

}  // namespace volute::planner

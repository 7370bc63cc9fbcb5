#include "planner/path/even_prolong.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/index.hpp"
#include "planner/path/even_fold.hpp"
#include "planner/path/point_grid.hpp"

namespace volute::planner {

using geometry::at;
namespace {

struct Found {
  Index triangle = geometry::no_index;
  Vec3 weight = Vec3::Zero();  ///< barycentric
};

/// Barycentric coordinates of the nearest point of the triangle, by projection and clamping; exact inside, near enough
/// outside.
Vec3 clamped_weight(const TriangleMesh& mesh, const TriangleOperator& o, Index triangle, const Vec3& place) {
  const auto& c = mesh.triangles[at(triangle)];
  Vec3 w;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3& other = mesh.vertices_mm[at(c[(k + 1) % 3])];
    w[static_cast<Eigen::Index>(k)] = std::clamp(o.hat_per_mm[k].dot(o.to_plane(place - other)), 0.0, 1.0);
  }
  return w / w.sum();
}

/// A mesh ready to be searched for the point nearest to a place.
struct Searchable {
  const TriangleMesh& mesh;
  const std::vector<TriangleOperator>& operators;
  std::vector<Vec3> middles;
  double edge_mm = 0.0;  ///< usual length

  Searchable(const TriangleMesh& searched, const std::vector<TriangleOperator>& of) : mesh(searched), operators(of) {
    double area_mm2 = 0.0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const auto& c = mesh.triangles[t];
      middles.push_back((mesh.vertices_mm[at(c[0])] + mesh.vertices_mm[at(c[1])] + mesh.vertices_mm[at(c[2])]) / 3.0);
      area_mm2 += operators[t].area_mm2;
    }
    edge_mm = 1.6 * std::sqrt(area_mm2 / static_cast<double>(middles.size()));
  }
};

Found find(const Searchable& domain, const PointGrid& middles, const Vec3& place) {
  double reach_mm = domain.edge_mm;
  Found out;
  double least = std::numeric_limits<double>::infinity();
  for (; out.triangle == geometry::no_index; reach_mm *= 2.0) {
    middles.near(place, reach_mm, [&](Index t) {
      const Vec3 w = clamped_weight(domain.mesh, domain.operators[at(t)], t, place);
      const auto& c = domain.mesh.triangles[at(t)];
      Vec3 nearest = Vec3::Zero();
      for (std::size_t k = 0; k < 3; ++k)
        nearest += w[static_cast<Eigen::Index>(k)] * domain.mesh.vertices_mm[at(c[k])];
      const double d = (nearest - place).squaredNorm();
      if (d >= least && !(d == least && t < out.triangle)) return;
      least = d;
      out = {t, w};
    });
  }
  return out;
}

}  // namespace

EvenField prolonged(const EvenDomain& coarse, const EvenField& field, const EvenDomain& fine) {
  const Searchable searchable(coarse.mesh, coarse.operators);
  const PointGrid grid(searchable.middles, searchable.edge_mm);
  std::vector<Found> found(fine.mesh.vertices_mm.size());
  tbb::parallel_for(std::size_t{0}, found.size(),
                    [&](std::size_t v) { found[v] = find(searchable, grid, fine.mesh.vertices_mm[v]); });

  EvenField out;
  out.turns = field.turns;
  for (const Found& f : found) {
    const auto& c = coarse.mesh.triangles[at(f.triangle)];
    out.phi.push_back(f.weight[0] * field.phi[at(c[0])] + f.weight[1] * field.phi[at(c[1])] +
                      f.weight[2] * field.phi[at(c[2])]);
  }
  for (Index v : fine.outer.vertices) out.phi[at(v)] = 0.0;
  for (Index v : fine.centre.vertices) out.phi[at(v)] = field.turns;
  for (std::size_t t = 0; t < fine.mesh.triangles.size(); ++t) {
    Vec3 direction = Vec3::Zero(), dual = Vec3::Zero();
    for (Index v : fine.mesh.triangles[t]) {
      const auto from = at(found[at(v)].triangle);
      direction += coarse.operators[from].to_space(field.direction[from]);
      dual += coarse.operators[from].to_space(field.dual[from]) / 3.0;
    }
    const Vec2 plane = fine.operators[t].to_plane(direction);
    out.direction.push_back(plane.norm() > 1e-9 ? Vec2(plane.normalized()) : Vec2(1.0, 0.0));
    out.dual.push_back(fine.operators[t].to_plane(dual));
  }
  return out;
}

std::vector<CcPoint> on_mesh(const TriangleMesh& mesh, std::span<const Vec3> vertex_normals,
                             const std::vector<TriangleOperator>& operators, std::span<const Vec3> places_mm) {
  const Searchable searchable(mesh, operators);
  const PointGrid grid(searchable.middles, searchable.edge_mm);
  std::vector<CcPoint> out(places_mm.size());
  tbb::parallel_for(std::size_t{0}, out.size(), [&](std::size_t i) {
    const Found f = find(searchable, grid, places_mm[i]);
    CcPoint& p = out[i];
    p.point_P_mm = p.normal_P = Vec3::Zero();
    for (std::size_t k = 0; k < 3; ++k) {
      const auto v = at(mesh.triangles[at(f.triangle)][k]);
      p.point_P_mm += f.weight[static_cast<Eigen::Index>(k)] * mesh.vertices_mm[v];
      p.normal_P += f.weight[static_cast<Eigen::Index>(k)] * vertex_normals[v];
    }
    p.normal_P.normalize();
  });
  return out;
}

CcPath on_surface(const EvenSurface& surface, const CcPath& path) {
  const auto operators = triangle_operators(surface.mesh);
  CcPath out = path;
  for (CcPiece& piece : out.pieces) {
    std::vector<Vec3> places;
    for (const CcPoint& p : piece.points) places.push_back(p.point_P_mm);
    const auto moved = on_mesh(surface.mesh, surface.vertex_normals, operators, places);
    for (std::size_t i = 0; i < moved.size(); ++i) {
      piece.points[i].point_P_mm = moved[i].point_P_mm;
      piece.points[i].normal_P = moved[i].normal_P;
    }
  }
  return out;
}

HeldLevels settled_levels(EvenDomain& domain, const EvenField& field) {
  std::vector<double> level, whole;  // on floating holes; those and at the folds' ends
  for (const auto& loop : domain.floating) {
    double sum = 0.0;
    for (Index v : loop.vertices) sum += field.phi[at(v)] - domain.theta.vertex[at(v)];
    level.push_back(sum / static_cast<double>(loop.vertices.size()));
  }
  whole = level;
  for (const auto& fold : domain.folds) {
    for (Index v : {fold.front(), fold.back()}) whole.push_back(field.phi[at(v)] - domain.theta.vertex[at(v)]);
  }
  constexpr int shifts = 64;
  double best_shift = 0.0, least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < shifts && !whole.empty(); ++i) {
    double off = 0.0;
    for (double l : whole) off += std::pow(std::remainder(l - whole.front() + static_cast<double>(i) / shifts, 1.0), 2);
    if (off >= least) continue;
    least = off;
    best_shift = whole.front() - static_cast<double>(i) / shifts;
  }
  for (double& theta : domain.theta.vertex) theta += best_shift;
  for (double& l : level) l = std::round(l - best_shift);
  return {std::move(level),
          domain.folds.empty() ? std::vector<std::array<double, 2>>{} : fold_choices(domain, field).front()};
}

}  // namespace volute::planner

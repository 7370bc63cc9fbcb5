#include "plane_mesher.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_size_criteria_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace volute::examples {

namespace {

using geometry::Index;
using geometry::Vec2;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<Index, Kernel>;
using FaceBase = CGAL::Delaunay_mesh_face_base_2<Kernel>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure>;
using Criteria = CGAL::Delaunay_mesh_size_criteria_2<Triangulation>;

double turn_rad(const Vec2& before, const Vec2& at, const Vec2& after) {
  const Vec2 u = at - before, v = after - at;
  return std::abs(std::atan2(u.x() * v.y() - u.y() * v.x(), u.dot(v)));
}

/// Corners that must stay; the first point when the polygon is smooth everywhere.
std::vector<std::size_t> kept_corners(const Polygon& polygon) {
  constexpr double sharp_rad = 40.0 * std::numbers::pi / 180.0;
  std::vector<std::size_t> corners;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    if (turn_rad(polygon[(i + polygon.size() - 1) % polygon.size()], polygon[i], polygon[(i + 1) % polygon.size()]) >
        sharp_rad)
      corners.push_back(i);
  if (corners.empty()) corners.push_back(0);
  return corners;
}

/// The chain from corner to corner at even spacing, without its last point.
void append_chain(const Polygon& chain, double spacing_mm, Polygon& out) {
  std::vector<double> along = {0.0};
  for (std::size_t i = 1; i < chain.size(); ++i) along.push_back(along.back() + (chain[i] - chain[i - 1]).norm());
  const auto pieces = std::max(1, static_cast<int>(std::lround(along.back() / spacing_mm)));
  std::size_t segment = 1;
  for (int k = 0; k < pieces; ++k) {
    const double wanted = along.back() * k / pieces;
    while (along[segment] < wanted) ++segment;
    const double part = (wanted - along[segment - 1]) / (along[segment] - along[segment - 1]);
    out.push_back(chain[segment - 1] + part * (chain[segment] - chain[segment - 1]));
  }
}

/// Distance from points to a set of segments, by a grid of cells that know which segments come near.
class BoundaryDistance {
 public:
  BoundaryDistance(const std::vector<Polygon>& polygons, double reach_mm) : reach_mm_(reach_mm) {
    least_ = greatest_ = polygons.front().front();
    for (const Polygon& polygon : polygons)
      for (const Vec2& p : polygon) {
        least_ = least_.cwiseMin(p);
        greatest_ = greatest_.cwiseMax(p);
      }
    columns_ = 1 + static_cast<std::size_t>((greatest_.x() - least_.x()) / reach_mm);
    rows_ = 1 + static_cast<std::size_t>((greatest_.y() - least_.y()) / reach_mm);
    cells_.resize(columns_ * rows_);
    for (const Polygon& polygon : polygons)
      for (const Vec2& p : polygon) cells_[cell_of(p)].push_back(p);
  }

  /// True when a boundary point lies nearer than the reach. Requires: boundary points spaced no wider than the reach.
  [[nodiscard]] bool is_near(const Vec2& p) const {
    const auto column = static_cast<std::ptrdiff_t>((p.x() - least_.x()) / reach_mm_);
    const auto row = static_cast<std::ptrdiff_t>((p.y() - least_.y()) / reach_mm_);
    for (std::ptrdiff_t r = row - 1; r <= row + 1; ++r)
      for (std::ptrdiff_t c = column - 1; c <= column + 1; ++c) {
        if (r < 0 || c < 0 || r >= static_cast<std::ptrdiff_t>(rows_) || c >= static_cast<std::ptrdiff_t>(columns_))
          continue;
        for (const Vec2& q : cells_[static_cast<std::size_t>(r) * columns_ + static_cast<std::size_t>(c)])
          if ((p - q).norm() < reach_mm_) return true;
      }
    return false;
  }
  [[nodiscard]] const Vec2& least() const { return least_; }
  [[nodiscard]] const Vec2& greatest() const { return greatest_; }

 private:
  [[nodiscard]] std::size_t cell_of(const Vec2& p) const {
    return static_cast<std::size_t>((p.y() - least_.y()) / reach_mm_) * columns_ +
           static_cast<std::size_t>((p.x() - least_.x()) / reach_mm_);
  }
  double reach_mm_;
  Vec2 least_, greatest_;
  std::size_t columns_ = 0, rows_ = 0;
  std::vector<std::vector<Vec2>> cells_;
};

void insert_polygon(Triangulation& triangulation, const Polygon& polygon) {
  std::vector<Triangulation::Vertex_handle> handles;
  for (const Vec2& p : polygon) handles.push_back(triangulation.insert({p.x(), p.y()}));
  for (std::size_t i = 0; i < handles.size(); ++i)
    triangulation.insert_constraint(handles[i], handles[(i + 1) % handles.size()]);
}

/// The equilateral lattice that keeps clear of the boundary; what lies outside the region does no harm there.
void insert_lattice(Triangulation& triangulation, const BoundaryDistance& boundary, double edge_mm) {
  const double row_mm = edge_mm * std::numbers::sqrt3 / 2.0;
  std::vector<Kernel::Point_2> points;
  int row = 0;
  for (double y = boundary.least().y(); y < boundary.greatest().y(); y += row_mm, ++row)
    for (double x = boundary.least().x() + (row % 2 == 0 ? 0.0 : 0.5 * edge_mm); x < boundary.greatest().x();
         x += edge_mm)
      if (!boundary.is_near({x, y})) points.emplace_back(x, y);
  triangulation.insert(points.begin(), points.end());
}

/// A point inside a polygon that is star-shaped seen from its centroid, as all holes here are.
Kernel::Point_2 seed_inside(const Polygon& polygon) {
  Vec2 sum = Vec2::Zero();
  for (const Vec2& p : polygon) sum += p;
  sum /= static_cast<double>(polygon.size());
  return {sum.x(), sum.y()};
}

PlaneMesh collected(Triangulation& triangulation) {
  PlaneMesh mesh;
  for (auto v : triangulation.finite_vertex_handles()) v->info() = geometry::no_index;
  for (auto f : triangulation.finite_face_handles()) {
    if (!f->is_in_domain()) continue;
    geometry::Triangle corners{};
    for (int k = 0; k < 3; ++k) {
      const auto v = f->vertex(k);
      if (v->info() == geometry::no_index) {
        v->info() = static_cast<Index>(mesh.points_mm.size());
        mesh.points_mm.emplace_back(v->point().x(), v->point().y());
      }
      corners[static_cast<std::size_t>(k)] = v->info();
    }
    mesh.triangles.push_back(corners);
  }
  return mesh;
}

}  // namespace

Polygon resampled(const Polygon& polygon, double spacing_mm) {
  const std::vector<std::size_t> corners = kept_corners(polygon);
  Polygon out;
  for (std::size_t c = 0; c < corners.size(); ++c) {
    const std::size_t first = corners[c];
    std::size_t last = corners[(c + 1) % corners.size()];
    if (last <= first) last += polygon.size();
    Polygon chain;
    for (std::size_t i = first; i <= last; ++i) chain.push_back(polygon[i % polygon.size()]);
    append_chain(chain, spacing_mm, out);
  }
  return out;
}

PlaneMesh mesh_plane(const PlaneRegion& region, double edge_mm) {
  std::vector<Polygon> polygons = {resampled(region.outer, edge_mm)};
  for (const Polygon& hole : region.holes) polygons.push_back(resampled(hole, edge_mm));
  Triangulation triangulation;
  for (const Polygon& polygon : polygons) insert_polygon(triangulation, polygon);
  insert_lattice(triangulation, BoundaryDistance(polygons, 0.75 * edge_mm), edge_mm);
  std::vector<Kernel::Point_2> seeds;
  for (std::size_t h = 1; h < polygons.size(); ++h) seeds.push_back(seed_inside(polygons[h]));
  constexpr double least_sine_sq = 0.125;  // 20.7 degrees: the bound for which the mesher is proved to end
  CGAL::refine_Delaunay_mesh_2(triangulation, seeds.begin(), seeds.end(), Criteria(least_sine_sq, 1.2 * edge_mm));
  return collected(triangulation);
}

}  // namespace volute::examples

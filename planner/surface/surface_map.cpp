#include "planner/surface/surface_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/index.hpp"
#include "planner/surface/operators.hpp"
#include "planner/surface/sparse_solver.hpp"

namespace volute::planner {

using geometry::at;
using geometry::bad_input;
using geometry::MeshTopology;
using geometry::Triangle;

namespace {

/// Least weight of an edge when negative ones are raised; a right angle has 0, an equilateral pair 0.58.
constexpr double raised_weight = 0.02;

/// Corner values of both coordinates of a triangle.
using Corners = std::array<Vec2, 3>;

double doubled_area(const Corners& c) {
  const Vec2 p = c[1] - c[0], q = c[2] - c[0];
  return p.x() * q.y() - p.y() * q.x();
}

/// `corners(t)` gives triangle t in the map; `stretch` scales the first coordinate for the conformal error.
template <class CornersOf>
MapQuality measure(const TriangleMesh& mesh, CornersOf corners, double stretch, Index& first_flip) {
  const auto operators = triangle_operators(mesh);
  MapQuality quality;
  double area = 0.0, error = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Corners c = corners(t);
    if (!(doubled_area(c) > 0.0)) {
      if (quality.flips++ == 0) first_flip = static_cast<Index>(t);
      continue;
    }
    const Vec2 gu = stretch * operators[t].gradient(c[0].x(), c[1].x(), c[2].x());
    const Vec2 gv = operators[t].gradient(c[0].y(), c[1].y(), c[2].y());
    const double det = std::abs(gu.x() * gv.y() - gu.y() * gv.x()),
                 half_sum = 0.5 * (gu.squaredNorm() + gv.squaredNorm());
    const double ratio = (half_sum + std::sqrt(std::max(half_sum * half_sum - det * det, 0.0))) / det;
    area += operators[t].area_mm2;
    error += operators[t].area_mm2 * (ratio - 1.0);
  }
  quality.quasi_conformal_error = area > 0.0 ? error / area : 0.0;
  return quality;
}

/// The same Laplacian with every edge weight at least `raised_weight`: with positive weights and a convex boundary no
/// triangle can flip (Tutte; Floater).
SparseMatrix with_positive_weights(SparseMatrix laplacian) {
  Eigen::VectorXd change = Eigen::VectorXd::Zero(laplacian.rows());
  for (Eigen::Index column = 0; column < laplacian.outerSize(); ++column)
    for (SparseMatrix::InnerIterator entry(laplacian, column); entry; ++entry) {
      if (entry.row() == entry.col() || entry.value() <= -raised_weight) continue;
      change[entry.row()] += entry.value() + raised_weight;
      entry.valueRef() = -raised_weight;
    }
  for (Eigen::Index i = 0; i < laplacian.rows(); ++i) laplacian.coeffRef(i, i) += change[i];
  return laplacian;
}

/// Chord length from the first point, as a share of the whole: eq. 7.
std::vector<double> chord_shares(const TriangleMesh& mesh, const std::vector<Index>& chain) {
  std::vector<double> share{0.0};
  for (std::size_t i = 1; i < chain.size(); ++i)
    share.push_back(share.back() + (mesh.vertices_mm[at(chain[i])] - mesh.vertices_mm[at(chain[i - 1])]).norm());
  for (double& s : share) s /= share.back();
  return share;
}

double chain_length_mm(const TriangleMesh& mesh, const std::vector<Index>& chain) {
  double length = 0.0;
  for (std::size_t i = 1; i < chain.size(); ++i)
    length += (mesh.vertices_mm[at(chain[i])] - mesh.vertices_mm[at(chain[i - 1])]).norm();
  return length;
}

struct FixedVertices {
  std::vector<int> vertices;
  std::vector<Vec2> values;
  [[nodiscard]] Eigen::MatrixXd matrix() const {
    Eigen::MatrixXd m(static_cast<Eigen::Index>(values.size()), 2);
    for (std::size_t i = 0; i < values.size(); ++i) m.row(static_cast<Eigen::Index>(i)) = values[i].transpose();
    return m;
  }
};

/// The boundary points on the rectangle's sides, eq. 5-7; each corner once.
FixedVertices sides_of_rectangle(const Annulus& annulus, double width, double height) {
  FixedVertices fixed;
  const auto add = [&](const std::vector<Index>& side, const Vec2& from, const Vec2& to, bool with_ends) {
    const std::vector<double> share = chord_shares(annulus.sheet, side);
    for (std::size_t i = with_ends ? 0 : 1; i < side.size() - (with_ends ? 0 : 1); ++i) {
      fixed.vertices.push_back(side[i]);
      fixed.values.emplace_back(from + share[i] * (to - from));
    }
  };
  add(annulus.bottom, {0.0, 0.0}, {width, 0.0}, true);
  add(annulus.top, {0.0, height}, {width, height}, true);
  add(annulus.left, {0.0, 0.0}, {0.0, height}, false);
  add(annulus.right, {width, 0.0}, {width, height}, false);
  return fixed;
}

tl::unexpected<geometry::Error> flipped_error(Index flips, Index triangle) {
  return bad_input("surface-map-flipped", std::to_string(flips) +
                                              " triangles have no area in the map, the first is triangle " +
                                              std::to_string(triangle) + "; refine or smooth the mesh there");
}

}  // namespace

Result<RectangleMap> rectangle_map(const Annulus& annulus) {
  const TriangleMesh& sheet = annulus.sheet;
  RectangleMap map;
  map.width_mm = 0.5 * (chain_length_mm(sheet, annulus.bottom) + chain_length_mm(sheet, annulus.top));
  map.height_mm = 0.5 * (chain_length_mm(sheet, annulus.left) + chain_length_mm(sheet, annulus.right));
  const FixedVertices fixed = sides_of_rectangle(annulus, map.width_mm, map.height_mm);
  SparseMatrix laplacian = cotan_laplacian(sheet);
  Index first_flip = geometry::no_index;
  for (bool raise : {false, true}) {
    if (raise) laplacian = with_positive_weights(laplacian);
    const auto solved = solve_with_fixed(laplacian, fixed.vertices, fixed.matrix());
    if (!solved) return tl::unexpected(solved.error());
    const auto corners = [&](std::size_t t) {
      Corners c;
      for (std::size_t k = 0; k < 3; ++k) c[k] = solved->row(sheet.triangles[t][k]).transpose();
      return c;
    };
    map.quality = measure(sheet, corners, 1.0, first_flip);
    map.quality.positive_weights = raise;
    map.u_mm.assign(solved->col(0).begin(), solved->col(0).end());
    map.v_mm.assign(solved->col(1).begin(), solved->col(1).end());
    if (map.quality.flips == 0) return map;
  }
  return flipped_error(map.quality.flips, first_flip);
}

namespace {

Result<std::vector<double>> harmonic_height(const Annulus& annulus, const SparseMatrix& laplacian) {
  std::vector<int> fixed(annulus.outer.begin(), annulus.outer.end());
  fixed.insert(fixed.end(), annulus.inner.begin(), annulus.inner.end());
  Eigen::MatrixXd values = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(fixed.size()), 1);
  values.bottomRows(static_cast<Eigen::Index>(annulus.inner.size())).setOnes();
  const auto solved = solve_with_fixed(laplacian, fixed, values);
  if (!solved) return tl::unexpected(solved.error());
  return std::vector<double>(solved->col(0).begin(), solved->col(0).end());
}

/// The rising sequence nearest to `x` in the mean square (pool adjacent violators).
std::vector<double> nearest_rising(const std::vector<double>& x) {
  struct Pool {
    double sum;
    std::size_t count;
    [[nodiscard]] double mean() const { return sum / static_cast<double>(count); }
  };
  std::vector<Pool> pools;
  for (double value : x) {
    pools.push_back({value, 1});
    while (pools.size() > 1 && pools[pools.size() - 2].mean() > pools.back().mean()) {
      pools[pools.size() - 2].sum += pools.back().sum;
      pools[pools.size() - 2].count += pools.back().count;
      pools.pop_back();
    }
  }
  std::vector<double> rising;
  for (const Pool& pool : pools) rising.insert(rising.end(), pool.count, pool.mean());
  return rising;
}

/// Turn values around a loop from the seam on, changed as little as makes them rise strictly by one turn.
std::vector<double> monotone_around(const std::vector<Index>& loop, const std::vector<double>& turn) {
  const std::vector<double> x = turns_along(loop, turn);
  const double step = 1e-2 / static_cast<double>(loop.size());  // the least rise from vertex to vertex
  std::vector<double> free_part;
  for (std::size_t i = 0; i < x.size(); ++i) free_part.push_back(x[i] - step * static_cast<double>(i));
  std::vector<double> values = nearest_rising(free_part);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double share = std::clamp(values[i], 0.0, 1.0 - step * static_cast<double>(values.size()));
    values[i] = turn[at(loop.front())] + (i == 0 ? 0.0 : share + step * static_cast<double>(i));
  }
  return values;
}

MapQuality measure_cylinder(const TriangleMesh& ring, const CylinderMap& map, Index& first_flip) {
  const auto corners = [&](std::size_t t) {
    Corners c;
    for (std::size_t k = 0; k < 3; ++k)
      c[k] = {map.turn.at_corner(ring, static_cast<Index>(t), static_cast<int>(k)),
              map.height[at(ring.triangles[t][k])]};
    return c;
  };
  const auto operators = triangle_operators(ring);
  double turn_energy = 0.0, height_energy = 0.0;
  for (std::size_t t = 0; t < ring.triangles.size(); ++t) {
    const Corners c = corners(t);
    turn_energy += operators[t].area_mm2 * operators[t].gradient(c[0].x(), c[1].x(), c[2].x()).squaredNorm();
    height_energy += operators[t].area_mm2 * operators[t].gradient(c[0].y(), c[1].y(), c[2].y()).squaredNorm();
  }
  return measure(ring, corners, std::sqrt(height_energy / turn_energy), first_flip);
}

/// Turn with both boundaries fixed: K x = -(load of the jump) at inner vertices.
Result<void> fix_turn_at_boundaries(const Annulus& annulus, const SparseMatrix& laplacian, CylinderMap& map) {
  const TriangleMesh& ring = annulus.ring;
  std::vector<int> fixed(annulus.outer.begin(), annulus.outer.end());
  fixed.insert(fixed.end(), annulus.inner.begin(), annulus.inner.end());
  std::vector<double> values = monotone_around(annulus.outer, map.turn.vertex);
  const std::vector<double> top = monotone_around(annulus.inner, map.turn.vertex);
  values.insert(values.end(), top.begin(), top.end());
  // The jump's load by edges, with the raised weights: sum over neighbours of w_ij (difference of the jump across the
  // edge).
  Eigen::MatrixXd load = Eigen::MatrixXd::Zero(laplacian.rows(), 1);
  const auto topology = MeshTopology::build(ring);
  if (!topology) return tl::unexpected(topology.error());
  for (Index e = 0; e < topology->edge_count(); ++e) {
    const Index h = topology->edge_halfedge(e);
    const auto t = at(geometry::halfedge_triangle(h));
    const std::size_t k = at(h % 3), l = at(geometry::next_halfedge(h) % 3);
    const Index i = ring.triangles[t][k], j = ring.triangles[t][l];
    const double step = map.turn.jump[t][l] - map.turn.jump[t][k];
    const double weight = -laplacian.coeff(i, j);
    load(i, 0) += weight * step;
    load(j, 0) -= weight * step;
  }
  const Eigen::MatrixXd fixed_values =
      Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
  const auto solved = solve_with_fixed(laplacian, fixed, fixed_values, load);
  if (!solved) return tl::unexpected(solved.error());
  map.turn.vertex.assign(solved->col(0).begin(), solved->col(0).end());
  return {};
}

}  // namespace

std::vector<double> turns_along(const std::vector<Index>& loop, const std::vector<double>& turn) {
  std::vector<double> along{0.0};
  for (std::size_t i = 1; i < loop.size(); ++i) {
    const double step = turn[at(loop[i])] - turn[at(loop[i - 1])];
    along.push_back(along.back() + step - std::round(step));
  }
  return along;
}

Result<CylinderMap> cylinder_map(const Annulus& annulus) {
  const auto topology = MeshTopology::build(annulus.ring);
  if (!topology) return tl::unexpected(topology.error());
  SparseMatrix laplacian = cotan_laplacian(annulus.ring);
  CylinderMap map;
  auto height = harmonic_height(annulus, laplacian);
  if (!height) return tl::unexpected(height.error());
  map.height = std::move(*height);
  auto turn = periodic_harmonic(annulus.ring, *topology, annulus.seam);
  if (!turn) return tl::unexpected(turn.error());
  map.turn = std::move(*turn);
  Index first_flip = geometry::no_index;
  map.quality = measure_cylinder(annulus.ring, map, first_flip);
  if (map.quality.flips == 0) return map;
  laplacian = with_positive_weights(laplacian);
  height = harmonic_height(annulus, laplacian);
  if (!height) return tl::unexpected(height.error());
  map.height = std::move(*height);
  if (auto fixed = fix_turn_at_boundaries(annulus, laplacian, map); !fixed) return tl::unexpected(fixed.error());
  map.quality = measure_cylinder(annulus.ring, map, first_flip);
  map.quality.positive_weights = true;
  if (map.quality.flips > 0) return flipped_error(map.quality.flips, first_flip);
  return map;
}

}  // namespace volute::planner

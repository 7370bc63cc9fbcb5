#include "sim/machining/stock_setup.hpp"

#include <cmath>
#include <set>
#include <utility>

#include "geometry/check.hpp"
#include "geometry/mesh_measure.hpp"
#include "geometry/number_text.hpp"

namespace volute::sim {
namespace {

using geometry::short_text;

Eigen::AlignedBox3d box_about(const geometry::TriangleMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Vec3& p : mesh.vertices_mm) box.extend(p);
  return box;
}

std::string corner_text(const Vec3& p) { return short_text(p.x()) + " " + short_text(p.y()) + " " + short_text(p.z()); }

}  // namespace

StockSetup assumed_stock(const geometry::TriangleMesh& surface_P, double allowance_mm) {
  StockSetup setup;
  setup.box_P_mm = box_about(surface_P);
  setup.box_P_mm.min().array() -= allowance_mm;
  setup.box_P_mm.max().array() += allowance_mm;
  setup.assumed = true;
  return setup;
}

StockSetup near_net_stock(const geometry::TriangleMesh& surface_P, double allowance_mm) {
  StockSetup setup;
  setup.solid_P = near_net_blank(surface_P, allowance_mm);
  return setup;
}

geometry::TriangleMesh near_net_blank(const geometry::TriangleMesh& surface_P, double allowance_mm) {
  VOLUTE_CHECK(allowance_mm >= 0.0, allowance_mm);
  using geometry::Index;
  const std::vector<Vec3> normals = geometry::vertex_normals(surface_P);
  const auto inner = static_cast<Index>(surface_P.vertices_mm.size());
  geometry::TriangleMesh skin;
  for (const double out_mm : {allowance_mm, -near_net_body_mm})
    for (std::size_t v = 0; v < normals.size(); ++v)
      skin.vertices_mm.push_back(surface_P.vertices_mm[v] + out_mm * normals[v]);
  std::set<std::pair<Index, Index>> edges;
  for (const geometry::Triangle& t : surface_P.triangles) {
    skin.triangles.push_back(t);
    skin.triangles.push_back({t[0] + inner, t[2] + inner, t[1] + inner});
    for (std::size_t k = 0; k < 3; ++k) edges.insert({t[k], t[(k + 1) % 3]});
  }
  for (const auto& [from, to] : edges) {
    if (edges.contains({to, from})) continue;
    skin.triangles.push_back({to, from, from + inner});
    skin.triangles.push_back({to, from + inner, to + inner});
  }
  return skin;
}

double default_stock_grid_mm(const StockSetup& setup) {
  const Eigen::AlignedBox3d box = setup.solid_P ? box_about(*setup.solid_P) : setup.box_P_mm;
  return box.isEmpty() ? 1.0 : box.sizes().maxCoeff() / 200.0;
}

geometry::Result<Stock> make_stock(const StockSetup& setup) {
  constexpr double rays_max = 6e7;
  const Eigen::AlignedBox3d box = setup.solid_P ? box_about(*setup.solid_P) : setup.box_P_mm;
  if (!setup.solid_P && (box.isEmpty() || box.sizes().minCoeff() <= 0.0))
    return geometry::bad_input("stock-box-empty", "the stock's box from (" + corner_text(box.min()) + ") to (" +
                                                      corner_text(box.max()) +
                                                      ") holds nothing; its low corner must lie below its high one");
  const double grid_mm = setup.grid_mm > 0.0 ? setup.grid_mm : default_stock_grid_mm(setup);
  const Vec3 n = box.isEmpty() ? Vec3::Zero().eval() : Vec3(box.sizes() / grid_mm);
  const double rays = n.x() * n.y() + n.y() * n.z() + n.z() * n.x();
  if (rays > rays_max)
    return geometry::bad_input("stock-grid-too-fine",
                               "a stock grid of " + short_text(grid_mm) + " mm takes " + short_text(rays / 1e6, 3) +
                                   " million rays in this stock; at most " + short_text(rays_max / 1e6, 3) +
                                   " million are kept: give a grid of " +
                                   short_text(grid_mm * std::sqrt(rays / rays_max) * 1.05, 2) + " mm or more");
  if (setup.solid_P) return Stock::solid(*setup.solid_P, grid_mm);
  return Stock::box(box.min(), box.max(), grid_mm);
}

geometry::TriangleMesh blank_mesh(const StockSetup& setup) {
  if (setup.solid_P) return *setup.solid_P;
  geometry::TriangleMesh box;
  for (const auto corner :
       {Eigen::AlignedBox3d::BottomLeftFloor, Eigen::AlignedBox3d::BottomRightFloor, Eigen::AlignedBox3d::TopLeftFloor,
        Eigen::AlignedBox3d::TopRightFloor, Eigen::AlignedBox3d::BottomLeftCeil, Eigen::AlignedBox3d::BottomRightCeil,
        Eigen::AlignedBox3d::TopLeftCeil, Eigen::AlignedBox3d::TopRightCeil})
    box.vertices_mm.push_back(setup.box_P_mm.corner(corner));
  box.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                   {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return box;
}

}  // namespace volute::sim

// What the blank is before the run.
#pragma once

#include <optional>

#include "sim/machining/stock.hpp"

namespace volute::sim {

struct StockSetup {
  std::optional<geometry::TriangleMesh> solid_P;  ///< a closed mesh; nothing: the box
  Eigen::AlignedBox3d box_P_mm;
  double grid_mm = 0.0;  ///< distance of the rays; 0: `default_stock_grid_mm`
  bool assumed = false;  ///< nobody gave it: what meets it is told, not judged
};

/// The box about a surface and `allowance_mm` more on every side, as an assumed stock.
StockSetup assumed_stock(const geometry::TriangleMesh& surface_P, double allowance_mm);

/// What a semi-finished part is made of: the surface and `allowance_mm` more along its normals.
StockSetup near_net_stock(const geometry::TriangleMesh& surface_P, double allowance_mm);

/// A semi-finished part as a closed skin: the surface moved out along its vertex normals by `allowance_mm`, and in by
/// `near_net_body_mm`, joined at the boundaries. What lies deeper in the part is left out: nothing may come there
/// anyway. Requires: an oriented mesh, allowance >= 0.
/// Properties: 1. Every edge has two triangles, of opposite direction. 2. On a sphere of radius R its volume is that of
/// the shell between R - near_net_body_mm and R + allowance. Where the surface bends more tightly than these distances
/// the skin folds over itself, within about as much.
geometry::TriangleMesh near_net_blank(const geometry::TriangleMesh& surface_P, double allowance_mm);
constexpr double near_net_body_mm = 1.5;

/// A two-hundredth of the longest side: coarse enough for a default, fine enough for holders.
double default_stock_grid_mm(const StockSetup& setup);

/// The blank before the run, closed: the solid, or the box as twelve triangles.
geometry::TriangleMesh blank_mesh(const StockSetup& setup);

/// Errors (bad_input): stock-box-empty, stock-grid-too-fine (more than 60 million rays), and those of Stock::solid.
geometry::Result<Stock> make_stock(const StockSetup& setup);

}  // namespace volute::sim

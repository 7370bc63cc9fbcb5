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

/// A two-hundredth of the longest side: coarse enough for a default, fine enough for holders.
double default_stock_grid_mm(const StockSetup& setup);

/// The blank before the run, closed: the solid, or the box as twelve triangles.
geometry::TriangleMesh blank_mesh(const StockSetup& setup);

/// Errors (bad_input): stock-box-empty, stock-grid-too-fine (more than 60 million rays), and those of Stock::solid.
geometry::Result<Stock> make_stock(const StockSetup& setup);

}  // namespace volute::sim

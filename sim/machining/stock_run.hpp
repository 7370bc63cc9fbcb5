// A run through the stock: what each line removes, and what should not touch material.
#pragma once

#include <vector>

#include "sim/machining/stock.hpp"

namespace volute::sim {

struct StockRunOptions {
  double tolerance_mm = 0.02;      ///< of the cutter's sweep
  double rapid_volume_mm3 = 0.05;  ///< a rapid that removes more goes through stock
  double holder_volume_mm3 = 0.5;  ///< a shank or holder with more material inside it is in the stock
  double holder_step_mm = 2.0;     ///< shank and holder are looked at so far apart along the tip's way
};

struct LineVolume {
  std::int64_t line = 0;
  double removed_mm3 = 0.0;
};

struct StockReport {
  double first_mm3 = 0.0, left_mm3 = 0.0;
  std::vector<LineVolume> removed;  ///< one a line that cut, in the order of the run
  std::vector<Finding> findings;  ///< kind "collision": rapid through stock, shank or holder in the stock; at most 100
};

/// Cuts `stock` along the run. Shank and holder are held against what is left when they get there.
StockReport run_through_stock(Stock& stock, const kinematics::Tool& tool, std::span<const SweptPose> poses,
                              const StockRunOptions& options);

}  // namespace volute::sim

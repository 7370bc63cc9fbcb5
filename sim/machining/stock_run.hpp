// A run through the stock: what each line removes, and what should not touch material.
#pragma once

#include <functional>
#include <vector>

#include "sim/machining/stock.hpp"

namespace volute::sim {

struct StockRunOptions {
  double tolerance_mm = 0.02;      ///< of the cutter's sweep
  double rapid_volume_mm3 = 0.05;  ///< a rapid that removes more goes through stock
  double holder_volume_mm3 = 0.5;  ///< a shank or holder with more material inside it is in the stock
  double step_mm = 0.5;  ///< no point of shank or holder moves further between two looks when material is near
  std::function<void(double)> progress;  ///< share of the poses that are done; may be empty
};

/// What one line of the program took away; a line that runs again has another entry.
struct LineVolume {
  std::int64_t line = 0;
  double removed_mm3 = 0.0;
  double time_s = 0.0;  ///< of the line's feed moves, in the air or not
};

struct StockReport {
  double first_mm3 = 0.0, left_mm3 = 0.0;
  std::vector<LineVolume> removed;  ///< one a line that cut, in the order of the run
  /// Kind "collision", at most 100. Pair cutter-stock: a rapid that cuts, `value` mm3. Pairs shank-stock, holder-stock:
  /// `value` is the depth in mm, the greatest of those seen: how much the cone can shrink on all sides before it is
  /// free.
  std::vector<Finding> findings;
  bool findings_left_out = false;  ///< there were more than 100
};

/// Cuts `stock` along the run. Shank and holder are held against what is left when they get there: never later than
/// `step_mm` of motion when material is that near, and not before they can reach any when it is not.
/// Property: the report does not depend on the number of threads. Requires: step_mm > 0, tolerance_mm > 0.
StockReport run_through_stock(Stock& stock, const kinematics::Tool& tool, std::span<const SweptPose> poses,
                              const StockRunOptions& options);

}  // namespace volute::sim

// Samples axis by axis: what is the same arithmetic for every cycle then fills whole registers.
#pragma once

#include <array>
#include <cstddef>

#include <Eigen/Core>

#include "kinematics/model/machine.hpp"

namespace volute::sim {

/// A lot of neighbouring cycles, small enough to stay near the processor; the first `count` rows are valid.
struct SampleColumns {
  static constexpr int size = 64;
  using Column = Eigen::Array<double, size, 1>;
  using Columns = std::array<Column, kinematics::axis_count>;
  int count = 0;
  Columns position, velocity, acceleration, jerk;
  Columns error;  ///< how far each axis stands behind its command
};

}  // namespace volute::sim

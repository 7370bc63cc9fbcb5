// Five axes as the processor likes them.
#pragma once

#include "kinematics/model/machine.hpp"

namespace volute::sim {

/// Calls `f<first, count>()` for the first four axes, which fill whole registers, and for the fifth: segments of that
/// size are vectorised, five numbers in a row are not. The results are the same to the last bit.
template <typename F>
void for_lanes(const F& f) {
  static_assert(kinematics::axis_count == 5);
  f.template operator()<0, 4>();
  f.template operator()<4, 1>();
}

}  // namespace volute::sim

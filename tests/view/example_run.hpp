// A run made from formulas, for pictures and pages: a wavy disc with a hole, a spiral over it, a machine with two
// rotaries in the head, one spike in the speed of A, one collision. No planner, no simulator.
#pragma once

#include "view/run_view.hpp"

namespace volute::view {

struct ExampleSize {
  int samples = 4000;
  int blocks = 500;
  int mesh_rings = 40;  ///< times 4 sectors each
};

/// The sample of the spike in the speed of A.
int spike_sample(const ExampleSize& size);
/// Line of the program that a sample belongs to.
int line_of_sample(const ExampleSize& size, int sample);
constexpr double spike_velocity_rad_s = 3.0;

RunView example_run(const ExampleSize& size);

}  // namespace volute::view

// Random states of every shipped machine, for tests that hold drive forces against another program.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <random>
#include <vector>

#include "kinematics/model/machine.hpp"
#include "sim/loads.hpp"

namespace volute::sim::test {

/// Calls check(machine, axes of one side from the base outwards, sign, q, velocity, acceleration, load) for `count`
/// seeded states a machine and for both sides; a table's axes come with sign -1, as they move their body against the
/// tool's motion.
template <typename Check>
void for_both_sides_of_every_machine(int count, unsigned seed, const Check& check) {
  using kinematics::AxisVector;
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<> uniform(-1.0, 1.0);
  int machines = 0;
  for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(VOLUTE_SOURCE_DIR) / "machines")) {
    if (entry.path().extension() != ".toml") continue;
    const auto m = kinematics::load_machine(entry.path());
    ASSERT_TRUE(m) << m.error().message;
    ++machines;
    const std::vector<int> head(m->chain.begin() + m->table_axes, m->chain.end());
    std::vector<int> table(m->chain.begin(), m->chain.begin() + m->table_axes);
    std::reverse(table.begin(), table.end());
    for (int i = 0; i < count; ++i) {
      SCOPED_TRACE(testing::Message() << m->name << ", seed " << seed << ", state " << i);
      AxisVector q, v, a;
      for (int k = 0; k < 5; ++k) {
        const double size = k < 3 ? 200.0 : 2.0;
        q[k] = size * uniform(random);
        v[k] = size * uniform(random);
        a[k] = 5 * size * uniform(random);
      }
      const AxisVector load = drive_forces(*m, q, v, a);
      check(*m, head, 1.0, q, v, a, load);
      check(*m, table, -1.0, q, v, a, load);
    }
  }
  EXPECT_GT(machines, 0);
}

}  // namespace volute::sim::test

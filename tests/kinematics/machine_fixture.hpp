// Every machine file of the repository, loaded once, and seeded random poses.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "kinematics/model/control.hpp"
#include "kinematics/model/machine.hpp"
#include "tests/cases.hpp"

namespace volute::kinematics::testing {

inline std::filesystem::path machines_folder() { return std::filesystem::path(VOLUTE_SOURCE_DIR) / "machines"; }

inline std::vector<std::string> machine_names() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(machines_folder()))
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

inline Machine machine_named(const std::string& name) {
  auto machine = load_machine(machines_folder() / (name + ".toml"));
  if (!machine) ADD_FAILURE() << machine.error().message;
  return machine.value_or(Machine{});
}

constexpr unsigned seed = 20161;

class Random {
 public:
  explicit Random(unsigned offset = 0) : engine_(seed + offset) {}
  double uniform(double least, double greatest) {
    return std::uniform_real_distribution<double>(least, greatest)(engine_);
  }
  /// Uniform on the sphere (Archimedes: z is uniform).
  Vec3 direction() {
    const double z = uniform(-1.0, 1.0), azimuth = uniform(-std::numbers::pi, std::numbers::pi),
                 across = std::sqrt(1.0 - z * z);
    return Vec3(across * std::cos(azimuth), across * std::sin(azimuth), z).normalized();
  }
  Vec3 point(double size_mm) {
    return {uniform(-size_mm, size_mm), uniform(-size_mm, size_mm), uniform(-size_mm, size_mm)};
  }
  AxisVector positions(const Machine& machine) {
    AxisVector q;
    for (int i = 0; i < axis_count; ++i) {
      const Axis& axis = machine.axes[static_cast<std::size_t>(i)];
      q[i] = uniform(axis.travel_min.value_or(-10.0), axis.travel_max.value_or(10.0));
    }
    return q;
  }

 private:
  std::mt19937 engine_;
};

inline double angle_between(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

}  // namespace volute::kinematics::testing

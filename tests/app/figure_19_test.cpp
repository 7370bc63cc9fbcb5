// The example of [Sun2016] Figs. 19 and 20 with every smoothing: what falls, and what cannot.
#include <gtest/gtest.h>

#include <array>
#include <map>
#include <nlohmann/json.hpp>

#include "tests/app/run_volute.hpp"

namespace volute::app_test {
namespace {

using Json = nlohmann::ordered_json;

Json orientation_of(const std::string& smoothing) {
  const auto folder = scratch_folder("figure-19-" + smoothing);
  std::string job = text_of(VOLUTE_SOURCE_DIR "/examples/figure-19.toml");
  const std::string key = "smoothing = \"acceleration\"", parts = "\"parts/";
  job.replace(job.find(key), key.size(), "smoothing = \"" + smoothing + "\"");
  for (std::size_t at = job.find(parts); at != std::string::npos; at = job.find(parts, at + 1))
    job.replace(at, parts.size(), "\"" VOLUTE_SOURCE_DIR "/examples/parts/");
  write_text(folder / "job.toml", job);
  const Outcome outcome = run_volute("plan job.toml --out out --json", folder);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  return Json::parse(outcome.out).at("orientation");
}

constexpr std::array quantities = {"velocity_max", "acceleration_max", "jerk_max"};

// From swinging only to dodge to velocity to acceleration the acceleration of A falls, and its velocity from the first
// to both others: velocity runs straight from pin to pin, and no curve through the same pins can be slower throughout
// (mean value theorem), so acceleration may be faster there, and is by less than a tenth. Corridor is in none of the
// six peaks above acceleration.
TEST(Figure19, PeaksFallFromMethodToMethod) {
  std::map<std::string, Json> by;
  for (const char* smoothing : {"none", "velocity", "acceleration", "corridor"})
    by[smoothing] = orientation_of(smoothing);
  const auto peak = [&](const char* smoothing, const char* axis, const char* quantity) {
    return by[smoothing].at(axis).at(quantity).get<double>();
  };
  EXPECT_GT(peak("none", "A", "velocity_max"), 5.0 * peak("velocity", "A", "velocity_max"));
  EXPECT_GT(peak("none", "A", "velocity_max"), 5.0 * peak("acceleration", "A", "velocity_max"));
  EXPECT_GE(peak("acceleration", "A", "velocity_max"), peak("velocity", "A", "velocity_max"));
  EXPECT_LT(peak("acceleration", "A", "velocity_max"), 1.1 * peak("velocity", "A", "velocity_max"));
  EXPECT_GT(peak("none", "A", "acceleration_max"), peak("velocity", "A", "acceleration_max"));
  EXPECT_GT(peak("velocity", "A", "acceleration_max"), peak("acceleration", "A", "acceleration_max"));
  for (const char* axis : {"A", "C"}) {
    for (const char* quantity : quantities)
      EXPECT_LE(peak("corridor", axis, quantity), peak("acceleration", axis, quantity) * (1.0 + 1e-6))
          << axis << " " << quantity;
  }
  for (const char* smoothing : {"velocity", "acceleration", "corridor"}) {
    EXPECT_EQ(by[smoothing].at("interferences_after").get<int>(), 0) << smoothing;
    EXPECT_EQ(by[smoothing].at("pins").get<int>(), 5) << smoothing;
  }
}

}  // namespace
}  // namespace volute::app_test

// The model of LinuxCNC's planner against the real one: data recorded by scripts/compare-with-linuxcnc --record.
#include <gtest/gtest.h>

#include <map>

#include "geometry/file.hpp"
#include "geometry/number_text.hpp"
#include "tests/sim/controller/linuxcnc/model_run.hpp"

namespace volute::sim {
namespace {

using namespace test;

struct Expected {
  std::int64_t cycles = 0;
  std::vector<std::pair<std::size_t, std::array<double, 5>>> positions;
};

const std::string folder = std::string(VOLUTE_SOURCE_DIR) + "/tests/sim/controller/linuxcnc/";

std::vector<std::string> split(const std::string& text, char at) {
  std::vector<std::string> parts;
  std::size_t from = 0;
  for (std::size_t k = 0; k <= text.size(); ++k) {
    if (k < text.size() && text[k] != at) continue;
    parts.push_back(text.substr(from, k - from));
    from = k + 1;
  }
  return parts;
}

std::map<std::string, Expected> read_expected() {
  std::map<std::string, Expected> programs;
  const auto bytes = geometry::read_file(folder + "expected.csv");
  if (!bytes) return programs;
  for (const std::string& line : split(*bytes, '\n')) {
    if (line.empty() || line[0] == '#' || line.rfind("program,", 0) == 0) continue;
    const auto words = split(line, ',');
    Expected& expected = programs[words[0]];
    expected.cycles = *geometry::parse_integer(words[1]);
    std::array<double, 5> position{};
    for (std::size_t i = 0; i < position.size(); ++i) position[i] = *geometry::parse_number(words[3 + i]);
    expected.positions.emplace_back(static_cast<std::size_t>(*geometry::parse_integer(words[2])), position);
  }
  return programs;
}

TEST(LinuxcncPlanner, TakesTheRealControlsCyclesAndPositions) {
  const auto programs = read_expected();
  ASSERT_GE(programs.size(), 30U);
  double apart = 0.0;
  for (const auto& [name, expected] : programs) {
    SCOPED_TRACE(name);
    const auto text = geometry::read_file(folder + "programs/" + name + ".ngc");
    ASSERT_TRUE(text);
    const auto run = run_on_model(*text);
    ASSERT_TRUE(run) << run.error().message;
    EXPECT_EQ(run->cycles, expected.cycles);
    for (const auto& [at, position] : expected.positions) {
      ASSERT_LT(at, run->positions.size());
      for (std::size_t i = 0; i < position.size(); ++i) {
        apart = std::max(apart, std::abs(run->positions[at][i] - position[i]));
        EXPECT_NEAR(run->positions[at][i], position[i], 1e-6) << "cycle " << at << " axis " << i;
      }
    }
  }
  std::printf("%zu programs, greatest difference of a position %.1e mm or deg\n", programs.size(), apart);
}

// More blocks than the queue holds, each 0.1 mm long: 1.02 servo cycles a block at least, whatever F says.
TEST(LinuxcncPlanner, LongProgramsOfShortBlocksRunAtOneBlockACycle) {
  std::string text = "G21 G90 G64 P0.01 Q0\nG1 F60000\n";
  for (int k = 1; k <= 4000; ++k) text += "X" + geometry::fixed_text(0.1 * k, 3) + "\n";
  const auto run = run_on_model(text + "M2\n");
  ASSERT_TRUE(run) << run.error().message;
  EXPECT_NEAR(run->positions.back()[0], 400.0, 1e-9);
  EXPECT_GE(run->cycles, 4080);
  EXPECT_LE(run->cycles, 4080 + 250);
}

// Dwells: the axes rest, then go on.
TEST(LinuxcncPlanner, DwellsBetweenMoves) {
  const auto without = run_on_model("G21 G90 G61.1\nG1 X10 F3000\nX0\nM2\n");
  const auto with = run_on_model("G21 G90 G61.1\nG1 X10 F3000\nG4 P0.5\nX0\nM2\n");
  ASSERT_TRUE(without && with);
  EXPECT_NEAR(static_cast<double>(with->cycles - without->cycles), 500.0, 5.0);
}

}  // namespace
}  // namespace volute::sim

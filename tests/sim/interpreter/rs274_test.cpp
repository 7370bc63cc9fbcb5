// Random programs read by LinuxCNC's own interpreter (rs274, Debian package linuxcnc-uspace) and by ours: the same
// motions to its 4 decimals.
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

#include "geometry/number_text.hpp"
#include "tests/cases.hpp"
#include "tests/sim/interpreter/program_writer.hpp"
#include "tests/sim/interpreter/reading.hpp"

namespace volute::sim::test {
namespace {

/// Where our reader says that the text does not tell.
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// One canonical motion in mm and degrees, in the coordinates of the setup.
struct Canon {
  MotionKind kind = MotionKind::line;
  std::array<double, 5> end{};     // X Y Z A C
  std::array<double, 2> centre{};  // in the plane
  int turns = 0;                   // signed, of an arc
  double feed = 0.0;               // as set last, mm/min; of a dwell: seconds
  double rotary_feed = 0.0;        // as set last, deg/min
  double tolerance = 0.0;          // half of the last digit printed, of the word and of its shifts, in mm
};

std::vector<double> numbers_of(const std::string& call) {
  std::vector<double> out;
  std::string list = call.substr(call.find('(') + 1);
  for (char& c : list)
    if (c == ',' || c == ')') c = ' ';
  std::istringstream in(list);
  std::string item;
  while (in >> item)
    if (const auto value = geometry::parse_number(item)) out.push_back(*value);
  return out;
}

class CanonReader {
 public:
  std::vector<Canon> read(std::istream& in) {
    std::string line;
    while (std::getline(in, line)) {
      const auto dots = line.find("N..... ");
      if (dots != std::string::npos) call(line.substr(dots + 7));
    }
    return out_;
  }

 private:
  void call(const std::string& text) {
    const auto v = numbers_of(text);
    if (text.starts_with("USE_LENGTH_UNITS")) unit_ = text.find("INCHES") != std::string::npos ? 25.4 : 1.0;
    if (text.starts_with("SET_FEED_RATE")) feed_ = {v[0] * unit_, v[0]};
    if (text.starts_with("SET_G92_OFFSET"))
      shift_ = {v[0] * unit_, v[1] * unit_, v[2] * unit_, v[3], v[5]}, shift_unit_ = unit_;
    if (text.starts_with("USE_TOOL_LENGTH_OFFSET"))
      tool_ = {v[0] * unit_, v[1] * unit_, v[2] * unit_, 0.0, 0.0}, tool_unit_ = unit_;
    if (text.starts_with("SELECT_PLANE"))
      plane_ = text.find("XZ") != std::string::npos ? 1 : text.find("YZ") != std::string::npos ? 2 : 0;
    if (text.starts_with("STRAIGHT_TRAVERSE") || text.starts_with("STRAIGHT_FEED"))
      straight(text.starts_with("STRAIGHT_FEED") ? MotionKind::line : MotionKind::rapid, v);
    if (text.starts_with("ARC_FEED")) arc(v);
    if (text.starts_with("DWELL")) out_.push_back({MotionKind::dwell, {}, {}, 0, v[0], 0.0, 0.0});
  }
  void straight(MotionKind kind, const std::vector<double>& v) {
    Canon c{kind,
            {v[0] * unit_, v[1] * unit_, v[2] * unit_, v[3], v[5]},
            {},
            0,
            feed_[0],
            feed_[1],
            0.6e-4 * (unit_ + shift_unit_ + tool_unit_)};
    add(c);
  }
  void arc(const std::vector<double>& v) {
    const std::array<std::array<std::size_t, 3>, 3> axes{{{0, 1, 2}, {2, 0, 1}, {1, 2, 0}}};
    const auto& in = axes[static_cast<std::size_t>(plane_)];
    Canon c{MotionKind::arc,
            {},
            {v[2] * unit_ + zero(in[0]), v[3] * unit_ + zero(in[1])},
            static_cast<int>(v[4]),
            feed_[0],
            feed_[1],
            0.6e-4 * (unit_ + shift_unit_ + tool_unit_)};
    c.end[in[0]] = v[0] * unit_;
    c.end[in[1]] = v[1] * unit_;
    c.end[in[2]] = v[5] * unit_;
    c.end[3] = v[6];
    c.end[4] = v[8];
    add(c);
  }
  [[nodiscard]] double zero(std::size_t i) const { return shift_[i] + tool_[i]; }
  void add(Canon c) {
    for (std::size_t i = 0; i < 5; ++i) c.end[i] += zero(i);
    out_.push_back(c);
  }

  std::vector<Canon> out_;
  double unit_ = 1.0;
  std::array<double, 2> feed_{};  // in mm/min, and as printed
  std::array<double, 5> shift_{}, tool_{};
  double shift_unit_ = 1.0, tool_unit_ = 1.0;
  int plane_ = 0;
};

bool rs274_installed() { return std::system("command -v rs274 >/dev/null 2>&1") == 0; }

/// Status 0 and the canonical motions; nothing: rs274 refused the program.
std::optional<std::vector<Canon>> run_rs274(const std::string& text, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "p.ngc") << text;
  std::ofstream(folder / "tool.tbl") << "T1 P1 Z0 D10\n";
  std::ofstream(folder / "params.var");
  const std::string command =
      "cd '" + folder.string() + "' && HOME=. rs274 -g -n 2 -t tool.tbl -v params.var p.ngc >canon.txt 2>err.txt";
  const bool accepted = std::system(command.c_str()) == 0;
  std::ifstream in(folder / "canon.txt");
  auto out = CanonReader().read(in);
  std::filesystem::remove_all(folder);
  if (!accepted) return std::nullopt;
  return out;
}

/// Motions without length, which the two write differently around drilling, are left out.
std::vector<Canon> without_still(const std::vector<Canon>& in) {
  std::vector<Canon> out;
  std::array<double, 5> at{};
  for (const Canon& c : in) {
    double way = 0.0;
    for (std::size_t i = 0; i < 5; ++i)
      if (!std::isnan(c.end[i])) way = std::max(way, std::isnan(at[i]) ? 1.0 : std::abs(c.end[i] - at[i]));
    const bool still = (c.kind == MotionKind::line || c.kind == MotionKind::rapid) && way < 2e-3;
    if (!still) out.push_back(c);
    if (c.kind != MotionKind::dwell) at = c.end;
  }
  return out;
}

std::vector<Canon> ours(const Reading& program) {
  std::vector<Canon> out;
  for (const MotionBlock& block : program.blocks) {
    Canon c{block.kind, {}, {}, 0, block.dwell_s, 0.0, 0.0};
    if (block.kind == MotionKind::dwell) {
      out.push_back(c);
      continue;
    }
    for (std::size_t i = 0; i < 3; ++i)
      c.end[i] = block.xyz_known[i] || block.xyz_programmed[i] ? block.xyz_mm[static_cast<Eigen::Index>(i)] : unknown;
    c.end[3] = block.rotary_rad[0] / rad_per_deg;
    c.end[4] = block.rotary_rad[1] / rad_per_deg;
    // Under inverse time rs274 prints a speed of its own; the text's F is compared by the other tests.
    if (block.feed_mode == FeedMode::per_minute)
      (block.rotary_only ? c.rotary_feed : c.feed) = block.feed * 60.0 / (block.rotary_only ? rad_per_deg : 1.0);
    if (block.kind == MotionKind::arc) {
      const int normal = block.plane_normal.z() != 0.0 ? 2 : block.plane_normal.y() != 0.0 ? 1 : 0;
      c.centre = {block.centre_mm[(normal + 1) % 3], block.centre_mm[(normal + 2) % 3]};
      const double turns = std::abs(block.sweep_rad) / (2.0 * std::numbers::pi);
      c.turns = static_cast<int>(std::ceil(turns - 1e-9)) * (block.sweep_rad > 0.0 ? 1 : -1);
    }
    out.push_back(c);
  }
  return out;
}

void expect_same(const std::vector<Canon>& theirs, const std::vector<Canon>& mine) {
  ASSERT_EQ(theirs.size(), mine.size());
  for (std::size_t k = 0; k < mine.size(); ++k) {
    ASSERT_EQ(theirs[k].kind, mine[k].kind) << "motion " << k;
    if (mine[k].kind == MotionKind::dwell) {
      ASSERT_NEAR(theirs[k].feed, mine[k].feed, 1e-4) << "motion " << k;
      continue;
    }
    for (std::size_t i = 0; i < 5; ++i) {
      if (std::isnan(mine[k].end[i])) continue;
      ASSERT_NEAR(theirs[k].end[i], mine[k].end[i], theirs[k].tolerance) << "motion " << k << " axis " << i;
    }
    if (mine[k].kind == MotionKind::arc) {
      ASSERT_EQ(theirs[k].turns, mine[k].turns) << "motion " << k;
      for (std::size_t i = 0; i < 2; ++i)
        ASSERT_NEAR(theirs[k].centre[i], mine[k].centre[i], theirs[k].tolerance) << "motion " << k;
    }
    if (mine[k].kind == MotionKind::rapid) continue;
    if (mine[k].feed > 0.0) {
      ASSERT_NEAR(theirs[k].feed, mine[k].feed, 0.002 + 1e-6 * mine[k].feed) << "motion " << k;
    }
    if (mine[k].rotary_feed > 0.0) {
      ASSERT_NEAR(theirs[k].rotary_feed, mine[k].rotary_feed, 1e-4) << "motion " << k;
    }
  }
}

TEST(Rs274, RandomProgramsGiveTheSameMotions) {
  if (!rs274_installed())
    GTEST_SKIP() << "rs274 (Debian package linuxcnc-uspace) is not installed: nothing was compared";
  const auto folder = std::filesystem::temp_directory_path() / ("volute-rs274-" + std::to_string(getpid()));
  int compared = 0;
  std::size_t motions = 0;
  for (int i = 0; i < cases(25); ++i) {
    const auto seed = static_cast<unsigned>(1000 + i);
    SCOPED_TRACE("seed " + std::to_string(seed));
    const std::string text = ProgramWriter(seed).write();
    const auto theirs = run_rs274(text, folder);
    const auto mine = read_with_tool(text, 0.0);
    ASSERT_EQ(!theirs, mine.error.has_value()) << mine.message() << "\n" << text;
    if (!theirs) continue;
    expect_same(without_still(*theirs), without_still(ours(mine)));
    if (HasFatalFailure()) FAIL() << text;
    ++compared;
    motions += mine.blocks.size();
  }
  std::printf("%d programs with %zu motions compared\n", compared, motions);
  EXPECT_GT(compared, cases(25) / 2);
}

TEST(Rs274, AcceptsThePostsProgramAndMovesAlike) {
  if (!rs274_installed())
    GTEST_SKIP() << "rs274 (Debian package linuxcnc-uspace) is not installed: nothing was compared";
  std::stringstream text;
  text << std::ifstream(std::filesystem::path(VOLUTE_SOURCE_DIR) / "tests/post/golden/ac-head-linuxcnc.txt").rdbuf();
  const std::string program = text.str();
  const auto folder = std::filesystem::temp_directory_path() / ("volute-rs274-post-" + std::to_string(getpid()));
  const auto theirs = run_rs274(program, folder);
  const auto mine = read(program, kinematics::DialectFamily::linuxcnc);
  ASSERT_TRUE(theirs);
  ASSERT_FALSE(mine.error) << mine.message();
  EXPECT_GT(mine.blocks.size(), 10U);
  auto moves = mine;
  std::erase_if(moves.blocks, [](const MotionBlock& block) { return block.kind == MotionKind::stop; });
  expect_same(without_still(*theirs), without_still(ours(moves)));
}

TEST(Rs274, RefusesTheSamePrograms) {
  if (!rs274_installed())
    GTEST_SKIP() << "rs274 (Debian package linuxcnc-uspace) is not installed: nothing was compared";
  const auto folder = std::filesystem::temp_directory_path() / ("volute-rs274-bad-" + std::to_string(getpid()));
  const std::string start = "G21 G90\nG0 X0 Y0 Z0 A0 C0\n";
  for (const char* text : {"g1 x1\nm2\n",
                           "f100\ng94\ng1 x1\nm2\n",
                           "g93 g1 x1\nm2\n",
                           "g0 g1 x1\nm2\n",
                           "g0 x1 x2\nm2\n",
                           "g0 x\nm2\n",
                           "f9 g2 x10 y0 i5.016\nm2\n",
                           "f9 g2 x10 y0 i5.01\nm2\n",
                           "f9 g2 x10 y0 r4.99\nm2\n",
                           "f9 g2 x10 y0 r4.9989\nm2\n",
                           "g0 x1\n",
                           "g0 x1\n%\n",
                           "g99.9\nm2\n",
                           "g80 x1\nm2\n",
                           "f9 g81 x0 y0 z-1 r0 a90\nm2\n",
                           "g0 x[1/0]\nm2\n",
                           "g0 x[sqrt[-1]]\nm2\n",
                           "o1 call\nm2\n",
                           "g0 x1 (open\nm2\n",
                           "#1=5 g0 x#1\nm2\n",
                           "g53 g2 x1 y1 i1\nm2\n",
                           "g91 g53 g0 x1\nm2\n",
                           "g4\nm2\n",
                           "f-5\nm2\n",
                           "g0 x#<none>\nm2\n",
                           "g92\nm2\n",
                           "f9 g2 x0 y0 r5\nm2\n",
                           "f9 g3 x1\nm2\n",
                           "f9 g18 g2 x1 j1\nm2\n",
                           "g0 x1 p2\nm2\n",
                           "g10 l20 p1 x5\nm2\n"}) {
    const bool theirs = run_rs274(start + text, folder).has_value();
    const auto mine = read(start + text, kinematics::DialectFamily::linuxcnc);
    EXPECT_EQ(theirs, !mine.error) << text << mine.message();
  }
}

}  // namespace
}  // namespace volute::sim::test

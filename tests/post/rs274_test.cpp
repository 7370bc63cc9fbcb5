// LinuxCNC's own interpreter, where it is installed: it must accept our programs, and its canonical moves must be ours.
#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "geometry/file.hpp"
#include "tests/post/example_paths.hpp"
#include "tests/post/sample_paths.hpp"

namespace volute::post {
namespace {

namespace fs = std::filesystem;
using Move = std::array<double, 6>;  // X Y Z A B C, mm and degrees

struct Interpreted {
  int status = -1;
  std::string canon, errors;
};

Interpreted run_rs274(const std::string& program) {
  const fs::path folder = fs::path(::testing::TempDir()) / ("volute_rs274_" + std::to_string(::getpid()));
  fs::create_directories(folder);
  std::ofstream(folder / "tool.tbl") << "T1 P1 Z10 D10 ;tool\n";
  std::ofstream(folder / "params.var") << "";
  // What a configuration with five-axis kinematics defines: M428 and M429 switch them, as its xyzac-trt sample does.
  std::ofstream(folder / "machine.ini")
      << "[EMC]\nVERSION = 1.1\n[RS274NGC]\nSUBROUTINE_PATH = .\n"
         "REMAP=M428 modalgroup=10 ngc=tcp_on\nREMAP=M429 modalgroup=10 ngc=tcp_off\n";
  for (const std::string name : {"tcp_on", "tcp_off"})
    std::ofstream(folder / (name + ".ngc")) << "o<" << name << "> sub\no<" << name << "> endsub\nM2\n";
  std::ofstream(folder / "program.ngc") << program;
  const std::string in =
      "cd '" + folder.string() + "' && HOME='" + folder.string() +
      "' rs274 -g -n 2 -i machine.ini -t tool.tbl -v params.var program.ngc > canon.txt 2> errors.txt";
  Interpreted run;
  run.status = std::system(in.c_str());
  run.canon = geometry::read_file(folder / "canon.txt").value_or("");
  run.errors = geometry::read_file(folder / "errors.txt").value_or("");
  fs::remove_all(folder);
  return run;
}

std::vector<Move> canonical_moves(const std::string& canon) {
  std::vector<Move> moves;
  std::istringstream in(canon);
  for (std::string line; std::getline(in, line);) {
    if (line.find("STRAIGHT_") == std::string::npos) continue;
    std::istringstream numbers(line.substr(line.find('(') + 1));
    Move move{};
    char comma = 0;
    for (double& value : move) numbers >> value >> comma;
    moves.push_back(move);
  }
  return moves;
}

/// What was planned, in program coordinates.
std::vector<Move> planned_moves(const PostRequest& request, const kinematics::Profile& profile,
                                const PostResult& result) {
  const auto zero = kinematics::program_zero(profile.machine, request.setup, request.tool.gauge_length_mm);
  std::vector<Move> moves;
  for (const kinematics::AxisPathPoint& point : result.axis_path.points) {
    const kinematics::AxisVector q = point.q - zero;
    Move move{q[0], q[1], q[2], 0.0, 0.0, 0.0};
    if (profile.control.tcp && !point.machine_move)
      for (std::size_t i = 0; i < 3; ++i) move[i] = point.pose.tip_P_mm[static_cast<Eigen::Index>(i)];
    for (int i = 3; i < kinematics::axis_count; ++i)
      move[static_cast<std::size_t>(3 + profile.machine.axes[static_cast<std::size_t>(i)].letter - 'A')] =
          geometry::Angle::radians(q[i]).degrees();
    moves.push_back(move);
  }
  return moves;
}

void expect_accepted_and_moves_as_planned(const PostRequest& request, const kinematics::Profile& profile) {
  const auto result = post(request, profile);
  ASSERT_TRUE(result.has_value()) << result.error().message;
  const Interpreted run = run_rs274(result->text);
  EXPECT_EQ(run.status, 0) << run.errors;
  const std::vector<Move> theirs = canonical_moves(run.canon), ours = planned_moves(request, profile, *result);
  ASSERT_GE(theirs.size(), ours.size());
  ASSERT_GT(ours.size(), 180u);
  // Theirs has the way to the first point before it and the way home behind; every planned point must be there, in
  // order.
  std::size_t at = 0;
  for (std::size_t i = 0; i < ours.size(); ++i) {
    const auto same = [&](const Move& move) {
      double worst = 0.0;
      for (std::size_t k = 0; k < 6; ++k) worst = std::max(worst, std::abs(move[k] - ours[i][k]));
      return worst < 1.01e-4;  // their 4 decimals and ours
    };
    while (at < theirs.size() && !same(theirs[at])) ++at;
    ASSERT_LT(at, theirs.size()) << "planned point " << i << " is not among the canonical moves";
  }
}

class Rs274 : public ::testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    if (std::system("command -v rs274 > /dev/null 2>&1") != 0)
      GTEST_SKIP() << "rs274 is not installed (package linuxcnc-uspace): LinuxCNC's interpreter was not asked";
  }
};

TEST_P(Rs274, AcceptsOurProgramAndMovesWhereWePlanned) {
  const kinematics::Profile profile = testing::profile_named(GetParam());
  PostRequest request = testing::request_for(testing::dome_spiral(3, 60));
  const bool small = profile.machine.name == "linuxcnc-xyzac";
  if (small || profile.machine.name == "ab-head") request = testing::request_for(testing::ring(3.0, 60));
  if (small) request.setup.part_in_machine.translation() = geometry::Vec3(0, 0, -110);
  expect_accepted_and_moves_as_planned(request, profile);
}

class Rs274OfExamples : public Rs274 {};

TEST_P(Rs274OfExamples, AcceptsTheProgramAndMovesWhereWePlanned) {
  for (const char* profile : {"ac-head-linuxcnc", "ac-head-linuxcnc-tcp"}) {
    SCOPED_TRACE(profile);
    expect_accepted_and_moves_as_planned(testing::example_request(GetParam()), testing::profile_named(profile));
  }
}

std::vector<std::string> linuxcnc_profiles() {
  const auto folder = std::filesystem::path(VOLUTE_SOURCE_DIR) / "machines";
  std::vector<std::string> names;
  const auto listed = kinematics::list_profiles(folder);
  for (const kinematics::ProfileName& name : *listed)
    if (kinematics::load_profile(folder, name.name)->control.family == kinematics::DialectFamily::linuxcnc)
      names.push_back(name.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(LinuxcncProfiles, Rs274, ::testing::ValuesIn(linuxcnc_profiles()),
                         [](const auto& instance) { return testing::identifier(instance.param); });
INSTANTIATE_TEST_SUITE_P(Examples, Rs274OfExamples, ::testing::ValuesIn(testing::example_names()),
                         [](const auto& instance) { return testing::identifier(instance.param); });

TEST(Rs274Alone, RefusesABrokenProgram) {
  // The check above can fail: with the F of an inverse-time block lost, the interpreter says so.
  if (std::system("command -v rs274 > /dev/null 2>&1") != 0)
    GTEST_SKIP() << "rs274 is not installed (package linuxcnc-uspace): LinuxCNC's interpreter was not asked";
  std::string text =
      post(testing::request_for(testing::dome_spiral(1, 12)), testing::profile_named("ac-head-linuxcnc"))->text;
  const std::size_t feed = text.find(" F", text.find("G93"));
  text.erase(feed, text.find('\n', feed) - feed);
  EXPECT_NE(run_rs274(text).status, 0);
}

}  // namespace
}  // namespace volute::post

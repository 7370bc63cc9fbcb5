// What every program must have, whatever the dialect: read back here by a few lines of its own.
#include <gmock/gmock.h>

#include <map>
#include <sstream>

#include "tests/post/sample_paths.hpp"

namespace volute::post {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

PostResult posted(const PostRequest& request, const kinematics::Profile& profile) {
  auto result = post(request, profile);
  if (!result) ADD_FAILURE() << profile.name << ": " << result.error().message;
  return result.value_or(PostResult{});
}

PostRequest request_on(const kinematics::Profile& profile, kinematics::ToolPath path) {
  PostRequest request = testing::request_for(std::move(path));
  if (profile.machine.name == "linuxcnc-xyzac") request.setup.part_in_machine.translation() = geometry::Vec3(0, 0, -80);
  return request;
}

// Last value of each single-letter word of a line ("X", "A"); A3= and TX keep their own names.
std::map<std::string, double> words_of(const std::string& line) {
  std::map<std::string, double> words;
  std::istringstream in(line);
  for (std::string token; in >> token;) {
    std::size_t name = token[0] == 'T' && token.size() > 1 && token[1] >= 'X' ? 2 : 1;
    if (token.size() > 2 && token[2] == '=') name = 3;
    try {
      words[token.substr(0, name)] = std::stod(token.substr(name));
    } catch (const std::exception&) {
    }
  }
  return words;
}

class EveryProfile : public ::testing::TestWithParam<std::string> {
 protected:
  kinematics::Profile profile = testing::profile_named(GetParam());
};

TEST_P(EveryProfile, PostsThePassWithinItsBlockLength) {
  const PostResult result = posted(request_on(profile, testing::short_pass()), profile);
  EXPECT_GT(result.blocks, 10);
  EXPECT_EQ(static_cast<std::size_t>(result.blocks), lines_of(result.text).size());
  for (const std::string& line : lines_of(result.text)) {
    EXPECT_LE(line.size(), static_cast<std::size_t>(profile.control.block_length_max)) << line;
    EXPECT_THAT(line, Not(HasSubstr("{"))) << "an unfilled field";
    EXPECT_THAT(line, Not(HasSubstr("  "))) << line;
    EXPECT_FALSE(line.empty() || line.back() == ' ') << line;
  }
}

TEST_P(EveryProfile, TheLastBlocksOfTheCutStandAtTheEndOfThePath) {
  // Words are modal: gathered over the program up to the line that leaves, they are the last pose within half a digit.
  const PostResult result = posted(request_on(profile, testing::short_pass()), profile);
  std::map<std::string, double> state;
  const auto lines = lines_of(result.text);
  std::size_t last_motion = 0;
  const std::string leave = !profile.control.tcp_off.empty() ? profile.control.tcp_off.front() : "G53";
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (lines[i].find(leave) != std::string::npos && i > 8) last_motion = i;
  for (std::size_t i = 0; i < last_motion; ++i)
    for (const auto& [word, value] : words_of(lines[i])) state[word] = value;
  const kinematics::AxisPathPoint& end = result.axis_path.points.back();
  const auto zero = kinematics::program_zero(profile.machine, request_on(profile, {}).setup,
                                             testing::request_for({}).tool.gauge_length_mm);
  for (int i = 0; i < 3; ++i) {
    const double expected = profile.control.tcp ? end.pose.tip_P_mm[i] : end.q[i] - zero[i];
    EXPECT_NEAR(state[std::string(1, "XYZ"[i])], expected, 0.5001 * std::pow(10.0, -profile.control.linear_decimals));
  }
  if (profile.control.orientation_words == kinematics::OrientationWords::vector) return;
  for (int i = 3; i < 5; ++i) {
    const std::string letter(1, profile.machine.axes[static_cast<std::size_t>(i)].letter);
    EXPECT_NEAR(state[letter], geometry::Angle::radians(end.q[i]).degrees(),
                0.5001 * std::pow(10.0, -profile.control.rotary_decimals));
  }
}

TEST_P(EveryProfile, IsThePureFunctionOfItsRequest) {
  const PostRequest request = request_on(profile, testing::short_pass());
  EXPECT_EQ(posted(request, profile).text, posted(request, profile).text);
}

INSTANTIATE_TEST_SUITE_P(Profiles, EveryProfile, ::testing::ValuesIn(testing::all_profiles()),
                         [](const auto& instance) { return testing::identifier(instance.param); });

TEST(Program, RotariesTurnBeforeTcpAndTheTopComesAfterIt) {
  const std::string text =
      posted(testing::request_for(testing::short_pass()), testing::profile_named("ac-head-fanuc")).text;
  const std::size_t turn = text.find("G0 A"), on = text.find("G43.4"), cut = text.find("G1 "), off = text.find("G49\n"),
                    top = text.rfind("G53 G0 Z0.000"), end = text.find("M30");
  EXPECT_LT(turn, on);
  EXPECT_LT(on, cut);
  EXPECT_LT(cut, off);
  EXPECT_LT(off, top);
  EXPECT_LT(top, end);
}

TEST(Program, InverseTimeIsTheFeedOverTheLength) {
  kinematics::ToolPath path;
  path.points = {testing::at({0, 0, 0}, 0, 0, kinematics::MoveKind::rapid),
                 testing::at({8, 0, 0}, 0, 0, kinematics::MoveKind::cut)};
  path.points[1].feed_mm_s = 4.0;  // 8 mm at 4 mm/s: 2 s, so F = 30 per minute
  EXPECT_THAT(posted(testing::request_for(path), testing::profile_named("ac-head-g93")).text,
              HasSubstr("G1 X8.0000 F30.000"));
}

TEST(Program, ABlockThatOnlyTurnsTakesTheRotarysOwnTime) {
  kinematics::Profile profile = testing::profile_named("ac-head-linuxcnc-tcp");
  kinematics::ToolPath path;
  path.points = {testing::at({0, 0, 0}, 30, -90, kinematics::MoveKind::rapid),
                 testing::at({0, 0, 0}, 30.05, -90, kinematics::MoveKind::cut)};
  // 0.05 deg at 180 deg/s: 1/3600 s, F = 216000 per minute, past the control's 99999.999.
  const PostResult result = posted(testing::request_for(path), profile);
  EXPECT_THAT(result.text, HasSubstr("F99999.999"));
  EXPECT_EQ(result.blocks_at_greatest_feed, 1);
}

TEST(Program, WithoutTcpPerMinuteFeedIsCountedAsTheControlCounts) {
  kinematics::Profile profile = testing::profile_named("ac-head-g93");
  profile.control.inverse_time = false;
  kinematics::ToolPath path;
  path.points = {testing::at({0, 0, 0}, 0, 0, kinematics::MoveKind::rapid),
                 testing::at({8, 0, 0}, 0, 0, kinematics::MoveKind::cut)};
  path.points[1].feed_mm_s = 4.0;
  EXPECT_THAT(posted(testing::request_for(path), profile).text, HasSubstr("G1 X8.0000 F240.000"));
}

TEST(Program, ShortestWayWordsStayWithinOneTurnAndNoStepReachesHalfATurn) {
  kinematics::Profile profile = testing::profile_named("ac-head-fanuc");
  profile.control.rotary_shortest_way = true;
  const PostResult result = posted(testing::request_for(testing::ring(3.0, 30)), profile);
  double before = 0.0, wound = 0.0;
  bool first = true;
  const auto lines = lines_of(result.text);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (i > 9 && lines[i].find("G49") != std::string::npos) break;  // the header has one too
    const auto words = words_of(lines[i]);
    if (!words.count("C")) continue;
    const double c = words.at("C");
    EXPECT_GE(c, 0.0);
    EXPECT_LT(c, 360.0 + 1e-9);
    if (!first) {
      EXPECT_LT(std::abs(std::remainder(c - before, 360.0)), 175.0);
      wound += std::remainder(c - before, 360.0);
    }
    before = c;
    first = false;
  }
  EXPECT_NEAR(wound, 3 * 360.0, 0.01);
}

TEST(Program, ShortestWayWordsAreNeverNegative) {
  kinematics::Profile profile = testing::profile_named("ac-head-siemens");
  kinematics::ToolPath path;
  path.points = {testing::at({0, 0, 50}, 20, 180, kinematics::MoveKind::rapid),
                 testing::at({0, 0, 40}, 20, 180, kinematics::MoveKind::approach)};
  EXPECT_THAT(posted(testing::request_for(path), profile).text, HasSubstr("A20.0000 C-90.0000"));
  profile.control.rotary_shortest_way = true;
  const std::string text = posted(testing::request_for(path), profile).text;
  EXPECT_THAT(text, HasSubstr("A20.0000 C270.0000"));
  EXPECT_THAT(text, Not(HasSubstr("C-")));
}

// Of two branches that turn the rotaries equally far the first is taken, whatever rounding says.
TEST(Program, EqualBranchesAreDecidedTheSameWayEverywhere) {
  for (const double azimuth_deg : {0.0, 180.0}) {  // C stands half way between its two places
    kinematics::ToolPath path;
    for (const double height : {50.0, 40.0})
      path.points.push_back(testing::at({0, 0, height}, 20, azimuth_deg, kinematics::MoveKind::rapid));
    const PostResult result = posted(testing::request_for(path), testing::profile_named("ac-head-fanuc"));
    EXPECT_GT(result.axis_path.points[0].q[3], 0.0) << azimuth_deg;
  }
}

TEST(Program, LongTurnsAreSplitForTheShortWay) {
  kinematics::Profile profile = testing::profile_named("ac-head-fanuc");
  profile.control.rotary_shortest_way = true;
  kinematics::ToolPath path;
  path.points = {testing::at({0, 0, 50}, 30, 0, kinematics::MoveKind::rapid),
                 testing::at({0, 0, 50}, 30, 179, kinematics::MoveKind::rapid)};
  const PostResult result = posted(testing::request_for(path), profile);
  for (std::size_t i = 1; i < result.axis_path.points.size(); ++i)
    EXPECT_LT(std::abs(result.axis_path.points[i].q[4] - result.axis_path.points[i - 1].q[4]), 3.0);
  EXPECT_GT(result.axis_path.points.size(), 2u);
}

TEST(Program, SourcesCountThePointsOfTheRequest) {
  for (const bool starts_rapid : {true, false}) {
    kinematics::ToolPath path = testing::ring(0.2, 20);
    if (starts_rapid) path.points.front().move = kinematics::MoveKind::rapid;
    const PostRequest request = testing::request_for(path);
    const PostResult result = posted(request, testing::profile_named("ac-head-fanuc"));
    int seen = 0;
    for (const kinematics::AxisPathPoint& point : result.axis_path.points) {
      if (point.source < 0) continue;
      EXPECT_EQ((point.pose.tip_P_mm - path.points.at(static_cast<std::size_t>(point.source)).pose.tip_P_mm).norm(),
                0.0);
      ++seen;
    }
    EXPECT_EQ(static_cast<std::size_t>(seen), path.points.size());
  }
}

TEST(Program, ErrorsNameThingAndRemedy) {
  const kinematics::Profile good = testing::profile_named("ac-head-fanuc");
  const auto code = [](const PostRequest& request, const kinematics::Profile& profile) {
    const auto result = post(request, profile);
    return result ? std::string("posted") : result.error().code;
  };
  EXPECT_EQ(code(testing::request_for({}), good), "post-no-motion");
  PostRequest no_feed = testing::request_for(testing::short_pass());
  no_feed.path.points[2].feed_mm_s = 0.0;
  EXPECT_EQ(code(no_feed, good), "post-feed");
  kinematics::Profile odd = good;
  odd.control.header.push_back("G99 {no_such_field}");
  EXPECT_EQ(code(testing::request_for(testing::short_pass()), odd), "post-field");
  kinematics::Profile narrow = good;
  narrow.control.block_length_max = 20;
  EXPECT_EQ(code(testing::request_for(testing::short_pass()), narrow), "post-block-too-long");
  PostRequest slow = testing::request_for(testing::short_pass());
  slow.path.points[2].feed_mm_s = 1e-6;
  EXPECT_EQ(code(slow, good), "post-feed-too-slow");
  PostRequest far = testing::request_for(testing::short_pass());
  far.path.points[2].pose.tip_P_mm.x() = 5000.0;
  EXPECT_EQ(code(far, good), "axis-out-of-travel");
}

}  // namespace
}  // namespace volute::post

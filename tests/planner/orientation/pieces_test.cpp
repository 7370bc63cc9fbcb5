// Pieces of one path: calm directions that agree, rapids that turn little.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "planner/orientation/branch.hpp"
#include "planner/orientation/orient.hpp"
#include "planner/orientation/turn_means.hpp"
#include "tests/planner/scenes.hpp"

namespace volute::planner {
namespace {

using geometry::Angle;
constexpr double full_turn = 2.0 * std::numbers::pi;

/// A flat spiral, 20 mm wide at the outside, of which each turn is cut from `from` to `to` (shares of a turn) only.
CcPath arcs(double turns, double from, double to, double tilt_of_surface_rad = 0.0) {
  const Eigen::AngleAxisd lean(tilt_of_surface_rad, Vec3::UnitX());
  CcPath path;
  for (int turn = 0; turn < static_cast<int>(turns); ++turn) {
    CcPiece piece;
    for (double share = from; share <= to + 1e-9; share += 0.005) {
      const double at = turn + share, radius = 20.0 - at;
      CcPoint point;
      point.point_P_mm = lean * Vec3(radius * std::cos(full_turn * at), radius * std::sin(full_turn * at), 0.0);
      point.normal_P = lean * Vec3::UnitZ();
      point.turn = at;
      piece.points.push_back(point);
    }
    path.pieces.push_back(piece);
  }
  return path;
}

OrientationOptions leaning() {
  OrientationOptions options;
  options.tilt = Angle::degrees(10.0);
  options.smoothing = Smoothing::acceleration;
  return options;
}

// On whole circles the lean cancels; over a part of each turn it is the mean along the arc, sin(half) / half of it.
TEST(TurnMeans, AreTheMeanAlongTheArcsOfATurn) {
  const double half = std::numbers::pi * 0.5;  // half a turn is cut
  const auto means = TurnMeans::of(arcs(8, 0.25, 0.75), leaning(), feed_window_mm);
  ASSERT_TRUE(means);
  const Vec3 mean = means->mean(4.5);
  const double lean = std::sin(10.0 * std::numbers::pi / 180.0);
  EXPECT_NEAR(mean.z(), std::cos(10.0 * std::numbers::pi / 180.0), 1e-9);
  EXPECT_NEAR(mean.head<2>().norm(), lean * std::sin(half) / half, 0.01);
  EXPECT_LT(mean.y(), -0.1);  // where half of each turn passes, on the left, the feed goes down
  EXPECT_NEAR((means->mean(3.5) - means->mean(4.5)).norm(), 0.0, 1e-3);
}

TEST(TurnMeans, AreOfSpiralsInPiecesAlone) {
  EXPECT_FALSE(TurnMeans::of(arcs(1, 0.0, 1.0), leaning(), feed_window_mm));
  CcPath falling = arcs(6, 0.0, 0.5);
  std::reverse(falling.pieces.begin(), falling.pieces.end());
  EXPECT_FALSE(TurnMeans::of(falling, leaning(), feed_window_mm));
  CcPath lines = arcs(6, 0.0, 0.5);
  for (CcPiece& piece : lines.pieces)
    for (CcPoint& point : piece.points) point.turn = 0.0;
  EXPECT_FALSE(TurnMeans::of(lines, leaning(), feed_window_mm));
}

TEST(Branches, OfEqualRowsTheOneNearestToThePieceBeforeStands) {
  const kinematics::Machine machine = testing::ac_head();
  RotaryChart chart(machine, {});
  std::vector<PlacedAxis> axes;
  for (int i = 0; i < 20; ++i) axes.push_back({chart.axis_P({0.3, 0.5 + 0.01 * i}), 1.0 * i, false});
  const auto alone = choose_branches(chart, axes);
  EXPECT_NEAR(*alone.at.front()[0], 0.3, 1e-9);
  chart.come_from({{-0.3, 0.6 + 0.5 * full_turn + 3.0 * full_turn}, 50.0});
  const auto after = choose_branches(chart, axes);
  EXPECT_NEAR(*after.at.front()[0], -0.3, 1e-9);
  EXPECT_NEAR(*after.at.front()[1], 0.5 + 3.5 * full_turn, 1e-9);
  EXPECT_NEAR((chart.axis_P({*after.at.back()[0], *after.at.back()[1]}) - axes.back().axis_P).norm(), 0.0, 1e-9);
}

/// The greatest turn of C between the end of a piece and the beginning of the next.
double turn_in_rapids(const CcPath& path, bool among_pieces) {
  Scene scene;
  const kinematics::Machine machine = testing::ac_head();
  const kinematics::Tool tool = testing::ball_tool();
  const Interference interference(scene, tool, nullptr, nullptr);
  const OrientationOptions options = leaning();
  const auto turns = TurnMeans::of(path, options, feed_window_mm);
  AmongPieces among{turns ? &*turns : nullptr, std::nullopt};
  std::optional<Rotaries> last;
  double most = 0.0;
  for (const CcPiece& piece : path.pieces) {
    const auto one = orient(piece, tool, machine, {}, interference, options, 5.0, among_pieces ? among : AmongPieces{});
    EXPECT_TRUE(one) << one.error().message;
    if (!one) return 1e9;
    const Rotaries first = one->rotaries_rad.front();
    if (last) most = std::max(most, std::abs(std::remainder(first[1] - (*last)[1], full_turn)));
    last = one->rotaries_rad.back();
    among.rotaries_before_rad = last;
    among.point_before_P_mm = piece.points.back().point_P_mm;
  }
  return most;
}

// Half of each turn is cut: by itself a piece leans along its own feed at both ends, and C turns back in each rapid.
TEST(Pieces, TheRapidsBetweenThemHardlyTurn) {
  const CcPath path = arcs(5, 0.25, 0.75);
  EXPECT_GT(turn_in_rapids(path, false), 0.5);
  EXPECT_LT(turn_in_rapids(path, true), 0.05);
}

// Where the calm direction is the pole itself C is free in every piece: it stays where the piece before left it.
TEST(Pieces, AtThePoleAFreeRotaryStaysWhereItStood) {
  const kinematics::Machine machine = testing::ac_head();
  const kinematics::Tool tool = testing::ball_tool();
  const Scene scene;
  const Interference interference(scene, tool, nullptr, nullptr);
  OrientationOptions options = leaning();
  options.tilt = Angle();
  AmongPieces among{nullptr, Rotaries{0.2, 1.3}};
  const auto one = orient(arcs(2, 0.0, 0.4).pieces[1], tool, machine, {}, interference, options, 5.0, among);
  ASSERT_TRUE(one) << one.error().message;
  for (const Rotaries& at : one->rotaries_rad) EXPECT_EQ(at[1], 1.3);
}

}  // namespace
}  // namespace volute::planner

// The allowed set at a CC point: its map against orientations tried one by one, and its picture.
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

#include "kinematics/model/control.hpp"
#include "planner/orientation_maps.hpp"
#include "tests/planner/scenes.hpp"
#include "tests/scenes/random_scene.hpp"
#include "view/cspace.hpp"

namespace volute::scenes {
namespace {

using geometry::Angle;
using geometry::Vec3;
using kinematics::CutterShape;
using kinematics::OrientationCell;
using kinematics::OrientationMap;
using kinematics::OrientationState;

/// One station on a sheet beside a wall, and everything that it takes to ask what is allowed there.
struct Question {
  planner::Scene scene;
  kinematics::Tool tool = planner::testing::ball_tool();
  planner::OrientationOptions options;
  kinematics::Machine machine = planner::testing::ac_head();
  kinematics::Setup setup;
  std::vector<planner::Station> stations;
  std::unique_ptr<planner::Interference> interference;
  std::unique_ptr<planner::RotaryChart> chart;
  std::unique_ptr<planner::AllowedSet> allowed;

  void ask(const Vec3& contact, const Vec3& normal) {
    planner::Station station;
    station.contact_P_mm = contact;
    station.normal_P = normal.normalized();
    station.feed_P = Vec3::UnitY().cross(station.normal_P).normalized();
    stations = {station};
    interference = std::make_unique<planner::Interference>(scene, tool, nullptr, nullptr);
    chart = std::make_unique<planner::RotaryChart>(machine, setup);
    allowed = std::make_unique<planner::AllowedSet>(stations, tool, *chart, *interference, options);
  }
};

std::unique_ptr<Question> beside_a_wall(const kinematics::Cutter& cutter) {
  auto question = std::make_unique<Question>();
  question->scene.part =
      planner::testing::sheet(-30, 30, -30, 30, 1.5, [](double x, double y) { return 0.01 * x * x + 0.005 * x * y; });
  question->scene.obstacles = {planner::testing::box(Vec3(12, -20, -5), Vec3(20, 20, 50))};
  question->scene.names = {"wall"};
  question->tool.cutter = cutter;
  question->options.tilt = Angle::degrees(15.0);
  question->options.tilt_max = Angle::degrees(65.0);
  question->ask(Vec3(0.0, 0.0, 0.0), Vec3(0.0, 0.0, 1.0));
  return question;
}

class CspaceMap : public ::testing::TestWithParam<kinematics::Cutter> {};
INSTANTIATE_TEST_SUITE_P(Cutters, CspaceMap,
                         ::testing::Values(kinematics::Cutter{CutterShape::ball, 3.0, 3.0, {}, 20.0, 2},
                                           kinematics::Cutter{CutterShape::bull, 5.0, 1.0, {}, 20.0, 2},
                                           kinematics::Cutter{CutterShape::flat, 4.0, 0.0, {}, 20.0, 2}));

/// Random orientations within random cells of one state, on both charts; returns how many of them were free.
void try_cells(const Question& question, const OrientationMap& map, OrientationState state, bool free) {
  const unsigned seed = 31;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  const auto& station = question.stations.front();
  const planner::FeedFrame frame = planner::feed_frame(station.feed_P, station.normal_P);
  for (const bool lean : {true, false}) {
    int tried = 0;
    for (const OrientationCell& cell : (lean ? map.lean : map.rotaries).cells) {
      if (cell.state != state || share(random) > 0.3) continue;
      ++tried;
      for (int k = 0; k < 6; ++k) {
        const double x = cell.least[0] + share(random) * (cell.greatest[0] - cell.least[0]);
        const double y = cell.least[1] + share(random) * (cell.greatest[1] - cell.least[1]);
        const Vec3 axis =
            lean ? planner::tool_axis(frame, Angle::radians(y), Angle::radians(x)) : question.chart->axis_P({y, x});
        ASSERT_EQ(question.interference->is_free_but_tip(question.allowed->pose(0, axis)), free)
            << "seed " << seed << (lean ? " lean " : " rotaries ") << x << " " << y;
      }
    }
    EXPECT_GT(tried, 10) << lean;
  }
}

TEST_P(CspaceMap, FreeCellsAreFreeThroughout) {
  const auto question = beside_a_wall(GetParam());
  const OrientationMap map = planner::orientation_map(*question->allowed, 0, {Angle::degrees(1.0)});
  try_cells(*question, map, OrientationState::free, true);
}

TEST_P(CspaceMap, BlockedCellsAreBlockedThroughout) {
  const auto question = beside_a_wall(GetParam());
  const OrientationMap map = planner::orientation_map(*question->allowed, 0, {Angle::degrees(1.0)});
  try_cells(*question, map, OrientationState::blocked, false);
  EXPECT_FALSE(map.blockers.empty());
}

TEST_P(CspaceMap, CellsCoverTheRangesOnce) {
  const auto question = beside_a_wall(GetParam());
  const OrientationMap map = planner::orientation_map(*question->allowed, 0, {Angle::degrees(2.0)});
  const double pi = std::numbers::pi;
  const auto area = [](const kinematics::OrientationChart& chart) {
    double sum = 0.0;
    for (const auto& cell : chart.cells) sum += (cell.greatest[0] - cell.least[0]) * (cell.greatest[1] - cell.least[1]);
    return sum;
  };
  EXPECT_NEAR(area(map.lean), 2.0 * pi * 0.5 * pi, 1e-9);
  EXPECT_NEAR(area(map.rotaries), 2.0 * pi * 4.0, 1e-9);
  std::mt19937 random(8);
  std::uniform_real_distribution<double> share(-1.0, 1.0);
  for (int n = 0; n < 300; ++n) {
    const double x = pi * share(random), y = 2.0 * share(random);
    int holding = 0;
    for (const auto& cell : map.rotaries.cells)
      holding += x >= cell.least[0] && x < cell.greatest[0] && y >= cell.least[1] && y < cell.greatest[1] ? 1 : 0;
    ASSERT_EQ(holding, 1) << x << " " << y;
  }
}

// A cylinder of radius 3 that ends 60 from the middle of the ball, each grown by the clearance 1, beside a wall 30 away
// from that middle, in the open: it touches where 61 a + 4 sqrt(1 - a^2) >= 30, a the axis's component towards the
// wall. On a hemisphere a is spread evenly over (-1, 1) (Archimedes), so the free share is (1 + a) / 2 at equality.
TEST(CspaceClosedForm, FreeShareOfAWallIsItsClosedForm) {
  Question question;
  question.scene.obstacles = {planner::testing::box(Vec3(30, -300, -300), Vec3(80, 300, 300))};
  question.tool.cutter = {CutterShape::ball, 3.0, 3.0, {}, 63.0, 2};
  question.tool.stick_out_mm = 63.0;
  question.tool.holder.clear();
  question.options.tilt_max = Angle::degrees(90.0);
  question.ask(Vec3(0, 0, -3), Vec3::UnitZ());
  const OrientationMap map = planner::orientation_map(*question.allowed, 0, {Angle::degrees(0.5)});
  double low = 0.0, high = 1.0;
  for (int k = 0; k < 60; ++k) {
    const double a = 0.5 * (low + high);
    (61.0 * a + 4.0 * std::sqrt(1.0 - a * a) < 30.0 ? low : high) = a;
  }
  EXPECT_NEAR(map.free_share, 0.5 * (1.0 + low), 0.003);
  EXPECT_NEAR(planner::allowed_share(*question.allowed, 0), 0.5 * (1.0 + low), 0.02);
  ASSERT_EQ(map.blockers.size(), 1u);
  EXPECT_EQ(map.blockers.front(), "cutter against obstacle 1");
}

/// Stations across the sheet towards the wall, in no order.
std::vector<planner::Station> towards_the_wall() {
  std::vector<planner::Station> stations;
  for (const double x : {-4.0, 6.0, -20.0, 1.0, 9.0, -9.0, 6.0, 3.5, -15.0, 7.5, -25.0, -12.0}) {
    planner::Station station;
    station.contact_P_mm = Vec3(x, 0.0, 0.01 * x * x);
    station.normal_P = Vec3(-0.02 * x, -0.005 * x, 1.0).normalized();
    station.feed_P = Vec3::UnitY().cross(station.normal_P).normalized();
    stations.push_back(station);
  }
  return stations;
}

struct NarrowPlaces {
  std::unique_ptr<Question> question = beside_a_wall({CutterShape::ball, 3.0, 3.0, {}, 20.0, 2});
  std::vector<planner::Station> stations = towards_the_wall();
  planner::AllowedSet allowed{stations, question->tool, *question->chart, *question->interference, question->options};
  std::vector<int> all = [this] {
    std::vector<int> indices(stations.size());
    std::iota(indices.begin(), indices.end(), 0);
    return indices;
  }();
};

TEST(Narrowest, NarrowestComeInTheOrderOfTheirShares) {
  const NarrowPlaces places;
  std::vector<int> order = places.all;
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
    return planner::allowed_share(places.allowed, a) < planner::allowed_share(places.allowed, b);
  });
  EXPECT_LT(planner::allowed_share(places.allowed, order.front()),
            0.8 * planner::allowed_share(places.allowed, order.back()));
  planner::NarrowestSearch search(places.allowed, places.all);
  std::vector<int> found;
  while (const auto next = search.next()) found.push_back(*next);
  EXPECT_EQ(found, order);
}

TEST(Narrowest, FewerAreAskedThanThereAre) {
  const NarrowPlaces places;
  planner::NarrowestSearch one(places.allowed, places.all), every(places.allowed, places.all);
  ASSERT_TRUE(one.next());
  while (every.next()) continue;
  EXPECT_LT(one.asked(), 0.8 * every.asked());
}

TEST(CspacePicture, ShowsEachStateInItsPlace) {
  OrientationMap map;
  map.lean.names = {"yaw", "tilt"};
  map.rotaries.names = {"C", "A"};
  map.blockers = {"holder against post"};
  map.resolution_rad = 0.01;
  map.lean.cells = {{{-1, 0}, {0, 1}, OrientationState::free, true, -1},
                    {{0, 0}, {1, 1}, OrientationState::blocked, false, 0}};
  map.rotaries.cells = {{{-1, -1}, {1, 0}, OrientationState::travel_limit, false, -1},
                        {{-1, 0}, {1, 1}, OrientationState::free, true, -1}};
  const view::Image image = view::draw_cspace_map(map, "test");
  ASSERT_EQ(image.bgra.size(), static_cast<std::size_t>(4 * image.width * image.height));
  const auto green_at = [&](int x, int y) {
    const std::size_t k = 4 * static_cast<std::size_t>(y * image.width + x);
    return image.bgra[k + 1] > image.bgra[k + 2] && image.bgra[k + 1] > image.bgra[k];
  };
  EXPECT_TRUE(green_at(300, 500));    // left panel, left half
  EXPECT_FALSE(green_at(700, 500));   // left panel, right half
  EXPECT_TRUE(green_at(1300, 300));   // right panel, upper half
  EXPECT_FALSE(green_at(1300, 700));  // right panel, lower half
  EXPECT_EQ(view::draw_cspace_map(map, "test").bgra, image.bgra);
}

// The maps of a plan: what it chose is allowed in its own map, and the worst points come worst first.
TEST(OrientationMaps, WhatWasChosenIsNotBlocked) {
  const auto profile = kinematics::load_profile(VOLUTE_SOURCE_DIR "/machines", "ac-head-fanuc");
  ASSERT_TRUE(profile);
  const planner::PlanRequest request = plan_request(random_scene(1), profile->machine, planner::Smoothing::corridor);
  const auto plan = planner::plan(request);
  ASSERT_TRUE(plan) << plan.error().message;
  planner::MapRequest wanted;
  wanted.cut_points = {10};
  wanted.worst = 2;
  wanted.cspace.resolution = Angle::degrees(2.0);
  const auto maps = planner::orientation_maps(request, *plan, wanted);
  ASSERT_TRUE(maps) << maps.error().message;
  ASSERT_EQ(maps->size(), 3u);
  EXPECT_LE((*maps)[1].free_share, (*maps)[2].free_share + 0.05);
  for (std::size_t m = 0; m < maps->size(); ++m) {
    const OrientationMap& map = (*maps)[m];
    for (const auto* chart : {&map.lean, &map.rotaries}) {
      ASSERT_TRUE(chart->chosen);
      for (const auto& cell : chart->cells) {
        const auto& [x, y] = *chart->chosen;
        if (x >= cell.least[0] && x < cell.greatest[0] && y >= cell.least[1] && y < cell.greatest[1]) {
          EXPECT_NE(cell.state, OrientationState::blocked);
        }
      }
    }
  }
  wanted.cut_points = {1000000};
  EXPECT_EQ(planner::orientation_maps(request, *plan, wanted).error().code, "map-point");
}

}  // namespace
}  // namespace volute::scenes

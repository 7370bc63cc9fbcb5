// Random scenes through the whole program: planned by FCL, judged by Bullet in the virtual run.
#include <cstdio>
#include <cstdlib>
#include <regex>

#include <gtest/gtest.h>

#include "planner/contact.hpp"
#include "planner/orientation/stations.hpp"
#include "post/post.hpp"
#include "sim/verify.hpp"
#include "tests/scenes/exhaustive_search.hpp"
#include "tests/scenes/random_scene.hpp"

namespace volute::scenes {
namespace {

using planner::PlanRequest;
using planner::PlanResult;

int number_from(const char* name, int otherwise) {
  const char* text = std::getenv(name);
  return text != nullptr ? std::atoi(text) : otherwise;
}

kinematics::Profile profile() {
  auto loaded = kinematics::load_profile(VOLUTE_SOURCE_DIR "/machines", "ac-head-fanuc");
  if (!loaded) ADD_FAILURE() << loaded.error().message;
  return *loaded;
}

/// Points and the ways between them that touch, asked anew of FCL; where the rotaries are known (all but leads) with
/// the links of the machine.
int interferences(const PlanRequest& request, const PlanResult& plan) {
  const planner::Interference check(request.scene, request.tool, &request.machine, &request.setup);
  const auto& points = plan.tool_path.points;
  const auto on_surface = [&](std::size_t k) {
    return points[k].move == kinematics::MoveKind::cut || points[k].move == kinematics::MoveKind::link;
  };
  int hits = 0;
  std::size_t known = 0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    hits += check.is_free_but_tip(points[k].pose) ? 0 : 1;
    // The first point of a piece is reached by an approach.
    const bool has_rotaries = on_surface(k) || (k + 1 < points.size() && on_surface(k + 1));
    if (has_rotaries) hits += check.links_are_free(points[k].pose, plan.rotaries_rad.at(known)) ? 0 : 1;
    if (k > 0 && points[k].move != kinematics::MoveKind::rapid) {
      planner::ToolMotion motion{points[k - 1].pose, points[k].pose, std::nullopt};
      if (on_surface(k)) motion.rotaries = std::array{plan.rotaries_rad.at(known - 1), plan.rotaries_rad.at(known)};
      hits += check.motion_is_free(motion) ? 0 : 1;
    }
    known += has_rotaries ? 1 : 0;
  }
  EXPECT_EQ(known, plan.rotaries_rad.size());
  return hits;
}

struct Judged {
  int sim_hits = 0;
  std::string first;
};

/// What Bullet says of the program's own text.
Judged run_virtually(const PlanRequest& request, const PlanResult& plan, const kinematics::Profile& at) {
  post::PostRequest posting;
  posting.path = plan.tool_path;
  posting.tool = request.tool;
  posting.setup = request.setup;
  const auto posted = post::post(posting, at);
  if (!posted) {
    ADD_FAILURE() << posted.error().message;
    return {};
  }
  sim::VerifyRequest judging;
  judging.text = posted->text;
  judging.file_name = "scene.nc";
  judging.profile = at;
  judging.setup = request.setup;
  judging.tool = request.tool;
  judging.surface_P = request.surface;
  judging.obstacles_P = request.scene.obstacles;
  judging.obstacle_names = request.scene.names;
  judging.cut.sample_spacing_mm = 1.0;
  const auto verified = sim::verify(judging);
  if (!verified || !verified->collision) {
    ADD_FAILURE() << (verified ? "no collision report" : verified.error().message);
    return {};
  }
  Judged judged{verified->collision->sim_hits, {}};
  if (!verified->collision->findings.empty()) judged.first = verified->collision->findings.front().text;
  return judged;
}

/// A refusal has to name CC points, and an exhaustive search there has to agree that nothing is allowed.
void expect_true_refusal(const PlanRequest& request, const geometry::Error& error) {
  ASSERT_EQ(error.code, "orientation-none") << error.message;
  std::smatch found;
  ASSERT_TRUE(std::regex_search(error.message, found, std::regex("CC points? (\\d+)"))) << error.message;
  const auto cc = planner::plan_cc_path(request.surface, request.tool.cutter, request.path, request.orientation);
  ASSERT_TRUE(cc);
  const auto& point = cc->path.pieces.front().points.at(static_cast<std::size_t>(std::stoi(found[1])));
  const SearchResult search =
      search_exhaustively(request, point.point_P_mm, point.normal_P.normalized(), geometry::Angle::degrees(0.5));
  EXPECT_EQ(search.allowed, 0) << error.message << "; of " << search.tried << " orientations tried";
}

// VOLUTE_CASES scenes, from seed VOLUTE_FIRST_SEED on. Odd seeds smooth in the corridor, even ones by acceleration.
TEST(RandomScenes, PlannedFreeAndJudgedFreeOrNothingIsAllowed) {
  const kinematics::Profile at = profile();
  const int cases = number_from("VOLUTE_CASES", 2), first = number_from("VOLUTE_FIRST_SEED", 1);
  int refused = 0;
  for (int k = 0; k < cases; ++k) {
    const auto seed = static_cast<unsigned>(first + k);
    SCOPED_TRACE("seed " + std::to_string(seed));
    const RandomScene scene = random_scene(seed);
    const PlanRequest request = plan_request(
        scene, at.machine, seed % 2 == 1 ? planner::Smoothing::corridor : planner::Smoothing::acceleration);
    const std::clock_t start = std::clock();
    const auto plan = planner::plan(request);
    const double plan_s = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    if (!plan) {
      ++refused;
      expect_true_refusal(request, plan.error());
      std::printf("seed %u: %zu obstacles, %.1f s CPU: %s\n", seed, scene.obstacles.size(), plan_s,
                  plan.error().message.c_str());
      continue;
    }
    const int hits = interferences(request, *plan);
    const Judged judged = run_virtually(request, *plan, at);
    EXPECT_EQ(hits, 0);
    EXPECT_EQ(judged.sim_hits, 0) << judged.first;
    std::printf("seed %u: %zu obstacles, %zu points, %d blocked at first, %d FCL hits, %d Bullet hits, %.1f s CPU\n",
                seed, scene.obstacles.size(), plan->rotaries_rad.size(), plan->orientation.interferences_before, hits,
                judged.sim_hits, plan_s);
    std::fflush(stdout);
  }
  EXPECT_LT(refused, cases);
}

// The generator keeps its word: closed bodies clear of the plate, and every kind of obstacle among a hundred scenes.
TEST(RandomScenes, SceneIsTheSameForTheSameSeedAndHoldsEveryKind) {
  std::array<int, 4> kinds{};
  std::array<int, 6> counts{};
  for (unsigned seed = 1; seed <= 100; ++seed) {
    const RandomScene scene = random_scene(seed), again = random_scene(seed);
    ASSERT_EQ(scene.names, again.names);
    ASSERT_GE(scene.obstacles.size(), 1u);
    ASSERT_LE(scene.obstacles.size(), 5u);
    ++counts[scene.obstacles.size()];
    for (std::size_t k = 0; k < scene.obstacles.size(); ++k) {
      ASSERT_EQ(scene.obstacles[k].vertices_mm, again.obstacles[k].vertices_mm);
      const char* names[] = {"post", "box", "sphere", "leaning"};
      for (std::size_t n = 0; n < 4; ++n) kinds[n] += scene.names[k].rfind(names[n], 0) == 0 ? 1 : 0;
    }
  }
  for (const int kind : kinds) EXPECT_GT(kind, 30);
  for (std::size_t k = 1; k < counts.size(); ++k) EXPECT_GT(counts[k], 5) << k;
}

}  // namespace
}  // namespace volute::scenes

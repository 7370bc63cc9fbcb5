// The step of the even field in one triangle, against allowed gradients drawn at random.
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "planner/path/even_project.hpp"
#include "tests/cases.hpp"

namespace volute::planner {
namespace {

constexpr double mu = 0.05;

struct Problem {
  LaneVectors z;
  Allowed allowed;
};

/// As the field has them: gradients of the order of g, and a weight of ten or so over g.
Problem random_problem(std::mt19937_64& random) {
  std::uniform_real_distribution<double> angle(-std::numbers::pi, std::numbers::pi), size(0.0, 3.0), g(0.2, 5.0),
      step(1.0, 30.0);
  Problem out{{}, {{}, {}, mu, {}}};
  for (Eigen::Index lane = 0; lane < project_lanes; ++lane) {
    const double needed = g(random), z = size(random) * needed, to = angle(random), d = angle(random);
    out.z.x[lane] = z * std::cos(to);
    out.z.y[lane] = z * std::sin(to);
    out.allowed.d.x[lane] = std::cos(d);
    out.allowed.d.y[lane] = std::sin(d);
    out.allowed.needed[lane] = needed;
    out.allowed.weight[lane] = step(random) / needed;
  }
  return out;
}

double cost(const Problem& p, Eigen::Index lane, double x, double y) {
  const double needed = p.allowed.needed[lane], norm = std::hypot(x, y);
  const double off = std::hypot(x - p.z.x[lane], y - p.z.y[lane]);
  return norm + mu * norm * norm / (2.0 * needed) + 0.5 * p.allowed.weight[lane] * off * off;
}

double along(const Problem& p, Eigen::Index lane, double x, double y) {
  return x * p.allowed.d.x[lane] + y * p.allowed.d.y[lane];
}

// Properties 1 and 2 of nearest_allowed.
TEST(EvenProject, NoAllowedGradientCostsLess) {
  constexpr unsigned seed = 20;
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> off(-1.0, 1.0);
  int held = 0, free = 0;
  for (int i = 0; i < cases(500); ++i) {
    const Problem p = random_problem(random);
    const LaneVectors q = nearest_allowed(p.z, p.allowed);
    for (Eigen::Index lane = 0; lane < project_lanes; ++lane) {
      const double needed = p.allowed.needed[lane], got = cost(p, lane, q.x[lane], q.y[lane]);
      ASSERT_GE(along(p, lane, q.x[lane], q.y[lane]), needed * (1.0 - 1e-12)) << "seed " << seed << ", case " << i;
      ++(along(p, lane, q.x[lane], q.y[lane]) > needed * (1.0 + 1e-9) ? free : held);
      for (int k = 0; k < 40; ++k) {
        const double reach = needed * std::pow(10.0, -0.1 * k);
        const double x = q.x[lane] + reach * off(random), y = q.y[lane] + reach * off(random);
        if (along(p, lane, x, y) < needed) continue;
        ASSERT_GE(cost(p, lane, x, y), got * (1.0 - 1e-9))
            << "seed " << seed << ", case " << i << ", " << x << ' ' << y;
      }
    }
  }
  EXPECT_GT(held, 0);
  EXPECT_GT(free, 0);
}

// Property 3, bit by bit: the field must not depend on which triangles are taken together.
TEST(EvenProject, ALaneDoesNotDependOnTheOthers) {
  constexpr unsigned seed = 21;
  std::mt19937_64 random(seed);
  for (int i = 0; i < cases(500); ++i) {
    const Problem p = random_problem(random);
    Problem turned = p;
    const auto turn = [](Lanes& lanes) { std::rotate(lanes.begin(), lanes.begin() + 1, lanes.end()); };
    for (Lanes* lanes : {&turned.z.x, &turned.z.y, &turned.allowed.d.x, &turned.allowed.d.y, &turned.allowed.needed,
                         &turned.allowed.weight})
      turn(*lanes);
    LaneVectors q = nearest_allowed(p.z, p.allowed);
    const LaneVectors q_turned = nearest_allowed(turned.z, turned.allowed);
    turn(q.x);
    turn(q.y);
    ASSERT_TRUE((q.x == q_turned.x).all() && (q.y == q_turned.y).all()) << "seed " << seed << ", case " << i;
  }
}

}  // namespace
}  // namespace volute::planner

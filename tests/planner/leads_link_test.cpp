#include <gtest/gtest.h>

#include <random>

#include "geometry/turn.hpp"
#include "tests/cases.hpp"
#include "tests/planner/flat_cut.hpp"

namespace volute::planner {
namespace {

using kinematics::MoveKind;
using kinematics::ToolPose;
using testing::FlatCut;
using testing::lowest_z_mm;
using testing::ToolPath;
using testing::ToolPathPoint;

/// [Sun2016] eq. 22.
Vec3 axis_at(double a_rad, double c_rad) {
  return {std::sin(c_rad) * std::sin(a_rad), -std::cos(c_rad) * std::sin(a_rad), std::cos(a_rad)};
}

/// What joins two pieces is planned and looked at with.
struct LinkJob {
  FlatCut flat;
  kinematics::Machine machine = testing::ac_head();
  kinematics::Setup setup;
  double top_mm = testing::clearance_z_mm;
  bool with_machine = true;

  [[nodiscard]] Interference interference() const { return {flat.scene, flat.tool, nullptr, nullptr}; }
  [[nodiscard]] Interference beyond() const {
    return {rapid_scene(flat.scene, flat.stock_P, flat.process.safe_distance_mm), flat.tool, nullptr, nullptr};
  }
  template <class Ask>
  [[nodiscard]] auto ask(Ask&& ask) const {
    const Interference near = interference(), far = beyond();
    const Leads leads(flat.tool, near, far, flat.process, top_mm, with_machine ? &machine : nullptr,
                      with_machine ? &setup : nullptr);
    return ask(leads);
  }
  [[nodiscard]] std::optional<ToolPath> link(const ToolPath& before, const ToolPath& after) const {
    return ask([&](const Leads& leads) { return leads.link(before, after); });
  }
};

/// A short straight cut that ends or begins at a contact, along `way`.
ToolPath cut_at(const Vec3& contact_mm, const Vec3& normal, const Vec3& axis, const Vec3& way, bool ends_here) {
  ToolPath path;
  for (int k = 0; k < 4; ++k) {
    ToolPathPoint p;
    p.contact_P_mm = contact_mm + (ends_here ? k - 3 : k) * 0.5 * way;
    p.normal_P = normal;
    p.pose.axis_P = axis;
    p.pose.tip_P_mm = p.contact_P_mm + 3.0 * normal - 3.0 * axis;
    p.feed_mm_s = 10.0;
    path.points.push_back(p);
  }
  return path;
}

double nearest_turn(double from_rad, double to_rad) {
  return from_rad + std::remainder(to_rad - from_rad, 2.0 * std::numbers::pi);
}

Vec3 on_great_circle(const Vec3& from, const Vec3& to, double share) {
  const double angle = std::atan2(from.cross(to).norm(), from.dot(to));
  if (angle < 1e-9) return from;
  return (std::sin((1.0 - share) * angle) * from + std::sin(share * angle) * to) / std::sin(angle);
}

/// Poses on the way from one to the other: the axis on the great circle, and the head's A and C in step.
std::vector<ToolPose> poses_between(const ToolPose& from, const ToolPose& to, bool in_step) {
  const auto angle = [](const Vec3& axis) { return std::acos(std::clamp(axis.z(), -1.0, 1.0)); };
  const auto turn = [](const Vec3& axis) { return std::atan2(axis.x(), -axis.y()); };
  const double c0 = turn(from.axis_P), c1 = nearest_turn(c0, turn(to.axis_P));
  std::vector<ToolPose> poses;
  for (int k = 0; k <= 200; ++k) {
    const double t = k / 200.0;
    ToolPose pose{from.tip_P_mm + t * (to.tip_P_mm - from.tip_P_mm), from.axis_P};
    if (in_step)
      pose.axis_P = axis_at(angle(from.axis_P) + t * (angle(to.axis_P) - angle(from.axis_P)), c0 + t * (c1 - c0));
    else
      pose.axis_P = on_great_circle(from.axis_P, to.axis_P, t);
    poses.push_back(pose);
  }
  return poses;
}

/// From the end of the first rapid on to the end of the last: the way across and the rapid down.
std::vector<ToolPose> poses_across(const ToolPath& link, bool in_step) {
  std::vector<ToolPose> poses;
  for (std::size_t i = 1; i < link.points.size(); ++i) {
    if (link.points[i].move != MoveKind::rapid || link.points[i - 1].move != MoveKind::rapid) continue;
    for (const ToolPose& pose : poses_between(link.points[i - 1].pose, link.points[i].pose, in_step))
      poses.push_back(pose);
  }
  return poses;
}

double highest_tip_mm(const ToolPath& path) {
  double z = path.points.front().pose.tip_P_mm.z();
  for (const auto& p : path.points) z = std::max(z, p.pose.tip_P_mm.z());
  return z;
}

ToolPath flat_end(double y, double a_rad, double c_rad, bool ends_here) {
  return cut_at(Vec3(0, y, 0), Vec3::UnitZ(), axis_at(a_rad, c_rad), ends_here ? Vec3::UnitX() : Vec3(-Vec3::UnitX()),
                ends_here);
}

TEST(LeadsLink, RisesToTheSafeDistanceAndNoHigher) {
  for (const double safe_mm : {1.0, 3.0, 6.0})
    for (const double tilt_rad : {0.0, 0.3}) {
      LinkJob job;
      job.flat.process.safe_distance_mm = safe_mm;
      const auto link = job.link(flat_end(-4, tilt_rad, 0.4, true), flat_end(4, tilt_rad, 1.9, false));
      ASSERT_TRUE(link) << safe_mm << " mm, " << tilt_rad;
      std::string order;
      for (const auto& p : link->points) {
        const char letter = p.move == MoveKind::rapid ? 'r' : p.move == MoveKind::retract ? 't' : 'a';
        if (order.empty() || order.back() != letter) order += letter;
      }
      EXPECT_EQ(order, "tra");
      double highest_mm = 0.0;
      for (const bool in_step : {false, true})
        for (const ToolPose& pose : poses_across(*link, in_step)) {
          EXPECT_GE(lowest_z_mm(job.flat.tool, pose), safe_mm - 1e-6);
          highest_mm = std::max(highest_mm, lowest_z_mm(job.flat.tool, pose));
        }
      // The grown tool's rim stands out along the axis and across it; then one step of the search.
      EXPECT_LE(highest_mm, safe_mm * (std::cos(tilt_rad) + std::sin(tilt_rad)) + 0.5 + 0.02 * safe_mm + 0.6);
    }
}

TEST(LeadsLink, ItsLeadsAreAFifthOfTheCutterUnlessGiven) {
  for (const double given_mm : {0.0, 1.7}) {
    LinkJob job;
    job.flat.process.link_lead_radius_mm = given_mm;
    const auto before = flat_end(-4, 0.2, 0.4, true);
    const auto link = job.link(before, flat_end(4, 0.2, 1.9, false));
    ASSERT_TRUE(link);
    const double radius_mm = given_mm > 0.0 ? given_mm : 0.2 * 3.0;
    const Vec3 centre = before.points.back().pose.tip_P_mm + radius_mm * Vec3::UnitZ();
    int points = 0;
    for (const auto& p : link->points)
      if (p.move == MoveKind::retract) {
        EXPECT_NEAR((p.pose.tip_P_mm - centre).norm(), radius_mm, 1e-12);
        ++points;
      }
    EXPECT_EQ(points, 12);
  }
}

TEST(LeadsLink, KeepsOutOfTheStock) {
  LinkJob job;
  job.flat.stock_P = testing::box(Vec3(-41, -21, -1), Vec3(41, 21, 5));
  const auto link = job.link(flat_end(-4, 0.2, 0.4, true), flat_end(4, 0.2, 1.9, false));
  ASSERT_TRUE(link);
  for (const ToolPose& pose : poses_across(*link, true))
    EXPECT_GE(lowest_z_mm(job.flat.tool, pose), 5.0 + job.flat.process.safe_distance_mm - 1e-6);
}

TEST(LeadsLink, GoesOverWhatStandsBetween) {
  LinkJob job;
  job.top_mm = 60.0;
  constexpr double wall_mm = 9.0;
  job.flat.scene.obstacles = {testing::box(Vec3(-40, -1, 0), Vec3(40, 1, wall_mm))};
  job.flat.scene.names = {"wall"};
  const auto link = job.link(flat_end(-9, 0.1, 0.4, true), flat_end(9, 0.1, 1.9, false));
  ASSERT_TRUE(link);
  EXPECT_LT(highest_tip_mm(*link), 45.0) << "lower than over clearance height";
  for (const bool in_step : {false, true})
    for (const ToolPose& pose : poses_across(*link, in_step)) {
      const double y = (pose.tip_P_mm + 3.0 * pose.axis_P).y();
      if (std::abs(y) >= 1.0) continue;
      EXPECT_GE(lowest_z_mm(job.flat.tool, pose), wall_mm + job.flat.process.safe_distance_mm - 1e-6) << "at y " << y;
    }
}

TEST(LeadsLink, WhereNoLowWayIsFreeTheToolRisesAsWithoutLinks) {
  LinkJob job;
  constexpr double wall_mm = 24.0;
  job.flat.scene.obstacles = {testing::box(Vec3(-40, -1, 0), Vec3(40, 1, wall_mm))};
  job.flat.scene.names = {"wall"};
  const ToolPath before = flat_end(-9, 0.1, 0.4, true), after = flat_end(9, 0.1, 1.9, false);
  EXPECT_FALSE(job.link(before, after));
  const auto whole = job.ask([&](const Leads& leads) { return leads.join({before, after}); });
  ASSERT_TRUE(whole) << whole.error().message;
  bool across = false;
  for (std::size_t i = 1; i < whole->points.size(); ++i) {
    const ToolPose &from = whole->points[i - 1].pose, &to = whole->points[i].pose;
    if (from.tip_P_mm.y() * to.tip_P_mm.y() >= 0.0) continue;
    across = true;
    for (const ToolPose& pose : poses_between(from, to, true))
      EXPECT_GE(lowest_z_mm(job.flat.tool, pose), testing::clearance_z_mm - 1e-6);
  }
  EXPECT_TRUE(across);
}

TEST(LeadsLink, RotariesInStepAreLookedAtToo) {
  // Tilted by 50 degrees, C turns by 170: in step the holder swings out to +x, on the great circle it stands up.
  LinkJob job;
  job.top_mm = 130.0;
  job.flat.scene.obstacles = {testing::box(Vec3(30, -60, 0), Vec3(34, 60, 60))};
  job.flat.scene.names = {"wall"};
  const double a = 50.0 * std::numbers::pi / 180.0, c = 5.0 * std::numbers::pi / 180.0;
  const ToolPath before = flat_end(3, a, c, true), after = flat_end(-3, a, std::numbers::pi - c, false);
  const Interference near = job.interference();
  const auto touches = [&](const ToolPath& link) {
    const auto poses = poses_across(link, true);
    return std::any_of(poses.begin(), poses.end(), [&](const ToolPose& pose) { return !near.is_free_but_tip(pose); });
  };
  job.with_machine = false;
  const auto blind = job.link(before, after);
  ASSERT_TRUE(blind);
  EXPECT_TRUE(touches(*blind)) << "the case is one where it matters";
  job.with_machine = true;
  const auto link = job.link(before, after);
  EXPECT_FALSE(link && touches(*link));
  EXPECT_FALSE(link && highest_tip_mm(*link) <= highest_tip_mm(*blind));
}

TEST(LeadsLink, JoinCutsEveryPieceAndComesAndGoesOnce) {
  const LinkJob job;
  std::vector<ToolPath> pieces;
  for (int k = 0; k < 5; ++k) pieces.push_back(job.flat.cut(-8.0 + 4.0 * k));
  const auto whole = job.ask([&](const Leads& leads) { return leads.join(pieces); });
  ASSERT_TRUE(whole) << whole.error().message;
  int high = 0;
  std::size_t cuts = 0;
  for (const auto& p : whole->points) {
    high += lowest_z_mm(job.flat.tool, p.pose) >= testing::clearance_z_mm - 1e-9 ? 1 : 0;
    cuts += p.move == MoveKind::cut ? 1 : 0;
  }
  EXPECT_EQ(high, 2) << "before the first and after the last piece";
  EXPECT_EQ(cuts, 5 * (pieces[0].points.size() - 1)) << "each piece's first point ends an approach";
  const auto none = job.ask([&](const Leads& leads) { return leads.join({}); });
  ASSERT_TRUE(none);
  EXPECT_TRUE(none->points.empty());
}

/// Least distance of points on the tool's skin from the vertices of the part: never less than the true one, and found
/// without the planner's trees.
double distance_to_vertices_mm(const kinematics::Tool& tool, const ToolPose& pose, const geometry::TriangleMesh& part) {
  std::vector<std::pair<Vec3, double>> balls{{pose.tip_P_mm + 3.0 * pose.axis_P, 3.0}};
  const Vec3 u = pose.axis_P.unitOrthogonal(), v = pose.axis_P.cross(u);
  for (const auto& [z, radius] : {std::pair(20.0, 3.0), {tool.stick_out_mm, 15.0}, {tool.stick_out_mm + 20.0, 15.0}})
    for (int k = 0; k < 12; ++k) {
      const double a = k * std::numbers::pi / 6.0;
      balls.emplace_back(pose.tip_P_mm + z * pose.axis_P + radius * (std::cos(a) * u + std::sin(a) * v), 0.0);
    }
  double least = 1e3;
  for (const Vec3& p : part.vertices_mm)
    for (const auto& [centre, radius] : balls) least = std::min(least, (p - centre).norm() - radius);
  return least;
}

TEST(LeadsLink, KeepsTheSafeDistanceOverRandomHills) {
  std::mt19937_64 random(20261122);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const int count = cases(30);
  int found = 0;
  for (int n = 0; n < count; ++n) {
    const double p = uniform(0, 6), q = uniform(0, 6), rise_mm = uniform(0.5, 3.0);
    const auto height = [&](double x, double y) { return rise_mm * (std::sin(x / 9.0 + p) + std::cos(y / 8.0 + q)); };
    LinkJob job;
    job.flat.scene.part = testing::sheet(-40, 40, -40, 40, 2.0, height);
    job.flat.process.safe_distance_mm = uniform(0.5, 4.0);
    job.top_mm = highest_point_mm(job.flat.scene) + 20.0;
    const auto end = [&](bool ends_here) {
      const Vec3 at(uniform(-25, 25), uniform(-25, 25), 0.0);
      const Vec3 contact(at.x(), at.y(), height(at.x(), at.y()) + 0.05);
      const Vec3 normal =
          Vec3(-rise_mm / 9.0 * std::cos(at.x() / 9.0 + p), rise_mm / 8.0 * std::sin(at.y() / 8.0 + q), 1.0)
              .normalized();
      const double lean = uniform(0.0, 0.4), turn = uniform(-3.1, 3.1);
      const Vec3 axis = geometry::turn_from_z(normal) * axis_at(lean, turn);
      return cut_at(contact, normal, axis, normal.unitOrthogonal(), ends_here);
    };
    const ToolPath before = end(true), after = end(false);
    const auto link = job.link(before, after);
    if (!link) continue;
    ++found;
    for (const bool in_step : {false, true})
      for (const ToolPose& pose : poses_across(*link, in_step))
        ASSERT_GE(distance_to_vertices_mm(job.flat.tool, pose, job.flat.scene.part),
                  job.flat.process.safe_distance_mm - 0.02)
            << "seed 20261122, case " << n;
  }
  EXPECT_GE(found, count * 2 / 3) << "most of such ways are free";
}

}  // namespace
}  // namespace volute::planner

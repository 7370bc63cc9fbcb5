// Proof by reading back: the simulator's own interpreter reads what the post wrote, for every profile, and its poses
// stand within rounding.
#include <gtest/gtest.h>

#include "sim/controller/axis_solver.hpp"
#include "sim/read_back.hpp"
#include "tests/post/example_paths.hpp"
#include "tests/post/sample_paths.hpp"

namespace volute::post {
namespace {

double angle_between(const geometry::Vec3& a, const geometry::Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// The printed digits' worth at the tip and at the axis.
sim::ReadBackTolerance rounding_of(const kinematics::Control& control) {
  const double half_mm = 0.5 * std::pow(10.0, -control.linear_decimals) * (1.0 + 1e-6);
  const double half_rad = geometry::Angle::degrees(0.5 * std::pow(10.0, -control.rotary_decimals)).radians();
  constexpr double farthest_pivot_mm = 500.0;  // from any rotary axis of the shipped machines to the tip
  const bool vector = control.orientation_words == kinematics::OrientationWords::vector;
  return {std::sqrt(3.0) * half_mm + (control.tcp ? 0.0 : 2.0 * half_rad * farthest_pivot_mm),
          vector ? std::sqrt(3.0) * 0.5 * std::pow(10.0, -control.vector_decimals) : 2.0 * half_rad};
}

struct Posted {
  kinematics::Profile profile;
  PostRequest request;
  Result<PostResult> result;
};

Posted posted_for(const std::string& name) {
  Posted made{testing::profile_named(name), testing::request_for(testing::dome_spiral(2, 90)), {}};
  const bool small = made.profile.machine.name == "linuxcnc-xyzac";
  if (small || made.profile.machine.name == "ab-head") made.request = testing::request_for(testing::ring(1.0, 40));
  if (small) made.request.setup.part_in_machine.translation() = geometry::Vec3(0, 0, -110);
  made.result = post(made.request, made.profile);
  return made;
}

/// One of the rotaries turns without turning the tool.
bool stands_at_pole(const kinematics::Machine& machine, const kinematics::Setup& setup,
                    const kinematics::AxisVector& q) {
  const auto axis_after = [&](int rotary, double turn_rad) {
    kinematics::AxisVector turned = q;
    turned[rotary] += turn_rad;
    return kinematics::tool_pose(machine, setup, 0.0, turned).axis_P;
  };
  return angle_between(axis_after(3, 0.0), axis_after(3, 1.0)) < 1e-9 ||
         angle_between(axis_after(4, 0.0), axis_after(4, 1.0)) < 1e-9;
}

void expect_feed_blocks_stand_where_planned(const Posted& made) {
  const auto& [profile, request, posted] = made;
  ASSERT_TRUE(posted.has_value()) << posted.error().message;

  sim::ProgramReader reader(posted->text, "program", profile.machine, profile.control);
  const auto read = sim::commanded_poses(reader, profile.machine, request.setup, request.tool.gauge_length_mm);
  ASSERT_TRUE(read.has_value()) << read.error().message;
  // At the pole the inverse may lean the axis by half of the tolerance, and nowhere else does it leave the path.
  const double lean_most_rad = 0.5 * kinematics::AxisPathOptions().rotary_tolerance_rad;
  std::vector<kinematics::ToolPose> planned;
  for (const kinematics::AxisPathPoint& point : posted->axis_path.points) {
    if (point.move == kinematics::MoveKind::rapid) continue;
    planned.push_back(kinematics::tool_pose(profile.machine, request.setup, request.tool.gauge_length_mm, point.q));
    ASSERT_LE((planned.back().tip_P_mm - point.pose.tip_P_mm).norm(), 1e-9);
    const double lean_rad = angle_between(planned.back().axis_P, point.pose.axis_P);
    ASSERT_LE(lean_rad, stands_at_pole(profile.machine, request.setup, point.q) ? lean_most_rad : 1e-9);
    if (profile.control.orientation_words == kinematics::OrientationWords::vector)
      planned.back().axis_P = point.pose.axis_P;  // vectors are written as they were asked for
  }
  ASSERT_EQ(read->size(), planned.size()) << "one block for every feed point";
  const sim::ReadBackTolerance rounding = rounding_of(profile.control);
  double tip_worst_mm = 0.0, axis_worst_rad = 0.0;
  for (std::size_t i = 0; i < planned.size(); ++i) {
    tip_worst_mm = std::max(tip_worst_mm, ((*read)[i].pose.tip_P_mm - planned[i].tip_P_mm).norm());
    axis_worst_rad = std::max(axis_worst_rad, angle_between((*read)[i].pose.axis_P, planned[i].axis_P));
  }
  EXPECT_LE(tip_worst_mm, rounding.tip_mm);
  EXPECT_LE(axis_worst_rad, rounding.axis_rad);
}

/// Poses along one block as the control interpolates it, from the program's words alone.
class ProgramFollower {
 public:
  ProgramFollower(const kinematics::Profile& profile, const PostRequest& request)
      : profile_(profile),
        request_(request),
        length_mm_(request.tool.gauge_length_mm),
        zero_(kinematics::program_zero(profile.machine, request.setup, length_mm_)),
        solver_(profile.machine, request.setup, length_mm_) {}

  /// Takes the block. False: its start or end is not known from the text (the first move after TCP is switched).
  bool take(const sim::MotionBlock& block) {
    from_ = to_;
    const bool was_known = known_ && tcp_ == block.tcp;
    tcp_ = block.tcp;
    for (int i = 0; i < 3; ++i) to_.words[i] = block.xyz_mm[i];
    if (block.axis_vector) {
      to_.axis_P = *block.axis_vector;
      const auto rotaries = solver_.rotaries_along(*block.axis_vector, from_.q);
      EXPECT_TRUE(rotaries.has_value());
      to_.q[3] = (*rotaries)[0];
      to_.q[4] = (*rotaries)[1];
    } else {
      for (int i = 0; i < 2; ++i) {
        if (!block.rotary_programmed[static_cast<std::size_t>(i)]) continue;
        const double word = block.rotary_rad[static_cast<std::size_t>(i)];
        to_.q[3 + i] = block.rotary_shortest
                           ? from_.q[3 + i] + std::remainder(word - from_.q[3 + i], 2.0 * std::numbers::pi)
                           : word;
      }
      to_.axis_P = axis_at(to_.q);
    }
    by_vector_ = block.tcp && block.axis_vector &&
                 block.orientation_interpolation.value_or(profile_.control.orientation_interpolation) ==
                     kinematics::OrientationInterpolation::great_circle;
    known_ = !block.machine_coordinates && block.xyz_known == std::array<bool, 3>{true, true, true};
    return was_known && known_;
  }

  [[nodiscard]] kinematics::ToolPose at(double share) const {
    const geometry::Vec3 words = from_.words + share * (to_.words - from_.words);
    kinematics::AxisVector q = from_.q + share * (to_.q - from_.q);
    if (!tcp_) {
      q.head<3>() = words + zero_.head<3>();
      return kinematics::tool_pose(profile_.machine, request_.setup, length_mm_, q);
    }
    return {words, by_vector_ ? great_circle(from_.axis_P, to_.axis_P, share) : axis_at(q)};
  }

  static geometry::Vec3 great_circle(const geometry::Vec3& a, const geometry::Vec3& b, double share) {
    const double angle = angle_between(a, b);
    if (angle < 1e-7) return (a + share * (b - a)).normalized();
    return (std::sin((1.0 - share) * angle) * a + std::sin(share * angle) * b) / std::sin(angle);
  }

 private:
  struct End {
    geometry::Vec3 words = geometry::Vec3::Zero(), axis_P = geometry::Vec3::UnitZ();
    kinematics::AxisVector q = kinematics::AxisVector::Zero();
  };
  [[nodiscard]] geometry::Vec3 axis_at(const kinematics::AxisVector& q) const {
    return kinematics::tool_pose(profile_.machine, request_.setup, length_mm_, q).axis_P;
  }
  const kinematics::Profile& profile_;
  const PostRequest& request_;
  double length_mm_;
  kinematics::AxisVector zero_;
  sim::AxisSolver solver_;
  End from_, to_;
  bool tcp_ = false, known_ = false, by_vector_ = false;
};

double distance_to_line(const geometry::Vec3& p, const geometry::Vec3& a, const geometry::Vec3& b) {
  const geometry::Vec3 along = b - a;
  const double length_sq = along.squaredNorm();
  const double share = length_sq > 0.0 ? std::clamp((p - a).dot(along) / length_sq, 0.0, 1.0) : 0.0;
  return (p - a - share * along).norm();
}

// What the control does between the blocks' ends, at ten places of each: the tip on the tool path's line, the axis on
// its great circle, within rounding and the linearization tolerance.
void expect_ten_points_inside_every_block_on_the_path(const Posted& made) {
  const auto& [profile, request, posted] = made;
  ASSERT_TRUE(posted.has_value()) << posted.error().message;
  const sim::ReadBackTolerance rounding = rounding_of(profile.control);
  const kinematics::AxisPathOptions linearization;
  sim::ProgramReader reader(posted->text, "program", profile.machine, profile.control);
  ProgramFollower follower(profile, request);
  std::size_t at = 0, inside = 0;
  const auto& points = posted->axis_path.points;
  double tip_worst_mm = 0.0, axis_worst_rad = 0.0;
  for (auto block = reader.next(); block && *block; block = reader.next()) {
    const sim::MotionBlock& motion = **block;
    if (motion.kind == sim::MotionKind::dwell || motion.kind == sim::MotionKind::stop) continue;
    const bool known = follower.take(motion);
    if (motion.kind == sim::MotionKind::rapid) continue;
    ++at;
    while (at < points.size() && points[at].move == kinematics::MoveKind::rapid) ++at;
    ASSERT_LT(at, points.size());
    if (!known) continue;
    const kinematics::ToolPose &from = points[at - 1].pose, &to = points[at].pose;
    for (int k = 1; k <= 10; ++k) {
      const double share = k / 11.0;
      const kinematics::ToolPose pose = follower.at(share);
      tip_worst_mm = std::max(tip_worst_mm, distance_to_line(pose.tip_P_mm, from.tip_P_mm, to.tip_P_mm));
      axis_worst_rad = std::max(
          axis_worst_rad, angle_between(pose.axis_P, ProgramFollower::great_circle(from.axis_P, to.axis_P, share)));
      ++inside;
    }
  }
  EXPECT_GT(inside, 300u);
  EXPECT_LE(tip_worst_mm, rounding.tip_mm + request.tolerance_mm);
  EXPECT_LE(axis_worst_rad, rounding.axis_rad + linearization.rotary_tolerance_rad);
  ::testing::Test::RecordProperty("tip_worst_um", std::to_string(1e3 * tip_worst_mm));
  ::testing::Test::RecordProperty("axis_worst_urad", std::to_string(1e6 * axis_worst_rad));
}

class ReadBack : public ::testing::TestWithParam<std::string> {};

TEST_P(ReadBack, EveryFeedBlockStandsWhereItWasPlanned) {
  expect_feed_blocks_stand_where_planned(posted_for(GetParam()));
}

TEST_P(ReadBack, TenPointsInsideEveryBlockStandOnTheToolPath) {
  expect_ten_points_inside_every_block_on_the_path(posted_for(GetParam()));
}

INSTANTIATE_TEST_SUITE_P(Profiles, ReadBack, ::testing::ValuesIn(testing::all_profiles()),
                         [](const auto& instance) { return testing::identifier(instance.param); });

// The same for the examples' own paths, in every dialect.
class ReadBackOfExamples : public ::testing::TestWithParam<std::string> {};

TEST_P(ReadBackOfExamples, StandsOnTheToolPathInEveryDialect) {
  const PostRequest request = testing::example_request(GetParam());
  for (const std::string& name : testing::example_profiles()) {
    SCOPED_TRACE(name);
    Posted made{testing::profile_named(name), request, {}};
    made.result = post(request, made.profile);
    expect_feed_blocks_stand_where_planned(made);
    expect_ten_points_inside_every_block_on_the_path(made);
  }
}

INSTANTIATE_TEST_SUITE_P(Examples, ReadBackOfExamples, ::testing::ValuesIn(testing::example_names()),
                         [](const auto& instance) { return testing::identifier(instance.param); });

}  // namespace
}  // namespace volute::post

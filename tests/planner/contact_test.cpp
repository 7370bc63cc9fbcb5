#include "planner/contact.hpp"

#include <random>

#include <gtest/gtest.h>

namespace volute::planner {
namespace {

using geometry::Angle;
using kinematics::Cutter;
using kinematics::CutterShape;

const Cutter ball{CutterShape::ball, 3.0, 3.0, {}, 20.0, 2};
const Cutter flat{CutterShape::flat, 5.0, 0.0, {}, 20.0, 2};
const Cutter bull{CutterShape::bull, 6.0, 1.0, {}, 20.0, 2};

TEST(FeedFrame, IsRightHandedAndTiltsAsAsked) {
  const FeedFrame frame = feed_frame(Vec3(2.0, 0.3, 0.5), Vec3(0.1, 0.2, 0.9));
  EXPECT_NEAR(frame.feed_P.cross(frame.across_P).dot(frame.normal_P), 1.0, 1e-14);
  const Vec3 axis = tool_axis(frame, Angle::degrees(25.0), Angle::degrees(40.0));
  EXPECT_NEAR(axis.dot(frame.normal_P), std::cos(Angle::degrees(25.0).radians()), 1e-14);
  EXPECT_NEAR(std::atan2(axis.dot(frame.across_P), axis.dot(frame.feed_P)), Angle::degrees(40.0).radians(), 1e-14);
}

/// Distance from a point to the swept solid of the cutter: of its lowest skin only, by dense sampling of the true
/// profile.
double skin_distance(const Cutter& cutter, const kinematics::ToolPose& pose, const Vec3& point) {
  double least = 1e9;
  const Vec3 u = pose.axis_P.unitOrthogonal(), v = pose.axis_P.cross(u);
  const double arc = cutter.shape == CutterShape::flat ? 0.0 : cutter.corner_radius_mm;
  for (int i = 0; i <= 400; ++i) {
    const double a = 0.5 * 3.14159265358979 * i / 400.0;
    const double radius = cutter.radius_mm - arc + arc * std::sin(a), z = arc * (1.0 - std::cos(a));
    for (int k = 0; k < 720; ++k) {
      const double b = 3.14159265358979 * k / 360.0;
      least = std::min(least,
                       (pose.tip_P_mm + z * pose.axis_P + radius * (std::cos(b) * u + std::sin(b) * v) - point).norm());
    }
  }
  return least;
}

/// The lowest point of the cutter below the tangent plane at the contact.
double lowest(const Cutter& cutter, const kinematics::ToolPose& pose, const Vec3& contact, const Vec3& normal) {
  double least = 1e9;
  const Vec3 u = pose.axis_P.unitOrthogonal(), v = pose.axis_P.cross(u);
  const double arc = cutter.shape == CutterShape::flat ? 0.0 : cutter.corner_radius_mm;
  for (int i = 0; i <= 400; ++i) {
    const double a = 0.5 * 3.14159265358979 * i / 400.0;
    const double radius = cutter.radius_mm - arc + arc * std::sin(a), z = arc * (1.0 - std::cos(a));
    for (int k = 0; k < 720; ++k) {
      const double b = 3.14159265358979 * k / 360.0;
      least = std::min(
          least,
          (pose.tip_P_mm + z * pose.axis_P + radius * (std::cos(b) * u + std::sin(b) * v) - contact).dot(normal));
    }
  }
  return least;
}

TEST(ContactPose, TouchesTheTangentPlaneAtTheContact) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  for (int n = 0; n < 6; ++n) {
    const Vec3 contact(10.0 * any(random), 10.0 * any(random), 10.0 * any(random));
    const FeedFrame frame =
        feed_frame(Vec3(any(random), any(random), 0.1), Vec3(0.5 * any(random), 0.5 * any(random), 1.0));
    const Vec3 axis = tool_axis(frame, Angle::degrees(35.0 + 30.0 * any(random)), Angle::degrees(180.0 * any(random)));
    for (const Cutter& cutter : {ball, flat, bull}) {
      const auto pose = contact_pose(cutter, contact, frame.normal_P, axis);
      EXPECT_LT(skin_distance(cutter, pose, contact), 0.04);
      EXPECT_NEAR(lowest(cutter, pose, contact, frame.normal_P), 0.0, 2e-3);
    }
  }
}

TEST(ContactPose, BallFollowsHuangEq13) {
  const Vec3 normal = Vec3(0.0, 0.6, 0.8), axis = Vec3(0.0, 0.0, 1.0), contact(1.0, 2.0, 3.0);
  const auto pose = contact_pose(ball, contact, normal, axis);
  EXPECT_NEAR((pose.tip_P_mm - (contact + 3.0 * normal - 3.0 * axis)).norm(), 0.0, 1e-15);
}

TEST(ContactPose, FlatBottomTouchesWithItsCentreWhereAxisIsNormal) {
  const Vec3 normal = Vec3(0.0, 0.6, 0.8), contact(1.0, 2.0, 3.0);
  for (const Cutter& cutter : {flat, bull})
    EXPECT_EQ((contact_pose(cutter, contact, normal, normal).tip_P_mm - contact).norm(), 0.0);
}

TEST(EffectiveRadius, OfAFlatCutterLeaningForwardIsRadiusOverSine) {
  EXPECT_NEAR(effective_radius_mm(flat, Angle::degrees(10.0), Angle()), 5.0 / std::sin(Angle::degrees(10.0).radians()),
              1e-12);
  EXPECT_NEAR(effective_radius_mm(ball, Angle::degrees(33.0), Angle::degrees(12.0)), 3.0, 0.0);
  EXPECT_NEAR(effective_radius_mm(bull, Angle::degrees(10.0), Angle::degrees(90.0)), 1.0, 1e-12);
  EXPECT_TRUE(std::isinf(effective_radius_mm(flat, Angle(), Angle())));
}

TEST(EffectiveRadius, IsTheCurvatureOfTheOutlineSeenAlongTheFeed) {
  // Independent: the lowest outline of the bull's corner, measured at two widths across the feed, gives the circle's
  // radius.
  const FeedFrame frame = feed_frame(Vec3::UnitX(), Vec3::UnitZ());
  for (const double yaw : {0.0, 35.0, 70.0}) {
    const Angle tilt = Angle::degrees(30.0), turn = Angle::degrees(yaw);
    const auto pose = contact_pose(bull, Vec3::Zero(), Vec3::UnitZ(), tool_axis(frame, tilt, turn));
    // Support function in directions n(t) in the plane across the feed: for a circle of radius r through 0, h(t) = r (1
    // - cos t).
    const auto height = [&](double t) {
      const Vec3 n(0.0, std::sin(t), -std::cos(t));
      const Vec3 square = n - n.dot(pose.axis_P) * pose.axis_P;
      return (pose.tip_P_mm + 1.0 * pose.axis_P + 5.0 * square.normalized() + 1.0 * n).dot(n);
    };
    const double t = 1e-3, h0 = height(0.0), second = (height(t) - 2.0 * h0 + height(-t)) / (t * t);
    EXPECT_NEAR(h0 + second, effective_radius_mm(bull, tilt, turn), 1e-4) << yaw;  // radius of curvature = h + h''
  }
}

}  // namespace
}  // namespace volute::planner

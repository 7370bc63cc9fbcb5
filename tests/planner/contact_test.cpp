#include "planner/contact.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace volute::planner {
namespace {

using geometry::Angle;
using kinematics::Cutter;
using kinematics::CutterShape;

const Cutter ball{CutterShape::ball, 3.0, 3.0, {}, 20.0, 2};
const Cutter flat{CutterShape::flat, 5.0, 0.0, {}, 20.0, 2};
const Cutter bull{CutterShape::bull, 6.0, 1.0, {}, 20.0, 2};
const Cutter taper_ball{CutterShape::taper_ball, 2.0, 2.0, Angle::degrees(8.0), 20.0, 2};

TEST(FeedFrame, IsRightHandedAndTiltsAsAsked) {
  const FeedFrame frame = feed_frame(Vec3(2.0, 0.3, 0.5), Vec3(0.1, 0.2, 0.9));
  EXPECT_NEAR(frame.feed_P.cross(frame.across_P).dot(frame.normal_P), 1.0, 1e-14);
  const Vec3 axis = tool_axis(frame, Angle::degrees(25.0), Angle::degrees(40.0));
  EXPECT_NEAR(axis.dot(frame.normal_P), std::cos(Angle::degrees(25.0).radians()), 1e-14);
  EXPECT_NEAR(std::atan2(axis.dot(frame.across_P), axis.dot(frame.feed_P)), Angle::degrees(40.0).radians(), 1e-14);
}

/// Radius and height of points on the cutter's outline, from the axis up the bottom, the arc and the flank: the shape
/// as its definition says, not as the code under test uses it.
std::vector<std::pair<double, double>> profile(const Cutter& cutter, int fineness = 1) {
  std::vector<std::pair<double, double>> points;
  const double arc = cutter.shape == CutterShape::flat ? 0.0 : cutter.corner_radius_mm;
  const double bottom = cutter.radius_mm - arc;  // 0 for balls
  const double last = 0.5 * std::numbers::pi - cutter.taper.radians();
  const int on_bottom = 40 * fineness, on_arc = 400 * fineness, on_flank = 100 * fineness;
  for (int i = 0; i <= on_bottom; ++i) points.emplace_back(bottom * i / on_bottom, 0.0);
  for (int i = 1; i <= on_arc; ++i) {
    const double a = last * i / on_arc;
    points.emplace_back(bottom + arc * std::sin(a), arc * (1.0 - std::cos(a)));
  }
  const auto [r, z] = points.back();
  for (int i = 1; i <= on_flank; ++i) {
    const double up = (cutter.length_mm - z) * i / on_flank;
    points.emplace_back(r + up * std::tan(cutter.taper.radians()), z + up);
  }
  return points;
}

/// Every point of the cutter's skin.
std::vector<Vec3> skin(const Cutter& cutter, const kinematics::ToolPose& pose) {
  constexpr int around = 720;
  const Vec3 u = pose.axis_P.unitOrthogonal(), v = pose.axis_P.cross(u);
  std::vector<Vec3> points;
  for (const auto& [radius, z] : profile(cutter))
    for (int k = 0; k < around; ++k) {
      const double b = 2.0 * std::numbers::pi * k / around;
      points.emplace_back(pose.tip_P_mm + z * pose.axis_P + radius * (std::cos(b) * u + std::sin(b) * v));
    }
  return points;
}

TEST(ContactPose, TouchesTheTangentPlaneAtTheContact) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  for (int n = 0; n < 6; ++n) {
    const Vec3 contact(10.0 * any(random), 10.0 * any(random), 10.0 * any(random));
    const FeedFrame frame =
        feed_frame(Vec3(any(random), any(random), 0.1), Vec3(0.5 * any(random), 0.5 * any(random), 1.0));
    const Vec3 axis = tool_axis(frame, Angle::degrees(40.0 + 35.0 * any(random)), Angle::degrees(180.0 * any(random)));
    for (const Cutter& cutter : {ball, flat, bull, taper_ball}) {
      double nearest = 1e9, lowest = 1e9;
      for (const Vec3& p : skin(cutter, contact_pose(cutter, contact, frame.normal_P, axis))) {
        nearest = std::min(nearest, (p - contact).norm());
        lowest = std::min(lowest, (p - contact).dot(frame.normal_P));
      }
      EXPECT_LT(nearest, 0.04);
      EXPECT_NEAR(lowest, 0.0, 2e-3);
    }
  }
}

TEST(ContactPose, ATaperBallTouchesWithItsBallUntilTheConeLiesOnTheSurface) {
  // The cone's flank stands at its half angle to the axis: it lies on the plane at a tilt of 90 - taper.
  const FeedFrame frame = feed_frame(Vec3::UnitX(), Vec3::UnitZ());
  for (const double tilt : {60.0, 81.9, 82.1, 86.0}) {
    const Vec3 axis = tool_axis(frame, Angle::degrees(tilt), Angle());
    double lowest = 1e9;
    for (const Vec3& p : skin(taper_ball, contact_pose(taper_ball, Vec3::Zero(), Vec3::UnitZ(), axis)))
      lowest = std::min(lowest, p.z());
    if (tilt < 82.0) {
      EXPECT_NEAR(lowest, 0.0, 2e-3) << tilt;
    } else {
      EXPECT_LT(lowest, -0.01) << "past it the cone gouges, which the interference check reports: " << tilt;
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

/// The lowest point of the cutter's skin over lines y = const along the feed: over every ring of the profile, where the
/// ring crosses that line.
class DroppedSkin {
 public:
  DroppedSkin(Cutter cutter, const kinematics::ToolPose& pose) : pose_(pose) {
    cutter.length_mm = cutter.corner_radius_mm + 2.0;  // what lies higher leaves no scallop
    rings_ = profile(cutter, 20);
  }
  [[nodiscard]] double lowest_mm(double y_mm) const {
    const Vec3 u = pose_.axis_P.unitOrthogonal(), v = pose_.axis_P.cross(u);
    const double reach = std::hypot(u.y(), v.y()), phase = std::atan2(v.y(), u.y());
    double lowest = 1e9;
    for (const auto& [radius, height] : rings_) {
      const Vec3 centre = pose_.tip_P_mm + height * pose_.axis_P;
      const double cosine = (y_mm - centre.y()) / (radius * reach);
      if (!(std::abs(cosine) <= 1.0)) continue;
      for (const double angle : {phase + std::acos(cosine), phase - std::acos(cosine)})
        lowest = std::min(lowest, (centre + radius * (std::cos(angle) * u + std::sin(angle) * v)).z());
    }
    return lowest;
  }

 private:
  kinematics::ToolPose pose_;
  std::vector<std::pair<double, double>> rings_;
};

/// Height of the ridge between two straight passes `interval_mm` apart on a plane: where the one skin, rising, meets
/// the other, falling.
double cusp_mm(const Cutter& cutter, Angle tilt, Angle yaw, double interval_mm) {
  const FeedFrame frame = feed_frame(Vec3::UnitX(), Vec3::UnitZ());
  const DroppedSkin skin(cutter, contact_pose(cutter, Vec3::Zero(), Vec3::UnitZ(), tool_axis(frame, tilt, yaw)));
  double low = 0.0, high = interval_mm;
  for (int round = 0; round < 24; ++round) {
    const double y = 0.5 * (low + high);
    (skin.lowest_mm(y) < skin.lowest_mm(y - interval_mm) ? low : high) = y;
  }
  return std::max(skin.lowest_mm(low), skin.lowest_mm(high - interval_mm));
}

TEST(ClearedWidth, PassesSoFarApartLeaveTheHeightByTheWholeSkin) {
  struct Lean {
    double tilt_deg, yaw_deg;
  };
  for (const Cutter& cutter : {ball, flat, bull, taper_ball})
    for (const Lean lean : {Lean{10.0, 0.0}, Lean{10.0, 60.0}, Lean{25.0, 90.0}, Lean{45.0, -30.0}})
      for (const double height : {0.05, 0.3}) {
        const Angle tilt = Angle::degrees(lean.tilt_deg), yaw = Angle::degrees(lean.yaw_deg);
        const double width = cleared_width_mm(cutter, tilt, yaw, height);
        EXPECT_NEAR(cusp_mm(cutter, tilt, yaw, width) / height, 1.0, 0.03)
            << "radius " << cutter.radius_mm << " tilt " << lean.tilt_deg << " yaw " << lean.yaw_deg << " height "
            << height << " width " << width;
      }
}

TEST(ClearedWidth, ClosedForms) {
  // A ball: the chord. A flat end that lies on the plane: its diameter. A flat end leaning forward: the ellipse with
  // half axes R and R sin(tilt).
  const double h = 0.2;
  EXPECT_NEAR(cleared_width_mm(ball, Angle::degrees(20.0), Angle::degrees(50.0), h),
              2.0 * std::sqrt(2.0 * 3.0 * h - h * h), 1e-9);
  EXPECT_NEAR(cleared_width_mm(flat, Angle(), Angle(), h), 10.0, 1e-12);
  const double sine = std::sin(Angle::degrees(15.0).radians()), share = 1.0 - h / (5.0 * sine);
  EXPECT_NEAR(cleared_width_mm(flat, Angle::degrees(15.0), Angle(), h), 10.0 * std::sqrt(1.0 - share * share), 1e-9);
  // A bull end that lies on the plane: the flat of radius 5 and the corner's chord at both sides.
  EXPECT_NEAR(cleared_width_mm(bull, Angle(), Angle(), h), 10.0 + 2.0 * std::sqrt(2.0 * h - h * h), 1e-9);
}

TEST(ClearingRadius, OfABallIsItsOwnAndTendsToTheCurvatureForSmallHeights) {
  EXPECT_EQ(clearing_radius_mm(ball, Angle::degrees(10.0), Angle(), 0.2), 3.0);
  EXPECT_EQ(clearing_radius_mm(taper_ball, Angle::degrees(10.0), Angle(), 0.2), 2.0);
  for (const Cutter& cutter : {flat, bull}) {
    const Angle tilt = Angle::degrees(20.0);
    const double small = clearing_radius_mm(cutter, tilt, Angle(), 1e-6);
    EXPECT_NEAR(small / effective_radius_mm(cutter, tilt, Angle()), 1.0, 1e-4);
    EXPECT_LT(clearing_radius_mm(cutter, tilt, Angle(), 0.5), small) << "higher up the ellipse is narrower";
  }
}

}  // namespace
}  // namespace volute::planner

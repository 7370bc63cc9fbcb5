#include "tests/scenes/exhaustive_search.hpp"

#include <cmath>
#include <numbers>

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/collision.h>

#include "geometry/turn.hpp"
#include "kinematics/inverse/inverse.hpp"
#include "planner/contact.hpp"

namespace volute::scenes {

using geometry::Vec3;

namespace {

using Model = fcl::BVHModel<fcl::OBBRSSd>;

std::shared_ptr<Model> model_of(const geometry::TriangleMesh& mesh) {
  std::vector<fcl::Vector3d> points(mesh.vertices_mm.begin(), mesh.vertices_mm.end());
  std::vector<fcl::Triangle> triangles;
  for (const auto& t : mesh.triangles) {
    triangles.emplace_back(static_cast<std::size_t>(t[0]), static_cast<std::size_t>(t[1]),
                           static_cast<std::size_t>(t[2]));
  }
  auto model = std::make_shared<Model>();
  model->beginModel();
  model->addSubModel(points, triangles);
  model->endModel();
  return model;
}

/// A cylinder or ball on the tool axis, for obstacles with the clearance and for the part as it may stand there.
struct Part {
  std::shared_ptr<fcl::CollisionGeometryd> shape;
  double centre_z_mm;
};

/// The assembly grown on all sides, cones as stacks of cylinders inside them: what these touch the cones touch too.
std::vector<Part> assembly(const kinematics::Tool& tool, double cutter_growth, double rest_growth, bool with_ball) {
  std::vector<Part> parts;
  const auto cylinder = [&](double radius, double from, double to) {
    parts.push_back({std::make_shared<fcl::Cylinderd>(radius, to - from), 0.5 * (from + to)});
  };
  const double r = tool.cutter.radius_mm, out = std::max(cutter_growth, 0.0);
  if (with_ball) parts.push_back({std::make_shared<fcl::Sphered>(r + cutter_growth), r});
  cylinder(r + cutter_growth, r - out, tool.cutter.length_mm + out);
  cylinder(tool.shank_radius_mm + rest_growth, tool.cutter.length_mm - rest_growth, tool.stick_out_mm + rest_growth);
  for (const auto& cone : tool.holder) {
    constexpr int slices = 8;
    const auto z = [&](int at) { return cone.z_mm + cone.length_mm * at / slices; };
    const auto radius = [&](int at) {
      return cone.bottom_radius_mm + (cone.top_radius_mm - cone.bottom_radius_mm) * at / slices + rest_growth;
    };
    for (int k = 0; k < slices; ++k)
      cylinder(std::min(radius(k), radius(k + 1)), k == 0 ? z(0) - rest_growth : z(k),
               k + 1 == slices ? z(slices) + rest_growth : z(k + 1));
  }
  return parts;
}

bool meets(const std::vector<Part>& parts, const kinematics::ToolPose& pose, const Model& model) {
  for (const Part& part : parts) {
    fcl::Transform3d X = fcl::Transform3d::Identity();
    X.linear() = geometry::turn_from_z(pose.axis_P).toRotationMatrix();
    X.translation() = pose.tip_P_mm + part.centre_z_mm * pose.axis_P;
    fcl::CollisionRequestd request;
    fcl::CollisionResultd result;
    if (fcl::collide(part.shape.get(), X, &model, fcl::Transform3d::Identity(), request, result) > 0) return true;
  }
  return false;
}

}  // namespace

SearchResult search_exhaustively(const planner::PlanRequest& request, const Vec3& contact_P_mm, const Vec3& normal_P,
                                 geometry::Angle step) {
  const planner::Scene& scene = request.scene;
  const auto at_others = assembly(request.tool, scene.clearance_mm, scene.clearance_mm, true);
  const auto at_part = assembly(request.tool, -scene.gouge_tolerance_mm, scene.clearance_mm, false);
  std::vector<std::shared_ptr<Model>> others;
  for (const auto& mesh : scene.obstacles) others.push_back(model_of(mesh));
  const auto part = model_of(scene.part);
  const Eigen::Matrix3d R = geometry::turn_from_z(normal_P).toRotationMatrix();
  SearchResult result;
  for (double tilt = request.orientation.tilt_min.radians(); tilt <= request.orientation.tilt_max.radians();
       tilt += step.radians()) {
    const int round =
        std::max(1, static_cast<int>(std::ceil(2.0 * std::numbers::pi * std::sin(tilt) / step.radians())));
    for (int k = 0; k < round; ++k) {
      const double a = 2.0 * std::numbers::pi * k / round;
      const Vec3 axis = R * Vec3(std::sin(tilt) * std::cos(a), std::sin(tilt) * std::sin(a), std::cos(tilt));
      ++result.tried;
      if (kinematics::solve_rotaries(request.machine, request.setup.part_in_machine.linear() * axis).empty()) continue;
      const kinematics::ToolPose pose = planner::contact_pose(request.tool.cutter, contact_P_mm, normal_P, axis);
      bool blocked = meets(at_part, pose, *part);
      for (std::size_t o = 0; o < others.size() && !blocked; ++o) blocked = meets(at_others, pose, *others[o]);
      result.allowed += blocked ? 0 : 1;
    }
  }
  return result;
}

}  // namespace volute::scenes

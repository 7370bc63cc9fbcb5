// Link geometry: closed bodies that touch neither each other nor a part in ordinary poses. Collision by FCL.
#include <fcl/fcl.h>

#include <memory>

#include "kinematics/inverse/inverse.hpp"
#include "tests/kinematics/machine_fixture.hpp"

namespace volute::kinematics {
namespace {

using Model = fcl::BVHModel<fcl::OBBRSSd>;

std::shared_ptr<Model> model_of(const geometry::TriangleMesh& mesh) {
  auto model = std::make_shared<Model>();
  model->beginModel();
  for (const geometry::Triangle& t : mesh.triangles)
    model->addTriangle(mesh.vertices_mm[static_cast<std::size_t>(t[0])],
                       mesh.vertices_mm[static_cast<std::size_t>(t[1])],
                       mesh.vertices_mm[static_cast<std::size_t>(t[2])]);
  model->endModel();
  return model;
}

struct Body {
  int link;
  std::string name;
  std::shared_ptr<Model> model;
};

bool collide(const Body& a, const Transform& place_a, const Body& b, const Transform& place_b) {
  fcl::CollisionObjectd first(a.model, place_a), second(b.model, place_b);
  fcl::CollisionRequestd request;
  fcl::CollisionResultd result;
  return fcl::collide(&first, &second, request, result) > 0;
}

class Links : public ::testing::TestWithParam<std::string> {
 protected:
  Links() : machine(testing::machine_named(GetParam())) {
    for (const LinkShape& shape : machine.shapes) bodies.push_back({shape.link, shape.name, model_of(shape.mesh_M)});
    // LinuxCNC's simulated machine is small and its origin lies at the spindle.
    small = GetParam() == "linuxcnc-xyzac";
    if (small) job.part_in_machine.translation() = Vec3(0, 0, -80);
  }

  bool within_travel(const AxisVector& q) const {
    for (int i = 0; i < axis_count; ++i) {
      const Axis& axis = machine.axes[static_cast<std::size_t>(i)];
      if ((axis.travel_min && q[i] < *axis.travel_min) || (axis.travel_max && q[i] > *axis.travel_max)) return false;
    }
    return true;
  }

  void expect_clear(const AxisVector& q) const {
    for (std::size_t a = 0; a < bodies.size(); ++a)
      for (std::size_t b = a + 1; b < bodies.size(); ++b) {
        if (bodies[a].link == bodies[b].link) continue;
        EXPECT_FALSE(collide(bodies[a], link_motion(machine, bodies[a].link, q), bodies[b],
                             link_motion(machine, bodies[b].link, q)))
            << bodies[a].name << " meets " << bodies[b].name << " at " << q.transpose();
      }
  }

  Machine machine;
  kinematics::Setup job;
  std::vector<Body> bodies;
  bool small = false;
};

geometry::TriangleMesh cube(double size_mm) {
  geometry::TriangleMesh mesh;
  for (int corner = 0; corner < 8; ++corner)
    mesh.vertices_mm.push_back(size_mm * Vec3((corner & 1) - 0.5, ((corner >> 1) & 1) - 0.5, (corner >> 2) & 1));
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

TEST_P(Links, AreClosedBodiesTurnedOutward) {
  for (const LinkShape& shape : machine.shapes) {
    double six_volumes = 0.0;
    Vec3 closing = Vec3::Zero();
    for (const geometry::Triangle& t : shape.mesh_M.triangles) {
      const Vec3 &a = shape.mesh_M.vertices_mm[static_cast<std::size_t>(t[0])],
                 &b = shape.mesh_M.vertices_mm[static_cast<std::size_t>(t[1])],
                 &c = shape.mesh_M.vertices_mm[static_cast<std::size_t>(t[2])];
      six_volumes += a.dot(b.cross(c));
      closing += (b - a).cross(c - a);
    }
    EXPECT_GT(six_volumes, 6e4) << shape.name;
    EXPECT_LT(closing.norm(), 1e-6 * six_volumes) << shape.name << " is not closed";
  }
}

TEST_P(Links, StandClearWhenEveryAxisIsAtZero) { expect_clear(AxisVector::Zero()); }

TEST_P(Links, MeetNeitherEachOtherNorAPartInOrdinaryPoses) {
  const double size_mm = small ? 60.0 : 100.0, tool_length_mm = small ? 100.0 : 150.0;
  const Body part{-1, "part", model_of(cube(size_mm))};
  testing::Random random(11);
  int tried = 0;
  for (int k = 0; k < cases(400); ++k) {
    const double tilt = random.uniform(0.0, small ? 0.5 : 1.0), azimuth = random.uniform(-3.14, 3.14);
    ToolPose pose;  // on the top face of the part
    pose.tip_P_mm = {random.uniform(-0.5, 0.5) * size_mm, random.uniform(-0.5, 0.5) * size_mm, size_mm};
    pose.axis_P = {std::sin(tilt) * std::cos(azimuth), std::sin(tilt) * std::sin(azimuth), std::cos(tilt)};
    for (const AxisVector& q : solve(machine, job, tool_length_mm, pose)) {
      if (!within_travel(q)) continue;
      ++tried;
      expect_clear(q);
      for (const Body& body : bodies)
        EXPECT_FALSE(collide(part, job.part_in_machine, body, link_motion(machine, body.link, q)))
            << body.name << " meets the part at " << q.transpose();
    }
    if (HasFailure()) return;
  }
  EXPECT_GT(tried, 100);
}

INSTANTIATE_TEST_SUITE_P(Machines, Links, ::testing::ValuesIn(testing::machine_names()), [](const auto& instance) {
  std::string name = instance.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

}  // namespace
}  // namespace volute::kinematics

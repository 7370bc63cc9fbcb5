// Bullet (the judge) against FCL (the planner's library) on random poses: they may differ only where the distance is
// nothing, or where a convex link is a solid for the one and a skin for the other.
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/collision.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <random>

#include <Eigen/LU>

#include "kinematics/model/machine.hpp"
#include "sim/collision_shapes.hpp"
#include "tests/cases.hpp"

namespace volute::sim {
namespace {

using geometry::Transform;
using geometry::TriangleMesh;
using geometry::Vec3;
using kinematics::AxisVector;
using kinematics::Machine;
using FclMesh = fcl::BVHModel<fcl::OBB<double>>;

std::shared_ptr<FclMesh> fcl_mesh(const TriangleMesh& mesh) {
  auto model = std::make_shared<FclMesh>();
  std::vector<fcl::Triangle> triangles;
  for (const auto& t : mesh.triangles) triangles.emplace_back(t[0], t[1], t[2]);
  model->beginModel();
  model->addSubModel(mesh.vertices_mm, triangles);
  model->endModel();
  return model;
}

bool fcl_hits(const fcl::CollisionGeometry<double>& a, const Transform& X_a, const fcl::CollisionGeometry<double>& b,
              const Transform& X_b) {
  fcl::CollisionRequest<double> request;
  fcl::CollisionResult<double> result;
  return fcl::collide(&a, X_a, &b, X_b, request, result) > 0;
}

/// A wavy block's top and sides as a part.
TriangleMesh part() {
  TriangleMesh mesh;
  constexpr int n = 40;
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) {
      const double x = -50.0 + 100.0 * i / n, y = -50.0 + 100.0 * j / n;
      mesh.vertices_mm.emplace_back(x, y, 12.0 * std::sin(x / 15.0) * std::cos(y / 12.0));
    }
  }
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const int v = j * (n + 1) + i;
      mesh.triangles.push_back({v, v + 1, v + n + 2});
      mesh.triangles.push_back({v, v + n + 2, v + n + 1});
    }
  }
  return mesh;
}

std::vector<Machine> machines() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(VOLUTE_SOURCE_DIR) / "machines")) {
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  std::vector<Machine> out;
  for (const auto& file : files) {
    auto machine = kinematics::load_machine(file);
    EXPECT_TRUE(machine) << machine.error().message;
    if (machine) out.push_back(*machine);
  }
  return out;
}

constexpr double length_mm = 120.0;  // gauge length of the tool here

/// A random position whose tip stands within `spread` of the part's middle.
AxisVector random_position(const Machine& m, std::mt19937_64& random, double spread) {
  std::uniform_real_distribution<> uniform(-1.0, 1.0);
  AxisVector q = AxisVector::Zero();
  for (int i = 3; i < 5; ++i) {
    const auto& axis = m.axes[static_cast<std::size_t>(i)];
    const double low = std::max(axis.travel_min.value_or(-3.0), -3.0),
                 high = std::min(axis.travel_max.value_or(3.0), 3.0);
    q[i] = low + (high - low) * 0.5 * (1.0 + uniform(random));
  }
  const Vec3 aim = spread * Vec3(uniform(random), uniform(random), uniform(random));
  const Vec3 tip = kinematics::forward(m, length_mm, q).translation();
  q.head<3>() = kinematics::jacobian(m, length_mm, q).topLeftCorner<3, 3>().partialPivLu().solve(aim - tip);
  return q;
}

struct Tally {
  int hits = 0, disagreements = 0, undecided = 0;
};

TEST(Agreement, BulletAndFclOnTheToolInThePartOnEveryMachine) {
  const TriangleMesh mesh = part();
  const auto skin = fcl_mesh(mesh);
  const auto body = CollisionBody::of_triangles("part", mesh);
  std::vector<std::unique_ptr<ConvexPiece>> pieces;
  pieces.push_back(cutter_piece({kinematics::CutterShape::ball, 3, 3, {}, 20, 2}, 0.0));
  pieces.push_back(frustum_piece({20, 20, 40, 50}));
  const CollisionBody tool("tool", std::move(pieces));
  const fcl::Sphere<double> nose(3.0);
  const fcl::Cylinder<double> flute(3.0, 17.0), holder(20.0, 50.0);
  const auto up = [](double z) { return Transform(Eigen::Translation3d(0, 0, z)); };
  std::mt19937_64 random(71);
  for (const Machine& m : machines()) {
    Tally tally;
    for (int i = 0; i < cases(300); ++i) {
      const AxisVector q = random_position(m, random, 35.0);
      const Transform X = kinematics::forward(m, length_mm, q);
      std::int64_t pairs = 0;
      const double distance = body_distance_mm(tool, body, X, 10.0, pairs);
      const bool hit = fcl_hits(nose, X * up(3.0), *skin, Transform::Identity()) ||
                       fcl_hits(flute, X * up(11.5), *skin, Transform::Identity()) ||
                       fcl_hits(holder, X * up(65.0), *skin, Transform::Identity());
      tally.hits += hit ? 1 : 0;
      if (hit == (distance <= 0.0)) continue;
      ++(std::abs(distance) < 1e-4 ? tally.undecided : tally.disagreements);
    }
    EXPECT_EQ(tally.disagreements, 0) << m.name << " seed 71";
    EXPECT_GT(tally.hits, cases(300) / 20) << m.name;
    EXPECT_LT(tally.hits, cases(300)) << m.name;
    RecordProperty(m.name + "_undecided", tally.undecided);
  }
}

/// Some corner of the part lies behind every face of some convex piece of the link: a solid holds it, a skin does not.
bool solid_holds_a_corner(const TriangleMesh& link, const TriangleMesh& inner, const Transform& X_link_part) {
  std::int64_t pairs = 0;
  const auto solid = CollisionBody::of_components("link", link);
  for (std::size_t v = 0; v < inner.vertices_mm.size(); v += 7) {
    const Vec3 p = X_link_part * inner.vertices_mm[v];
    std::vector<std::unique_ptr<ConvexPiece>> point;
    point.push_back(triangle_piece(p, p + Vec3(1e-6, 0, 0), p + Vec3(0, 1e-6, 0)));
    if (body_distance_mm(CollisionBody("point", std::move(point)), solid, Transform::Identity(), 1.0, pairs) <= 0.0)
      return true;
  }
  return false;
}

TEST(Agreement, BulletAndFclOnTheLinksAndThePartOnEveryMachine) {
  const TriangleMesh mesh = part();
  const auto skin = fcl_mesh(mesh);
  const auto body = CollisionBody::of_triangles("part", mesh);
  std::mt19937_64 random(72);
  for (const Machine& m : machines()) {
    int unexplained = 0, solid = 0, hits = 0, looked = 0;
    for (const auto& shape : m.shapes) {
      const auto link = CollisionBody::of_components(shape.name, shape.mesh_M);
      const auto link_skin = fcl_mesh(shape.mesh_M);
      for (int i = 0; i < cases(300) / 5; ++i) {
        const AxisVector q = random_position(m, random, 400.0);
        const Transform X = kinematics::link_motion(m, shape.link, q);
        std::int64_t pairs = 0;
        const double distance = body_distance_mm(link, body, X, 10.0, pairs);
        const bool hit = fcl_hits(*link_skin, X, *skin, Transform::Identity());
        ++looked;
        hits += hit ? 1 : 0;
        if (hit == (distance <= 0.0) || std::abs(distance) < 1e-4) continue;
        if (!hit && solid_holds_a_corner(shape.mesh_M, mesh, X.inverse()))
          ++solid;
        else
          ++unexplained;
      }
    }
    EXPECT_EQ(unexplained, 0) << m.name << " seed 72";
    RecordProperty(m.name + "_hits", hits);
    RecordProperty(m.name + "_solid", solid);
    RecordProperty(m.name + "_looked", looked);
  }
}

}  // namespace
}  // namespace volute::sim

#include <gtest/gtest.h>

#include <cstring>

#include "geometry/mesh_measure.hpp"
#include "geometry/mesh_report.hpp"
#include "tests/geometry/sample_meshes.hpp"

namespace volute::geometry::test {
namespace {

TriangleMesh loaded(const std::string& name, const std::string& bytes) {
  const auto mesh = load_mesh(written(name, bytes));
  EXPECT_TRUE(mesh) << mesh.error().message;
  return mesh ? mesh->mesh : TriangleMesh{};
}

const std::string off_square =
    "OFF # made by hand\n# a comment\n4 1 0\n0 0 0\n2 0 0 # corner\n2 1 0\n0 1 0\n4 0 1 2 3 255 0 0\n";
const std::string obj_square =
    "# made by hand\nmtllib none.mtl\no square\nv 0 0 0\nv 2 0 0 0.5 0.5 0.5\nv 2 1 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\ns "
    "off\nf 1/1/1 2//1 3/1 \\\n 4\n";
const std::string ply_square =
    "ply\nformat ascii 1.0\ncomment made by hand\nelement vertex 4\nproperty float x\nproperty float y\nproperty float "
    "z\nproperty "
    "uchar red\nelement face 1\nproperty list uchar int vertex_index\nend_header\n0 0 0 9\n2 0 0 9\n2 1 0 9\n0 1 0 "
    "9\n4 0 1 2 3\n";

TEST(MeshFormats, EachReadsASquare) {
  for (const auto& [name, text] : {std::pair("a.off", off_square),
                                   {"a.obj", obj_square},
                                   {"a.ply", ply_square},
                                   {"no-ending", off_square},
                                   {"a.stl", ply_square}}) {
    const TriangleMesh mesh = loaded(name, text);
    EXPECT_EQ(mesh.triangles.size(), 2U) << name;
    EXPECT_DOUBLE_EQ(area_mm2(mesh), 2.0) << name;
    EXPECT_EQ(triangle_normals(mesh).front(), Vec3::UnitZ()) << name;
  }
}

TEST(MeshFormats, ObjCountsBackFromTheLatestVertex) {
  EXPECT_DOUBLE_EQ(area_mm2(loaded("a.obj", "v 9 9 9\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\n")), 0.5);
}

TEST(MeshFormats, PlyComesBackExactly) {
  const TriangleMesh mesh = sphere(3.0, 2);
  const auto file = scratch("ply") / "sphere.ply";
  ASSERT_TRUE(save_ply(file, mesh, std::vector<std::array<unsigned char, 3>>(mesh.vertices_mm.size(), {1, 2, 3}),
                       std::vector<double>(mesh.vertices_mm.size(), 0.5)));
  const auto again = load_mesh(file);
  ASSERT_TRUE(again) << again.error().message;
  EXPECT_EQ(again->mesh.vertices_mm, mesh.vertices_mm);
  EXPECT_EQ(again->mesh.triangles, mesh.triangles);
}

template <class Number>
void append_big_endian(std::string& out, Number value) {
  char bytes[sizeof value];
  std::memcpy(bytes, &value, sizeof value);
  for (std::size_t i = sizeof value; i-- > 0;) out += bytes[i];
}

TEST(MeshFormats, BigEndianPlyWithListsToSkip) {
  std::string bytes =
      "ply\r\nformat binary_big_endian 1.0\r\nelement vertex 3\r\nproperty double x\r\nproperty short y\r\nproperty "
      "float z\r\nelement extra 2\r\n"
      "property list ushort float values\r\nelement face 1\r\nproperty uchar flag\r\nproperty list int uint "
      "vertex_indices\r\nend_header\r\n";
  for (const auto& [x, y] : {std::pair(0.0, 0), {3.0, 0}, {0.0, 4}}) {
    append_big_endian(bytes, x);
    append_big_endian(bytes, static_cast<std::int16_t>(y));
    append_big_endian(bytes, 1.5F);
  }
  for (int i = 0; i < 2; ++i) {
    append_big_endian(bytes, std::uint16_t{1});
    append_big_endian(bytes, 7.0F);
  }
  bytes += '\1';
  append_big_endian(bytes, std::int32_t{3});
  for (const std::uint32_t v : {0U, 1U, 2U}) append_big_endian(bytes, v);
  const TriangleMesh mesh = loaded("a.ply", bytes);
  EXPECT_DOUBLE_EQ(area_mm2(mesh), 6.0);
  EXPECT_DOUBLE_EQ(mesh.vertices_mm[0].z(), 1.5);
}

TEST(MeshFormats, AConcavePolygonIsCutInsideItself) {
  // An L: its area is 3; a fan from its first corner would cover the notch.
  const TriangleMesh mesh = loaded("a.off", "OFF\n6 1 0\n2 0 0\n2 1 0\n1 1 0\n1 2 0\n0 2 0\n0 0 0\n6 0 1 2 3 4 5\n");
  EXPECT_EQ(mesh.triangles.size(), 4U);
  EXPECT_DOUBLE_EQ(area_mm2(mesh), 3.0);
  for (const Vec3& n : triangle_normals(mesh)) EXPECT_DOUBLE_EQ(n.z(), 1.0);
}

TEST(MeshFormats, AQuadIsCutAlongItsBetterDiagonal) {
  const TriangleMesh mesh = loaded("a.off", "OFF\n4 1 0\n-5 0 0\n0 -1 0\n5 0 0\n0 1 0\n4 0 1 2 3\n");
  const MeshReport report = inspect({mesh, {}});
  EXPECT_NEAR(report.least_angle_deg, 22.62, 0.01);  // 2 atan(1 / 5), not atan(1 / 5)
}

}  // namespace
}  // namespace volute::geometry::test

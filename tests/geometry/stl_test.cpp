#include <gtest/gtest.h>

#include "geometry/mesh_measure.hpp"
#include "tests/geometry/sample_meshes.hpp"

namespace volute::geometry::test {
namespace {

LoadedMesh loaded(const std::filesystem::path& file, double unit_mm = 1.0) {
  const auto mesh = load_mesh(file, unit_mm);
  EXPECT_TRUE(mesh) << mesh.error().message;
  return mesh ? *mesh : LoadedMesh{};
}

TEST(Stl, BinaryAndTextGiveTheSameMesh) {
  const TriangleMesh mesh = torus(5.0, 2.0, 12, 8);
  const LoadedMesh binary = loaded(written("torus.stl", stl_bytes(mesh)));
  const LoadedMesh text = loaded(written("torus.stl", stl_text(mesh)));
  ASSERT_EQ(binary.mesh.triangles, text.mesh.triangles);
  for (std::size_t v = 0; v < binary.mesh.vertices_mm.size(); ++v)
    EXPECT_LT((binary.mesh.vertices_mm[v] - text.mesh.vertices_mm[v]).norm(), 1e-6);
}

TEST(Stl, ABinaryFileThatBeginsWithSolidIsBinary) {
  std::string bytes = stl_bytes(sheet(3, 3));
  bytes.replace(0, 13, "solid cad-out");
  EXPECT_EQ(loaded(written("a.stl", bytes)).mesh.triangles.size(), 18U);
}

TEST(Stl, TextMayHaveWindowsLineEndsCapitalsAndSeveralSolids) {
  std::string text;
  for (const char c : stl_text(sheet(1, 1)) + stl_text(sheet(2, 1))) {
    if (c == '\n') text += '\r';
    text += static_cast<char>(std::toupper(c));
  }
  EXPECT_EQ(loaded(written("a.stl", text)).mesh.triangles.size(), 4U);  // two of the six are there twice
}

TEST(Stl, UnitScalesEverything) {
  EXPECT_NEAR(area_mm2(loaded(written("a.stl", stl_bytes(sheet(2, 2))), 25.4).mesh), 4.0 * 25.4 * 25.4, 1e-9);
}

TEST(Stl, SavedBytesAreTheSameAgain) {
  EXPECT_EQ(stl_bytes(sphere(3.0, 2)), stl_bytes(loaded(written("s.stl", stl_bytes(sphere(3.0, 2)))).mesh));
}

TEST(Stl, TurnedTrianglesAreRepairedWithAWarning) {
  const LoadedMesh mesh = loaded(written("a.stl", stl_bytes(turned(sheet(3, 3), {4, 5}))));
  EXPECT_EQ(mesh.repairs.triangles_turned, 2);
  ASSERT_EQ(mesh.repairs.warnings.size(), 1U);
  EXPECT_TRUE(MeshTopology::build(mesh.mesh));
}

}  // namespace
}  // namespace volute::geometry::test

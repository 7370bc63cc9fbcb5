// Every kind of bad mesh file ends with its own name and one line; no file whatever brings the reader down.
#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <random>

#include "geometry/file.hpp"
#include "geometry/mesh_report.hpp"
#include "tests/geometry/sample_meshes.hpp"

namespace volute::geometry::test {
namespace {

/// The code, "" when the file is accepted; checks that the message is one line and names the file.
std::string refusal(const std::filesystem::path& file) {
  const auto mesh = load_mesh(file);
  if (mesh) return "";
  EXPECT_EQ(mesh.error().kind, ErrorKind::bad_input);
  EXPECT_EQ(mesh.error().message.find('\n'), std::string::npos) << mesh.error().message;
  EXPECT_EQ(mesh.error().message.find(file.string()), 0U) << mesh.error().message;
  return mesh.error().code;
}
std::string refusal(const std::string& name, std::string_view bytes) { return refusal(written(name, bytes)); }

std::string with_count(std::string bytes, std::uint32_t count) {
  std::memcpy(bytes.data() + 80, &count, sizeof count);
  return bytes;
}

std::string with_float(std::string bytes, std::size_t triangle, std::size_t which, float value) {
  std::memcpy(bytes.data() + 84 + 50 * triangle + 4 * which, &value, sizeof value);
  return bytes;
}

TEST(DamagedStl, IsToldApartByName) {
  const std::string good = stl_bytes(sphere(5.0, 2));
  EXPECT_EQ(refusal("a.stl", good), "");
  EXPECT_EQ(refusal("a.stl", ""), "file-empty");
  EXPECT_EQ(refusal("a.stl", good.substr(0, 50)), "mesh-truncated");
  EXPECT_EQ(refusal("a.stl", good.substr(0, 2000)), "mesh-truncated");
  EXPECT_EQ(refusal("a.stl", with_count(good, 129)), "mesh-count-impossible");
  EXPECT_EQ(refusal("a.stl", with_count(good, 127)), "mesh-count-impossible");
  EXPECT_EQ(refusal("a.stl", with_count(good.substr(0, 84), 0)), "mesh-empty");
  EXPECT_EQ(refusal("a.stl", with_float(good, 7, 4, std::numeric_limits<float>::quiet_NaN())), "mesh-not-finite");
  EXPECT_EQ(refusal("a.stl", with_float(good, 7, 9, std::numeric_limits<float>::infinity())), "mesh-not-finite");
  EXPECT_EQ(refusal("a.stl", with_float(good, 7, 4, 1e30F)), "mesh-not-finite");
  EXPECT_EQ(refusal(scratch("none") / "a.stl"), "file-missing");
}

TEST(DamagedStl, ATenGigabyteClaimInAHeaderIsRefusedBeforeAnythingIsAllocated) {
  const std::string header = with_count(stl_bytes(sphere(5.0, 1)).substr(0, 84), 200'000'000U);
  EXPECT_EQ(refusal("a.stl", header), "mesh-count-impossible");
  EXPECT_EQ(refusal("a.stl", with_count(header, 0xFFFFFFFFU)), "mesh-count-impossible");
}

TEST(DamagedStlText, IsToldApartByNameAndLine) {
  const std::string good = stl_text(sheet(2, 2));
  EXPECT_EQ(refusal("a.stl", good.substr(0, 300)), "mesh-truncated");
  EXPECT_EQ(refusal("a.stl", good.substr(0, good.find("endsolid"))), "mesh-truncated");
  EXPECT_EQ(refusal("a.stl", "solid nothing\nendsolid\n"), "mesh-empty");
  const auto changed = [&](const std::string& from, const std::string& to) {
    return std::string(good).replace(good.find(from), from.size(), to);
  };
  EXPECT_EQ(refusal("a.stl", changed("vertex 1 0 0", "vertex nan 0 0")), "mesh-not-finite");
  EXPECT_EQ(refusal("a.stl", changed("vertex 1 0 0", "vertex 1 -inf 0")), "mesh-not-finite");
  EXPECT_EQ(refusal("a.stl", changed("vertex 1 0 0", "vertex 1,0 0 0")), "mesh-syntax");
  EXPECT_EQ(refusal("a.stl", changed("outer loop", "outer lop")), "mesh-syntax");
  const auto mesh = load_mesh(written("a.stl", changed("vertex 1 0 0", "vertex 1 x 0")));
  ASSERT_FALSE(mesh);
  EXPECT_NE(mesh.error().message.find("a.stl:5: \"x\""), std::string::npos) << mesh.error().message;
}

const std::string ply_head =
    "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\nproperty float x\nproperty float y\nproperty "
    "float z\n"
    "element face 4000000000\nproperty list uchar int vertex_indices\nend_header\n";

TEST(DamagedPly, IsToldApartByName) {
  const auto file = scratch("ply") / "a.ply";
  ASSERT_TRUE(save_ply(file, sphere(3.0, 2)));
  const std::string good = read_file(file).value();
  EXPECT_EQ(refusal("a.ply", good), "");
  EXPECT_EQ(refusal("a.ply", good.substr(0, 40)), "mesh-truncated");
  EXPECT_EQ(refusal("a.ply", good.substr(0, 900)), "mesh-truncated");
  EXPECT_EQ(refusal("a.ply", good.substr(0, good.size() - 2)), "mesh-truncated");
  EXPECT_EQ(refusal("a.ply", ply_head), "mesh-count-impossible");
  EXPECT_EQ(refusal("a.ply", "ply\nformat ascii 1.0\nelement vertex -3\nproperty float x\n"), "mesh-syntax");
  EXPECT_EQ(refusal("a.ply", "ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nend_header\n"), "mesh-syntax");
  std::string far = good;
  far[far.size() - 1] = '\x7f';
  EXPECT_EQ(refusal("a.ply", far), "mesh-index-out-of-range");
}

TEST(DamagedOff, IsToldApartByName) {
  EXPECT_EQ(refusal("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"), "mesh-index-out-of-range");
  EXPECT_EQ(refusal("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n2 0 1\n"), "mesh-syntax");
  EXPECT_EQ(refusal("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0\n"), "mesh-truncated");
  EXPECT_EQ(refusal("a.off", "OFF\n3 2000000000 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"), "mesh-count-impossible");
  EXPECT_EQ(refusal("a.off", "OFF\n3 1 0\n0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n"), "mesh-not-finite");
  EXPECT_EQ(refusal("a.off", "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n"), "mesh-empty");
  EXPECT_EQ(refusal("a.off", "OFF BINARY\n"), "mesh-format-unknown");
}

TEST(DamagedObj, IsToldApartByName) {
  EXPECT_EQ(refusal("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n"), "mesh-index-out-of-range");
  EXPECT_EQ(refusal("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\n"), "mesh-syntax");
  EXPECT_EQ(refusal("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 0\n"), "mesh-syntax");
  EXPECT_EQ(refusal("a.obj", "v 0 0\nv 1 0 0\n"), "mesh-syntax");
  EXPECT_EQ(refusal("a.obj", "v 0 inf 0\n"), "mesh-not-finite");
  EXPECT_EQ(refusal("a.obj", "hello\n"), "mesh-syntax");
  EXPECT_EQ(refusal("a.obj", "v 0 0 0\n"), "mesh-empty");
  EXPECT_EQ(refusal("a.xyz", "hello\n"), "mesh-format-unknown");
}

TEST(DamagedMesh, ASurfaceOfNothingButSliversIsEmpty) {
  EXPECT_EQ(refusal("a.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n"), "mesh-empty");
}

double greatest_shift_mm(const TriangleMesh& a, const TriangleMesh& b) {
  double greatest = 0.0;
  for (const Vec3& p : a.vertices_mm) {
    double nearest = std::numeric_limits<double>::max();
    for (const Vec3& q : b.vertices_mm) nearest = std::min(nearest, (p - q).norm());
    greatest = std::max(greatest, nearest);
  }
  return greatest;
}

TEST(DamagedStl, AFlippedBitIsRefusedOrMovesNothing) {
  const unsigned seed = 5;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  const TriangleMesh mesh = sphere(5.0, 2);
  const std::string good = stl_bytes(mesh);
  int refused = 0;
  for (int i = 0; i < cases(600); ++i) {
    std::string bytes = good;
    const std::size_t position = 80 + random() % (bytes.size() - 80);
    const int bit = static_cast<int>(random() % 8);
    bytes[position] = static_cast<char>(bytes[position] ^ (1 << bit));
    const auto loaded = load_mesh(written("flipped.stl", bytes));
    if (!loaded) {
      ++refused;
      continue;
    }
    EXPECT_EQ(loaded->mesh.triangles.size(), mesh.triangles.size()) << "byte " << position << " bit " << bit;
    EXPECT_LT(greatest_shift_mm(loaded->mesh, mesh), 1e-5) << "byte " << position << " bit " << bit;
    EXPECT_EQ(MeshTopology::build(loaded->mesh)->boundary_loops().size(), 0U);
  }
  EXPECT_GT(refused, cases(600) / 3);
}

TEST(DamagedFiles, NoCutAndNoNoiseBringsAReaderDown) {
  const unsigned seed = 6;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  const auto file = scratch("ply") / "a.ply";
  ASSERT_TRUE(save_ply(file, sphere(3.0, 1)));
  const std::vector<std::pair<std::string, std::string>> samples = {
      {"a.stl", stl_bytes(sphere(3.0, 1))},
      {"a.stl", stl_text(sphere(3.0, 1))},
      {"a.ply", read_file(file).value()},
      {"a.off", "OFF\n4 2 0\n0 0 0\n2 0 0\n2 1 0\n0 1 0\n4 0 1 2 3\n3 0 1 2\n"},
      {"a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"}};
  for (int i = 0; i < cases(600); ++i) {
    auto [name, bytes] = samples[random() % samples.size()];
    if (random() % 2 == 0) bytes.resize(random() % bytes.size());
    for (std::size_t changes = random() % 6; changes > 0 && !bytes.empty(); --changes)
      bytes[random() % bytes.size()] = static_cast<char>(random());
    const auto path = written(name, bytes);
    if (const auto mesh = load_mesh(path))
      inspect(*mesh);
    else
      EXPECT_EQ(mesh.error().message.find('\n'), std::string::npos);
  }
}

}  // namespace
}  // namespace volute::geometry::test

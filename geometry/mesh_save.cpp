#include <cstring>
#include <string>

#include "geometry/check.hpp"
#include "geometry/file.hpp"
#include "geometry/mesh_io.hpp"
#include "geometry/mesh_measure.hpp"

namespace volute::geometry {

namespace {

template <class Number>
void append_bytes(std::string& out, Number value) {
  char bytes[sizeof value];
  std::memcpy(bytes, &value, sizeof value);
  out.append(bytes, sizeof value);
}

void append_floats(std::string& out, const Vec3& point) {
  for (int k = 0; k < 3; ++k) append_bytes(out, static_cast<float>(point[k] + 0.0));
}

/// Rounded to float first, so that the normal fits the corners that a reader will see.
Vec3 as_stored(const TriangleMesh& mesh, Index vertex) {
  return mesh.vertices_mm[static_cast<std::size_t>(vertex)].cast<float>().cast<double>();
}

std::string ply_header(const TriangleMesh& mesh, bool with_colours, bool with_quality) {
  std::string header = "ply\nformat binary_little_endian 1.0\ncomment unit mm\nelement vertex " +
                       std::to_string(mesh.vertices_mm.size()) +
                       "\nproperty double x\nproperty double y\nproperty double z\n";
  if (with_colours) header += "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  if (with_quality) header += "property double quality\n";
  return header + "element face " + std::to_string(mesh.triangles.size()) +
         "\nproperty list uchar int vertex_indices\nend_header\n";
}

}  // namespace

Result<void> save_stl(const std::filesystem::path& file, const TriangleMesh& mesh) {
  std::string bytes = "binary STL, unit mm";
  bytes.resize(80, ' ');
  bytes.reserve(84 + 50 * mesh.triangles.size());
  append_bytes(bytes, static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const Triangle& corners : mesh.triangles) {
    const Vec3 a = as_stored(mesh, corners[0]), b = as_stored(mesh, corners[1]), c = as_stored(mesh, corners[2]);
    append_floats(bytes, (b - a).cross(c - a).normalized());
    append_floats(bytes, a);
    append_floats(bytes, b);
    append_floats(bytes, c);
    append_bytes(bytes, std::uint16_t{0});
  }
  return write_file(file, bytes);
}

Result<void> save_ply(const std::filesystem::path& file, const TriangleMesh& mesh,
                      const std::vector<std::array<unsigned char, 3>>& colours, const std::vector<double>& quality) {
  VOLUTE_CHECK(colours.empty() || colours.size() == mesh.vertices_mm.size(), colours.size(), mesh.vertices_mm.size());
  VOLUTE_CHECK(quality.empty() || quality.size() == mesh.vertices_mm.size(), quality.size(), mesh.vertices_mm.size());
  std::string bytes = ply_header(mesh, !colours.empty(), !quality.empty());
  for (std::size_t v = 0; v < mesh.vertices_mm.size(); ++v) {
    for (int k = 0; k < 3; ++k) append_bytes(bytes, mesh.vertices_mm[v][k]);
    if (!colours.empty())
      for (const unsigned char part : colours[v]) append_bytes(bytes, part);
    if (!quality.empty()) append_bytes(bytes, quality[v]);
  }
  for (const Triangle& corners : mesh.triangles) {
    append_bytes(bytes, static_cast<unsigned char>(3));
    for (const Index v : corners) append_bytes(bytes, v);
  }
  return write_file(file, bytes);
}

}  // namespace volute::geometry

#include "tests/geometry/sample_meshes.hpp"

#include <unistd.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <numbers>

#include "geometry/index.hpp"
#include "geometry/number_text.hpp"

namespace volute::geometry::test {

using geometry::at;

namespace {
constexpr double pi = std::numbers::pi;
/// A grid of vertices (columns x rows), wrapped round in one or both directions.
template <class Point>
TriangleMesh grid(int columns, int rows, bool wrap_columns, bool wrap_rows, const Point& point) {
  TriangleMesh mesh;
  const int column_vertices = wrap_columns ? columns : columns + 1, row_vertices = wrap_rows ? rows : rows + 1;
  for (int r = 0; r < row_vertices; ++r)
    for (int c = 0; c < column_vertices; ++c) mesh.vertices_mm.push_back(point(c, r));
  const auto index = [&](int c, int r) { return (r % row_vertices) * column_vertices + c % column_vertices; };
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c) {
      mesh.triangles.push_back({index(c, r), index(c + 1, r), index(c + 1, r + 1)});
      mesh.triangles.push_back({index(c, r), index(c + 1, r + 1), index(c, r + 1)});
    }
  return mesh;
}
}  // namespace

TriangleMesh sheet(int nx, int ny, double size_mm) {
  return grid(nx, ny, false, false, [&](int c, int r) { return Vec3(c * size_mm, r * size_mm, 0.0); });
}

TriangleMesh sheet_with_hole(int nx, int ny, int i, int j) {
  TriangleMesh mesh = sheet(nx, ny);
  const auto first = mesh.triangles.begin() + 2 * (j * nx + i);
  mesh.triangles.erase(first, first + 2);
  return mesh;
}

TriangleMesh tetrahedron() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
}

TriangleMesh sphere(double radius_mm, int subdivisions) {
  TriangleMesh mesh{{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
                    {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
  for (int s = 0; s < subdivisions; ++s) {
    std::map<std::pair<Index, Index>, Index> middles;
    const auto middle = [&](Index a, Index b) {
      const auto [found, fresh] = middles.try_emplace(std::minmax(a, b), static_cast<Index>(mesh.vertices_mm.size()));
      if (fresh) mesh.vertices_mm.push_back((mesh.vertices_mm[at(a)] + mesh.vertices_mm[at(b)]).normalized());
      return found->second;
    };
    std::vector<Triangle> finer;
    for (const Triangle& t : mesh.triangles) {
      const Index ab = middle(t[0], t[1]), bc = middle(t[1], t[2]), ca = middle(t[2], t[0]);
      finer.insert(finer.end(), {{t[0], ab, ca}, {ab, t[1], bc}, {ca, bc, t[2]}, {ab, bc, ca}});
    }
    mesh.triangles = finer;
  }
  for (Vec3& p : mesh.vertices_mm) p *= radius_mm;
  return mesh;
}

TriangleMesh tube(double radius_mm, double length_mm, int around, int along) {
  return grid(around, along, true, false, [&](int c, int r) {
    const double angle = 2.0 * pi * c / around;
    return Vec3(radius_mm * std::cos(angle), radius_mm * std::sin(angle), length_mm * r / along);
  });
}

TriangleMesh torus(double major_mm, double minor_mm, int around, int across) {
  return grid(around, across, true, true, [&](int c, int r) {
    const double u = 2.0 * pi * c / around, v = 2.0 * pi * r / across, radius = major_mm + minor_mm * std::cos(v);
    return Vec3(radius * std::cos(u), radius * std::sin(u), minor_mm * std::sin(v));
  });
}

TriangleMesh moebius_band(int around) {
  TriangleMesh mesh = grid(around, 1, false, false, [&](int c, int r) {
    const double u = 2.0 * pi * c / around, w = r - 0.5, radius = 5.0 + w * std::cos(0.5 * u);
    return Vec3(radius * std::cos(u), radius * std::sin(u), w * std::sin(0.5 * u));
  });
  // The last column is the first one upside down.
  const Index row = around + 1;
  for (Triangle& t : mesh.triangles)
    for (Index& v : t) v = v == around ? row : v == row + around ? 0 : v;
  return weld(std::move(mesh)).mesh;
}

TriangleMesh together(const TriangleMesh& a, const TriangleMesh& b) {
  TriangleMesh mesh = a;
  const auto offset = static_cast<Index>(a.vertices_mm.size());
  mesh.vertices_mm.insert(mesh.vertices_mm.end(), b.vertices_mm.begin(), b.vertices_mm.end());
  for (const Triangle& t : b.triangles) mesh.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
  return mesh;
}

TriangleMesh soup_of(const TriangleMesh& mesh) {
  TriangleMesh soup;
  for (const Triangle& t : mesh.triangles) {
    const auto first = static_cast<Index>(soup.vertices_mm.size());
    for (const Index v : t) soup.vertices_mm.push_back(mesh.vertices_mm[at(v)]);
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  return soup;
}

TriangleMesh turned(TriangleMesh mesh, const std::vector<Index>& triangles) {
  for (const Index t : triangles) std::swap(mesh.triangles[at(t)][0], mesh.triangles[at(t)][1]);
  return mesh;
}

std::string stl_bytes(const TriangleMesh& mesh) {
  const auto file = scratch("stl_bytes") / "mesh.stl";
  if (!save_stl(file, mesh)) return {};
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string stl_text(const TriangleMesh& mesh) {
  std::string text = "solid sample\n";
  for (const Triangle& t : mesh.triangles) {
    text += " facet normal 0 0 0\n  outer loop\n";
    for (const Index v : t) {
      text += "   vertex";
      for (int k = 0; k < 3; ++k) text += " " + shortest_text(mesh.vertices_mm[at(v)][k]);
      text += "\n";
    }
    text += "  endloop\n endfacet\n";
  }
  return text + "endsolid sample\n";
}

std::filesystem::path scratch(const std::string& name) {
  const auto folder = std::filesystem::temp_directory_path() / ("volute-geometry-" + std::to_string(::getpid())) / name;
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder;
}

std::filesystem::path written(const std::string& name, std::string_view bytes) {
  const auto file = scratch("written") / name;
  std::ofstream(file, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return file;
}

}  // namespace volute::geometry::test

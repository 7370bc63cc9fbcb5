// Meshes whose every property is known in closed form, and files made of them.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <random>
#include <string>

#include "geometry/mesh_io.hpp"
#include "tests/cases.hpp"

namespace volute::geometry::test {

/// nx x ny squares of the given size in the xy plane, each cut in two, normals up.
TriangleMesh sheet(int nx, int ny, double size_mm = 1.0);
/// A sheet without the square at (i, j).
TriangleMesh sheet_with_hole(int nx, int ny, int i, int j);
TriangleMesh tetrahedron();
/// Subdivided octahedron, vertices on the sphere.
TriangleMesh sphere(double radius_mm, int subdivisions);
/// Open tube about z.
TriangleMesh tube(double radius_mm, double length_mm, int around, int along);
TriangleMesh torus(double major_mm, double minor_mm, int around, int across);
TriangleMesh moebius_band(int around);
/// Two meshes side by side in one.
TriangleMesh together(const TriangleMesh& a, const TriangleMesh& b);
/// Three vertices of its own for every triangle, as in an STL.
TriangleMesh soup_of(const TriangleMesh& mesh);
TriangleMesh turned(TriangleMesh mesh, const std::vector<Index>& triangles);

/// The bytes of a binary STL with right normals.
std::string stl_bytes(const TriangleMesh& mesh);
std::string stl_text(const TriangleMesh& mesh);

/// A folder for this test alone, emptied first.
std::filesystem::path scratch(const std::string& name);
std::filesystem::path written(const std::string& name, std::string_view bytes);

}  // namespace volute::geometry::test

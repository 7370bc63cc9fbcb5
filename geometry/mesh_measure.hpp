// Areas, normals and curvature of a triangle mesh.
#pragma once

#include <vector>

#include "geometry/mesh.hpp"

namespace volute::geometry {

double triangle_area_mm2(const TriangleMesh& mesh, Index triangle);
double area_mm2(const TriangleMesh& mesh);
/// Unit normal of each triangle. Requires: no degenerate triangle.
std::vector<Vec3> triangle_normals(const TriangleMesh& mesh);
/// Unit normal at each vertex: corner-angle weighted mean of the triangle normals.
std::vector<Vec3> vertex_normals(const TriangleMesh& mesh);

/// The curvature tensor of each triangle as a symmetric 3 x 3 matrix S in the part's axes with S n = 0: the normal
/// curvature in the unit tangent direction d is d . S d, in 1/mm, POSITIVE where the surface is convex seen from
/// outside (a ball of radius R seen from outside has +1/R). From the vertex normals' change along each edge
/// (Rusinkiewicz 2004), averaged `rounds` times over vertex neighbours with area weights. Accuracy: on a sphere or
/// cylinder of edge length e << R the error is O(e/R^2).
std::vector<Mat3> triangle_curvature(const TriangleMesh& mesh, int rounds = 6);

struct PrincipalCurvature {
  double least_per_mm = 0.0, greatest_per_mm = 0.0;
  Vec3 direction_of_greatest = Vec3::UnitX();  ///< unit tangent; arbitrary tangent at an umbilic
};
PrincipalCurvature principal_curvature(const Mat3& tensor, const Vec3& unit_normal);

}  // namespace volute::geometry

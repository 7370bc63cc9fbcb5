#include "geometry/mesh_damage.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "geometry/index.hpp"
#include "geometry/number_text.hpp"

namespace volute::geometry {

namespace {

/// Between writers' rounding, which stays far below, and a changed bit that matters.
constexpr double least_misfit = 0.02;
/// Triangles are judged from this number on.
constexpr std::size_t least_judged = 8;

enum class Fit { not_judged, good, bad };

Vec3 stored_normal(std::string_view bytes, std::size_t triangle) {
  float normal[3];
  std::memcpy(normal, bytes.data() + 84 + 50 * triangle, sizeof normal);
  return {normal[0], normal[1], normal[2]};
}

/// `spacing_mm`: of floats at the farthest vertex. Slivers, whose direction drowns in rounding, are not judged.
Fit fit_of(const TriangleMesh& soup, const Triangle& t, const Vec3& stored, double spacing_mm) {
  if (stored == Vec3::Zero()) return Fit::not_judged;
  const Vec3 &a = soup.vertices_mm[at(t[0])], &b = soup.vertices_mm[at(t[1])], &c = soup.vertices_mm[at(t[2])];
  const Vec3 across = (b - a).cross(c - a);
  const double longest = std::sqrt(std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()}));
  const double height = across.norm() / longest;
  if (!(height > 100.0 * spacing_mm) || height < 1e-3 * longest) return Fit::not_judged;
  const double misfit = (stored - across.normalized()).norm();
  return misfit <= least_misfit + 8.0 * spacing_mm / height ? Fit::good : Fit::bad;
}

double float_spacing_mm(const TriangleMesh& soup) {
  double farthest = 0.0;
  for (const Vec3& p : soup.vertices_mm) farthest = std::max(farthest, p.cwiseAbs().maxCoeff());
  return std::ldexp(farthest, -23);
}

std::string point_text(const Vec3& p) {
  return "(" + short_text(p.x()) + ", " + short_text(p.y()) + ", " + short_text(p.z()) + ")";
}

}  // namespace

Result<void> check_stored_normals(std::string_view bytes, const TriangleMesh& soup, const std::string& name) {
  const double spacing_mm = float_spacing_mm(soup);
  std::size_t judged = 0, bad = 0, first_bad = 0;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
    const Fit fit = fit_of(soup, soup.triangles[t], stored_normal(bytes, t), spacing_mm);
    if (fit == Fit::not_judged) continue;
    ++judged;
    if (fit == Fit::bad && bad++ == 0) first_bad = t;
  }
  if (bad == 0 || judged < least_judged || bad > std::max<std::size_t>(1, judged / 100)) return {};
  return bad_input("mesh-damaged", name + ": triangle " + std::to_string(first_bad) +
                                       ": its corners do not fit its stored normal, as those of " +
                                       std::to_string(judged - bad) +
                                       " other triangles do; the file is damaged, copy or export it again");
}

Result<void> check_torn(const TriangleMesh& welded, const std::string& name) {
  const Result<MeshTopology> topology = MeshTopology::build(welded);
  if (!topology) return {};
  for (const BoundaryLoop& loop : topology->boundary_loops()) {
    if (loop.vertices.size() != 4) continue;
    if (topology->components()[at(loop.component)].triangles < static_cast<Index>(least_judged)) continue;
    for (const Index v : loop.vertices)
      if (topology->outgoing(v).size() == 1)
        return bad_input("mesh-damaged",
                         name + ": the triangle with a corner at " + point_text(welded.vertices_mm[at(v)]) +
                             " hangs on by one edge over a gap; the file is damaged, copy or export it again");
  }
  return {};
}

}  // namespace volute::geometry

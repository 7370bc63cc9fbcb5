#include "geometry/mesh_report.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/angle.hpp"
#include "geometry/edge_groups.hpp"
#include "geometry/index.hpp"
#include "geometry/mesh_measure.hpp"

namespace volute::geometry {

namespace {

struct Verdict {
  std::string code, reason;
};

Verdict component_verdict(const Component& component) {
  if (component.boundary_loops == 0)
    return {
        "mesh-no-boundary",
        "the surface is closed: a spiral needs an edge to start from; cut away the faces that are not to be machined"};
  if (component.handles > 0)
    return {"mesh-handles",
            "the surface has " + std::to_string(component.handles) + (component.handles == 1 ? " handle" : " handles") +
                " (a tunnel through it): it cannot be laid flat; cut it open or machine its parts one by one"};
  return {};
}

Verdict topology_verdict(const std::vector<Component>& components) {
  if (components.size() > 1)
    return {"mesh-several-components", "the mesh has " + std::to_string(components.size()) +
                                           " separate components; a path is planned on one: choose one by number (0 is "
                                           "the largest) or export it alone"};
  return component_verdict(components.front());
}

void measure_extent(const TriangleMesh& mesh, MeshReport& report) {
  report.least_mm = report.greatest_mm = mesh.vertices_mm.front();
  for (const Vec3& p : mesh.vertices_mm) {
    report.least_mm = report.least_mm.cwiseMin(p);
    report.greatest_mm = report.greatest_mm.cwiseMax(p);
  }
}

void measure_angles(const TriangleMesh& mesh, MeshReport& report) {
  double least = std::numbers::pi, greatest = 0.0;
  for (const Triangle& corners : mesh.triangles) {
    double widest = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& p = mesh.vertices_mm[at(corners[k])];
      const Vec3 u = mesh.vertices_mm[at(corners[(k + 1) % 3])] - p, v = mesh.vertices_mm[at(corners[(k + 2) % 3])] - p;
      const double angle = std::atan2(u.cross(v).norm(), u.dot(v));
      least = std::min(least, angle);
      widest = std::max(widest, angle);
    }
    greatest = std::max(greatest, widest);
    if (widest > 0.5 * std::numbers::pi + 1e-9) ++report.obtuse_triangles;
  }
  report.least_angle_deg = Angle::radians(least).degrees();
  report.greatest_angle_deg = Angle::radians(greatest).degrees();
}

double median_edge_mm(const TriangleMesh& mesh) {
  const EdgeGroups edges = group_edges(mesh);
  std::vector<double> lengths;
  for (Index e = 0; e < edges.count(); ++e) {
    const Index h = edges.group(e).front();
    lengths.push_back((mesh.vertices_mm[at(target(mesh, h))] - mesh.vertices_mm[at(origin(mesh, h))]).norm());
  }
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  return *middle;
}

TriangleMesh extracted(const TriangleMesh& mesh, const MeshTopology& topology, Index component) {
  TriangleMesh part;
  std::vector<Index> number(mesh.vertices_mm.size(), no_index);
  for (Index t = 0; t < topology.triangle_count(); ++t) {
    if (topology.component_of_triangle(t) != component) continue;
    part.triangles.push_back(mesh.triangles[at(t)]);
    for (const Index v : part.triangles.back()) number[at(v)] = 0;
  }
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (number[v] == no_index) continue;
    number[v] = static_cast<Index>(part.vertices_mm.size());
    part.vertices_mm.push_back(mesh.vertices_mm[v]);
  }
  for (Triangle& corners : part.triangles)
    for (Index& v : corners) v = number[at(v)];
  return part;
}

}  // namespace

MeshReport inspect(const LoadedMesh& loaded) {
  MeshReport report;
  const TriangleMesh& mesh = loaded.mesh;
  report.triangles = static_cast<Index>(mesh.triangles.size());
  report.vertices = static_cast<Index>(mesh.vertices_mm.size());
  report.repairs = loaded.repairs;
  const Result<MeshTopology> topology = MeshTopology::build(mesh);
  if (!topology) {
    report.reason_code = topology.error().code;
    report.reason = topology.error().message;
    if (report.reason_code == "mesh-empty" || report.reason_code == "mesh-index-out-of-range") return report;
  }
  report.area_mm2 = area_mm2(mesh);
  measure_extent(mesh, report);
  measure_angles(mesh, report);
  report.median_edge_mm = median_edge_mm(mesh);
  if (!topology) return report;
  report.loops = topology->boundary_loops();
  report.components = topology->components();
  for (const Component& component : report.components) report.handles += component.handles;
  const Verdict verdict = topology_verdict(report.components);
  report.machinable = verdict.code.empty();
  report.reason_code = verdict.code;
  report.reason = verdict.reason;
  return report;
}

Result<TriangleMesh> machinable_surface(const LoadedMesh& loaded, int component) {
  const Result<MeshTopology> topology = MeshTopology::build(loaded.mesh);
  if (!topology) return tl::unexpected(topology.error());
  const auto& components = topology->components();
  if (component >= static_cast<int>(components.size()))
    return bad_input("component-out-of-range",
                     "component " + std::to_string(component) + " does not exist: the mesh has " +
                         std::to_string(components.size()) + ", numbered from 0 by falling area");
  const Verdict verdict = component < 0 ? topology_verdict(components) : component_verdict(components[at(component)]);
  if (!verdict.code.empty()) return bad_input(verdict.code, verdict.reason);
  if (components.size() == 1) return loaded.mesh;
  return extracted(loaded.mesh, *topology, component);
}

}  // namespace volute::geometry

// The machine at a moment: its links where the axes have them, the tool with its holder, the part and the way so far.
#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/number_text.hpp"
#include "view/pictures.hpp"
#include "view/solids.hpp"

namespace volute::view {

namespace {

using geometry::Transform;
using geometry::TriangleMesh;

constexpr int sectors = 48;
constexpr double profile_tolerance_mm = 0.02, near_reach = 1.6;
constexpr Colour link_colour{0.72F, 0.77F, 0.83F}, cutter_colour{0.88F, 0.65F, 0.15F},
    shank_colour{0.73F, 0.75F, 0.78F}, holder_colour{0.35F, 0.38F, 0.42F}, way_colour{0.10F, 0.35F, 0.75F};

void append(TriangleMesh& to, const TriangleMesh& from) {
  const auto first = static_cast<geometry::Index>(to.vertices_mm.size());
  to.vertices_mm.insert(to.vertices_mm.end(), from.vertices_mm.begin(), from.vertices_mm.end());
  for (const geometry::Triangle& t : from.triangles) to.triangles.push_back({first + t[0], first + t[1], first + t[2]});
}

/// Cutter, shank and holder. Bands belong to the part in which their middle lies.
std::array<TriangleMesh, 3> tool_meshes(const kinematics::Tool& tool) {
  std::array<TriangleMesh, 3> meshes;
  const auto profile = kinematics::assembly_profile(tool, profile_tolerance_mm);
  for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
    const double middle = 0.5 * (profile[i].z_mm + profile[i + 1].z_mm);
    const bool steps_up = profile[i].z_mm == profile[i + 1].z_mm && profile[i].z_mm >= tool.stick_out_mm;
    const std::size_t part = middle > tool.stick_out_mm || steps_up ? 2 : middle > tool.cutter.length_mm ? 1 : 0;
    append(meshes[part], revolution_mesh(std::array{profile[i], profile[i + 1]}, sectors));
  }
  if (!profile.empty())
    append(meshes[2],
           revolution_mesh(std::array{profile.back(), kinematics::ProfilePoint{profile.back().z_mm, 0.0}}, sectors));
  return meshes;
}

/// The mesh with corners of its own for every triangle: boxes are seen with flat faces.
TriangleMesh faceted(const TriangleMesh& mesh) {
  TriangleMesh out;
  for (const geometry::Triangle& triangle : mesh.triangles) {
    const auto first = static_cast<geometry::Index>(out.vertices_mm.size());
    for (const geometry::Index corner : triangle)
      out.vertices_mm.push_back(mesh.vertices_mm[static_cast<std::size_t>(corner)]);
    out.triangles.push_back({first, first + 1, first + 2});
  }
  return out;
}

/// The links where the axes have them, in P. The base is left out of close pictures: a table would be their background.
std::vector<TriangleMesh> placed_links(const RunView& view, const kinematics::AxisVector& q, bool close) {
  const kinematics::Machine& machine = view.profile->machine;
  const Transform X_PM = view.setup.part_in_machine.inverse();
  std::vector<TriangleMesh> links;
  for (const kinematics::LinkShape& shape : machine.shapes)
    if (!close || shape.link != -1)
      links.push_back(moved_mesh(faceted(shape.mesh_M), X_PM * kinematics::link_motion(machine, shape.link, q)));
  return links;
}

std::size_t sample_at(const RunView& view, double time_s) {
  const auto& samples = view.trace.samples;
  const auto after = std::upper_bound(samples.begin(), samples.end(), time_s,
                                      [](double time, const sim::AxisSample& sample) { return time < sample.time_s; });
  return after == samples.begin() ? 0 : static_cast<std::size_t>(after - samples.begin()) - 1;
}

ColouredLine way_so_far(const RunView& view, std::size_t last) {
  ColouredLine line{{}, {}, way_colour, 1.4, 0.3};
  for (std::size_t i = 0; i <= last; ++i)
    if (view.trace.samples[i].cutting) line.points.push_back(view.trace.poses_P[i].tip_P_mm);
  return line;
}

Box grown_box(const std::vector<TriangleMesh>& meshes, Box box) {
  for (const TriangleMesh& mesh : meshes)
    for (const Vec3& vertex : mesh.vertices_mm) grow(box, vertex);
  return box;
}

/// The part with the tool's whole length about it, so that holder and spindle nose are in sight.
Box near_box(const RunView& view, const kinematics::ToolPose& pose) {
  Box box = part_box(view);
  grow(box, pose.tip_P_mm + near_reach * view.tool.gauge_length_mm * pose.axis_P);
  return box;
}

}  // namespace

double shown_moment_s(const RunView& view) {
  for (const sim::Finding& finding : view.findings)
    if (finding.time_s > 0.0) return finding.time_s;
  return view.trace.samples.empty() ? 0.0 : 0.5 * view.trace.samples.back().time_s;
}

Result<Image> machine_picture(const RunView& view, double time_s, bool close, const PictureStyle& style) {
  const std::size_t at = sample_at(view, time_s);
  const kinematics::Machine& machine = view.profile->machine;
  const kinematics::AxisVector& q = view.trace.samples[at].position;
  const Transform X_PM = view.setup.part_in_machine.inverse();
  const std::vector<TriangleMesh> links = placed_links(view, q, close);
  std::array<TriangleMesh, 3> tool = tool_meshes(view.tool);
  for (TriangleMesh& mesh : tool)
    mesh = moved_mesh(mesh, X_PM * kinematics::forward(machine, view.tool.gauge_length_mm, q));
  Scene3d scene;
  add_solids(scene, view);
  for (const TriangleMesh& link : links) scene.meshes.push_back({&link, {}, link_colour, 1.0F});
  const std::array<Colour, 3> colours{cutter_colour, shank_colour, holder_colour};
  for (std::size_t i = 0; i < tool.size(); ++i) scene.meshes.push_back({&tool[i], {}, colours[i], 1.0F});
  scene.lines.push_back(way_so_far(view, at));
  const Box box = close ? near_box(view, view.trace.poses_P[at]) : grown_box(links, part_box(view));
  Camera camera = standard_camera(box, style, RightSide::empty);
  if (close) camera.half_depth = standard_camera(grown_box(links, box), style, RightSide::empty).half_depth * 2.0;
  const std::string when = "at " + geometry::fixed_text(view.trace.samples[at].time_s, 2) + " s, line " +
                           std::to_string(view.trace.samples[at].line);
  return finished_picture(
      scene, camera,
      {view.title, {(close ? "tool, holder and part from near " : "machine with tool and part ") + when}}, style);
}

}  // namespace volute::view

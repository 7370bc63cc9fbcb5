// volute inspect: can this surface be machined by one spiral, and if not, why.
#include <nlohmann/json.hpp>

#include "app/commands.hpp"
#include "app/exit_status.hpp"
#include "app/report.hpp"
#include "geometry/mesh_report.hpp"
#include "geometry/number_text.hpp"

namespace volute::app {

namespace {

using geometry::MeshReport;
using geometry::short_text;

std::string row(const std::string& name, const std::string& value) {
  return "  " + name + std::string(name.size() < 22 ? 22 - name.size() : 1, ' ') + value + "\n";
}

std::string size_text(const MeshReport& report) {
  const geometry::Vec3 size = report.greatest_mm - report.least_mm;
  return short_text(size.x()) + " x " + short_text(size.y()) + " x " + short_text(size.z()) + " mm, from (" +
         short_text(report.least_mm.x()) + ", " + short_text(report.least_mm.y()) + ", " +
         short_text(report.least_mm.z()) + ")";
}

std::string loops_text(const MeshReport& report) {
  if (report.loops.empty()) return "none (closed surface)";
  std::string text = std::to_string(report.loops.size()) + ", lengths ";
  for (std::size_t i = 0; i < report.loops.size(); ++i) {
    if (i > 0) text += ", ";
    if (i == 12) return text + "...";
    text += short_text(report.loops[i].length_mm, 4);
  }
  return text + " mm";
}

std::string human_text(const MeshReport& report, const std::string& file) {
  std::string text =
      file + ": " + (report.machinable ? "can be machined" : "cannot be machined: " + report.reason) + "\n";
  text += row("triangles, vertices", std::to_string(report.triangles) + ", " + std::to_string(report.vertices));
  text += row("size", size_text(report));
  text += row("area", short_text(report.area_mm2) + " mm2");
  text += row("boundary loops", loops_text(report));
  text += row("components, handles", std::to_string(report.components.size()) + ", " + std::to_string(report.handles));
  text += row("angles", short_text(report.least_angle_deg, 3) + " to " + short_text(report.greatest_angle_deg, 4) +
                            " deg; " + std::to_string(report.obtuse_triangles) + " obtuse triangles");
  text += row("median edge", short_text(report.median_edge_mm, 4) + " mm");
  return text;
}

}  // namespace

int inspect_command(const InspectArguments& arguments, Context& context) {
  Json values = Json::array();
  std::string text;
  int status = exit_clean;
  for (const path& part : arguments.parts) {
    const auto loaded = geometry::load_mesh(part, arguments.unit_mm);
    if (!loaded) {
      status = context.fail(loaded.error());
      values.push_back({{"file", part.string()},
                        {"machinable", false},
                        {"reason_code", loaded.error().code},
                        {"reason", loaded.error().message}});
      continue;
    }
    const MeshReport report = geometry::inspect(*loaded);
    if (report.machinable) context.warn(report.repairs.warnings);
    if (!report.machinable)
      status = context.fail({geometry::ErrorKind::bad_input, report.reason_code, part.string() + ": " + report.reason});
    values.push_back(mesh_json(report, part.string()));
    text += human_text(report, part.string());
  }
  context.print(values.size() == 1 ? values.front() : values, text);
  return status;
}

}  // namespace volute::app

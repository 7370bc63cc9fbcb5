#include "app/material_files.hpp"

#include "geometry/mesh_io.hpp"
#include "geometry/number_text.hpp"

namespace volute::app {

namespace {

std::string removed_table(const sim::StockReport& report, const kinematics::Cutter& cutter,
                          std::optional<double> spindle_rpm) {
  using geometry::fixed_text;
  std::string text = "block,removed_mm3,time_s,rate_mm3_s";
  text += spindle_rpm ? ",chip_mm3_per_tooth\n" : "\n";
  for (const sim::LineVolume& line : report.removed) {
    const double rate = line.time_s > 0.0 ? line.removed_mm3 / line.time_s : 0.0;
    text += std::to_string(line.line) + "," + fixed_text(line.removed_mm3, 6) + "," + fixed_text(line.time_s, 4) + "," +
            (line.time_s > 0.0 ? fixed_text(rate, 5) : "");
    if (spindle_rpm)
      text += "," + (line.time_s > 0.0 ? fixed_text(rate / (*spindle_rpm / 60.0 * cutter.flutes), 7) : "");
    text += "\n";
  }
  return text;
}

}  // namespace

geometry::Result<void> write_material(const sim::VerifyResult& result, const kinematics::Cutter& cutter,
                                      std::optional<double> spindle_rpm, const OutputFolder& out) {
  if (result.picture) {
    const sim::CutPicture& picture = *result.picture;
    if (auto saved =
            geometry::save_ply(out.file("cut_surface.ply"), picture.mesh, picture.colours, picture.deviation_mm);
        !saved)
      return saved;
  }
  if (!result.stock) return {};
  if (auto saved = geometry::save_stl(out.file("stock.stl"), result.stock->skin_P); !saved) return saved;
  return out.write("removed.csv", removed_table(result.stock->report, cutter, spindle_rpm));
}

}  // namespace volute::app

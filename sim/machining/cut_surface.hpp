// What the swept cutter leaves or takes on the design surface.
#pragma once

#include <vector>

#include "geometry/mesh.hpp"
#include "kinematics/model/tool.hpp"
#include "kinematics/model/tool_path.hpp"
#include "sim/finding.hpp"

namespace volute::sim {

/// Poses of the cutter in the part frame P, in order, each with the line that caused it; between two the cutter moves
/// linearly.
struct SweptPose {
  kinematics::ToolPose pose;
  std::int64_t line = 0;
  double time_s = 0.0;
  bool rapid = false;
};

struct CutSurfaceOptions {
  double sample_spacing_mm =
      0.0;  ///< 0: from the scallop (a tenth of the path interval), fine enough for the gouge and the uncut area limit
  double uncut_limit_mm = 0.1;         ///< higher than this above the surface (allowance included) is uncut
  double gouge_limit_mm = 0.01;        ///< deeper than this is a gouge
  double search_height_mm = 0.0;       ///< 0: cutter radius
  double uncut_area_limit_mm2 = 0.05;  ///< the verdict is `uncut` when more than this stands above the uncut limit
  double sweep_tolerance_mm =
      0.001;  ///< greatest cusp that stands between places of a flank, flat or bull nose (balls are exact)
  std::int64_t samples_max =
      8'000'000;  ///< a spacing that would need more is widened to it, and the report tells the spacing
};

struct CutSurfaceReport {
  std::int64_t samples = 0;
  double scallop_max_mm = 0.0, scallop_p99_mm = 0.0, gouge_max_mm = 0.0, uncut_area_mm2 = 0.0;
  bool uncut = false;
  std::vector<double> vertex_deviation_mm;  ///< per vertex: the worst sample about it; NaN: one not reached
  std::vector<std::int64_t>
      histogram;  ///< deviations from histogram_min_mm in steps of histogram_step_mm; the ends hold what lies beyond
  double histogram_min_mm = 0.0, histogram_step_mm = 0.0;
  std::vector<Finding> findings;
  double sample_spacing_mm = 0.0;  ///< used
  double area_mm2 = 0.0;           ///< of the surface that was sampled
  double deviation_mean_mm = 0.0;  ///< of the samples that the cutter came near
};

/// The deviation of a surface point is the least height along the outward normal of its triangle at which any moment's
/// cutter begins: positive, material stands above the design surface (scallop, uncut); negative, the cutter went below
/// it (gouge). A cutter that lies wholly below the point (on the far side of a thin wall or behind a sharp edge) does
/// not count, and a gouge is no deeper than the material that it took lay under the whole surface (at a sharp edge less
/// than along the normal: `SurfaceFacets::buried_mm`). Within `search_height_mm` above the point no cutter: nothing
/// came near, which counts as uncut. scallop_max_mm and gouge_max_mm are sought between the samples too: by zooming
/// into the cells that can hold them, and for noses other than balls from the cutter's side (`deepest_notches`), since
/// a sharp corner's notch is narrower than any spacing. Accuracy: ball noses exact for the poses given; flanks, flat
/// and bull noses within `sweep_tolerance_mm`. Properties: 1. The report does not depend on the number of threads. 2. A
/// surface moved with its poses has the same deviations.
/// 3. scallop_max_mm on a plane under parallel passes of a ball is r - sqrt(r^2 - (interval / 2)^2) within 0.1 %.
/// Requires: a cutter that kinematics::validate accepts, unit axes, a surface without degenerate triangles,
/// uncut_limit_mm > 0, gouge_limit_mm > 0. No poses: everything is uncut.
CutSurfaceReport measure_cut_surface(const geometry::TriangleMesh& surface, const kinematics::Cutter& cutter,
                                     const std::vector<SweptPose>& poses, const CutSurfaceOptions& options);

}  // namespace volute::sim

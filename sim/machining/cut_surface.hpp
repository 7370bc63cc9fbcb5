// What the swept cutter leaves or takes on the design surface.
#pragma once

#include <vector>

#include "geometry/mesh.hpp"
#include "kinematics/model/tool.hpp"
#include "kinematics/model/tool_path.hpp"
#include "sim/finding.hpp"

namespace volute::sim {

/// Poses of the cutter in the part frame P, in order, each with the line that caused it; between two the cutter moves linearly.
struct SweptPose { kinematics::ToolPose pose; std::int64_t line = 0; double time_s = 0.0; bool rapid = false; };

struct CutSurfaceOptions {
  double sample_spacing_mm = 0.0;       ///< 0: from the scallop (a tenth of the path interval)
  double uncut_limit_mm = 0.1;          ///< higher than this above the surface (allowance included) is uncut
  double gouge_limit_mm = 0.01;         ///< deeper than this is a gouge
  double search_height_mm = 0.0;        ///< 0: cutter radius
};

struct CutSurfaceReport {
  std::int64_t samples = 0;
  double scallop_max_mm = 0.0, scallop_p99_mm = 0.0, gouge_max_mm = 0.0, uncut_area_mm2 = 0.0;
  bool uncut = false;
  std::vector<double> vertex_deviation_mm;  ///< per vertex of the surface; NaN where nothing came near
  std::vector<std::int64_t> histogram;      ///< deviations from histogram_min_mm in steps of histogram_step_mm
  double histogram_min_mm = 0.0, histogram_step_mm = 0.0;
  std::vector<Finding> findings;
};

CutSurfaceReport measure_cut_surface(const geometry::TriangleMesh& surface, const kinematics::Cutter& cutter,
                                     const std::vector<SweptPose>& poses, const CutSurfaceOptions& options);

}  // namespace volute::sim

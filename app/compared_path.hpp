// A path as `volute compare` names it: a strategy, and how the tool's axis goes along it.
#pragma once

#include <string>

#include "app/pipeline.hpp"

namespace volute::app {

enum class ComparedAxis {
  as_job,  ///< as the job's `orientation` says
  tilted,  ///< at the job's initial tilt and yaw everywhere, turning with the feed
  normal   ///< along the surface normal everywhere
};

struct ComparedPath {
  std::string name;    ///< as on the command line: "contour-offset", "contour-offset:normal"
  std::string folder;  ///< the same as a file name: "contour-offset-normal"
  planner::Strategy strategy = planner::Strategy::spiral;
  ComparedAxis axis = ComparedAxis::as_job;
};

/// NAME or NAME:AXIS. Errors: strategy-unknown, axis-unknown, which list what there is.
geometry::Result<ComparedPath> compared_path(const std::string& name);

/// The job with this strategy and axis; an axis other than the job's own is not smoothed, only turned aside where
/// something is in the way.
JobInputs with_path(JobInputs inputs, planner::Strategy strategy, ComparedAxis axis);

}  // namespace volute::app

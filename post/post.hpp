// From a tool path to the text of a program for one machine and control.
#pragma once

#include <string>

#include "geometry/result.hpp"
#include "kinematics/inverse/inverse.hpp"
#include "kinematics/model/control.hpp"

namespace volute::post {

using geometry::Result;

struct PostRequest {
  std::string program_name = "VOLUTE";
  kinematics::ToolPath path;  ///< in P
  kinematics::Tool tool;
  kinematics::Setup setup;
  double spindle_rpm = 5000.0;
  bool coolant = true;
  double tolerance_mm = 0.005;  ///< linearization
};

struct PostResult {
  std::string text;
  std::int64_t blocks = 0;
  std::int64_t blocks_at_greatest_feed =
      0;                           ///< G93 blocks whose F is the control's greatest: they take longer than asked
  kinematics::AxisPath axis_path;  ///< what was written, before rounding
  kinematics::AxisPathReport linearization;
};

/// Errors (bad_input): those of kinematics::solve_path, and post-*.
Result<PostResult> post(const PostRequest& request, const kinematics::Profile& profile);

}  // namespace volute::post

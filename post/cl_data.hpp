// CL data (ISO 4343 / APT): other systems' tool paths in, Volute's out.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "geometry/result.hpp"
#include "kinematics/model/tool.hpp"
#include "kinematics/model/tool_path.hpp"

namespace volute::post {

struct ClData {
  std::string part_name;
  kinematics::Tool tool;
  double spindle_rpm = 0.0;
  bool coolant = false;
  kinematics::ToolPath path;          ///< tip points (CL points) with axes; CC points are not part of CL data
  std::vector<std::string> warnings;  ///< statements passed over, with their lines
};

/// Errors (bad_input): cl-syntax, cl-no-motion, naming file and line.
geometry::Result<ClData> parse_cl(std::string_view text, std::string_view file_name);
std::string write_cl(const ClData& data);

}  // namespace volute::post

// The job file: TOML in, everything that a run needs out. Inside units from here on.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "geometry/mesh_io.hpp"
#include "kinematics/model/control.hpp"
#include "planner/field/field_options.hpp"
#include "planner/options.hpp"

namespace volute::app {

/// [stock] of the job; nothing given: a block about the part, assumed.
struct StockJob {
  bool given = false, skip = false;
  std::filesystem::path solid_file;  ///< a closed mesh; empty: a box
  std::optional<geometry::Vec3> low_mm, high_mm;
  std::optional<double> near_net_mm;  ///< the surface and so much more along its normals
  double allowance_mm = 1.0;          ///< of a block about the part, when neither solid nor box is given
  double grid_mm = 0.0;               ///< 0: chosen
};

struct Job {
  std::filesystem::path file;
  std::string name;  ///< the file's name without .toml
  std::filesystem::path surface_file;
  double unit_mm = 1.0;
  int component = -1;  ///< -1: the part must have one component
  kinematics::Tool tool;
  std::vector<std::filesystem::path> obstacle_files, fixture_files;
  planner::PathOptions path;
  planner::OrientationOptions orientation;
  planner::ProcessOptions process;
  planner::FieldOptions field;
  double spindle_rpm = 5000.0;
  bool coolant = true;
  std::string profile;  ///< name or path as written
  kinematics::Setup setup;
  double gouge_tolerance_mm = 0.0, clearance_mm = 1.0;
  StockJob stock;
};

/// Errors (bad_input): job-*: file, line, key, value, rule, remedy. Keys that nobody reads are refused, with the
/// nearest name. Files that the job names are looked up relative to the job file.
geometry::Result<Job> load_job(const std::filesystem::path& file);

/// "x,y,z" in mm as a setup without turning; "" is 0,0,0. Error: setup-syntax.
geometry::Result<kinematics::Setup> parse_setup(const std::string& text);

}  // namespace volute::app

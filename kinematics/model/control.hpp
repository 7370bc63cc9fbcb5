// A control as data: how its programs are written and read, and how it moves the axes.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "geometry/result.hpp"
#include "kinematics/model/machine.hpp"

namespace volute::kinematics {

enum class DialectFamily : std::uint8_t { linuxcnc, fanuc, siemens, heidenhain, haas, mazak };
enum class OrientationWords : std::uint8_t { axes, vector };  ///< A B C, or a unit vector
enum class OrientationInterpolation : std::uint8_t { axes, great_circle };
enum class CornerMode : std::uint8_t { exact_stop, tolerance, parabolic_blend };
enum class AccelerationProfile : std::uint8_t { trapezoid, s_curve };
/// What F means when rotary axes move too and TCP is off.
enum class MixedFeed : std::uint8_t { linear_axes_only, all_axes_weighted };

struct Control {
  std::string name;  ///< "fanuc"
  std::string title;
  std::filesystem::path file;

  // how programs are written
  DialectFamily family = DialectFamily::linuxcnc;
  bool tcp = false;  ///< programs carry tip points and the control keeps the tip (TCP, RTCP)
  OrientationWords orientation_words = OrientationWords::axes;
  bool inverse_time = false;           ///< cutting blocks in G93
  double inverse_time_max = 9999.999;  ///< greatest F in G93, 1/min
  int linear_decimals = 3, rotary_decimals = 3, vector_decimals = 6, feed_decimals = 1;
  bool force_decimal_point = false;
  bool rotary_shortest_way = false;  ///< the control takes rotary words modulo one turn, the short way
  bool block_numbers = true;
  int block_number_step = 1;
  int block_length_max = 256;
  std::string program_extension = ".nc";
  std::vector<std::string> header, tcp_on, tcp_off, smoothing_on, smoothing_off,
      footer;                        ///< lines; {name} {tool} {spindle} ... are filled in
  std::vector<std::string> retract;  ///< lines that take Z to the end of its travel in machine coordinates, TCP off

  // how it moves
  double servo_period_s = 0.001;  ///< interpolation cycle
  int look_ahead_blocks = 200;
  double least_block_time_s = 0.0;
  OrientationInterpolation orientation_interpolation = OrientationInterpolation::axes;
  CornerMode corner_mode = CornerMode::tolerance;
  double corner_tolerance_mm = 0.01;
  double corner_tolerance_rad = 0.001;
  AccelerationProfile acceleration_profile = AccelerationProfile::trapezoid;
  double filter_time_s = 0.0;  ///< moving average after interpolation
  MixedFeed mixed_feed = MixedFeed::linear_axes_only;
  double mixed_feed_mm_per_rad = 57.295779513082321;  ///< all_axes_weighted: 1 mm for 1 degree
  bool linuxcnc_planner = false;                      ///< move as LinuxCNC 2.9's own planner does
  bool feed_forward = true;
  std::vector<std::string> assumed;  ///< keys whose number has no published source
};

/// Errors (bad_input), naming file, line and key: control-*.
geometry::Result<Control> load_control(const std::filesystem::path& file);

/// A machine with a control.
struct Profile {
  std::string name;  ///< "ac-head-fanuc"
  Machine machine;
  Control control;
};

/// `folder` holds NAME.toml for machines and controls/NAME.toml for controls. A profile's name is MACHINE-CONTROL.
/// `name_or_path`: such a name, or a path to a machine file followed by ":" and a control's name or path.
/// Errors (bad_input): profile-unknown (lists the nearest names), machine-*, control-*.
geometry::Result<Profile> load_profile(const std::filesystem::path& folder, std::string_view name_or_path);

struct ProfileName {
  std::string name, machine, control, kind;
};
/// Every machine with every control that its file allows (`controls = [...]`; all when absent), sorted by name.
geometry::Result<std::vector<ProfileName>> list_profiles(const std::filesystem::path& folder);

}  // namespace volute::kinematics

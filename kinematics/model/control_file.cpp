// A control file read into a Control, every mistake named with file, line and key.
#include <algorithm>

#include "kinematics/model/control.hpp"
#include "kinematics/model/toml_reader.hpp"

namespace volute::kinematics {

using geometry::Angle;
using geometry::Result;

namespace {

const toml::table& section(TomlReader& reader, const char* name) { return reader.table(reader.root(), "", name); }

void read_words(TomlReader& reader, Control& control) {
  const toml::table& words = section(reader, "words");
  reader.only_keys(words, "words",
                   {"orientation", "linear_decimals", "rotary_decimals", "vector_decimals", "feed_decimals",
                    "force_decimal_point", "rotary_shortest_way", "block_numbers", "block_number_step",
                    "block_length_max", "inverse_time", "inverse_time_max"});
  control.orientation_words =
      static_cast<OrientationWords>(reader.choice(words, "words", "orientation", {"axes", "vector"}, 0));
  control.linear_decimals = reader.integer(words, "words", "linear_decimals", control.linear_decimals, 0, 9);
  control.rotary_decimals = reader.integer(words, "words", "rotary_decimals", control.rotary_decimals, 0, 9);
  control.vector_decimals = reader.integer(words, "words", "vector_decimals", control.vector_decimals, 3, 12);
  control.feed_decimals = reader.integer(words, "words", "feed_decimals", control.feed_decimals, 0, 6);
  control.force_decimal_point = reader.boolean(words, "words", "force_decimal_point", control.force_decimal_point);
  control.rotary_shortest_way = reader.boolean(words, "words", "rotary_shortest_way", control.rotary_shortest_way);
  control.block_numbers = reader.boolean(words, "words", "block_numbers", control.block_numbers);
  control.block_number_step = reader.integer(words, "words", "block_number_step", control.block_number_step, 1, 1000);
  control.block_length_max = reader.integer(words, "words", "block_length_max", control.block_length_max, 40, 100000);
  control.inverse_time = reader.boolean(words, "words", "inverse_time", control.inverse_time);
  control.inverse_time_max = reader.positive(words, "words", "inverse_time_max", control.inverse_time_max);
}

void read_program(TomlReader& reader, Control& control) {
  const toml::table& program = section(reader, "program");
  reader.only_keys(program, "program",
                   {"extension", "header", "retract", "smoothing_on", "tcp_on", "tcp_off", "smoothing_off", "footer"});
  control.program_extension = reader.text(program, "program", "extension", control.program_extension);
  control.header = reader.texts(program, "program", "header");
  control.retract = reader.texts(program, "program", "retract");
  control.smoothing_on = reader.texts(program, "program", "smoothing_on");
  control.smoothing_off = reader.texts(program, "program", "smoothing_off");
  control.tcp_on = reader.texts(program, "program", "tcp_on");
  control.tcp_off = reader.texts(program, "program", "tcp_off");
  control.footer = reader.texts(program, "program", "footer");
}

void read_interpolation(TomlReader& reader, const toml::table& motion, Control& control) {
  constexpr const char* where = "motion";
  control.orientation_interpolation = static_cast<OrientationInterpolation>(
      reader.choice(motion, where, "orientation_interpolation", {"axes", "great_circle"}, 0));
  control.corner_mode = static_cast<CornerMode>(
      reader.choice(motion, where, "corner_mode", {"exact_stop", "tolerance", "parabolic_blend"}, 1));
  control.corner_tolerance_mm = reader.positive(motion, where, "corner_tolerance_mm", control.corner_tolerance_mm);
  const Angle corner = Angle::degrees(
      reader.positive(motion, where, "corner_tolerance_deg", Angle::radians(control.corner_tolerance_rad).degrees()));
  control.corner_tolerance_rad = corner.radians();
  control.acceleration_profile = static_cast<AccelerationProfile>(
      reader.choice(motion, where, "acceleration_profile", {"trapezoid", "s_curve"}, 0));
  control.mixed_feed =
      static_cast<MixedFeed>(reader.choice(motion, where, "mixed_feed", {"linear_axes_only", "all_axes_weighted"}, 0));
  const double mm_per_degree = reader.positive(motion, where, "mixed_feed_mm_per_deg", 1.0);
  control.mixed_feed_mm_per_rad = mm_per_degree * Angle::radians(1.0).degrees();
}

void read_motion(TomlReader& reader, Control& control) {
  const toml::table& motion = section(reader, "motion");
  reader.only_keys(motion, "motion",
                   {"servo_period_ms", "look_ahead_blocks", "least_block_time_ms", "orientation_interpolation",
                    "corner_mode", "corner_tolerance_mm", "corner_tolerance_deg", "acceleration_profile",
                    "filter_time_ms", "mixed_feed", "mixed_feed_mm_per_deg", "linuxcnc_planner", "feed_forward"});
  control.servo_period_s = 1e-3 * reader.positive(motion, "motion", "servo_period_ms", 1.0);
  control.look_ahead_blocks =
      reader.integer(motion, "motion", "look_ahead_blocks", control.look_ahead_blocks, 1, 1000000);
  control.least_block_time_s = 1e-3 * reader.number(motion, "motion", "least_block_time_ms", 0.0);
  control.filter_time_s = 1e-3 * reader.number(motion, "motion", "filter_time_ms", 0.0);
  if (control.least_block_time_s < 0.0 || control.filter_time_s < 0.0)
    reader.refuse(&motion, "motion", "times must not be negative");
  control.linuxcnc_planner = reader.boolean(motion, "motion", "linuxcnc_planner", false);
  control.feed_forward = reader.boolean(motion, "motion", "feed_forward", true);
  read_interpolation(reader, motion, control);
}

// Settings that contradict each other would make a program that means something else than was planned.
void check_together(TomlReader& reader, const Control& control) {
  const toml::node* root = &reader.root();
  if (control.orientation_words == OrientationWords::vector && !control.tcp)
    reader.refuse(root, "words.orientation",
                  "vector words need tcp = true: without TCP the control moves axes, not the tool");
  if (control.tcp && (control.tcp_on.empty() || control.tcp_off.empty()))
    reader.refuse(root, "program.tcp_on", "tcp = true needs the lines tcp_on and tcp_off");
  if (control.header.empty() || control.footer.empty())
    reader.refuse(root, "program.header", "header and footer must not be empty");
}

}  // namespace

Result<Control> load_control(const std::filesystem::path& file) {
  TomlReader reader(file, "control");
  Control control;
  control.name = file.stem().string();
  control.file = file;
  if (!reader.error()) {
    const toml::table& root = reader.root();
    reader.only_keys(root, "", {"title", "family", "tcp", "assumed", "words", "program", "motion"});
    control.title = reader.text(root, "", "title");
    control.family = static_cast<DialectFamily>(
        reader.choice(root, "", "family", {"linuxcnc", "fanuc", "siemens", "heidenhain", "haas", "mazak"}));
    control.tcp = reader.boolean(root, "", "tcp", false);
    control.assumed = reader.texts(root, "", "assumed");
    read_words(reader, control);
    read_program(reader, control);
    read_motion(reader, control);
    check_together(reader, control);
  }
  if (reader.error()) return tl::unexpected(*reader.error());
  return control;
}

}  // namespace volute::kinematics

// volute machines: the profiles, or one of them checked and explained.
#include <nlohmann/json.hpp>
#include <numbers>

#include "app/commands.hpp"
#include "app/exit_status.hpp"
#include "app/report.hpp"
#include "app/run_table.hpp"
#include "geometry/number_text.hpp"
#include "kinematics/model/control.hpp"

namespace volute::app {

namespace {

using geometry::short_text;
using kinematics::Axis;
using kinematics::AxisKind;

constexpr double degrees_per_radian = 180.0 / std::numbers::pi;

Json axis_json(const Axis& axis) {
  const bool rotary = axis.kind == AxisKind::rotary;
  const double unit = rotary ? degrees_per_radian : 1.0;
  const std::string length = rotary ? "deg" : "mm";
  Json json{{"letter", std::string(1, axis.letter)}, {"kind", rotary ? "rotary" : "linear"}};
  json["velocity_max_" + length + "_s"] = axis.velocity_max * unit;
  json["acceleration_max_" + length + "_s2"] = axis.acceleration_max * unit;
  json["jerk_max_" + length + "_s3"] = axis.jerk_max * unit;
  if (axis.travel_min) json["travel_min_" + length] = *axis.travel_min * unit;
  if (axis.travel_max) json["travel_max_" + length] = *axis.travel_max * unit;
  json["assumed"] = axis.assumed;
  return json;
}

std::string travel_text(const Axis& axis) {
  const double unit = axis.kind == AxisKind::rotary ? degrees_per_radian : 1.0;
  if (!axis.travel_min || !axis.travel_max) return "endless";
  return short_text(*axis.travel_min * unit) + " to " + short_text(*axis.travel_max * unit);
}

std::string axis_row(const Axis& axis) {
  const bool rotary = axis.kind == AxisKind::rotary;
  const double unit = rotary ? degrees_per_radian : 1.0;
  const std::string length = rotary ? "deg" : "mm";
  return table_row(std::string(1, axis.letter) + " (" + (rotary ? "rotary" : "linear") + ")",
                   travel_text(axis) + " " + (axis.travel_min ? length : "") + "; " +
                       short_text(axis.velocity_max * unit) + " " + length + "/s, " +
                       short_text(axis.acceleration_max * unit) + " " + length + "/s2, " +
                       short_text(axis.jerk_max * unit) + " " + length + "/s3" + (axis.assumed ? "  (assumed)" : ""));
}

std::string control_rows(const kinematics::Control& control) {
  std::string text = table_row("control", control.title + " (" + control.file.filename().string() + ")");
  text += table_row("TCP", control.tcp ? "on: programs carry the tool tip" : "off: programs carry axis positions");
  text +=
      table_row("tool axis written as",
                control.orientation_words == kinematics::OrientationWords::axes ? "rotary axis words" : "unit vector");
  text += table_row("look-ahead", std::to_string(control.look_ahead_blocks) + " blocks, cycle " +
                                      short_text(control.servo_period_s * 1000.0) + " ms");
  text += table_row("corner tolerance", short_text(control.corner_tolerance_mm) + " mm");
  std::string assumed;
  for (const std::string& key : control.assumed) assumed += (assumed.empty() ? "" : ", ") + key;
  if (!assumed.empty()) text += table_row("assumed numbers", assumed);
  return text;
}

int list(Context& context) {
  const auto profiles = kinematics::list_profiles(context.machines_folder());
  if (!profiles) return context.fail(profiles.error());
  Json json = Json::array();
  std::string text = "profile                          machine                control            kind\n";
  const auto cell = [](const std::string& word, std::size_t width) {
    return word + std::string(word.size() < width ? width - word.size() : 1, ' ');
  };
  for (const kinematics::ProfileName& profile : *profiles) {
    json.push_back(
        {{"name", profile.name}, {"machine", profile.machine}, {"control", profile.control}, {"kind", profile.kind}});
    text += cell(profile.name, 33) + cell(profile.machine, 23) + cell(profile.control, 19) + profile.kind + "\n";
  }
  context.print(json, text);
  return exit_clean;
}

int explain(const std::string& name, Context& context) {
  const auto profile = kinematics::load_profile(context.machines_folder(), name);
  if (!profile) return context.fail(profile.error());
  const kinematics::Machine& machine = profile->machine;
  Json json{
      {"name", profile->name}, {"machine", machine.name}, {"control", profile->control.name}, {"kind", machine.kind}};
  json["axes"] = Json::array();
  std::string chain;
  for (const int index : machine.chain)
    chain += std::string(chain.empty() ? "" : " - ") + machine.axes[static_cast<std::size_t>(index)].letter;
  std::string text = profile->name + ": " + machine.title + "\n" + table_row("machine file", machine.file.string());
  text += table_row("kind", machine.kind + "; chain from workpiece to tool: " + chain);
  for (const Axis& axis : machine.axes) {
    json["axes"].push_back(axis_json(axis));
    text += axis_row(axis);
  }
  context.print(json, text + control_rows(profile->control));
  return exit_clean;
}

}  // namespace

int machines_command(const MachinesArguments& arguments, Context& context) {
  return arguments.name.empty() ? list(context) : explain(arguments.name, context);
}

}  // namespace volute::app

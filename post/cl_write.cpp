// A tool path as CL data, ISO 4343: one statement a line.
#include <cmath>

#include "geometry/number_text.hpp"
#include "post/cl_data.hpp"

namespace volute::post {

using geometry::append_fixed;
using kinematics::CutterShape;
using kinematics::MoveKind;

namespace {

constexpr int length_decimals = 6, vector_decimals = 9, feed_decimals = 4;

void append_numbers(std::string& text, std::initializer_list<double> numbers, int decimals) {
  bool first = true;
  for (const double number : numbers) {
    if (!first) text += ", ";
    append_fixed(text, number, decimals);
    first = false;
  }
}

std::string in_quotes(std::string_view text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' || c == '\n' || c == '$' ? ' ' : c;
  return result + "'";
}

// CUTTER/ diameter, corner radius, axis to corner centre, tip to corner centre, bottom angle, taper, height
void append_cutter(std::string& text, const kinematics::Tool& tool) {
  const kinematics::Cutter& cutter = tool.cutter;
  text += "CUTTER/ ";
  append_numbers(text,
                 {2.0 * cutter.radius_mm, cutter.corner_radius_mm, cutter.radius_mm - cutter.corner_radius_mm,
                  cutter.corner_radius_mm, 0.0, cutter.shape == CutterShape::taper_ball ? cutter.taper.degrees() : 0.0,
                  cutter.length_mm},
                 length_decimals);
  text += "\nLOADTL/ " + std::to_string(tool.number) + ", LENGTH, ";
  append_fixed(text, tool.gauge_length_mm, length_decimals);
  text += '\n';
}

const char* move_word(MoveKind move) {
  switch (move) {
    case MoveKind::approach:
      return "APPROACH";
    case MoveKind::link:
      return "LINK";
    case MoveKind::retract:
      return "RETRACT";
    default:
      return "CUT";
  }
}

void append_motion(std::string& text, const kinematics::ToolPath& path) {
  MoveKind move = MoveKind::cut;
  double feed_mm_s = -1.0;
  for (const kinematics::ToolPathPoint& point : path.points) {
    if (point.move == MoveKind::rapid) {
      text += "RAPID\n";
    } else {
      if (point.move != move) text += "PPRINT/ 'MOVE " + std::string(move_word(point.move)) + "'\n";
      move = point.move;
      if (point.feed_mm_s != feed_mm_s) {
        text += "FEDRAT/ ";
        append_fixed(text, point.feed_mm_s * 60.0, feed_decimals);
        text += ", MMPM\n";
        feed_mm_s = point.feed_mm_s;
      }
    }
    text += "GOTO/ ";
    append_numbers(text, {point.pose.tip_P_mm.x(), point.pose.tip_P_mm.y(), point.pose.tip_P_mm.z()}, length_decimals);
    text += ", ";
    append_numbers(text, {point.pose.axis_P.x(), point.pose.axis_P.y(), point.pose.axis_P.z()}, vector_decimals);
    text += '\n';
  }
}

}  // namespace

std::string write_cl(const ClData& data) {
  std::string text;
  text.reserve(256 + 80 * data.path.points.size());
  text += "PARTNO/ " + in_quotes(data.part_name) + "\nUNITS/ MM\nMULTAX/ ON\n";
  append_cutter(text, data.tool);
  if (data.spindle_rpm > 0.0) {
    text += "SPINDL/ ";
    append_fixed(text, data.spindle_rpm, 1);
    text += ", RPM, CLW\n";
  }
  if (data.coolant) text += "COOLNT/ ON\n";
  append_motion(text, data.path);
  if (data.coolant) text += "COOLNT/ OFF\n";
  text += "SPINDL/ OFF\nEND\nFINI\n";
  return text;
}

}  // namespace volute::post

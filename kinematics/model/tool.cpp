#include "kinematics/model/tool.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "geometry/number_text.hpp"

namespace volute::kinematics {

using geometry::bad_input;
using geometry::Result;
using geometry::short_text;

namespace {

Result<void> validate_radii(const Cutter& cutter) {
  if (!(cutter.radius_mm > 0.0) || !std::isfinite(cutter.radius_mm))
    return bad_input("tool-radius", "tool.radius_mm = " + short_text(cutter.radius_mm) +
                                        " mm is not a radius; give a finite value above 0");
  const double corner = cutter.corner_radius_mm;
  const bool ball = cutter.shape == CutterShape::ball || cutter.shape == CutterShape::taper_ball;
  if (ball && corner != cutter.radius_mm)
    return bad_input("tool-corner-radius", "tool.corner_radius_mm = " + short_text(corner) +
                                               " mm differs from radius_mm = " + short_text(cutter.radius_mm) +
                                               " mm of a ball; leave it out or give the same");
  if (cutter.shape == CutterShape::flat && corner != 0.0)
    return bad_input("tool-corner-radius", "tool.corner_radius_mm = " + short_text(corner) +
                                               " mm on a flat cutter; leave it out or use shape = \"bull\"");
  if (cutter.shape == CutterShape::bull && !(corner > 0.0 && corner < cutter.radius_mm))
    return bad_input("tool-corner-radius",
                     "tool.corner_radius_mm = " + short_text(corner) + " mm of a bull cutter must lie between 0 and " +
                         short_text(cutter.radius_mm) + " mm; use \"flat\" or \"ball\" for the ends");
  return {};
}

Result<void> validate_lengths(const Tool& tool) {
  const Cutter& cutter = tool.cutter;
  const double rounded = cutter.corner_radius_mm;
  if (!(cutter.length_mm >= rounded) || !(cutter.length_mm > 0.0) || !std::isfinite(cutter.length_mm))
    return bad_input("tool-length", "tool.length_mm = " + short_text(cutter.length_mm) +
                                        " mm is shorter than the rounded tip (" + short_text(rounded) +
                                        " mm); lengthen the flutes");
  const double taper = cutter.taper.radians();
  if (cutter.shape == CutterShape::taper_ball && !(taper > 0.0 && taper < 0.5 * std::numbers::pi))
    return bad_input("tool-length", "tool.taper_deg = " + short_text(cutter.taper.degrees()) +
                                        " deg of a taper-ball must lie between 0 and 90");
  if (!(tool.stick_out_mm >= cutter.length_mm) || !std::isfinite(tool.stick_out_mm))
    return bad_input("tool-stick-out", "tool.stick_out_mm = " + short_text(tool.stick_out_mm) +
                                           " mm is shorter than length_mm = " + short_text(cutter.length_mm) +
                                           " mm; the flutes would stand in the holder");
  if (!(tool.gauge_length_mm >= tool.stick_out_mm) || !std::isfinite(tool.gauge_length_mm))
    return bad_input("tool-stick-out", "tool.gauge_length_mm = " + short_text(tool.gauge_length_mm) +
                                           " mm is shorter than stick_out_mm = " + short_text(tool.stick_out_mm) +
                                           " mm; it is measured from the tip to the gauge line");
  if (!(tool.shank_radius_mm > 0.0) || !std::isfinite(tool.shank_radius_mm))
    return bad_input("tool-radius", "tool.shank_radius_mm = " + short_text(tool.shank_radius_mm) +
                                        " mm is not a radius; give a value above 0");
  return {};
}

Result<void> validate_holder(const Tool& tool) {
  double z_mm = tool.stick_out_mm;
  for (std::size_t k = 0; k < tool.holder.size(); ++k) {
    const ConeSegment& segment = tool.holder[k];
    const std::string where = "holder.segments[" + std::to_string(k) + "]";
    if (!(segment.bottom_radius_mm > 0.0 && segment.top_radius_mm > 0.0 && segment.length_mm > 0.0))
      return bad_input(
          "tool-holder",
          where + " has a diameter or length that is not above 0; give [bottom diameter, top diameter, length]");
    if (std::abs(segment.z_mm - z_mm) > 1e-9)
      return bad_input("tool-holder", where + " starts at " + short_text(segment.z_mm) +
                                          " mm, but the part below it ends at " + short_text(z_mm) +
                                          " mm; segments are stacked without gaps");
    z_mm += segment.length_mm;
  }
  return {};
}

struct CutterWord {
  std::string_view name;
  CutterShape shape;
  std::size_t numbers;
};
constexpr std::array<CutterWord, 4> cutter_words = {{{"ball", CutterShape::ball, 1},
                                                     {"flat", CutterShape::flat, 1},
                                                     {"bull", CutterShape::bull, 2},
                                                     {"taper-ball", CutterShape::taper_ball, 2}}};

std::vector<std::string_view> split_at_commas(std::string_view text) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t comma = text.find(',');
    parts.push_back(text.substr(0, comma));
    if (comma == std::string_view::npos) return parts;
    text.remove_prefix(comma + 1);
  }
}

Cutter cutter_from_numbers(CutterShape shape, const std::vector<double>& numbers) {
  Cutter cutter;
  cutter.shape = shape;
  cutter.radius_mm = cutter.corner_radius_mm = numbers[0];
  if (shape == CutterShape::flat) cutter.corner_radius_mm = 0.0;
  if (shape == CutterShape::bull) cutter.corner_radius_mm = numbers[1];
  if (shape == CutterShape::taper_ball) cutter.taper = geometry::Angle::degrees(numbers[1]);
  cutter.length_mm = std::max(20.0, 4.0 * cutter.radius_mm);
  return cutter;
}

}  // namespace

Result<void> validate(const Tool& tool) {
  if (auto radii = validate_radii(tool.cutter); !radii) return radii;
  if (auto lengths = validate_lengths(tool); !lengths) return lengths;
  return validate_holder(tool);
}

Result<Cutter> parse_cutter(std::string_view spec) {
  const auto refuse = [&](const std::string& why) {
    return bad_input(
        "cutter-spec",
        "cutter \"" + std::string(spec) + "\": " + why +
            "; write ball,3 flat,5 bull,6,1 or taper-ball,1,5 (radius mm, corner radius mm or half angle deg)");
  };
  const auto parts = split_at_commas(spec);
  for (const CutterWord& word : cutter_words) {
    if (parts[0] != word.name) continue;
    if (parts.size() != word.numbers + 1)
      return refuse(std::to_string(parts.size() - 1) + " numbers instead of " + std::to_string(word.numbers));
    std::vector<double> numbers;
    for (std::size_t k = 1; k < parts.size(); ++k) {
      const auto number = geometry::parse_number(parts[k]);
      if (!number || !(*number > 0.0)) return refuse("\"" + std::string(parts[k]) + "\" is not a number above 0");
      numbers.push_back(*number);
    }
    if (word.shape == CutterShape::bull && !(numbers[1] < numbers[0]))
      return refuse("the corner radius must be below the radius");
    if (word.shape == CutterShape::taper_ball && !(numbers[1] < 90.0)) return refuse("the half angle must be below 90");
    return cutter_from_numbers(word.shape, numbers);
  }
  return refuse("unknown shape");
}

}  // namespace volute::kinematics

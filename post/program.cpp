#include "post/program.hpp"

#include <cmath>
#include <numbers>

#include "geometry/number_text.hpp"
#include "post/rotary_words.hpp"

namespace volute::post {

using kinematics::AxisPathPoint;
using kinematics::AxisVector;
using kinematics::DialectFamily;
using kinematics::MoveKind;
using kinematics::OrientationWords;

namespace {

// The whole turns of a wound axis nearest to where it stands: going home never unwinds a spiral.
double nearest_whole_turn_rad(double position_rad) {
  constexpr double turn = 2.0 * std::numbers::pi;
  return std::round(position_rad / turn) * turn;
}

bool reaches(const kinematics::Axis& axis, double position) {
  return (!axis.travel_min || position >= *axis.travel_min) && (!axis.travel_max || position <= *axis.travel_max);
}

}  // namespace

Program::Program(const PostRequest& request, const kinematics::Profile& profile, const kinematics::AxisPath& path)
    : request_(request),
      machine_(profile.machine),
      control_(profile.control),
      path_(path),
      zero_(kinematics::program_zero(profile.machine, request.setup, request.tool.gauge_length_mm)),
      writer_(profile.machine, profile.control) {
  prepare_fields();
  prepare_box();
}

void Program::prepare_fields() {
  const NumberFormat whole{.decimals = 0};
  const bool heidenhain = control_.family == DialectFamily::heidenhain;
  fields_["name"] = program_name(request_.program_name);
  fields_["tool"] = std::to_string(request_.tool.number);
  fields_["tool_name"] = program_name(request_.tool.name);
  fields_["length"] = number_text(request_.tool.gauge_length_mm, writer_.linear_format());
  fields_["spindle"] = number_text(request_.spindle_rpm, whole);
  fields_["coolant_on"] = request_.coolant ? "M8" : "";
  fields_["coolant_off"] = request_.coolant ? "M9" : "";
  fields_["retract_z"] = number_text(machine_.axes[2].travel_max.value_or(0.0), writer_.linear_format());
  fields_["corner_tolerance"] =
      number_text(control_.corner_tolerance_mm, NumberFormat{.decimals = 4, .plus_sign = heidenhain});
  fields_["corner_tolerance_deg"] =
      number_text(geometry::Angle::radians(control_.corner_tolerance_rad).degrees(), NumberFormat{.decimals = 3});
  AxisVector home = path_.points.empty() ? AxisVector(AxisVector::Zero()) : path_.points.back().q;
  for (int i = 3; i < kinematics::axis_count; ++i) {
    const double turn = nearest_whole_turn_rad(home[i]);
    home[i] = reaches(machine_.axes[static_cast<std::size_t>(i)], turn) ? turn : home[i];
  }
  fields_["home_rotaries"] = writer_.coordinates({.rotary_deg = rotary_words(home)});
  fields_["approach"] = "";
}

// A block that holds the part, for controls that draw one.
void Program::prepare_box() {
  geometry::Vec3 least = geometry::Vec3::Constant(0.0), greatest = least;
  bool first = true;
  for (const AxisPathPoint& point : path_.points) {
    if (point.move != MoveKind::cut) continue;
    least = first ? point.pose.tip_P_mm : least.cwiseMin(point.pose.tip_P_mm);
    greatest = first ? point.pose.tip_P_mm : greatest.cwiseMax(point.pose.tip_P_mm);
    first = false;
  }
  const std::array<const char*, 3> letters = {"x", "y", "z"};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    fields_[std::string(letters[k]) + "_min"] = number_text(std::floor(least[i]) - 1.0, writer_.linear_format());
    fields_[std::string(letters[k]) + "_max"] = number_text(std::ceil(greatest[i]) + 1.0, writer_.linear_format());
  }
}

void Program::refuse(geometry::Error error) {
  if (!error_) error_ = std::move(error);
}

void Program::lines(const std::vector<std::string>& templates) {
  for (const std::string& text : templates) {
    auto filled = fill(text, fields_, control_.name);
    filled ? writer_.line(*filled) : refuse(filled.error());
  }
}

void Program::begin() { lines(control_.header); }

std::array<double, 2> Program::rotary_words(const AxisVector& q) const {
  return {rotary_word_deg(control_, machine_.axes[3], q[3]), rotary_word_deg(control_, machine_.axes[4], q[4])};
}

// Z stands at the top: turn first, then go over the place, then switch TCP on, then come down.
void Program::enter(const AxisPathPoint& point) {
  const BlockWords turned{.rotary_deg = rotary_words(point.q)};
  writer_.move(Motion::rapid, turned);
  writer_.move(Motion::rapid, {.xyz_mm = {point.q[0] - zero_[0], point.q[1] - zero_[1], std::nullopt}});
  if (first_entry_) lines(control_.smoothing_on);
  first_entry_ = false;

  const BlockWords target = words_of(point);
  bool line_carries_it = false;
  for (const std::string& text : control_.tcp_on)
    line_carries_it = line_carries_it || text.find("{approach}") != std::string::npos;
  if (line_carries_it) fields_["approach"] = writer_.coordinates({.xyz_mm = target.xyz_mm});
  lines(control_.tcp_on);
  if (line_carries_it) writer_.now_at({.xyz_mm = target.xyz_mm});
  writer_.now_at(turned);
  writer_.move(Motion::rapid, target);
}

void Program::leave() {
  set_feed_unit(FeedUnit::per_minute);
  lines(control_.tcp_off);
  lines(control_.retract);
}

void Program::motion() {
  writer_.expect_blocks(path_.points.size());
  for (std::size_t i = 1; i < path_.points.size(); ++i) {
    const AxisPathPoint& point = path_.points[i];
    if (!point.machine_move) {
      write_point(path_.points[i - 1], point);
      continue;
    }
    if (!path_.points[i - 1].machine_move) leave();
    const bool last = i + 1 == path_.points.size() || !path_.points[i + 1].machine_move;
    if (last) enter(point);
  }
}

void Program::set_feed_unit(FeedUnit unit) {
  if (unit == feed_unit_ || control_.family == DialectFamily::heidenhain) return;
  feed_unit_ = unit;
  writer_.code(unit == FeedUnit::inverse_time ? "G93" : "G94");
}

void Program::write_point(const AxisPathPoint& from, const AxisPathPoint& to) {
  BlockWords words = words_of(to);
  if (to.move == MoveKind::rapid) return writer_.move(Motion::rapid, words);
  set_feed_unit(control_.inverse_time ? FeedUnit::inverse_time : FeedUnit::per_minute);
  const FeedWord feed = feed_word(machine_, control_, from, to);
  if (scaled(feed.value, control_.feed_decimals) < 1)
    refuse({geometry::ErrorKind::bad_input, "post-feed-too-slow",
            "control " + control_.name + ": F = " + geometry::short_text(feed.value) +
                " rounds to 0 at words.feed_decimals = " + std::to_string(control_.feed_decimals) +
                "; raise the feed or the decimals"});
  clamped_ += feed.clamped ? 1 : 0;
  words.feed = feed.value;
  words.feed_always = control_.inverse_time;
  writer_.move(Motion::feed, words);
}

void Program::end() {
  lines(control_.smoothing_off);
  lines(control_.footer);
}

Result<PostResult> Program::finish() {
  if (error_) return tl::unexpected(*error_);
  if (writer_.longest_block() > static_cast<std::size_t>(control_.block_length_max))
    return geometry::bad_input("post-block-too-long", "control " + control_.name + ": a block has " +
                                                          std::to_string(writer_.longest_block()) +
                                                          " characters, words.block_length_max is " +
                                                          std::to_string(control_.block_length_max) +
                                                          "; shorten the lines of its file or print fewer decimals");
  PostResult result;
  result.blocks = writer_.blocks();
  result.blocks_at_greatest_feed = clamped_;
  result.text = writer_.take_text();
  return result;
}

BlockWords Program::words_of(const AxisPathPoint& point) const {
  const geometry::Vec3 xyz_mm =
      control_.tcp ? point.pose.tip_P_mm : geometry::Vec3(point.q.head<3>() - zero_.head<3>());
  BlockWords words{.xyz_mm = {xyz_mm.x(), xyz_mm.y(), xyz_mm.z()}};
  if (control_.orientation_words == OrientationWords::vector) {
    words.axis_vector = point.pose.axis_P;
  } else {
    words.rotary_deg = rotary_words(point.q);
  }
  return words;
}

}  // namespace volute::post

// CL data read into a tool path: tolerant of what it need not know, strict about every number it uses.
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

#include "geometry/number_text.hpp"
#include "post/cl_data.hpp"
#include "post/cl_statement.hpp"

namespace volute::post {

using geometry::bad_input;
using geometry::Result;
using geometry::Vec3;
using kinematics::CutterShape;
using kinematics::MoveKind;

namespace {

constexpr double mm_per_inch = 25.4;
constexpr double arc_tolerance_mm = 0.001;

struct Arc {
  Vec3 centre_mm, normal;
  std::optional<double> sweep_rad;  ///< else to the end point, right-handed about the normal
};

class ClReader {
 public:
  explicit ClReader(std::string_view file_name) : file_(file_name) {}

  Result<ClData> read(std::string_view text) {
    ClLexer lexer(text);
    while (const auto statement = lexer.next()) {
      if (statement->major == "FINI") break;
      if (auto taken = take(*statement); !taken) return tl::unexpected(taken.error());
    }
    if (data_.path.points.empty())
      return bad_input("cl-no-motion", file_ + ": no GOTO/ statement; there is no motion to post");
    list_passed_over();
    return std::move(data_);
  }

 private:
  Result<void> refuse(const ClStatement& statement, const std::string& what) const {
    return bad_input("cl-syntax", file_ + ":" + std::to_string(statement.line) + ": " + statement.major + "/" +
                                      statement.text + ": " + what);
  }

  Result<void> take(const ClStatement& statement) {
    const auto handler = handlers().find(statement.major);
    if (handler != handlers().end()) return (this->*handler->second)(statement);
    auto& [line, count] = passed_over_[statement.major];
    if (count++ == 0) line = statement.line;
    return {};
  }

  using Handler = Result<void> (ClReader::*)(const ClStatement&);
  static const std::map<std::string, Handler, std::less<>>& handlers() {
    static const std::map<std::string, Handler, std::less<>> table = {
        {"GOTO", &ClReader::take_goto},        {"FROM", &ClReader::take_from},
        {"GODLTA", &ClReader::take_delta},     {"RAPID", &ClReader::take_rapid},
        {"FEDRAT", &ClReader::take_feed},      {"UNITS", &ClReader::take_units},
        {"UNIT", &ClReader::take_units},       {"TLAXIS", &ClReader::take_axis},
        {"MULTAX", &ClReader::take_nothing},   {"SPINDL", &ClReader::take_spindle},
        {"COOLNT", &ClReader::take_coolant},   {"CUTTER", &ClReader::take_cutter},
        {"LOADTL", &ClReader::take_load},      {"LOAD", &ClReader::take_load},
        {"MOVARC", &ClReader::take_arc},       {"CIRCLE", &ClReader::take_arc},
        {"CYCLE", &ClReader::take_cycle},      {"PARTNO", &ClReader::take_name},
        {"PPRINT", &ClReader::take_print},     {"INSERT", &ClReader::take_nothing},
        {"REMARK", &ClReader::take_nothing},   {"MACHIN", &ClReader::take_nothing},
        {"MODE", &ClReader::take_nothing},     {"END", &ClReader::take_nothing},
        {"TOOLPATH", &ClReader::take_nothing}, {"ENDOFPATH", &ClReader::take_nothing},
        {"PAINT", &ClReader::take_nothing},    {"DISPLY", &ClReader::take_nothing}};
    return table;
  }

  // ---- motion ----
  Result<void> position(const ClStatement& statement, kinematics::ToolPose& pose) {
    const std::vector<double> numbers = statement.numbers();
    if (numbers.size() != statement.items.size() || (numbers.size() != 3 && numbers.size() != 6))
      return refuse(statement, "needs 3 numbers, or 6 with the tool axis");
    pose.tip_P_mm = unit_mm_ * Vec3(numbers[0], numbers[1], numbers[2]);
    pose.axis_P = axis_;
    if (numbers.size() == 6) {
      const Vec3 axis(numbers[3], numbers[4], numbers[5]);
      if (!(axis.norm() > 0.1)) return refuse(statement, "the tool axis must be a unit vector");
      pose.axis_P = axis.normalized();
    }
    return {};
  }

  Result<void> move_to(const ClStatement& statement, const kinematics::ToolPose& pose) {
    if (!rapid_ && !feed_mm_s_) return refuse(statement, "a move at feed before any FEDRAT/; the feed is unknown");
    kinematics::ToolPathPoint point;
    point.pose = pose;
    point.move = rapid_ ? MoveKind::rapid : move_;
    point.feed_mm_s = rapid_ ? 0.0 : *feed_mm_s_;
    rapid_ = false;
    data_.path.points.push_back(point);
    return {};
  }

  Result<void> take_goto(const ClStatement& statement) {
    if (in_cycle_) {
      ++cycle_points_;
      return {};
    }
    kinematics::ToolPose pose;
    if (auto read = position(statement, pose); !read) return read;
    const std::optional<Arc> arc = std::exchange(arc_, std::nullopt);
    if (!arc || rapid_) return move_to(statement, pose);
    if (data_.path.points.empty()) return refuse(statement, "an arc before the first point has no start");
    return along_arc(statement, *arc, pose);
  }

  Result<void> along_arc(const ClStatement& statement, const Arc& arc, const kinematics::ToolPose& end) {
    const kinematics::ToolPose start = data_.path.points.back().pose;
    const Vec3 from = start.tip_P_mm - arc.centre_mm, to = end.tip_P_mm - arc.centre_mm;
    const Vec3 from_across = from - from.dot(arc.normal) * arc.normal, to_across = to - to.dot(arc.normal) * arc.normal;
    double sweep = std::atan2(arc.normal.dot(from_across.cross(to_across)), from_across.dot(to_across));
    if (sweep <= 1e-9) sweep += 2.0 * std::numbers::pi;
    if (arc.sweep_rad) sweep = *arc.sweep_rad;
    const double radius_mm = from_across.norm();
    if (!(radius_mm > 0.0)) return refuse(statement, "the arc's start lies on its axis");
    const double step = 2.0 * std::acos(std::max(0.0, 1.0 - arc_tolerance_mm / radius_mm));
    const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(sweep) / step)));
    for (int k = 1; k < steps; ++k) {
      const double share = static_cast<double>(k) / steps;
      const Vec3 turned = Eigen::AngleAxisd(share * sweep, arc.normal) * from_across;
      const double height = (1.0 - share) * from.dot(arc.normal) + share * to.dot(arc.normal);
      const Vec3 axis = ((1.0 - share) * start.axis_P + share * end.axis_P).normalized();
      if (auto moved = move_to(statement, {arc.centre_mm + turned + height * arc.normal, axis}); !moved) return moved;
    }
    return move_to(statement, end);
  }

  Result<void> take_from(const ClStatement& statement) {
    rapid_ = true;
    return take_goto(statement);
  }

  Result<void> take_delta(const ClStatement& statement) {
    const std::vector<double> numbers = statement.numbers();
    if (numbers.size() != 3 || data_.path.points.empty())
      return refuse(statement, "needs 3 numbers and a point before it");
    kinematics::ToolPose pose = data_.path.points.back().pose;
    pose.tip_P_mm += unit_mm_ * Vec3(numbers[0], numbers[1], numbers[2]);
    return move_to(statement, pose);
  }

  Result<void> take_rapid(const ClStatement&) {
    rapid_ = true;
    return {};
  }

  Result<void> take_arc(const ClStatement& statement) {
    const std::vector<double> numbers = statement.numbers();
    if (numbers.size() < 6) return refuse(statement, "needs centre and normal");
    const Vec3 normal(numbers[3], numbers[4], numbers[5]);
    if (!(normal.norm() > 0.1)) return refuse(statement, "the normal must be a unit vector");
    arc_ = Arc{unit_mm_ * Vec3(numbers[0], numbers[1], numbers[2]), normal.normalized(), std::nullopt};
    if (const auto sweep_deg = statement.number_after("ANGLE"))
      arc_->sweep_rad = geometry::Angle::degrees(*sweep_deg).radians();
    return {};
  }

  Result<void> take_axis(const ClStatement& statement) {
    const std::vector<double> numbers = statement.numbers();
    if (numbers.size() != 3 || !(Vec3(numbers[0], numbers[1], numbers[2]).norm() > 0.1))
      return refuse(statement, "needs a unit vector");
    axis_ = Vec3(numbers[0], numbers[1], numbers[2]).normalized();
    return {};
  }

  Result<void> take_cycle(const ClStatement& statement) {
    in_cycle_ = !statement.has("OFF");
    if (in_cycle_ && cycle_line_ == 0) cycle_line_ = statement.line;
    return {};
  }

  // ---- technology ----
  Result<void> take_feed(const ClStatement& statement) {
    const std::vector<double> numbers = statement.numbers();
    if (numbers.size() != 1 || !(numbers[0] > 0.0)) return refuse(statement, "needs one number above 0");
    double per_minute = numbers[0];
    if (statement.has("MMPR") || statement.has("IPR")) {
      if (!(data_.spindle_rpm > 0.0)) return refuse(statement, "a feed per revolution needs SPINDL/ before it");
      per_minute *= data_.spindle_rpm;
    }
    const bool inches = statement.has("IPM") || statement.has("IPR"),
               millimetres = statement.has("MMPM") || statement.has("MMPR");
    feed_mm_s_ = per_minute * (inches ? mm_per_inch : millimetres ? 1.0 : unit_mm_) / 60.0;
    return {};
  }

  Result<void> take_units(const ClStatement& statement) {
    const bool inches = statement.has("INCHES") || statement.has("INCH") || statement.has("IN");
    if (!inches && !statement.has("MM")) return refuse(statement, "the unit must be MM or INCHES");
    unit_mm_ = inches ? mm_per_inch : 1.0;
    return {};
  }

  Result<void> take_spindle(const ClStatement& statement) {
    const std::vector<double> numbers = statement.numbers();
    if (!numbers.empty() && numbers[0] > 0.0 && data_.spindle_rpm == 0.0) data_.spindle_rpm = numbers[0];
    return {};
  }

  Result<void> take_coolant(const ClStatement& statement) {
    data_.coolant = data_.coolant || !statement.has("OFF");
    return {};
  }

  Result<void> take_cutter(const ClStatement& statement) {
    const std::vector<double> numbers = statement.numbers();
    if (numbers.empty() || !(numbers[0] > 0.0)) return refuse(statement, "needs the diameter");
    if (cutter_seen_) {
      auto& [line, count] = passed_over_["CUTTER (after the first)"];
      if (count++ == 0) line = statement.line;
      return {};
    }
    cutter_seen_ = true;
    kinematics::Cutter& cutter = data_.tool.cutter;
    cutter.radius_mm = 0.5 * unit_mm_ * numbers[0];
    cutter.corner_radius_mm = numbers.size() > 1 ? unit_mm_ * numbers[1] : 0.0;
    cutter.shape = cutter.corner_radius_mm <= 0.0                               ? CutterShape::flat
                   : cutter.corner_radius_mm >= cutter.radius_mm * (1.0 - 1e-9) ? CutterShape::ball
                                                                                : CutterShape::bull;
    if (cutter.shape == CutterShape::ball) cutter.corner_radius_mm = cutter.radius_mm;
    const double height_mm = numbers.size() > 6 ? unit_mm_ * numbers[6] : 0.0;
    cutter.length_mm =
        height_mm >= cutter.corner_radius_mm && height_mm > 0.0 ? height_mm : std::max(20.0, 4.0 * cutter.radius_mm);
    data_.tool.shank_radius_mm = cutter.radius_mm;
    data_.tool.stick_out_mm = std::max(data_.tool.stick_out_mm, cutter.length_mm);
    data_.tool.gauge_length_mm = std::max(data_.tool.gauge_length_mm, data_.tool.stick_out_mm);
    return {};
  }

  Result<void> take_load(const ClStatement& statement) {
    const std::vector<double> numbers = statement.numbers();
    if (tool_seen_ || numbers.empty()) return {};
    tool_seen_ = true;
    data_.tool.number = static_cast<int>(numbers[0]);
    if (const auto length = statement.number_after("LENGTH"); length && *length > 0.0)
      data_.tool.gauge_length_mm = unit_mm_ * *length;
    return {};
  }

  Result<void> take_name(const ClStatement& statement) {
    data_.part_name = statement.text;
    if (data_.part_name.size() > 1 && data_.part_name.front() == '\'')
      data_.part_name = data_.part_name.substr(1, data_.part_name.rfind('\'') - 1);
    return {};
  }

  // Volute writes what kind of move follows as a print statement, which every other reader passes over.
  Result<void> take_print(const ClStatement& statement) {
    static const std::map<std::string, MoveKind, std::less<>> kinds = {{"MOVE APPROACH", MoveKind::approach},
                                                                       {"MOVE CUT", MoveKind::cut},
                                                                       {"MOVE LINK", MoveKind::link},
                                                                       {"MOVE RETRACT", MoveKind::retract}};
    if (statement.items.size() == 1)
      if (const auto kind = kinds.find(statement.items[0].word); kind != kinds.end()) move_ = kind->second;
    return {};
  }

  Result<void> take_nothing(const ClStatement&) { return {}; }

  void list_passed_over() {
    for (const auto& [word, seen] : passed_over_)
      data_.warnings.push_back(file_ + ":" + std::to_string(seen.first) + ": " + word + " is passed over (" +
                               std::to_string(seen.second) + " of them)");
    if (cycle_line_ > 0)
      data_.warnings.push_back(file_ + ":" + std::to_string(cycle_line_) + ": " + std::to_string(cycle_points_) +
                               " points of CYCLE/ statements are passed over: only continuous motion is read");
  }

  std::string file_;
  ClData data_;
  std::map<std::string, std::pair<std::int64_t, std::int64_t>> passed_over_;  // word -> first line, count
  double unit_mm_ = 1.0;
  Vec3 axis_ = Vec3::UnitZ();
  std::optional<double> feed_mm_s_;
  std::optional<Arc> arc_;
  MoveKind move_ = MoveKind::cut;
  bool rapid_ = false, in_cycle_ = false, cutter_seen_ = false, tool_seen_ = false;
  std::int64_t cycle_points_ = 0, cycle_line_ = 0;
};

}  // namespace

Result<ClData> parse_cl(std::string_view text, std::string_view file_name) { return ClReader(file_name).read(text); }

}  // namespace volute::post

#include "sim/machining/stock_run.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/check.hpp"
#include "geometry/number_text.hpp"

namespace volute::sim {
namespace {

using geometry::short_text;
using kinematics::ConeSegment;

constexpr std::size_t findings_max = 100;

struct NamedCone {
  const char* name;
  ConeSegment cone;
};

std::vector<NamedCone> above_the_flutes(const kinematics::Tool& tool) {
  std::vector<NamedCone> out;
  const double shank = tool.stick_out_mm - tool.cutter.length_mm;
  if (shank > 0.0) out.push_back({"shank", {tool.shank_radius_mm, tool.shank_radius_mm, tool.cutter.length_mm, shank}});
  for (const auto& segment : tool.holder) out.push_back({"holder", segment});
  return out;
}

/// A cone that holds every point within `by_mm` of another (within minus that, where it is negative).
ConeSegment grown(const ConeSegment& s, double by_mm) {
  const double slope = s.length_mm > 0.0 ? (s.top_radius_mm - s.bottom_radius_mm) / s.length_mm : 0.0;
  const double wider = by_mm * std::sqrt(1.0 + slope * slope);
  return {std::max(0.0, s.bottom_radius_mm + wider - slope * by_mm),
          std::max(0.0, s.top_radius_mm + wider + slope * by_mm), s.z_mm - by_mm,
          std::max(0.0, s.length_mm + 2.0 * by_mm)};
}

SweptPose between(const SweptPose& a, const SweptPose& b, double share) {
  SweptPose out = b;
  out.pose.tip_P_mm = (1.0 - share) * a.pose.tip_P_mm + share * b.pose.tip_P_mm;
  out.pose.axis_P = ((1.0 - share) * a.pose.axis_P + share * b.pose.axis_P).normalized();
  out.time_s = (1.0 - share) * a.time_s + share * b.time_s;
  return out;
}

/// Gathers what each line removes.
class LineTally {
 public:
  explicit LineTally(std::vector<LineVolume>& out) : out_(out) {}
  ~LineTally() { end(); }
  LineTally(const LineTally&) = delete;
  LineTally& operator=(const LineTally&) = delete;

  void add(std::int64_t line, double removed_mm3, double time_s) {
    if (line != now_.line) end();
    now_.line = line;
    now_.removed_mm3 += removed_mm3;
    now_.time_s += time_s;
  }

 private:
  void end() {
    if (now_.removed_mm3 > 0.0) out_.push_back(now_);
    now_ = {};
  }
  std::vector<LineVolume>& out_;
  LineVolume now_;
};

class StockRun {
 public:
  StockRun(Stock& stock, const kinematics::Tool& tool, const StockRunOptions& options, StockReport& report)
      : stock_(stock),
        tool_(tool),
        options_(options),
        report_(report),
        cones_(above_the_flutes(tool)),
        tally_(report.removed) {
    for (const auto& [name, cone] : cones_) {
      top_mm_ = std::max(top_mm_, cone.z_mm + cone.length_mm);
      radius_mm_ = std::max({radius_mm_, cone.bottom_radius_mm, cone.top_radius_mm});
    }
  }

  void run(std::span<const SweptPose> poses) {
    pending_.assign(1, poses.front());
    begun_ = false;
    free_mm_ = end_stretch(poses.front());
    for (std::size_t i = 1; i < poses.size(); ++i) {
      follow(poses[i - 1], poses[i]);
      if (options_.progress && i % 4096 == 0)
        options_.progress(static_cast<double>(i) / static_cast<double>(poses.size()));
    }
    end_stretch(poses.back());
  }

 private:
  /// How far any point of shank and holder moves at most between two poses.
  [[nodiscard]] double motion(const SweptPose& a, const SweptPose& b) const {
    const Vec3 shift = b.pose.tip_P_mm - a.pose.tip_P_mm, turn = b.pose.axis_P - a.pose.axis_P;
    return std::max(shift.norm(), (shift + top_mm_ * turn).norm()) + radius_mm_ * turn.norm();
  }

  void follow(const SweptPose& a, const SweptPose& b) {
    const double way = motion(a, b);
    if (way < free_mm_) {
      free_mm_ -= way;
      pending_.push_back(b);
      if (pending_.size() >= pending_max) cut();
      return;
    }
    const int parts = std::max(1, static_cast<int>(std::ceil(2.0 * way / options_.step_mm)));
    for (int k = 1; k <= parts; ++k) {
      free_mm_ -= way / parts;
      const bool end = k == parts, look = free_mm_ < way / parts;
      if (!end && !look) continue;
      const SweptPose here = end ? b : between(a, b, static_cast<double>(k) / parts);
      pending_.push_back(here);
      if (look) free_mm_ = end_stretch(here);
    }
  }

  /// Cuts what is pending; the last pose begins the next stretch.
  void cut() {
    const std::vector<double> removed = stock_.cut(tool_.cutter, pending_, options_.tolerance_mm);
    for (std::size_t i = begun_ ? 1 : 0; i < pending_.size(); ++i) {
      const SweptPose& pose = pending_[i];
      const double time_s = i > 0 && !pose.rapid ? pose.time_s - pending_[i - 1].time_s : 0.0;
      tally_.add(pose.line, removed[i], time_s);
      if (pose.rapid) take_rapid(pose, removed[i]);
    }
    begun_ = true;
    pending_.assign(1, SweptPose(pending_.back()));
  }

  /// Cuts, looks at shank and holder where the stretch ends, and says how far they may move before the next look.
  double end_stretch(const SweptPose& pose) {
    cut();
    double free_mm = std::numeric_limits<double>::infinity();
    for (const auto& cone : cones_) free_mm = std::min(free_mm, look(cone, pose));
    return std::max(options_.step_mm, free_mm);
  }

  double look(const NamedCone& named, const SweptPose& pose) {
    const double apart = std::sqrt(box_of_cone(named.cone, pose.pose).squaredExteriorDistance(stock_.box()));
    if (apart >= options_.step_mm) return apart;
    const double far = 8.0 * options_.step_mm;
    // Where the list of findings is full, a line that is not in it has nothing to be looked for.
    if (report_.findings_left_out && listed(pair_name(named), pose) == nullptr) return far;
    if (!stock_.touches(grown(named.cone, far), pose.pose)) return far;
    if (!stock_.touches(named.cone, pose.pose)) return options_.step_mm;
    const double inside = stock_.overlap_mm3(named.cone, pose.pose);
    if (inside > options_.holder_volume_mm3) meet(named, inside, pose);
    return options_.step_mm;
  }

  /// How much the cone can shrink on all sides and still hold material.
  [[nodiscard]] double depth_mm(const ConeSegment& cone, const SweptPose& pose) const {
    double low = 0.0, high = std::min(0.5 * cone.length_mm, std::max(cone.bottom_radius_mm, cone.top_radius_mm));
    while (high - low > 1e-3) {
      const double middle = 0.5 * (low + high);
      (stock_.touches(grown(cone, -middle), pose.pose) ? low : high) = middle;
    }
    return 0.5 * (low + high);
  }

  static std::string pair_name(const NamedCone& named) { return std::string(named.name) + "-stock"; }

  void meet(const NamedCone& named, double inside_mm3, const SweptPose& pose) {
    Finding* finding = find(pair_name(named), pose, 0.0);
    if (finding == nullptr) return;
    const double depth = depth_mm(named.cone, pose);
    if (depth <= finding->value) return;
    finding->value = depth;
    finding->text = "line " + std::to_string(finding->line) + ": " + named.name + " and stock meet from " +
                    short_text(finding->time_s, 6) + " s on, up to " + short_text(depth, 3) + " mm deep (" +
                    short_text(inside_mm3, 3) + " mm3 of material inside)";
  }

  void take_rapid(const SweptPose& pose, double removed_mm3) {
    if (pose.line != rapid_line_) rapid_mm3_ = 0.0;
    rapid_line_ = pose.line;
    rapid_mm3_ += removed_mm3;
    if (removed_mm3 <= 0.0 || rapid_mm3_ <= options_.rapid_volume_mm3) return;
    Finding* finding = find("cutter-stock", pose, options_.rapid_volume_mm3);
    if (finding == nullptr) return;
    finding->value = rapid_mm3_;
    finding->text = "line " + std::to_string(finding->line) + ": the rapid goes through stock from " +
                    short_text(finding->time_s, 6) + " s on and takes " + short_text(rapid_mm3_, 4) + " mm3 of it";
  }

  /// The finding of a pair on a line, if there is one.
  [[nodiscard]] Finding* listed(const std::string& pair, const SweptPose& pose) {
    auto& all = report_.findings;
    const auto same = [&](const Finding& f) { return f.axis_or_pair == pair && f.line == pose.line; };
    const auto found = std::find_if(all.begin(), all.end(), same);
    return found != all.end() ? &*found : nullptr;
  }

  /// The same, made where there is none; nothing when there are too many.
  Finding* find(const std::string& pair, const SweptPose& pose, double limit) {
    if (Finding* found = listed(pair, pose)) return found;
    auto& all = report_.findings;
    if (all.size() >= findings_max) {
      report_.findings_left_out = true;
      return nullptr;
    }
    all.push_back({"collision", pose.line, pose.time_s, pair, 0.0, limit, ""});
    all.back().pose_P = pose.pose;
    return &all.back();
  }

  static constexpr std::size_t pending_max = 4096;
  Stock& stock_;
  const kinematics::Tool& tool_;
  const StockRunOptions& options_;
  StockReport& report_;
  std::vector<NamedCone> cones_;
  LineTally tally_;
  std::vector<SweptPose> pending_;
  bool begun_ = false;  // the first pending pose has been cut already
  double free_mm_ = 0.0, top_mm_ = 0.0, radius_mm_ = 0.0, rapid_mm3_ = 0.0;
  std::int64_t rapid_line_ = -1;
};

}  // namespace

StockReport run_through_stock(Stock& stock, const kinematics::Tool& tool, std::span<const SweptPose> poses,
                              const StockRunOptions& options) {
  VOLUTE_CHECK(options.step_mm > 0.0 && options.tolerance_mm > 0.0, options.step_mm, options.tolerance_mm);
  StockReport report;
  report.first_mm3 = stock.volume_mm3();
  if (!poses.empty()) StockRun(stock, tool, options, report).run(poses);
  report.left_mm3 = stock.volume_mm3();
  return report;
}

}  // namespace volute::sim

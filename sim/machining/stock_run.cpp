#include "sim/machining/stock_run.hpp"

#include <algorithm>

#include "geometry/number_text.hpp"

namespace volute::sim {
namespace {

constexpr std::size_t findings_max = 100;

struct NamedCone {
  const char* name;
  kinematics::ConeSegment cone;
};

std::vector<NamedCone> above_the_flutes(const kinematics::Tool& tool) {
  std::vector<NamedCone> out;
  const double shank = tool.stick_out_mm - tool.cutter.length_mm;
  if (shank > 0.0) out.push_back({"shank", {tool.shank_radius_mm, tool.shank_radius_mm, tool.cutter.length_mm, shank}});
  for (const auto& segment : tool.holder) out.push_back({"holder", segment});
  return out;
}

class StockRun {
 public:
  StockRun(Stock& stock, const kinematics::Tool& tool, const StockRunOptions& options, StockReport& report)
      : stock_(stock), tool_(tool), options_(options), report_(report), cones_(above_the_flutes(tool)) {}

  /// A stretch after whose last pose shank and holder are looked at; its first pose is where the stretch before ended.
  void stretch(std::span<const SweptPose> poses, bool first) {
    const std::vector<double> removed = stock_.cut(tool_.cutter, poses, options_.tolerance_mm);
    for (std::size_t i = first ? 0 : 1; i < poses.size(); ++i) {
      if (removed[i] <= 0.0) continue;
      if (report_.removed.empty() || report_.removed.back().line != poses[i].line)
        report_.removed.push_back({poses[i].line, 0.0});
      report_.removed.back().removed_mm3 += removed[i];
      if (poses[i].rapid && removed[i] > options_.rapid_volume_mm3)
        find("cutter-stock", "the rapid takes ", removed[i], options_.rapid_volume_mm3, poses[i]);
    }
    for (const auto& [name, cone] : cones_) {
      const double inside = stock_.overlap_mm3(cone, poses.back().pose);
      if (inside > options_.holder_volume_mm3) {
        find(std::string(name) + "-stock", std::string(name) + " and stock share ", inside, options_.holder_volume_mm3,
             poses.back());
      }
    }
  }

 private:
  /// One finding a pair and stretch of neighbouring looks.
  void find(const std::string& pair, const std::string& words, double volume, double limit, const SweptPose& pose) {
    for (auto& finding : report_.findings) {
      if (finding.axis_or_pair == pair && finding.line == pose.line) {
        finding.value = std::max(finding.value, volume);
        return;
      }
    }
    if (report_.findings.size() >= findings_max) return;
    report_.findings.push_back(
        {"collision", pose.line, pose.time_s, pair, volume, limit,
         "line " + std::to_string(pose.line) + ": " + words + geometry::short_text(volume, 4) + " mm3 of material"});
  }

  Stock& stock_;
  const kinematics::Tool& tool_;
  const StockRunOptions& options_;
  StockReport& report_;
  std::vector<NamedCone> cones_;
};

}  // namespace

StockReport run_through_stock(Stock& stock, const kinematics::Tool& tool, std::span<const SweptPose> poses,
                              const StockRunOptions& options) {
  StockReport report;
  report.first_mm3 = stock.volume_mm3();
  StockRun run(stock, tool, options, report);
  std::size_t from = 0;
  double way = 0.0;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    const auto &a = poses[i - 1].pose, &b = poses[i].pose;
    way += std::max((b.tip_P_mm - a.tip_P_mm).norm(), tool.stick_out_mm * (b.axis_P - a.axis_P).norm());
    if (way < options.holder_step_mm && i + 1 < poses.size()) continue;
    run.stretch(poses.subspan(from, i - from + 1), from == 0);
    from = i;
    way = 0.0;
  }
  if (poses.size() == 1) run.stretch(poses, true);
  report.left_mm3 = stock.volume_mm3();
  return report;
}

}  // namespace volute::sim

#include "planner/plan.hpp"

#include <algorithm>
#include <chrono>

#include "planner/leads.hpp"

namespace volute::planner {

namespace {

/// Measures a stage, and says when it starts and ends.
class Stage {
 public:
  Stage(const PlanRequest& request, PlanResult& result, std::string name)
      : request_(request), result_(result), name_(std::move(name)), start_(Clock::now()) {
    say(0.0);
  }
  ~Stage() {
    result_.timing_s[name_] += std::chrono::duration<double>(Clock::now() - start_).count();
    say(1.0);
  }
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;
  void say(double done) const {
    if (request_.progress) request_.progress(name_, done);
  }

 private:
  using Clock = std::chrono::steady_clock;
  const PlanRequest& request_;
  PlanResult& result_;
  std::string name_;
  Clock::time_point start_;
};

/// Stock left on the surface: the contact moves out along the normal.
CcPiece offset_piece(CcPiece piece, double allowance_mm) {
  for (CcPoint& point : piece.points) point.point_P_mm += allowance_mm * point.normal_P;
  return piece;
}

void merge_peaks(AxisMotionPeaks& into, const AxisMotionPeaks& from, double share) {
  const auto rms = [&](double a, double b) { return std::sqrt((1.0 - share) * a * a + share * b * b); };
  into = {std::max(into.velocity_max, from.velocity_max),
          std::max(into.acceleration_max, from.acceleration_max),
          std::max(into.jerk_max, from.jerk_max),
          rms(into.velocity_rms, from.velocity_rms),
          rms(into.acceleration_rms, from.acceleration_rms),
          rms(into.jerk_rms, from.jerk_rms)};
}

/// `share`: of the points of `from` in all so far.
void merge_report(OrientationReport& into, const OrientationReport& from, double share) {
  into.smoothing = from.smoothing;
  into.pins += from.pins;
  into.iterations += from.iterations;
  into.solve_s += from.solve_s;
  into.interferences_before += from.interferences_before;
  into.interferences_after += from.interferences_after;
  into.neighbour_turn_max_rad = std::max(into.neighbour_turn_max_rad, from.neighbour_turn_max_rad);
  into.first_letter = from.first_letter;
  into.second_letter = from.second_letter;
  merge_peaks(into.first, from.first, share);
  merge_peaks(into.second, from.second, share);
  for (const std::string& note : from.notes) {
    if (std::find(into.notes.begin(), into.notes.end(), note) == into.notes.end()) into.notes.push_back(note);
  }
}

Result<std::vector<OrientedPath>> orient_pieces(const PlanRequest& request, const Interference& interference,
                                                PlanResult& result) {
  const Stage stage(request, result, "orientation");
  std::vector<OrientedPath> oriented;
  double points = 0.0;
  const auto turns = TurnMeans::of(result.cc.path, request.orientation, feed_window_mm);
  AmongPieces among{turns ? &*turns : nullptr, std::nullopt};
  for (const CcPiece& piece : result.cc.path.pieces) {
    auto one = orient(offset_piece(piece, request.path.allowance_mm), request.tool, request.machine, request.setup,
                      interference, request.orientation, request.process.feed_mm_s, among);
    if (!one) return tl::unexpected(one.error());
    points += static_cast<double>(one->tool_path.points.size());
    merge_report(result.orientation, one->report, static_cast<double>(one->tool_path.points.size()) / points);
    result.rotaries_rad.insert(result.rotaries_rad.end(), one->rotaries_rad.begin(), one->rotaries_rad.end());
    among.rotaries_before_rad = one->rotaries_rad.back();
    among.point_before_P_mm = piece.points.back().point_P_mm;
    oriented.push_back(std::move(*one));
    stage.say(static_cast<double>(oriented.size()) / static_cast<double>(result.cc.path.pieces.size()));
  }
  return oriented;
}

Result<void> join_pieces(const PlanRequest& request, const Interference& interference,
                         const std::vector<OrientedPath>& pieces, PlanResult& result) {
  const Stage stage(request, result, "leads");
  double clearance_z_mm =
      std::max(highest_point_mm(request.scene), highest_point_mm(Scene{request.surface, {}, {}, {}})) +
      request.process.clearance_height_mm;
  const Scene rapids = rapid_scene(request.scene, request.stock_P, request.process.safe_distance_mm);
  if (request.stock_P)
    clearance_z_mm = std::max(clearance_z_mm,
                              highest_point_mm(Scene{*request.stock_P, {}, {}, {}}) + request.process.safe_distance_mm);
  const Interference beyond_safe_distance(rapids, request.tool, nullptr, nullptr);
  const Leads leads(request.tool, interference, beyond_safe_distance, request.process, clearance_z_mm, &request.machine,
                    &request.setup);
  std::vector<kinematics::ToolPath> cuts;
  for (const OrientedPath& piece : pieces) cuts.push_back(piece.tool_path);
  auto whole = leads.join(cuts);
  if (!whole) return tl::unexpected(whole.error());
  result.tool_path = std::move(*whole);
  return {};
}

}  // namespace

Result<PlanResult> plan(const PlanRequest& request) {
  PlanResult result;
  {
    const Stage stage(request, result, "path");
    auto cc = plan_cc_path(request.surface, request.tool.cutter, request.path, request.orientation);
    if (!cc) return tl::unexpected(cc.error());
    result.cc = std::move(*cc);
  }
  std::optional<Interference> interference;
  {
    const Stage stage(request, result, "interference trees");
    interference.emplace(request.scene, request.tool, &request.machine, &request.setup);
  }
  const auto oriented = orient_pieces(request, *interference, result);
  if (!oriented) return tl::unexpected(oriented.error());
  if (const auto joined = join_pieces(request, *interference, *oriented, result); !joined)
    return tl::unexpected(joined.error());
  return result;
}

}  // namespace volute::planner

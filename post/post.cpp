#include "post/post.hpp"

#include <cmath>
#include <optional>

#include "geometry/number_text.hpp"
#include "post/program.hpp"
#include "post/rotary_words.hpp"

namespace volute::post {

using kinematics::MoveKind;
using kinematics::ToolPath;
using kinematics::ToolPathPoint;

namespace {

constexpr double clearance_mm = 50.0;  // along the tool axis, where a foreign path starts or ends on the part

Result<void> check(const PostRequest& request) {
  if (request.path.points.empty())
    return geometry::bad_input("post-no-motion", "the tool path has no point; there is nothing to post");
  if (!(request.tolerance_mm > 0.0))
    return geometry::bad_input("post-tolerance",
                               "tolerance_mm = " + geometry::short_text(request.tolerance_mm) + " must be above 0");
  for (std::size_t i = 0; i < request.path.points.size(); ++i) {
    const ToolPathPoint& point = request.path.points[i];
    if (point.move == MoveKind::rapid || (point.feed_mm_s > 0.0 && std::isfinite(point.feed_mm_s))) continue;
    return geometry::bad_input("post-feed", "point " + std::to_string(i) + " of the tool path has feed " +
                                                geometry::short_text(point.feed_mm_s) +
                                                " mm/s; a move that is no rapid needs a feed above 0");
  }
  return {};
}

ToolPathPoint above(const ToolPathPoint& point, MoveKind move) {
  ToolPathPoint lifted = point;
  lifted.pose.tip_P_mm += clearance_mm * point.pose.axis_P;
  lifted.move = move;
  return lifted;
}

// A path that starts at feed is approached along its axis, and one that ends in the cut is left so. Nothing: the path
// does both itself.
std::optional<ToolPath> with_safe_ends(const ToolPath& path) {
  const MoveKind first = path.points.front().move, end = path.points.back().move;
  if (first == MoveKind::rapid && (end == MoveKind::rapid || end == MoveKind::retract)) return std::nullopt;
  ToolPath safe;
  safe.points.reserve(path.points.size() + 2);
  const ToolPathPoint& last = path.points.back();
  if (path.points.front().move != MoveKind::rapid) safe.points.push_back(above(path.points.front(), MoveKind::rapid));
  safe.points.insert(safe.points.end(), path.points.begin(), path.points.end());
  if (last.move != MoveKind::rapid && last.move != MoveKind::retract)
    safe.points.push_back(above(last, MoveKind::retract));
  return safe;
}

// Sources count the points of the request: the approach that was put before them and the retract behind have none.
void count_sources_from_request(const ToolPath& request, bool approach_added, kinematics::AxisPath& path) {
  const auto count = static_cast<std::int32_t>(request.points.size());
  for (kinematics::AxisPathPoint& point : path.points) {
    if (approach_added && point.source >= 0) --point.source;
    if (point.source >= count) point.source = -1;
  }
}

kinematics::AxisPathOptions options_for(const PostRequest& request, const kinematics::Control& control) {
  kinematics::AxisPathOptions options;
  options.chordal_tolerance_mm = request.tolerance_mm;
  options.control_keeps_tip = control.tcp;
  options.great_circle = control.orientation_interpolation == kinematics::OrientationInterpolation::great_circle;
  return options;
}

}  // namespace

Result<PostResult> post(const PostRequest& request, const kinematics::Profile& profile) {
  if (auto checked = check(request); !checked) return tl::unexpected(checked.error());
  const std::optional<ToolPath> made_safe = with_safe_ends(request.path);
  const ToolPath& path = made_safe ? *made_safe : request.path;
  auto solved =
      kinematics::solve_path(profile.machine, request.setup, request.tool, path, options_for(request, profile.control));
  if (!solved) return tl::unexpected(solved.error());
  count_sources_from_request(request.path, request.path.points.front().move != MoveKind::rapid, solved->path);
  if (profile.control.rotary_shortest_way)
    solved->path = split_long_turns(profile.machine, request.setup, request.tool.gauge_length_mm, solved->path);

  Program program(request, profile, solved->path);
  program.begin();
  program.enter(solved->path.points.front());
  program.motion();
  program.leave();
  program.end();
  auto result = program.finish();
  if (!result) return result;
  result->axis_path = std::move(solved->path);
  result->linearization = solved->report;
  return result;
}

}  // namespace volute::post

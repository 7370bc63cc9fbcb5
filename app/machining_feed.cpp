#include "app/machining_feed.hpp"

namespace volute::app {

std::optional<MachiningFeed> machining_feed(const kinematics::ToolPath& path, const sim::VerifyResult& verified) {
  double length_mm = 0.0, programmed_s = 0.0;
  for (std::size_t i = 1; i < path.points.size(); ++i) {
    const kinematics::ToolPathPoint& point = path.points[i];
    if (point.move != kinematics::MoveKind::cut || point.feed_mm_s <= 0.0) continue;
    const double way_mm = (point.pose.tip_P_mm - path.points[i - 1].pose.tip_P_mm).norm();
    length_mm += way_mm;
    programmed_s += way_mm / point.feed_mm_s;
  }
  if (programmed_s <= 0.0 || !verified.machining_time_s || *verified.machining_time_s <= 0.0) return std::nullopt;
  const auto loss_percent = [&](double time_s) { return 100.0 * (programmed_s / time_s - 1.0); };
  MachiningFeed feed{length_mm,
                     length_mm / programmed_s,
                     length_mm / *verified.machining_time_s,
                     loss_percent(*verified.machining_time_s),
                     {}};
  if (verified.unlimited_jerk && verified.unlimited_jerk->machining_time_s.value_or(0.0) > 0.0)
    feed.unlimited_jerk_loss_percent = loss_percent(*verified.unlimited_jerk->machining_time_s);
  return feed;
}

}  // namespace volute::app

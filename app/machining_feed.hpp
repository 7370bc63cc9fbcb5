// The feed of a whole machining: cutting length over all of the time from the first cut's approach to the last retract.
#pragma once

#include <optional>

#include "kinematics/model/tool_path.hpp"
#include "sim/verify.hpp"

namespace volute::app {

/// [Sun2016] (37) and (38) read literally: the length of the tool path is that of its cutting passes, the machining
/// time everything from the first feed move with the spindle on to the end of the last. Leads, linkings and rapids are
/// then time without length; RunReport::actual_feed_mm_s counts feed moves only, with their own length.
struct MachiningFeed {
  double cutting_length_mm = 0.0;  ///< of the tip, links along the surface not counted
  double programmed_mm_s = 0.0;    ///< that length over the time that its feeds ask for it
  double actual_mm_s = 0.0;
  double loss_percent = 0.0;  ///< (actual - programmed) / programmed * 100
  /// The same where no jerk is limited; nothing where the control limits none by itself.
  std::optional<double> unlimited_jerk_loss_percent;
};

/// Nothing where the path cuts nothing or the run has no feed move.
std::optional<MachiningFeed> machining_feed(const kinematics::ToolPath& path, const sim::VerifyResult& verified);

}  // namespace volute::app

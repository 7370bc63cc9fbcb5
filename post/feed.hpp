// The F word of a cutting block. Private to post.
#pragma once

#include "kinematics/inverse/inverse.hpp"
#include "kinematics/model/control.hpp"

namespace volute::post {

enum class FeedUnit : std::uint8_t { per_minute, inverse_time };

struct FeedWord {
  double value = 0.0;    ///< mm/min, or 1/min
  bool clamped = false;  ///< the control's greatest F: the block takes longer than asked
};

/// F for the step from `from` to `to` at to.feed_mm_s of the tip in the part.
/// Inverse time: 1 / time, the time being that of the tip, and not less than any rotary needs at its own speed (a step
/// that only turns would otherwise last no time). Per minute with TCP: the tip's feed. Per minute without TCP: the feed
/// along whatever the control counts as path (Control::mixed_feed) that takes the tip's time.
FeedWord feed_word(const kinematics::Machine& machine, const kinematics::Control& control,
                   const kinematics::AxisPathPoint& from, const kinematics::AxisPathPoint& to);

}  // namespace volute::post

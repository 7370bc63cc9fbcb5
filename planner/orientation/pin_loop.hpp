// The loop of [Sun2016] Fig. 8: pin critical points, smooth, check, pin again where something touches, until nothing
// does.
#pragma once

#include <vector>

#include "geometry/result.hpp"
#include "planner/orientation/allowed_set.hpp"

namespace volute::planner {

struct PinLoopResult {
  std::vector<Rotaries> at;
  std::vector<int> pins;
  int iterations = 0;
  double solve_s = 0.0;
  bool free = false;  ///< every point and every motion is allowed
};

/// Where the path goes through what blocks the reference axis: [first, last] point of a run.
struct BlockedArea {
  int first = 0, last = 0;
};

/// Runs of blocked points.
std::vector<BlockedArea> blocked_areas(const std::vector<char>& blocked);
/// First and last point, and of each area the point entering it, one inside and the point leaving it ([Sun2016] Fig.
/// 9), rising.
std::vector<int> critical_points(int points, const std::vector<BlockedArea>& areas);

/// Requires: targets[i] is allowed at every index in `critical`. `fixed` are pins that the user gave (index, axis).
struct FixedPin {
  int index;
  Vec3 axis_P;
};
PinLoopResult run_pin_loop(const AllowedSet& allowed, const std::vector<Vec3>& reference,
                           const std::vector<char>& reference_blocked, const std::vector<int>& critical,
                           const std::vector<FixedPin>& fixed, const OrientationOptions& options);

/// Which points are not allowed, or not free on the way to the next one. `limits_only`: travel and process limits
/// alone, points only.
std::vector<char> check_path(const AllowedSet& allowed, const std::vector<Rotaries>& at, bool limits_only);

/// Limits first, and interference only when they hold; what stands as it stood at the last look is not looked at again.
class PathCheck {
 public:
  explicit PathCheck(const AllowedSet& allowed) : allowed_(allowed) {}
  std::vector<char> touching(const std::vector<Rotaries>& at);

 private:
  const AllowedSet& allowed_;
  std::vector<Rotaries> last_;
  std::vector<char> last_bad_;
};

}  // namespace volute::planner

#include "app/compared_path.hpp"

#include <algorithm>
#include <array>

namespace volute::app {

using geometry::Result;
using planner::Strategy;

namespace {

struct NamedStrategy {
  const char* name;
  Strategy strategy;
};
constexpr std::array<NamedStrategy, 5> all_strategies{{{"contour-parallel", Strategy::contour_parallel},
                                                       {"projected-spiral", Strategy::projected_spiral},
                                                       {"contour-offset", Strategy::contour_offset},
                                                       {"iso-planar", Strategy::iso_planar},
                                                       {"spiral", Strategy::spiral}}};

struct NamedAxis {
  const char* name;
  ComparedAxis axis;
};
constexpr std::array<NamedAxis, 2> all_axes{{{"tilted", ComparedAxis::tilted}, {"normal", ComparedAxis::normal}}};

}  // namespace

Result<ComparedPath> compared_path(const std::string& name) {
  const std::size_t colon = name.find(':');
  const std::string first = name.substr(0, colon);
  const auto* strategy = std::find_if(all_strategies.begin(), all_strategies.end(),
                                      [&](const NamedStrategy& s) { return first == s.name; });
  if (strategy == all_strategies.end())
    return geometry::bad_input(
        "strategy-unknown", "--strategies " + name + ": " + first +
                                " is none of contour-parallel, projected-spiral, contour-offset, iso-planar, spiral");
  if (colon == std::string::npos) return ComparedPath{name, name, strategy->strategy, ComparedAxis::as_job};
  const std::string second = name.substr(colon + 1);
  const auto* axis =
      std::find_if(all_axes.begin(), all_axes.end(), [&](const NamedAxis& a) { return second == a.name; });
  if (axis == all_axes.end())
    return geometry::bad_input("axis-unknown", "--strategies " + name + ": \"" + second +
                                                   "\" is none of normal, tilted; leave it out for the job's own axes");
  return ComparedPath{name, first + "-" + second, strategy->strategy, axis->axis};
}

JobInputs with_path(JobInputs inputs, Strategy strategy, ComparedAxis axis) {
  inputs.job.path.strategy = strategy;
  if (axis == ComparedAxis::as_job) return inputs;
  planner::OrientationOptions& orientation = inputs.job.orientation;
  orientation.smoothing = planner::Smoothing::none;
  if (axis == ComparedAxis::normal) orientation.tilt = orientation.yaw = orientation.tilt_min = {};
  return inputs;
}

}  // namespace volute::app

#include "planner/orientation/field_loop.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <chrono>

#include "planner/field/mesh_field.hpp"

namespace volute::planner {

namespace {

/// Keys when the user gives none: enough to follow the surface, few enough for well conditioned equations.
constexpr int own_keys = 24;
/// A key is not put nearer to another one than this share of the path's extent: the equations would turn singular.
constexpr double least_spacing_share = 0.01;

FieldKey key_at(const Station& station, const Vec3& axis_P) {
  return {{geometry::Vec2::Zero(), station.contact_P_mm}, axis_P};
}

std::vector<FieldKey> first_keys(const AllowedSet& allowed, const std::vector<Vec3>& reference,
                                 const std::vector<FixedPin>& fixed, const OrientationOptions& options) {
  std::vector<FieldKey> keys;
  for (const KeyOrientation& key : options.keys)
    if (key.point_P_mm) keys.push_back({{geometry::Vec2::Zero(), *key.point_P_mm}, key.axis_P.normalized()});
  for (const FixedPin& pin : fixed)
    keys.push_back(key_at(allowed.stations()[static_cast<std::size_t>(pin.index)], pin.axis_P));
  if (!keys.empty()) return keys;
  const int points = static_cast<int>(allowed.stations().size());
  for (int k = 0; k < own_keys; ++k) {
    const int i = static_cast<int>((static_cast<std::int64_t>(points) - 1) * k / (own_keys - 1));
    const Vec3& wanted = reference[static_cast<std::size_t>(i)];
    keys.push_back(key_at(allowed.stations()[static_cast<std::size_t>(i)],
                          allowed.nearest(i, wanted, geometry::Angle()).value_or(wanted)));
  }
  return keys;
}

double extent_mm(std::span<const Station> stations) {
  Vec3 least = stations.front().contact_P_mm, greatest = least;
  for (const Station& station : stations) {
    least = least.cwiseMin(station.contact_P_mm);
    greatest = greatest.cwiseMax(station.contact_P_mm);
  }
  return (greatest - least).norm();
}

/// Adds a key where there is room; says whether it did.
bool add_key(std::vector<FieldKey>& keys, const FieldKey& key, double least_spacing_mm) {
  for (const FieldKey& other : keys)
    if (field_distance({}, other.place, key.place) < least_spacing_mm) return false;
  keys.push_back(key);
  return true;
}

/// Own keys of neighbouring turns can lie together: keep those with room.
std::vector<FieldKey> spaced(const std::vector<FieldKey>& keys, double least_spacing_mm) {
  std::vector<FieldKey> kept;
  for (const FieldKey& key : keys) add_key(kept, key, least_spacing_mm);
  return kept;
}

geometry::Result<std::vector<Vec3>> field_axes(const AllowedSet& allowed, const std::vector<FieldKey>& keys,
                                               const FieldOptions& options) {
  const auto field = RbfField::fit(keys, with_width(options.basis, keys, {}), {});
  if (!field) return tl::unexpected(field.error());
  std::vector<Vec3> axes(allowed.stations().size(), Vec3::Zero());
  tbb::parallel_for(std::size_t{0}, axes.size(), [&](std::size_t i) {
    axes[i] = field->axis({geometry::Vec2::Zero(), allowed.stations()[i].contact_P_mm}).value_or(Vec3::Zero());
  });
  for (std::size_t i = 0; i < axes.size(); ++i)
    if (axes[i].isZero())
      return geometry::bad_input("orientation-field-vanishes", "the orientation field has no direction at CC point " +
                                                                   std::to_string(allowed.stations()[i].source) +
                                                                   "; add a key axis near it");
  return axes;
}

std::vector<char> blocked_points(const AllowedSet& allowed, const std::vector<Vec3>& axes) {
  std::vector<char> marks(axes.size(), 0);
  tbb::parallel_for(std::size_t{0}, axes.size(), [&](std::size_t i) {
    marks[i] = allowed.blocked(static_cast<int>(i), axes[i]) == Blocked::no ? 0 : 1;
  });
  return marks;
}

}  // namespace

geometry::Result<FieldLoopResult> run_field_loop(const AllowedSet& allowed, const std::vector<Vec3>& reference,
                                                 const std::vector<FixedPin>& fixed,
                                                 const OrientationOptions& options) {
  const double least_spacing_mm = least_spacing_share * extent_mm(allowed.stations());
  std::vector<FieldKey> keys = spaced(first_keys(allowed, reference, fixed, options), least_spacing_mm);
  FieldLoopResult result;
  for (result.iterations = 1; result.iterations <= options.iterations_max; ++result.iterations) {
    const auto started = std::chrono::steady_clock::now();
    auto axes = field_axes(allowed, keys, options.field);
    result.solve_s += std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
    if (!axes) return tl::unexpected(axes.error());
    result.axes_P = std::move(*axes);
    result.keys = static_cast<int>(keys.size());
    const std::vector<BlockedArea> areas = blocked_areas(blocked_points(allowed, result.axes_P));
    result.allowed = areas.empty();
    if (result.allowed) return result;
    bool added = false;
    for (const BlockedArea& area : areas) {
      const int i = (area.first + area.last) / 2;
      if (const auto axis =
              allowed.nearest(i, result.axes_P[static_cast<std::size_t>(i)], geometry::Angle::degrees(2.0)))
        added =
            add_key(keys, key_at(allowed.stations()[static_cast<std::size_t>(i)], *axis), least_spacing_mm) || added;
    }
    if (!added) return result;
  }
  --result.iterations;
  return result;
}

}  // namespace volute::planner

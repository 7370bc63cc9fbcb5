#include "planner/orientation/field_loop.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <chrono>

#include "planner/field/mesh_field.hpp"

namespace volute::planner {

namespace {

/// Keys when the user gives none: enough to follow the surface, few enough for well conditioned equations.
constexpr int own_keys = 24;
/// A key is not put nearer to another one than this share of the path's extent, in the field's own distance: the
/// equations would turn singular.
constexpr double least_spacing_share = 0.01;

std::vector<PointKey> first_keys(const AllowedSet& allowed, const std::vector<Vec3>& reference,
                                 const std::vector<FixedPin>& fixed, const OrientationOptions& options) {
  std::vector<PointKey> keys;
  const auto contact = [&](int i) { return allowed.stations()[static_cast<std::size_t>(i)].contact_P_mm; };
  for (const KeyOrientation& key : options.keys)
    if (key.point_P_mm) keys.push_back({*key.point_P_mm, key.axis_P.normalized()});
  for (const FixedPin& pin : fixed) keys.push_back({contact(pin.index), pin.axis_P});
  if (!keys.empty()) return keys;
  const int points = static_cast<int>(allowed.stations().size());
  for (int k = 0; k < own_keys; ++k) {
    const int i = static_cast<int>((static_cast<std::int64_t>(points) - 1) * k / (own_keys - 1));
    const Vec3& wanted = reference[static_cast<std::size_t>(i)];
    keys.push_back({contact(i), allowed.nearest(i, wanted, geometry::Angle()).value_or(wanted)});
  }
  return keys;
}

/// The contacts' box carries the parameters.
FieldFrame frame_of(const AllowedSet& allowed, FieldPlacement placement) {
  std::vector<Vec3> contacts;
  for (const Station& station : allowed.stations()) contacts.push_back(station.contact_P_mm);
  return {placement, contacts};
}

/// Adds a key where there is room; says whether it did.
bool add_key(std::vector<PointKey>& keys, const PointKey& key, const FieldFrame& frame) {
  const FieldPlace place = frame.place(key.point_P_mm);
  for (const PointKey& other : keys)
    if (field_distance(frame.metric(), frame.place(other.point_P_mm), place) < least_spacing_share * frame.extent())
      return false;
  keys.push_back(key);
  return true;
}

/// Own keys of neighbouring turns can lie together: keep those with room.
std::vector<PointKey> spaced(const std::vector<PointKey>& keys, const FieldFrame& frame) {
  std::vector<PointKey> kept;
  for (const PointKey& key : keys) add_key(kept, key, frame);
  return kept;
}

geometry::Result<std::vector<Vec3>> field_axes(const AllowedSet& allowed, const FieldFrame& frame,
                                               const std::vector<PointKey>& keys, const FieldOptions& options) {
  const auto field = SurfaceField::fit(frame, keys, options);
  if (!field) return tl::unexpected(field.error());
  std::vector<Vec3> axes(allowed.stations().size(), Vec3::Zero());
  tbb::parallel_for(std::size_t{0}, axes.size(), [&](std::size_t i) {
    axes[i] = field->axis(allowed.stations()[i].contact_P_mm).value_or(Vec3::Zero());
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
  const FieldFrame frame = frame_of(allowed, options.field.placement);
  std::vector<PointKey> keys = spaced(first_keys(allowed, reference, fixed, options), frame);
  FieldLoopResult result;
  for (result.iterations = 1; result.iterations <= options.iterations_max; ++result.iterations) {
    const auto started = std::chrono::steady_clock::now();
    auto axes = field_axes(allowed, frame, keys, options.field);
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
        added = add_key(keys, {allowed.stations()[static_cast<std::size_t>(i)].contact_P_mm, *axis}, frame) || added;
    }
    if (!added) return result;
  }
  --result.iterations;
  return result;
}

}  // namespace volute::planner

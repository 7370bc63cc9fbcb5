#include "sim/machining/notch_search.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "sim/machining/golden_section.hpp"

namespace volute::sim {
namespace {

/// Where on a triangle a standing cutter reaches deepest below it.
struct Notch {
  double depth_mm = 0.0;
  std::int32_t place = 0;
  std::int32_t triangle = 0;
  Vec3 foot_mm = Vec3::Zero();
};

bool deeper(const Notch& a, const Notch& b) {
  return std::tuple(-a.depth_mm, a.place, a.triangle) < std::tuple(-b.depth_mm, b.place, b.triangle);
}

/// The deepest of each neighbourhood (a cube of `size_mm` within a triangle), the deepest first, at most so many.
void keep_deepest(std::vector<Notch>& notches, double size_mm, std::size_t most) {
  const auto where = [&](const Notch& n) {
    const Vec3 cube = (n.foot_mm / size_mm).array().floor();
    return std::tuple(n.triangle, cube.x(), cube.y(), cube.z());
  };
  std::sort(notches.begin(), notches.end(), [&](const Notch& a, const Notch& b) {
    const auto wa = where(a), wb = where(b);
    return wa != wb ? wa < wb : deeper(a, b);
  });
  const auto same = [&](const Notch& a, const Notch& b) { return where(a) == where(b); };
  notches.erase(std::unique(notches.begin(), notches.end(), same), notches.end());
  std::sort(notches.begin(), notches.end(), deeper);
  if (notches.size() > most) notches.resize(most);
}

class NotchSearch {
 public:
  NotchSearch(const SweptCutter& cutter, const SurfaceFacets& facets, double beyond_mm)
      : cutter_(cutter), facets_(facets), beyond_mm_(beyond_mm) {}

  void at_place(std::int32_t place, std::vector<Notch>& out) const {
    const StandingCutter& stand = cutter_.place(place);
    // The nose lies within this of the arc's height on the axis.
    const double radius = cutter_.profile().greatest_radius_mm(), height = cutter_.profile().corner_radius_mm();
    facets_.tree().near(stand.tip_mm + height * stand.axis, std::hypot(radius, height),
                        [&](std::int32_t t) { under_triangle(stand, place, t, out); });
  }

  /// As the cut surface defines it: what the whole sweep does at the foot.
  [[nodiscard]] Extreme measured(const Notch& notch) const {
    const Vec3& normal = facets_.normal(static_cast<std::size_t>(notch.triangle));
    SweptCutter::Near near;
    cutter_.near(notch.foot_mm, 0.0, normal, 0.0, near);
    const auto entry = cutter_.entry(notch.foot_mm, normal, 0.0, near);
    if (!entry) return {0.0, -1, notch.foot_mm};
    return {-facets_.buried_mm(notch.foot_mm, normal, -entry->height_mm), entry->pose, notch.foot_mm};
  }

 private:
  void under_triangle(const StandingCutter& stand, std::int32_t place, std::int32_t t, std::vector<Notch>& out) const {
    const auto triangle = static_cast<std::size_t>(t);
    const CutterProfile& profile = cutter_.profile();
    const Vec3& normal = facets_.normal(triangle);
    const double down = -normal.dot(stand.axis);
    const Vec2 lowest = profile.support(down);
    const Vec3 out_of_axis = -normal - down * stand.axis;
    const double length = out_of_axis.norm();
    const Vec3 away = length > 1e-12 ? Vec3(out_of_axis / length) : Vec3(Vec3::Zero());
    const Vec3 deepest = stand.tip_mm + lowest.y() * stand.axis + lowest.x() * away;
    const double depth = -normal.dot(deepest - facets_.corner(triangle, 0));
    if (depth <= beyond_mm_ || depth > 2.0 * profile.greatest_radius_mm()) return;
    if (passes_by(stand, triangle, away)) return;
    const Vec3 foot = deepest + depth * normal;
    bool held = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 &a = facets_.corner(triangle, k), &b = facets_.corner(triangle, (k + 1) % 3);
      if ((b - a).cross(foot - a).dot(normal) >= -1e-9 * (b - a).norm()) continue;
      held = false;
      under_edge(stand, place, t, a, b, out);
    }
    if (held) take({depth, place, t, foot}, out);
  }

  /// The depth is a concave function of the foot. Where its greatest lies beyond an edge of the triangle, the deepest
  /// on the triangle lies on such an edge, and along that it is a concave function too.
  void under_edge(const StandingCutter& stand, std::int32_t place, std::int32_t t, const Vec3& a, const Vec3& b,
                  std::vector<Notch>& out) const {
    const CutterProfile& profile = cutter_.profile();
    const double length = (b - a).norm();
    const Vec3 way = (b - a) / length;
    const auto in = line_entry_mm(profile, stand, a, way, length);
    if (!in) return;
    const auto behind = line_entry_mm(profile, stand, b, -way, length);
    if (!behind) return;
    const Vec3& normal = facets_.normal(static_cast<std::size_t>(t));
    Notch best{0.0, place, t, a};
    const auto depth = [&](double s) {
      const Vec3 foot = a + s * way;
      const double found = -line_entry_mm(profile, stand, foot, normal, 0.0).value_or(0.0);
      if (found > best.depth_mm) best = {found, place, t, foot};
      return found;
    };
    const double low = std::max(0.0, *in), high = length - std::max(0.0, *behind);
    if (low > high) return;
    depth(low);
    depth(high);
    const auto height = [&](double s) { return -depth(s); };
    GoldenSection(height, low, high).narrow(30);
    take(best, out);
  }

  /// Does the triangle lie wholly below the plane of the cutter's bottom, or wholly beyond its reach?
  [[nodiscard]] bool passes_by(const StandingCutter& stand, std::size_t triangle, const Vec3& away) const {
    double highest = -1.0, nearest = cutter_.profile().greatest_radius_mm();
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 w = facets_.corner(triangle, k) - stand.tip_mm;
      highest = std::max(highest, w.dot(stand.axis));
      nearest = std::min(nearest, w.dot(away));
    }
    return highest <= 0.0 || nearest >= cutter_.profile().greatest_radius_mm();
  }

  void take(Notch notch, std::vector<Notch>& out) const {
    if (notch.depth_mm <= beyond_mm_) return;
    notch.depth_mm =
        facets_.buried_mm(notch.foot_mm, facets_.normal(static_cast<std::size_t>(notch.triangle)), notch.depth_mm);
    if (notch.depth_mm > beyond_mm_) out.push_back(notch);
  }

  const SweptCutter& cutter_;
  const SurfaceFacets& facets_;
  double beyond_mm_;
};

}  // namespace

std::vector<Extreme> deepest_notches(const SweptCutter& cutter, const SurfaceFacets& facets, double beyond_mm,
                                     std::size_t most) {
  if (cutter.ball_nose() || cutter.place_count() == 0) return {};
  const NotchSearch search(cutter, facets, beyond_mm);
  // Blocks of a fixed size, so that the result is the same however many threads share them.
  constexpr std::size_t block = 2048;
  const double size_mm = cutter.profile().greatest_radius_mm();
  std::vector<std::vector<Notch>> blocks((cutter.place_count() + block - 1) / block);
  tbb::parallel_for(std::size_t{0}, blocks.size(), [&](std::size_t b) {
    for (std::size_t p = b * block; p < std::min((b + 1) * block, cutter.place_count()); ++p)
      search.at_place(static_cast<std::int32_t>(p), blocks[b]);
    keep_deepest(blocks[b], size_mm, most);
  });
  std::vector<Notch> all;
  for (const auto& found : blocks) all.insert(all.end(), found.begin(), found.end());
  keep_deepest(all, size_mm, most);
  std::vector<Extreme> out(all.size());
  tbb::parallel_for(std::size_t{0}, all.size(), [&](std::size_t i) { out[i] = search.measured(all[i]); });
  std::erase_if(out, [&](const Extreme& e) { return e.pose < 0 || e.height_mm >= -beyond_mm; });
  return out;
}

}  // namespace volute::sim

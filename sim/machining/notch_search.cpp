#include "sim/machining/notch_search.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace volute::sim {
namespace {

/// A triangle's foot of the deepest point of a standing cutter.
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
  NotchSearch(const SweptCutter& cutter, const geometry::TriangleMesh& surface) : cutter_(cutter), surface_(surface) {
    std::vector<Box> boxes;
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
      Box box;
      for (std::size_t k = 0; k < 3; ++k) box.extend(corner(t, k));
      boxes.push_back(box);
      normals_.push_back((corner(t, 1) - corner(t, 0)).cross(corner(t, 2) - corner(t, 0)).normalized());
    }
    tree_ = BoxTree(boxes);
  }

  void at_place(std::int32_t place, double beyond_mm, std::vector<Notch>& out) const {
    const CutterProfile& profile = cutter_.profile();
    const StandingCutter& stand = cutter_.place(place);
    // The nose lies within this of the arc's height on the axis.
    const double height = profile.corner_radius_mm();
    tree_.near(stand.tip_mm + height * stand.axis, std::hypot(profile.greatest_radius_mm(), height), [&](auto t) {
      const auto triangle = static_cast<std::size_t>(t);
      const Vec3& normal = normals_[triangle];
      const double down = -normal.dot(stand.axis);
      const Vec2 lowest = profile.support(down);
      const Vec3 out_of_axis = -normal - down * stand.axis;
      const double length = out_of_axis.norm();
      const Vec3 deepest = stand.tip_mm + lowest.y() * stand.axis +
                           (length > 1e-12 ? Vec3(lowest.x() / length * out_of_axis) : Vec3(Vec3::Zero()));
      const double depth = -normal.dot(deepest - corner(triangle, 0));
      if (depth <= beyond_mm || depth > 2.0 * profile.greatest_radius_mm()) return;
      const Vec3 foot = deepest + depth * normal;
      if (holds(triangle, foot)) out.push_back({depth, place, t, foot});
    });
  }

  /// As the cut surface defines it: what the whole sweep does at the foot.
  [[nodiscard]] Extreme measured(const Notch& notch) const {
    const Vec3& normal = normals_[static_cast<std::size_t>(notch.triangle)];
    SweptCutter::Near near;
    cutter_.near(notch.foot_mm, 0.0, normal, 0.0, near);
    const auto entry = cutter_.entry(notch.foot_mm, normal, 0.0, near);
    return entry ? Extreme{entry->height_mm, entry->pose, notch.foot_mm} : Extreme{0.0, -1, notch.foot_mm};
  }

 private:
  [[nodiscard]] const Vec3& corner(std::size_t triangle, std::size_t k) const {
    return surface_.vertices_mm[static_cast<std::size_t>(surface_.triangles[triangle][k])];
  }
  [[nodiscard]] bool holds(std::size_t triangle, const Vec3& point) const {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 &a = corner(triangle, k), &b = corner(triangle, (k + 1) % 3);
      if ((b - a).cross(point - a).dot(normals_[triangle]) < -1e-9 * (b - a).norm()) return false;
    }
    return true;
  }

  const SweptCutter& cutter_;
  const geometry::TriangleMesh& surface_;
  std::vector<Vec3> normals_;
  BoxTree tree_;
};

}  // namespace

std::vector<Extreme> deepest_notches(const SweptCutter& cutter, const geometry::TriangleMesh& surface, double beyond_mm,
                                     std::size_t most) {
  if (cutter.ball_nose() || cutter.place_count() == 0) return {};
  const NotchSearch search(cutter, surface);
  // Blocks of a fixed size, so that the result is the same however many threads share them.
  constexpr std::size_t block = 2048;
  const double size_mm = cutter.profile().greatest_radius_mm();
  std::vector<std::vector<Notch>> blocks((cutter.place_count() + block - 1) / block);
  tbb::parallel_for(std::size_t{0}, blocks.size(), [&](std::size_t b) {
    for (std::size_t p = b * block; p < std::min((b + 1) * block, cutter.place_count()); ++p)
      search.at_place(static_cast<std::int32_t>(p), beyond_mm, blocks[b]);
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

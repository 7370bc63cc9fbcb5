#include "sim/machining/stock.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "geometry/check.hpp"

namespace volute::sim {
namespace {

using Box3 = Eigen::AlignedBox3d;

/// A tool's place with the pose whose move it belongs to and the box about it.
struct CuttingPlace {
  StandingCutter stand;
  std::size_t from = 0, pose = 0;  // of a move; `from` is the pose where it began
  Box3 box;
};

void extend_by_disc(Box3& box, const Vec3& centre, const Vec3& axis, double radius) {
  const Vec3 reach = radius * (Vec3::Ones() - axis.cwiseProduct(axis)).cwiseMax(0.0).cwiseSqrt();
  box.extend(Vec3(centre - reach));
  box.extend(Vec3(centre + reach));
}

Box3 box_of(const CutterProfile& profile, const kinematics::Cutter& cutter, const StandingCutter& stand) {
  Box3 box;
  const bool ball =
      cutter.shape == kinematics::CutterShape::ball || cutter.shape == kinematics::CutterShape::taper_ball;
  if (ball) {
    const Vec3 centre = stand.tip_mm + cutter.radius_mm * stand.axis, reach = Vec3::Constant(cutter.radius_mm);
    box.extend(Vec3(centre - reach));
    box.extend(Vec3(centre + reach));
  } else {
    extend_by_disc(box, stand.tip_mm, stand.axis, profile.greatest_radius_mm());
  }
  extend_by_disc(box, stand.tip_mm + profile.length_mm() * stand.axis, stand.axis, profile.greatest_radius_mm());
  return box;
}

/// Spacing of places for a greatest cusp. A sharp tilted corner leaves steps, not round cusps: at most half the spacing
/// high.
double place_spacing(const CutterProfile& profile, const kinematics::Cutter& cutter, double tolerance_mm) {
  if (cutter.shape == kinematics::CutterShape::flat) return 2.0 * tolerance_mm;
  return std::sqrt(8.0 * profile.corner_radius_mm() * tolerance_mm);
}

/// How far the farthest point of the cutter's axis moves between two poses.
double apart(const CutterProfile& profile, const kinematics::ToolPose& a, const kinematics::ToolPose& b) {
  const Vec3 shift = b.tip_P_mm - a.tip_P_mm;
  return std::max(shift.norm(), (shift + profile.length_mm() * (b.axis_P - a.axis_P)).norm());
}

/// Whether the poses between two others lie within a distance of the straight move between those.
bool straight(const CutterProfile& profile, std::span<const SweptPose> poses, std::size_t from, std::size_t to,
              double tolerance_mm) {
  const auto &a = poses[from].pose, &b = poses[to].pose;
  const Vec3 along = b.tip_P_mm - a.tip_P_mm;
  const double length_sq = along.squaredNorm();
  for (std::size_t i = from + 1; i < to; ++i) {
    const auto& p = poses[i].pose;
    const double s = length_sq > 0.0 ? std::clamp((p.tip_P_mm - a.tip_P_mm).dot(along) / length_sq, 0.0, 1.0) : 0.0;
    const kinematics::ToolPose at{a.tip_P_mm + s * along, ((1.0 - s) * a.axis_P + s * b.axis_P).normalized()};
    if (apart(profile, at, p) > tolerance_mm) return false;
  }
  return true;
}

/// Poses that a cusp of the tolerance does not need are passed over (a quarter of the tolerance goes to their chord),
/// and long moves are filled (the other three quarters).
std::vector<CuttingPlace> places(const kinematics::Cutter& cutter, const CutterProfile& profile,
                                 std::span<const SweptPose> poses, double tolerance_mm) {
  const double cusp_mm = 0.75 * tolerance_mm, chord_mm = 0.25 * tolerance_mm;
  const double spacing = place_spacing(profile, cutter, cusp_mm);
  std::vector<CuttingPlace> out;
  const auto add = [&](const StandingCutter& stand, std::size_t from, std::size_t pose) {
    out.push_back({stand, from, pose, box_of(profile, cutter, stand)});
  };
  if (!poses.empty()) add({poses[0].pose.tip_P_mm, poses[0].pose.axis_P}, 0, 0);
  for (std::size_t from = 0, to = 1; to < poses.size(); from = to, ++to) {
    while (to + 1 < poses.size() && poses[to].rapid == poses[to + 1].rapid &&
           apart(profile, poses[from].pose, poses[to + 1].pose) <= spacing &&
           straight(profile, poses, from, to + 1, chord_mm)) {
      ++to;
    }
    const auto &a = poses[from].pose, &b = poses[to].pose;
    // An upright flat end that moves along its own face leaves round cusps only.
    const bool level = std::abs((b.tip_P_mm - a.tip_P_mm).dot(b.axis_P)) < 1e-9 && (b.axis_P - a.axis_P).norm() < 1e-12;
    const double step = level ? std::sqrt(8.0 * profile.greatest_radius_mm() * cusp_mm) : spacing;
    const int parts = static_cast<int>(std::ceil(apart(profile, a, b) / step));
    for (int k = 1; k < parts; ++k) {
      const double s = static_cast<double>(k) / parts;
      add({a.tip_P_mm + s * (b.tip_P_mm - a.tip_P_mm), ((1.0 - s) * a.axis_P + s * b.axis_P).normalized()}, from, to);
    }
    add({b.tip_P_mm, b.axis_P}, from, to);
  }
  return out;
}

/// What a move over several poses removed stands with its last pose: here each of them gets its share by how far it
/// moves.
void share_among_poses(const CutterProfile& profile, std::span<const SweptPose> poses,
                       const std::vector<CuttingPlace>& all, std::vector<double>& removed) {
  for (std::size_t k = 0; k < all.size(); ++k) {
    const std::size_t from = all[k].from, to = all[k].pose;
    if (to < from + 2 || removed[to] <= 0.0 || (k + 1 < all.size() && all[k + 1].pose == to)) continue;
    double way = 0.0;
    for (std::size_t i = from + 1; i <= to; ++i) way += apart(profile, poses[i - 1].pose, poses[i].pose);
    const double volume = removed[to];
    for (std::size_t i = from + 1; i <= to && way > 0.0; ++i)
      removed[i] = volume * apart(profile, poses[i - 1].pose, poses[i].pose) / way;
  }
}

/// Columns of one row that a tool can reach: within its greatest radius of its axis, both seen along the rays.
struct Columns {
  int begin, end;
};
Columns columns_of(const DexelGrid& grid, int row, const DexelGrid::Range& range, const StandingCutter& stand,
                   const CutterProfile& profile) {
  const int u = (grid.axis() + 1) % 3, v = (grid.axis() + 2) % 3;
  const Vec3 top = stand.tip_mm + profile.length_mm() * stand.axis;
  const double at = grid.node(0, row)[v], radius = profile.greatest_radius_mm();
  const double from = stand.tip_mm[v] - at, rise = top[v] - stand.tip_mm[v];
  // The stretch of the axis whose second coordinate is within the radius of the row's, and how near it comes.
  double s0 = 0.0, s1 = 1.0;
  if (std::abs(rise) > 1e-12) {
    s0 = std::clamp((-from - radius) / rise, 0.0, 1.0);
    s1 = std::clamp((-from + radius) / rise, 0.0, 1.0);
  }
  const double d0 = from + s0 * rise, d1 = from + s1 * rise;
  const double near = d0 * d1 <= 0.0 ? 0.0 : std::min(std::abs(d0), std::abs(d1));
  if (near > radius) return {0, 0};
  const double half = std::sqrt(radius * radius - near * near);
  const double u0 = stand.tip_mm[u] + s0 * (top[u] - stand.tip_mm[u]),
               u1 = stand.tip_mm[u] + s1 * (top[u] - stand.tip_mm[u]);
  const double origin = grid.node(0, row)[u], step = grid.grid_mm();
  const int begin = static_cast<int>(std::ceil((std::min(u0, u1) - half - origin) / step - 1e-9));
  const int end = static_cast<int>(std::floor((std::max(u0, u1) + half - origin) / step + 1e-9)) + 1;
  return {std::max(begin, range.column_begin), std::min(end, range.column_end)};
}

/// Cuts one row of a grid at every place; returns the length removed per place.
void cut_row(DexelGrid& grid, int row, const CutterProfile& profile, const std::vector<CuttingPlace>& where,
             const std::vector<DexelGrid::Range>& ranges, const std::vector<LineSpans>& spans,
             std::vector<double>& removed) {
  const int axis = grid.axis();
  for (std::size_t i = 0; i < where.size(); ++i) {
    const auto& range = ranges[i];
    if (row < range.row_begin || row >= range.row_end) continue;
    const double low = where[i].box.min()[axis], high = where[i].box.max()[axis];
    double sum = 0.0;
    const Columns columns = columns_of(grid, row, range, where[i].stand, profile);
    for (int column = columns.begin; column < columns.end; ++column) {
      if (!grid.reaches(column, row, low, high)) continue;
      if (const auto span = spans[i].of(grid.node(column, row))) sum += grid.remove(column, row, *span);
    }
    removed[i] += sum;
  }
}

}  // namespace

Stock::Stock(const Vec3& low_mm, const std::array<int, 3>& nodes, double grid_mm)
    : low_mm_(low_mm),
      box_mm_(low_mm, Vec3(low_mm + grid_mm * Vec3(nodes[0], nodes[1], nodes[2]))),
      nodes_(nodes),
      grid_mm_(grid_mm) {
  for (int axis = 0; axis < 3; ++axis) grids_.emplace_back(axis, low_mm, nodes, grid_mm);
}

Stock Stock::box(const Vec3& low_mm, const Vec3& high_mm, double grid_mm) {
  VOLUTE_CHECK(grid_mm > 0.0 && (high_mm - low_mm).minCoeff() > 0.0, grid_mm, low_mm.transpose(), high_mm.transpose());
  const Vec3 size = high_mm - low_mm;
  std::array<int, 3> nodes{};
  for (int k = 0; k < 3; ++k)
    nodes[static_cast<std::size_t>(k)] = std::max(1, static_cast<int>(std::lround(size[k] / grid_mm)));
  Stock stock(low_mm, nodes, grid_mm);
  for (DexelGrid& grid : stock.grids_) {
    const std::vector<Span> whole{{low_mm[grid.axis()], high_mm[grid.axis()]}};
    for (int row = 0; row < grid.rows(); ++row) {
      for (int column = 0; column < grid.columns(); ++column) grid.set(column, row, whole);
    }
  }
  return stock;
}

double Stock::volume_mm3() const {
  double sum = 0.0;
  for (const DexelGrid& grid : grids_) sum += grid.length_mm();
  return sum * grid_mm_ * grid_mm_ / 3.0;
}

std::vector<double> Stock::cut(const kinematics::Cutter& cutter, std::span<const SweptPose> poses,
                               double tolerance_mm) {
  VOLUTE_CHECK(tolerance_mm > 0.0, tolerance_mm);
  const CutterProfile profile(cutter);
  const std::vector<CuttingPlace> all = places(cutter, profile, poses, tolerance_mm);
  std::vector<double> removed(poses.size(), 0.0);
  constexpr std::size_t batch = 1024;  // so many places at a time keep a row's material in the cache
  for (std::size_t begin = 0; begin < all.size(); begin += batch) {
    const std::vector<CuttingPlace> where(
        all.begin() + static_cast<std::ptrdiff_t>(begin),
        all.begin() + static_cast<std::ptrdiff_t>(std::min(all.size(), begin + batch)));
    for (DexelGrid& grid : grids_) {
      std::vector<DexelGrid::Range> ranges;
      std::vector<LineSpans> spans;
      int row_begin = grid.rows(), row_end = 0;
      for (const auto& place : where) {
        ranges.push_back(grid.range(place.box));
        spans.emplace_back(cutter, profile, place.stand, grid.direction());
        row_begin = std::min(row_begin, ranges.back().row_begin);
        row_end = std::max(row_end, ranges.back().row_end);
      }
      if (row_begin >= row_end) continue;
      std::vector<std::vector<double>> by_row(static_cast<std::size_t>(row_end - row_begin));
      tbb::parallel_for(row_begin, row_end, [&](int row) {
        auto& sums = by_row[static_cast<std::size_t>(row - row_begin)];
        sums.assign(where.size(), 0.0);
        cut_row(grid, row, profile, where, ranges, spans, sums);
      });
      for (const auto& sums : by_row) {  // in the order of rows, whoever cut them
        for (std::size_t i = 0; i < where.size(); ++i) removed[where[i].pose] += sums[i];
      }
    }
  }
  for (double& volume : removed) volume *= grid_mm_ * grid_mm_ / 3.0;
  share_among_poses(profile, poses, all, removed);
  return removed;
}

template <class Visit>
void Stock::visit_inside(const kinematics::ConeSegment& segment, const kinematics::ToolPose& pose,
                         Visit&& visit) const {
  const StandingCutter stand{pose.tip_P_mm, pose.axis_P};
  const Box3 box = box_of_cone(segment, pose);
  if (!box.intersects(box_mm_)) return;
  for (const DexelGrid& grid : grids_) {
    const LineSpans spans(segment, stand, grid.direction());
    const auto range = grid.range(box);
    for (int row = range.row_begin; row < range.row_end; ++row) {
      for (int column = range.column_begin; column < range.column_end; ++column) {
        if (!grid.reaches(column, row, box.min()[grid.axis()], box.max()[grid.axis()])) continue;
        const auto span = spans.of(grid.node(column, row));
        if (span && !visit(grid, column, row, *span)) return;
      }
    }
  }
}

double Stock::overlap_mm3(const kinematics::ConeSegment& segment, const kinematics::ToolPose& pose) const {
  double sum = 0.0;
  visit_inside(segment, pose, [&](const DexelGrid& grid, int column, int row, const Span& span) {
    sum += grid.overlap(column, row, span);
    return true;
  });
  return sum * grid_mm_ * grid_mm_ / 3.0;
}

bool Stock::touches(const kinematics::ConeSegment& segment, const kinematics::ToolPose& pose) const {
  bool found = false;
  visit_inside(segment, pose, [&](const DexelGrid& grid, int column, int row, const Span& span) {
    found = grid.overlap(column, row, span) > 0.0;
    return !found;
  });
  return found;
}

Eigen::AlignedBox3d box_of_cone(const kinematics::ConeSegment& segment, const kinematics::ToolPose& pose) {
  Box3 box;
  extend_by_disc(box, pose.tip_P_mm + segment.z_mm * pose.axis_P, pose.axis_P, segment.bottom_radius_mm);
  extend_by_disc(box, pose.tip_P_mm + (segment.z_mm + segment.length_mm) * pose.axis_P, pose.axis_P,
                 segment.top_radius_mm);
  return box;
}

}  // namespace volute::sim

#include "sim/machining/cut_measure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace volute::sim {
namespace {

/// What stands near a cell, for lines along its normal up to a height.
void near_cell(const SweptCutter& cutter, const Cell& cell, const Vec3& normal, double height_mm,
               SweptCutter::Near& near) {
  const Vec3 middle = cell.centroid();
  const double size = std::max({(cell.a - middle).norm(), (cell.b - middle).norm(), (cell.c - middle).norm()});
  cutter.near(middle, size, normal, height_mm, near);
}

void measure_patch(const SweptCutter& cutter, const SurfaceSamples& samples, const SurfaceSamples::Patch& patch,
                   const SearchHeights& heights, SweptCutter::Near& near, Deviations& out) {
  const Cell cell = samples.patch_cell(patch);
  const Vec3& normal = samples.normal(patch.triangle);
  bool missing = false;
  const std::int32_t cells = patch.cell_cuts * patch.cell_cuts;
  const auto measure = [&](double height_mm, bool only_missing) {
    near_cell(cutter, cell, normal, height_mm, near);
    for (std::int32_t k = 0; k < cells; ++k) {
      const auto sample = static_cast<std::size_t>(patch.first_sample + k);
      if (only_missing && out.pose[sample] >= 0) continue;
      const auto entry = cutter.entry(child_cell(cell, patch.cell_cuts, k).centroid(), normal, height_mm, near);
      if (!entry) {
        missing = true;
        continue;
      }
      out.height_mm[sample] = entry->height_mm;
      out.pose[sample] = entry->pose;
    }
  };
  measure(heights.near_height_mm, false);
  if (missing && heights.search_height_mm > heights.near_height_mm) measure(heights.search_height_mm, true);
}

/// A height that can be compared: where nothing came near, material stands higher than anything measured.
double comparable(const std::optional<SweptEntry>& entry) {
  return entry ? entry->height_mm : std::numeric_limits<double>::infinity();
}

/// Points beside the cell would lie beside the surface, where the cutter may well go deeper.
bool holds(const Cell& cell, const Vec3& normal, const Vec3& point) {
  constexpr double slack = -1e-12;
  const auto side = [&](const Vec3& p, const Vec3& q) { return (q - p).cross(point - p).dot(normal); };
  return side(cell.a, cell.b) >= slack && side(cell.b, cell.c) >= slack && side(cell.c, cell.a) >= slack;
}

/// The entry of one line: first below the height where most have theirs, then up to the height that is searched.
class TwoSteps {
 public:
  TwoSteps(const SweptCutter& cutter, const Cell& cell, const Vec3& normal, const SearchHeights& heights)
      : cutter_(cutter), cell_(cell), normal_(normal), heights_(heights) {
    near_cell(cutter, cell, normal, heights.near_height_mm, low_);
  }
  /// Nothing above `limit_mm` matters, nor which of those as low as `enough_mm` is found.
  std::optional<SweptEntry> entry(const Vec3& point, double limit_mm, double enough_mm) {
    const double low = std::min(limit_mm, heights_.near_height_mm);
    if (auto found = cutter_.entry(point, normal_, low, low_, enough_mm); found || limit_mm <= low) return found;
    if (!high_) near_cell(cutter_, cell_, normal_, heights_.search_height_mm, high_.emplace());
    return cutter_.entry(point, normal_, heights_.search_height_mm, *high_, enough_mm);
  }

 private:
  const SweptCutter& cutter_;
  const Cell& cell_;
  const Vec3& normal_;
  const SearchHeights& heights_;
  SweptCutter::Near low_;
  std::optional<SweptCutter::Near> high_;
};

Extreme zoom_cell(const SweptCutter& cutter, const Cell& whole, const Vec3& normal, const SearchHeights& heights,
                  Sought sought) {
  constexpr int levels = 3, cuts = 8;
  Cell cell = whole;
  TwoSteps lines(cutter, whole, normal, heights);
  const double limit_mm = sought == Sought::highest ? heights.search_height_mm : 0.0;
  Extreme best{
      sought == Sought::highest ? -std::numeric_limits<double>::infinity() : std::numeric_limits<double>::infinity(),
      -1, cell.centroid()};
  const auto take = [&](const Vec3& point) {
    if (!holds(whole, normal, point)) return;
    // Of the highest only what stands above the best so far is wanted exactly.
    const auto entry = lines.entry(
        point, limit_mm, sought == Sought::highest ? best.height_mm : -std::numeric_limits<double>::infinity());
    const double height = comparable(entry);
    const bool better = sought == Sought::highest ? (entry && height > best.height_mm) : height < best.height_mm;
    if (better) best = {height, entry->pose, point};
  };
  take(whole.centroid());  // the sample itself
  for (int level = 0; level < levels; ++level) {
    for (const Vec3& corner : {cell.a, cell.b, cell.c}) take(corner);
    for (int k = 0; k < cuts * cuts; ++k) take(child_cell(cell, cuts, k).centroid());
    // A quarter of the cell about the best point, so that an extreme between two children stays inside.
    const Vec3 shift = best.point_mm - 0.25 * cell.centroid();
    cell = {0.25 * cell.a + shift, 0.25 * cell.b + shift, 0.25 * cell.c + shift};
  }
  return best;
}

/// The cell of one sample.
Cell sample_cell(const SurfaceSamples& samples, std::int64_t sample) {
  const auto& patch = samples.patch_of(sample);
  return child_cell(samples.patch_cell(patch), patch.cell_cuts, static_cast<int>(sample - patch.first_sample));
}

}  // namespace

Deviations measure_samples(const SweptCutter& cutter, const SurfaceSamples& samples, const SearchHeights& heights) {
  Deviations out;
  out.height_mm.assign(static_cast<std::size_t>(samples.count()), std::numeric_limits<double>::quiet_NaN());
  out.pose.assign(static_cast<std::size_t>(samples.count()), -1);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, samples.patches().size()), [&](const auto& range) {
    SweptCutter::Near near;
    for (std::size_t i = range.begin(); i != range.end(); ++i) {
      measure_patch(cutter, samples, samples.patches()[i], heights, near, out);
    }
  });
  return out;
}

std::vector<double> worst_about_vertices(const geometry::TriangleMesh& mesh, const SurfaceSamples& samples,
                                         const Deviations& deviations) {
  const auto worse = [](double a, double b) {
    if (std::isnan(a) || std::isnan(b)) return std::isnan(a);
    return std::abs(a) != std::abs(b) ? std::abs(a) > std::abs(b) : a > b;
  };
  std::vector<double> of_triangle(mesh.triangles.size(), 0.0);
  for (const auto& patch : samples.patches()) {
    double& worst = of_triangle[static_cast<std::size_t>(patch.triangle)];
    const auto first = deviations.height_mm.begin() + patch.first_sample;
    std::for_each(first, first + static_cast<std::ptrdiff_t>(patch.cell_cuts) * patch.cell_cuts, [&](double height) {
      if (worse(height, worst)) worst = height;
    });
  }
  std::vector<double> out(mesh.vertices_mm.size(), 0.0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (const geometry::Index v : mesh.triangles[t])
      if (worse(of_triangle[t], out[static_cast<std::size_t>(v)])) out[static_cast<std::size_t>(v)] = of_triangle[t];
  return out;
}

std::vector<Extreme> zoom(const SweptCutter& cutter, const SurfaceSamples& samples,
                          const std::vector<std::int64_t>& where, const SearchHeights& heights, Sought sought) {
  std::vector<Extreme> out(where.size());
  tbb::parallel_for(std::size_t{0}, where.size(), [&](std::size_t i) {
    const auto& patch = samples.patch_of(where[i]);
    out[i] = zoom_cell(cutter, sample_cell(samples, where[i]), samples.normal(patch.triangle), heights, sought);
  });
  return out;
}

}  // namespace volute::sim

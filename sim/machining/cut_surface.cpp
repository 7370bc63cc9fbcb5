#include "sim/machining/cut_surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "geometry/check.hpp"
#include "geometry/mesh_measure.hpp"
#include "geometry/number_text.hpp"
#include "sim/machining/cut_measure.hpp"
#include "sim/machining/notch_search.hpp"

namespace volute::sim {
namespace {

constexpr std::size_t zoom_high_max = 128, zoom_deep_max = 512;
constexpr std::size_t gouge_findings_max = 50;

/// A tenth of the interval that leaves a scallop of the uncut limit on a plane, and close enough to feel half the gouge
/// limit anywhere in the footprint of a gouge as deep as the limit. Four samples at least make up the area that may
/// stay uncut: one that stands for more would decide alone.
double spacing_mm(const kinematics::Cutter& cutter, const CutSurfaceOptions& options, double area_mm2) {
  double spacing = options.sample_spacing_mm;
  if (spacing <= 0.0) {
    const double r = cutter.radius_mm, h = std::min(options.uncut_limit_mm, r);
    spacing = std::min(0.1 * 2.0 * std::sqrt(2.0 * r * h - h * h), std::sqrt(r * options.gouge_limit_mm));
    if (options.uncut_area_limit_mm2 > 0.0) spacing = std::min(spacing, std::sqrt(0.25 * options.uncut_area_limit_mm2));
  }
  return std::max(spacing, std::sqrt(area_mm2 / (0.4 * static_cast<double>(options.samples_max))));
}

/// The `count` first samples in the order `before`; ties by number.
template <class Before>
std::vector<std::int64_t> first_samples(std::vector<std::int64_t> samples, std::size_t count, Before before) {
  const auto order = [&](std::int64_t a, std::int64_t b) { return before(a, b) || (!before(b, a) && a < b); };
  count = std::min(count, samples.size());
  std::partial_sort(samples.begin(), samples.begin() + static_cast<std::ptrdiff_t>(count), samples.end(), order);
  samples.resize(count);
  return samples;
}

struct Measurement {
  const SweptCutter& cutter;
  const SurfaceSamples& samples;
  const Deviations& deviations;
  SearchHeights heights;
  const CutSurfaceOptions& options;

  [[nodiscard]] double height(std::int64_t sample) const {
    return deviations.height_mm[static_cast<std::size_t>(sample)];
  }
  [[nodiscard]] bool found(std::int64_t sample) const { return deviations.pose[static_cast<std::size_t>(sample)] >= 0; }

  template <class Wanted>
  [[nodiscard]] std::vector<std::int64_t> where(Wanted wanted) const {
    std::vector<std::int64_t> out;
    for (std::int64_t s = 0; s < samples.count(); ++s) {
      if (found(s) && wanted(height(s))) out.push_back(s);
    }
    return out;
  }
  [[nodiscard]] std::vector<Extreme> highest() const;
  [[nodiscard]] std::vector<Extreme> deepest(const SurfaceFacets& facets) const;
};

std::vector<Extreme> Measurement::highest() const {
  double top = 0.0;
  for (std::int64_t s = 0; s < samples.count(); ++s) {
    if (found(s)) top = std::max(top, height(s));
  }
  const auto cells = first_samples(where([&](double h) { return h > 0.0 && h >= 0.5 * top; }), zoom_high_max,
                                   [&](auto a, auto b) { return height(a) > height(b); });
  return zoom(cutter, samples, cells, heights, Sought::highest);
}

std::vector<Extreme> Measurement::deepest(const SurfaceFacets& facets) const {
  // The spacing lets a gouge of the limit show at half its depth at least in one sample; less deep ones only move
  // gouge_max.
  const auto cells = first_samples(where([&](double h) { return h < -1e-7; }), zoom_deep_max,
                                   [&](auto a, auto b) { return height(a) < height(b); });
  std::vector<Extreme> found = zoom(cutter, samples, cells, heights, Sought::deepest);
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (found[i].height_mm >= 0.0) continue;
    const Vec3& normal = samples.normal(samples.patch_of(cells[i]).triangle);
    found[i].height_mm = -facets.buried_mm(found[i].point_mm, normal, -found[i].height_mm);
  }
  return found;
}

void add_areas(const Measurement& m, CutSurfaceReport& report) {
  double sum = 0.0, found_area = 0.0;
  for (const auto& patch : m.samples.patches()) {
    const double area = m.samples.sample_area_mm2(patch);
    for (std::int64_t k = 0; k < static_cast<std::int64_t>(patch.cell_cuts) * patch.cell_cuts; ++k) {
      const std::int64_t s = patch.first_sample + k;
      report.area_mm2 += area;
      if (!m.found(s) || m.height(s) > m.options.uncut_limit_mm) report.uncut_area_mm2 += area;
      if (!m.found(s)) continue;
      sum += area * m.height(s);
      found_area += area;
    }
  }
  if (found_area > 0.0) report.deviation_mean_mm = sum / found_area;
  report.uncut = report.uncut_area_mm2 > m.options.uncut_area_limit_mm2;
}

void add_histogram(const Measurement& m, CutSurfaceReport& report) {
  constexpr int bins = 300;
  report.histogram_step_mm = m.options.uncut_limit_mm / 100.0;
  report.histogram_min_mm = -m.options.uncut_limit_mm;
  report.histogram.assign(bins, 0);
  std::vector<double> heights;
  for (std::int64_t s = 0; s < m.samples.count(); ++s) {
    if (!m.found(s)) continue;
    heights.push_back(m.height(s));
    const double bin = std::floor((m.height(s) - report.histogram_min_mm) / report.histogram_step_mm);
    ++report.histogram[static_cast<std::size_t>(std::clamp(bin, 0.0, static_cast<double>(bins - 1)))];
  }
  if (heights.empty()) return;
  const auto place = heights.begin() + static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(heights.size() - 1));
  std::nth_element(heights.begin(), place, heights.end());
  report.scallop_p99_mm = std::max(0.0, *place);
}

std::string point_text(const Vec3& p) {
  using geometry::fixed_text;
  return "(" + fixed_text(p.x(), 3) + " " + fixed_text(p.y(), 3) + " " + fixed_text(p.z(), 3) + ")";
}

/// One finding for each place that is deeper than its neighbourhood of a cutter radius.
void add_gouges(std::vector<Extreme> gouges, const std::vector<SweptPose>& poses, double radius_mm, double limit_mm,
                CutSurfaceReport& report) {
  std::stable_sort(gouges.begin(), gouges.end(),
                   [](const auto& a, const auto& b) { return a.height_mm < b.height_mm; });
  std::vector<Vec3> told;
  for (const Extreme& gouge : gouges) {
    report.gouge_max_mm = std::max(report.gouge_max_mm, -gouge.height_mm);
    if (-gouge.height_mm <= limit_mm || told.size() >= gouge_findings_max) continue;
    const bool known =
        std::any_of(told.begin(), told.end(), [&](const Vec3& p) { return (p - gouge.point_mm).norm() < radius_mm; });
    if (known) continue;
    told.push_back(gouge.point_mm);
    const SweptPose& pose = poses[static_cast<std::size_t>(gouge.pose)];
    Finding finding{"gouge", pose.line, pose.time_s, "cutter-part", -gouge.height_mm, limit_mm, ""};
    finding.text = "line " + std::to_string(pose.line) + ": the cutter goes " +
                   geometry::short_text(-gouge.height_mm, 4) + " mm below the surface at " +
                   point_text(gouge.point_mm) + " of the part; at most " + geometry::short_text(limit_mm, 4) +
                   " mm is allowed";
    report.findings.push_back(std::move(finding));
  }
}

void add_uncut(const std::vector<Extreme>& highest, const std::vector<SweptPose>& poses,
               const CutSurfaceOptions& options, CutSurfaceReport& report) {
  const Extreme* worst = nullptr;
  for (const Extreme& place : highest) {
    report.scallop_max_mm = std::max(report.scallop_max_mm, place.height_mm);
    if (worst == nullptr || place.height_mm > worst->height_mm) worst = &place;
  }
  if (!report.uncut) return;
  Finding finding{"uncut", 0, 0.0, "part", report.uncut_area_mm2, options.uncut_area_limit_mm2, ""};
  finding.text = geometry::short_text(report.uncut_area_mm2, 4) + " mm2 of " +
                 geometry::short_text(report.area_mm2, 6) + " mm2 stand more than " +
                 geometry::short_text(options.uncut_limit_mm, 4) + " mm above the surface";
  if (worst != nullptr && worst->pose >= 0) {
    finding.line = poses[static_cast<std::size_t>(worst->pose)].line;
    finding.time_s = poses[static_cast<std::size_t>(worst->pose)].time_s;
    finding.text += "; the highest that the cutter came near is " + geometry::short_text(worst->height_mm, 4) +
                    " mm at " + point_text(worst->point_mm);
  }
  report.findings.push_back(std::move(finding));
}

}  // namespace

CutSurfaceReport measure_cut_surface(const geometry::TriangleMesh& surface, const kinematics::Cutter& cutter,
                                     const std::vector<SweptPose>& poses, const CutSurfaceOptions& options) {
  VOLUTE_CHECK(options.uncut_limit_mm > 0.0 && options.gouge_limit_mm > 0.0, options.uncut_limit_mm,
               options.gouge_limit_mm);
  CutSurfaceReport report;
  report.sample_spacing_mm = spacing_mm(cutter, options, geometry::area_mm2(surface));
  const double search = options.search_height_mm > 0.0 ? options.search_height_mm : cutter.radius_mm;
  const SearchHeights heights{std::min(search, 1.5 * options.uncut_limit_mm), search};

  const SweptCutter swept(cutter, poses, options.sweep_tolerance_mm);
  const SurfaceSamples samples(surface, report.sample_spacing_mm,
                               std::max(4.0 * report.sample_spacing_mm, 0.25 * cutter.radius_mm));
  const Deviations deviations = measure_samples(swept, samples, heights);
  const Measurement measurement{swept, samples, deviations, heights, options};

  report.samples = samples.count();
  add_areas(measurement, report);
  add_histogram(measurement, report);
  const SurfaceFacets facets(surface);
  std::vector<Extreme> deepest = measurement.deepest(facets);
  const auto notches = deepest_notches(swept, facets, 0.1 * options.gouge_limit_mm, zoom_deep_max);
  deepest.insert(deepest.end(), notches.begin(), notches.end());
  add_gouges(std::move(deepest), poses, cutter.radius_mm, options.gouge_limit_mm, report);
  add_uncut(measurement.highest(), poses, options, report);
  report.vertex_deviation_mm = worst_about_vertices(surface, samples, deviations);
  return report;
}

}  // namespace volute::sim

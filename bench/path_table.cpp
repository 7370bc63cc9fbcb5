// The table of docs/paths.md: every strategy and method on every surface given, as Markdown on standard output.
//
//   path_table [--pictures DIR] [--only "STRATEGY, METHOD"] [--noise-mm N] [--edge-mm E] SURFACE,RADIUS_MM,SCALLOP_MM
//   ...
//
// RADIUS_MM 0: a ball to the surface's size (a 36th of the square root of its area, scallop a 15th of the radius, so
// that about 50 passes cover it). Surfaces that cannot be machined are named with the reason.
// --noise-mm: every vertex moved by normal noise of that standard deviation in each direction, seed 1.
// --edge-mm: edges halved until none is longer.
// Exit status: 0, or 2 when an argument cannot be read.
#include <cmath>
#include <ctime>
#include <filesystem>
#include <iostream>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "bench/path_drawing.hpp"
#include "geometry/mesh_io.hpp"
#include "geometry/mesh_measure.hpp"
#include "geometry/mesh_report.hpp"
#include "geometry/number_text.hpp"
#include "planner/path/cc_path.hpp"
#include "planner/path/even_resample.hpp"

namespace {

using volute::geometry::short_text;
using volute::planner::CcPathResult;
using volute::planner::Method;
using volute::planner::Strategy;

struct Row {
  Strategy strategy;
  Method method;
  std::string name;
};
const std::vector<Row> rows{{Strategy::spiral, Method::even, "spiral, even"},
                            {Strategy::spiral, Method::periodic, "spiral, periodic"},
                            {Strategy::spiral, Method::paper, "spiral, paper"},
                            {Strategy::contour_parallel, Method::periodic, "contour-parallel, periodic"},
                            {Strategy::contour_parallel, Method::paper, "contour-parallel, paper"},
                            {Strategy::contour_offset, Method::even, "contour-offset"},
                            {Strategy::projected_spiral, Method::even, "projected-spiral"},
                            {Strategy::iso_planar, Method::even, "iso-planar"}};

struct Job {
  std::filesystem::path file;
  double radius_mm = 0.0, scallop_mm = 0.0;
};

struct Arguments {
  std::string pictures, only;
  double noise_mm = 0.0;
  std::optional<double> edge_mm;
  std::vector<Job> jobs;
};

std::optional<Arguments> arguments_of(int count, char** words) {
  Arguments arguments;
  for (int i = 1; i < count; ++i) {
    const std::string word = words[i];
    if (word == "--pictures" && i + 1 < count) {
      arguments.pictures = words[++i];
    } else if (word == "--only" && i + 1 < count) {
      arguments.only = words[++i];
    } else if ((word == "--noise-mm" || word == "--edge-mm") && i + 1 < count) {
      const auto value = volute::geometry::parse_number(words[++i]);
      if (!value || !(*value > 0.0)) return std::nullopt;
      (word == "--noise-mm" ? arguments.noise_mm : arguments.edge_mm.emplace()) = *value;
    } else {
      const std::size_t second = word.rfind(','), first = second == 0 ? second : word.rfind(',', second - 1);
      if (second == std::string::npos || first == std::string::npos) return std::nullopt;
      const auto radius = volute::geometry::parse_number(word.substr(first + 1, second - first - 1)),
                 scallop = volute::geometry::parse_number(word.substr(second + 1));
      if (!radius || !scallop) return std::nullopt;
      arguments.jobs.push_back({word.substr(0, first), *radius, *scallop});
    }
  }
  return arguments;
}

std::string two(const std::optional<double>& value) {
  if (!value) return "";
  const double rounded = static_cast<double>(static_cast<long>(*value * 100.0 + 0.5)) / 100.0;
  std::string text = short_text(rounded);
  if (text.find('.') == std::string::npos) return text + ".00";
  if (text.size() - text.find('.') == 2) text += "0";
  return text;
}

std::string whole(const std::optional<double>& value) {
  return value ? short_text(static_cast<int>(*value + 0.5)) : "";
}

/// Length over that of a plane as large: area over the interval on flat ground.
double flat_bound_ratio(const CcPathResult& result, const Job& job) {
  const double interval_mm = volute::planner::path_interval_mm(job.radius_mm, job.scallop_mm, 0.0);
  return result.report.length_mm * interval_mm / result.surface.area_mm2;
}

/// One line of the table.
std::string line_of(const std::string& part, const std::string& name, const CcPathResult& result, const Job& job,
                    double cpu_s) {
  const auto& r = result.report;
  const bool replaced = name == "spiral, even" && r.method != "even";
  return "| " + part + " | " + name + (replaced ? " (" + r.method + " took its place)" : "") + " | " +
         two(r.length_ratio) + " | " + two(flat_bound_ratio(result, job)) + " | " + std::to_string(r.pieces) + " | " +
         std::to_string(r.rapid_traversals) + " | " + std::to_string(r.liftings) + " | " + std::to_string(r.linkings) +
         " | " + std::to_string(r.sharp_corners) + " (" + std::to_string(r.sharp_corners_60) + ") | " +
         two(r.scallop_ratio_p9999) + " / " + two(r.scallop_ratio_max) + " | " + two(r.scallop_area_above_percent) +
         " | " + two(r.interval_ratio_max) + " | " + whole(r.seam_kink_max_deg) + " | " + two(cpu_s) + " |";
}

volute::kinematics::Cutter ball(double radius_mm) {
  volute::kinematics::Cutter cutter;
  cutter.shape = volute::kinematics::CutterShape::ball;
  cutter.radius_mm = cutter.corner_radius_mm = radius_mm;
  return cutter;
}

void plan_row(const Row& row, const std::string& part, const std::string& shown, const Job& job,
              const volute::geometry::TriangleMesh& surface, const std::string& pictures) {
  volute::planner::PathOptions options;
  options.strategy = row.strategy;
  options.method = row.method;
  options.scallop_mm = job.scallop_mm;
  const std::clock_t start = std::clock();
  const auto result = volute::planner::plan_cc_path(surface, ball(job.radius_mm), options, {});
  const double cpu_s = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  if (!result) {
    std::cout << "| " << shown << " | " << row.name << " | none: " << result.error().message
              << " | | | | | | | | | | | |\n";
    return;
  }
  std::cout << line_of(shown, row.name, *result, job, cpu_s) << '\n' << std::flush;
  for (const std::string& note : result->report.notes) std::cerr << part << ", " << row.name << ": " << note << '\n';
  if (pictures.empty()) return;
  volute::bench::PathPicture picture{part + "-" + row.name, surface, ball(job.radius_mm), options, *result};
  for (char& c : picture.name)
    if (c == ',' || c == ' ') c = '-';
  while (picture.name.find("--") != std::string::npos) picture.name.erase(picture.name.find("--"), 1);
  if (!volute::bench::write_pictures(picture, pictures)) std::cerr << "cannot write into " << pictures << '\n';
}

/// The surface as the arguments want it: refined, noisy.
volute::geometry::Result<volute::geometry::TriangleMesh> changed(volute::geometry::TriangleMesh mesh,
                                                                 const Arguments& arguments) {
  if (arguments.edge_mm) {
    auto fine = volute::planner::finer(mesh, *arguments.edge_mm);
    if (!fine) return tl::unexpected(fine.error());
    mesh = std::move(fine->mesh);
  }
  if (arguments.noise_mm <= 0.0) return mesh;
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0.0, arguments.noise_mm);
  for (auto& vertex : mesh.vertices_mm)
    for (int k = 0; k < 3; ++k) vertex[k] += noise(random);
  return mesh;
}

void plan_part(Job job, const Arguments& arguments) {
  const std::string part = job.file.stem().string();
  const auto loaded = volute::geometry::load_mesh(job.file);
  if (!loaded) {
    std::cerr << loaded.error().message << '\n';
    return;
  }
  auto surface = volute::geometry::machinable_surface(*loaded);
  if (surface) surface = changed(std::move(*surface), arguments);
  if (!surface) {
    std::cout << "| " << part << " | none: " << surface.error().message << " | | | | | | | | | | | | |\n";
    return;
  }
  if (job.radius_mm == 0.0) {
    job.radius_mm = std::sqrt(volute::geometry::area_mm2(*surface)) / 36.0;
    job.scallop_mm = job.radius_mm / 15.0;
  }
  std::string shown = part + ", " + std::to_string(surface->triangles.size()) + " triangles, R" +
                      short_text(job.radius_mm, 3) + "/" + short_text(job.scallop_mm, 2);
  for (const Row& row : rows) {
    if (!arguments.only.empty() && row.name != arguments.only) continue;
    plan_row(row, part, shown, job, *surface, arguments.pictures);
    shown.clear();
  }
}

}  // namespace

int main(int count, char** words) {
  const auto arguments = arguments_of(count, words);
  if (!arguments || arguments->jobs.empty()) {
    std::cerr << "usage: path_table [--pictures DIR] [--only \"STRATEGY, METHOD\"] [--noise-mm N] [--edge-mm E] "
                 "SURFACE,RADIUS_MM,SCALLOP_MM ...\n";
    return 2;
  }
  std::cout << "| part | strategy, method | length / bound | length / flat | pieces | rapids | liftings | linkings | "
               "corners (> 60) | "
               "scallop 99.99 % / max | area above, % | interval max | seam kink, deg | CPU, s |\n"
               "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n";
  for (const Job& job : arguments->jobs) plan_part(job, *arguments);
  return 0;
}

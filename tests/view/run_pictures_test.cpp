// The pictures of a whole run: which are made, that each shows something, and that what they show follows the run.
#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "tests/view/example_run.hpp"
#include "view/axis_plots.hpp"
#include "view/pictures.hpp"

namespace volute::view {
namespace {

namespace fs = std::filesystem;

constexpr ExampleSize small{600, 200, 20};

RunView example_with_map() {
  RunView view = example_run(small);
  for (const geometry::Vec3& vertex : view.surface_P.vertices_mm)
    view.map_vertices.emplace_back(vertex.x(), vertex.y());
  view.map_triangles = view.surface_P.triangles;
  view.map_guide_lines = {{{-20, 0}, {20, 0}}};
  return view;
}

/// Share of the pixels that are not white.
double drawn_share(const Image& image) {
  std::size_t drawn = 0;
  for (std::size_t i = 0; i < image.bgra.size(); i += 4)
    drawn += image.bgra[i] < 250 || image.bgra[i + 1] < 250 || image.bgra[i + 2] < 250 ? 1 : 0;
  return static_cast<double>(drawn) / (static_cast<double>(image.bgra.size()) / 4.0);
}

std::size_t different_pixels(const Image& a, const Image& b) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.bgra.size(); i += 4)
    count += !std::equal(&a.bgra[i], &a.bgra[i] + 3, &b.bgra[i]) ? 1 : 0;
  return count;
}

TEST(RunPictures, AWholeRunHasThemAll) {
  const fs::path folder = fs::temp_directory_path() / "volute-run-pictures";
  fs::remove_all(folder);
  fs::create_directories(folder);
  const auto written = write_pictures(example_with_map(), folder);
  ASSERT_TRUE(written) << written.error().message;
  const std::set<std::string> names(written->begin(), written->end());
  for (const char* name : {"path.png", "path-feed.png", "path-limit.png", "path-tilt.png", "orientation.png", "map.png",
                           "machined.png", "machine.png", "machine-close.png", "rotary-axes.svg", "linear-axes.svg",
                           "feed.svg", "path.svg", "loads.svg", "deviation.svg"}) {
    EXPECT_TRUE(names.contains(name)) << name;
    EXPECT_GT(fs::file_size(folder / name), 2000U) << name;
  }
  fs::remove_all(folder);
}

TEST(RunPictures, AForeignProgramHasThoseOfItsRun) {
  RunView view = example_run(small);
  view.surface_P = {};
  view.tool_path = {};
  view.cut.reset();
  const fs::path folder = fs::temp_directory_path() / "volute-run-pictures-foreign";
  fs::create_directories(folder);
  const auto written = write_pictures(view, folder);
  ASSERT_TRUE(written) << written.error().message;
  const std::set<std::string> names(written->begin(), written->end());
  EXPECT_TRUE(names.contains("path-feed.png"));
  EXPECT_FALSE(names.contains("orientation.png"));
  EXPECT_FALSE(names.contains("machined.png"));
  fs::remove_all(folder);
}

TEST(RunPictures, TheMachineMovesWithTime) {
  const RunView view = example_run(small);
  const auto early = machine_picture(view, 1.0, true), late = machine_picture(view, 60.0, true),
             again = machine_picture(view, 60.0, true);
  ASSERT_TRUE(early && late && again);
  EXPECT_GT(drawn_share(*early), 0.05);
  EXPECT_GT(different_pixels(*early, *late), 20'000U);
  EXPECT_EQ(different_pixels(*late, *again), 0U);
}

TEST(RunPictures, ColourByLimitShowsTheOneSampleAtALimit) {
  RunView view = example_run(small);
  const auto with = coloured_path_picture(view, PathColour::limit);
  view.trace.samples[static_cast<std::size_t>(spike_sample(small))].limit = sim::Limit::programmed_feed;
  const auto without = coloured_path_picture(view, PathColour::limit);
  ASSERT_TRUE(with && without);
  EXPECT_GT(different_pixels(*with, *without), 20U);
}

TEST(RunPlots, OverThePathEndsAtItsLength) {
  const RunView view = example_run(small);
  double length_mm = 0.0;
  for (std::size_t i = 1; i < view.trace.poses_P.size(); ++i)
    length_mm += (view.trace.poses_P[i].tip_P_mm - view.trace.poses_P[i - 1].tip_P_mm).norm();
  const Plot plot = path_plot(view);
  for (const PlotPanel& panel : plot.panels)
    for (const PlotSeries& series : panel.series) EXPECT_NEAR(series.points.back().x(), length_mm, 1e-9);
  EXPECT_NEAR(plot.panels.at(1).series.at(0).points.at(static_cast<std::size_t>(spike_sample(small))).y(),
              spike_velocity_rad_s * 57.29577951308232, 1e-9);
}

TEST(RunPlots, SharesOfTheHistogramSumToAHundred) {
  const Plot plot = deviation_plot(example_run(small));
  double sum = 0.0;
  for (std::size_t i = 0; i < plot.panels.at(0).series.at(0).points.size(); i += 2)
    sum += plot.panels[0].series[0].points[i].y();
  EXPECT_NEAR(sum, 100.0, 1e-9);
}

}  // namespace
}  // namespace volute::view

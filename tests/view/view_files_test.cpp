#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/view/example_run.hpp"
#include "view/run_view.hpp"

namespace volute::view {
namespace {

namespace fs = std::filesystem;

fs::path scratch_folder(const char* name) {
  const fs::path folder = fs::temp_directory_path() / (std::string("volute-view-test-") + name);
  fs::remove_all(folder);
  fs::create_directories(folder);
  return folder;
}

RunView example_view() {
  RunView view;
  view.title = "plate on ac-head";
  view.surface_P = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0.5}}, {{0, 1, 2}}};
  view.obstacles_P = {view.surface_P};
  view.obstacle_names = {"post"};
  view.tool.holder = {{5, 10, 40, 30}};
  view.tool_path.points = {{{{1, 2, 3}, {0, 0.6, 0.8}}, kinematics::MoveKind::link, 4.5, {1, 1, 1}, {0, 0, 1}, 2.25}};
  sim::AxisSample sample;
  sample.time_s = 1.25;
  sample.position << 1, 2, 3, 0.5, -0.25;
  sample.velocity.setConstant(2);
  sample.acceleration.setConstant(3);
  sample.jerk.setConstant(4);
  sample.actual.setConstant(5);
  sample.line = 77;
  sample.limit = sim::Limit::corner;
  sample.limiting_axis = 4;
  sample.cutting = true;
  view.trace = {{sample}, {{{1, 2, 3}, {0, 0, 1}}}};
  using geometry::Angle;
  view.orientation = {Angle::degrees(10), Angle(), Angle::degrees(1), Angle::degrees(60), 1.5, 0.01, 1, {{0.25, -3.5}}};
  view.findings = {{"gouge", 12, 0.5, "cutter - part", 0.02, 0.01, "text"}};
  view.report_json = "{\"run\": 1}";
  view.program_name = "plate.nc";
  view.program_text = "G1 X1\n";
  view.map_vertices = {{0.5, 0.25}};
  view.map_guide_lines = {{{0, 0}, {1, 1}}};
  view.cut.emplace();
  view.cut->vertex_deviation_mm = {0.01, 0.02, -0.03};
  return view;
}

TEST(ViewFiles, WhatIsSavedComesBack) {
  const fs::path folder = scratch_folder("round-trip");
  const RunView view = example_view();
  ASSERT_TRUE(save_view(view, folder));
  const auto back = load_view(folder);
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_EQ(back->title, view.title);
  EXPECT_EQ(back->surface_P.vertices_mm, view.surface_P.vertices_mm);
  EXPECT_EQ(back->surface_P.triangles, view.surface_P.triangles);
  EXPECT_EQ(back->obstacle_names, view.obstacle_names);
  EXPECT_EQ(back->tool.holder.at(0).top_radius_mm, 10);
  EXPECT_EQ(back->tool_path.points.at(0).pose.axis_P, view.tool_path.points[0].pose.axis_P);
  EXPECT_EQ(back->tool_path.points.at(0).move, kinematics::MoveKind::link);
  EXPECT_EQ(back->tool_path.points.at(0).turn, 2.25);
  EXPECT_EQ(back->trace.samples.at(0).position, view.trace.samples[0].position);
  EXPECT_EQ(back->trace.samples.at(0).line, 77);
  EXPECT_EQ(back->trace.samples.at(0).limit, sim::Limit::corner);
  EXPECT_EQ(back->trace.samples.at(0).limiting_axis, 4);
  ASSERT_TRUE(back->orientation);
  EXPECT_EQ(back->orientation->tilt_max.radians(), view.orientation->tilt_max.radians());
  EXPECT_EQ(back->orientation->clearance_mm, 1.5);
  EXPECT_EQ(back->orientation->fixtures, 1u);
  EXPECT_EQ(back->orientation->rotaries_rad, view.orientation->rotaries_rad);
  EXPECT_EQ(back->findings.at(0).text, "text");
  EXPECT_EQ(back->cut->vertex_deviation_mm, view.cut->vertex_deviation_mm);
  EXPECT_EQ(back->map_guide_lines.at(0).at(1), view.map_guide_lines[0][1]);
  fs::remove_all(folder);
}

TEST(ViewFiles, HundredThousandBlocksStaySmall) {
  const fs::path folder = scratch_folder("size");
  ASSERT_TRUE(save_view(example_run({200'000, 100'000, 120}), folder));
  RecordProperty("bytes", std::to_string(fs::file_size(folder / "view.cbor.z")));
  EXPECT_LT(fs::file_size(folder / "view.cbor.z"), 15'000'000U);
  fs::remove_all(folder);
}

TEST(ViewFiles, FolderWithoutARunIsNamed) {
  const fs::path folder = scratch_folder("empty");
  const auto view = load_view(folder);
  ASSERT_FALSE(view);
  EXPECT_EQ(view.error().code, "view-missing");
  EXPECT_NE(view.error().message.find(folder.string()), std::string::npos);
  fs::remove_all(folder);
}

TEST(ViewFiles, DamagedFileIsRefused) {
  const fs::path folder = scratch_folder("damaged");
  ASSERT_TRUE(save_view(example_view(), folder));
  fs::resize_file(folder / "view.cbor.z", 100);
  const auto view = load_view(folder);
  ASSERT_FALSE(view);
  EXPECT_EQ(view.error().code, "view-damaged");
  fs::remove_all(folder);
}

}  // namespace
}  // namespace volute::view

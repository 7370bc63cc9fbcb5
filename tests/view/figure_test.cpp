// Sheets of panels, plots that compare, the page that compares: what the papers' figures are made of.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>

#include "geometry/file.hpp"
#include "geometry/mesh_measure.hpp"
#include "tests/view/example_run.hpp"
#include "view/comparison_html.hpp"
#include "view/figure_sheet.hpp"
#include "view/orientation_plot.hpp"
#include "view/pictures.hpp"
#include "view/solids.hpp"

namespace volute::view {
namespace {

namespace fs = std::filesystem;

Image plain_image(int width, int height, std::uint8_t grey) {
  Image image{width, height, {}};
  image.bgra.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4, grey);
  return image;
}

std::size_t dark_pixels(const Image& image, int top, int bottom) {
  std::size_t count = 0;
  for (int y = top; y < bottom; ++y)
    for (int x = 0; x < image.width; ++x)
      count += image.bgra[(static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                           static_cast<std::size_t>(x)) *
                          4] < 100
                   ? 1
                   : 0;
  return count;
}

TEST(FigureSheet, PanelsStandWholeAndCaptionsUnderThem) {
  const Image sheet = figure_sheet({{"(a) one", plain_image(200, 100, 8)}, {"", plain_image(200, 100, 16)}}, 2);
  EXPECT_GE(sheet.width, 400);
  std::size_t eights = 0, sixteens = 0;
  for (std::size_t i = 0; i < sheet.bgra.size(); i += 4) {
    eights += sheet.bgra[i] == 8 && sheet.bgra[i + 1] == 8 ? 1 : 0;
    sixteens += sheet.bgra[i] == 16 && sheet.bgra[i + 1] == 16 ? 1 : 0;
  }
  EXPECT_GE(eights, 20'000U);
  EXPECT_GE(sixteens, 20'000U);
  EXPECT_GT(dark_pixels(sheet, sheet.height - 40, sheet.height), 40U) << "the caption is written";
}

TEST(Image, RoundedShadesStayAndKeepTheEnds) {
  Image image{256, 1, {}};
  for (int value = 0; value < 256; ++value) image.bgra.insert(image.bgra.end(), 4, static_cast<std::uint8_t>(value));
  round_shades(image, 32);
  EXPECT_EQ(image.bgra.front(), 0);
  EXPECT_EQ(image.bgra.back(), 255);
  for (int value = 0; value < 256; ++value)
    EXPECT_NEAR(image.bgra[static_cast<std::size_t>(value) * 4], value, 4.2) << value;
  Image again = image;
  round_shades(again, 32);
  EXPECT_EQ(again.bgra, image.bgra);
}

TEST(FigureSheet, ThirdPanelBeginsARow) {
  const Image panel = plain_image(120, 90, 50);
  const Image sheet = figure_sheet({{"", panel}, {"", panel}, {"", panel}}, 2);
  EXPECT_LT(sheet.width, 3 * 120);
  EXPECT_GT(sheet.height, 2 * 90);
}

TEST(OrientationPlot, QuotientsOfAParabolaAreExact) {
  RotaryCurve curve{"test", {}, {}};
  for (const double s : {0.0, 0.5, 0.5, 1.7, 2.0, 4.0}) {  // one point twice
    curve.length_mm.push_back(s);
    curve.rotaries_rad.push_back({0.3 * s * s, 1.0});
  }
  const Plot plot = rotary_comparison_plot({curve}, 5.0, {"parabola", {"A", "C"}});
  ASSERT_EQ(plot.panels.size(), 6U);
  const auto& velocity = plot.panels[1].series.at(0).points;
  ASSERT_EQ(velocity.size(), 4U);
  for (const auto& point : velocity) EXPECT_NEAR(point.y(), 5.0 * 0.6 * point.x(), 1e-12);
  for (const auto& point : plot.panels[2].series.at(0).points) EXPECT_NEAR(point.y(), 25.0 * 0.6, 1e-11);
  for (const auto& point : plot.panels[4].series.at(0).points) EXPECT_NEAR(point.y(), 0.0, 1e-12);
  EXPECT_NE(plot.panels[1].y_label.find("A, rad/s"), std::string::npos);
}

TEST(Solids, CylinderHasItsArea) {
  const std::array<kinematics::ProfilePoint, 4> profile{{{-2.0, 0.0}, {-2.0, 3.0}, {5.0, 3.0}, {5.0, 0.0}}};
  const double area = 2.0 * std::numbers::pi * 3.0 * 7.0 + 2.0 * std::numbers::pi * 9.0;
  EXPECT_NEAR(geometry::area_mm2(revolution_mesh(profile, 400)) / area, 1.0, 1e-4);
}

RunView two_pieces() {
  RunView view;
  view.surface_P = {{{-50, -50, 0}, {50, -50, 0}, {50, 50, 0}, {-50, 50, 0}}, {{0, 1, 2}, {0, 2, 3}}};
  for (const double x : {-40.0, 40.0}) {
    kinematics::ToolPathPoint point;
    point.move = kinematics::MoveKind::rapid;
    view.tool_path.points.push_back(point);
    for (const double y : {-40.0, 40.0}) {
      point.move = kinematics::MoveKind::cut;
      point.contact_P_mm = {x, y, 0.0};
      view.tool_path.points.push_back(point);
    }
  }
  return view;
}

TEST(PathPicture, PiecesAreNotJoinedThroughTheAir) {
  RunView apart = two_pieces(), joined = two_pieces();
  joined.tool_path.points.erase(joined.tool_path.points.begin() + 3);  // the rapid between them
  const auto a = path_picture(apart, panel_style(400, 300)), b = path_picture(joined, panel_style(400, 300));
  ASSERT_TRUE(a && b);
  std::size_t different = 0;
  for (std::size_t i = 0; i < a->bgra.size(); i += 4) different += a->bgra[i] != b->bgra[i] ? 1 : 0;
  EXPECT_GT(different, 100U) << "a line leads from the end of one piece to the start of the next";
}

TEST(Comparison, TableHasARowARunAndNoRunSaysWhy) {
  const fs::path file = fs::temp_directory_path() / "volute-comparison-test.html";
  Comparison comparison{"plate <b>", {"rapids", "loss %"}, {}, "loss < 0"};
  comparison.runs.push_back(
      {"spiral", true, "Nothing wrong.", {"0", "-0.10"}, "spiral/report.html", {{"path", plain_image(8, 8, 9)}}});
  comparison.runs.push_back({"iso-planar", false, "cannot be cut so", {}, {}, {}});
  ASSERT_TRUE(write_comparison_html(comparison, file));
  const std::string page = *geometry::read_file(file);
  fs::remove(file);
  EXPECT_NE(page.find("1 of 2 passed"), std::string::npos);
  EXPECT_NE(page.find("plate &lt;b&gt;"), std::string::npos);
  EXPECT_NE(page.find("<td>0</td><td>-0.10</td>"), std::string::npos);
  EXPECT_NE(page.find("<td colspan=\"2\">cannot be cut so</td>"), std::string::npos);
  EXPECT_NE(page.find("<p>loss &lt; 0</p>"), std::string::npos);
  EXPECT_NE(page.find("href=\"spiral/report.html\""), std::string::npos);
  EXPECT_NE(page.find("src=\"data:image/png;base64,"), std::string::npos);
  EXPECT_EQ(page.find("http"), std::string::npos) << "it must need no network";
}

}  // namespace
}  // namespace volute::view

// The data that the page gets: what is packed comes back, and the same run gives the same bytes.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <random>

#include "geometry/file.hpp"
#include "geometry/mesh_measure.hpp"
#include "tests/view/example_run.hpp"
#include "view/coarse_mesh.hpp"
#include "view/packed_data.hpp"
#include "view/page_asset.hpp"
#include "view/report_data.hpp"

namespace volute::view {
namespace {

namespace fs = std::filesystem;

std::string page_of(const RunView& view, const char* name) {
  const fs::path file = fs::temp_directory_path() / (std::string("volute-page-test-") + name + ".html");
  EXPECT_TRUE(write_report_html(view, file));
  const auto text = geometry::read_file(file);
  fs::remove(file);
  return text ? *text : std::string();
}

/// An independent reader of one column, by the layout that packed_data.hpp states.
std::vector<std::int64_t> steps_of(const std::string& bytes, std::size_t column_start, std::size_t count, int order) {
  std::vector<std::int64_t> out(count);
  for (std::size_t i = 0; i < count; ++i) {
    std::uint32_t coded = 0;
    for (std::size_t plane = 4; plane-- > 0;)
      coded = coded * 256U + static_cast<std::uint8_t>(bytes[column_start + plane * count + i]);
    out[i] = coded % 2 == 0 ? static_cast<std::int64_t>(coded / 2) : -static_cast<std::int64_t>(coded / 2) - 1;
  }
  for (int pass = 0; pass < order; ++pass)
    for (std::size_t i = 1; i < count; ++i)
      out[i] = static_cast<std::int32_t>(static_cast<std::uint32_t>(out[i] + out[i - 1]));
  return out;
}

TEST(PackedData, ValuesComeBackWithinHalfAStep) {
  const unsigned seed = 20160607;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> value(-1e6, 1e6);
  std::vector<double> values(257);
  for (double& v : values) v = value(random);
  PackedData data;
  data.add("a", values, 0.01);
  const std::string bytes = data.bytes();
  const std::size_t header = static_cast<std::uint8_t>(bytes[0]) + 256U * static_cast<std::uint8_t>(bytes[1]);
  const std::size_t at = bytes.find("\"order\":") + 8;
  const auto steps = steps_of(bytes, 4 + header, values.size(), bytes[at] - '0');
  for (std::size_t i = 0; i < values.size(); ++i)
    EXPECT_NEAR(static_cast<double>(steps[i]) * 0.01, values[i], 0.005 + 1e-9) << "seed " << seed << " i " << i;
}

TEST(PackedData, ASteadyLineCostsAlmostNothing) {
  std::vector<double> line(10'000);
  for (std::size_t i = 0; i < line.size(); ++i) line[i] = 3.0 + 0.25 * static_cast<double>(i);
  PackedData data;
  data.add("line", line, 0.001);
  EXPECT_LT(zlib_bytes(data.bytes()).size(), 300U);
}

TEST(Zlib, ComesBack) {
  std::string text;
  for (int i = 0; i < 5000; ++i) text += std::to_string(i * i % 977);
  EXPECT_EQ(inflated_bytes(zlib_bytes(text)), text);
  EXPECT_EQ(inflated_bytes("no stream"), "");
}

TEST(Base64, VectorsOfRfc4648) {
  const std::vector<std::pair<std::string, std::string>> vectors{{"", ""},
                                                                 {"f", "Zg=="},
                                                                 {"fo", "Zm8="},
                                                                 {"foo", "Zm9v"},
                                                                 {"foob", "Zm9vYg=="},
                                                                 {"fooba", "Zm9vYmE="},
                                                                 {"foobar", "Zm9vYmFy"}};
  for (const auto& [plain, coded] : vectors) EXPECT_EQ(base64_text(plain), coded);
}

TEST(CoarseMesh, KeepsShapeAreaAndTheWorstValue) {
  const RunView view = example_run({100, 10, 80});
  const CoarseMesh coarse = coarse_mesh(view.surface_P, 8000);
  EXPECT_LE(coarse.mesh.triangles.size(), 8000U);
  EXPECT_GT(coarse.mesh.triangles.size(), 2000U);
  EXPECT_NEAR(geometry::area_mm2(coarse.mesh) / geometry::area_mm2(view.surface_P), 1.0, 0.05);
  std::vector<double> values(view.surface_P.vertices_mm.size(), 0.01);
  values[4321] = -0.5;
  const std::vector<double> kept = coarse_values(coarse, values);
  EXPECT_EQ(*std::min_element(kept.begin(), kept.end()), -0.5);
  EXPECT_EQ(coarse_mesh(view.surface_P, 1'000'000).mesh.triangles, view.surface_P.triangles);
}

TEST(PageAsset, IsTheBundle) {
  EXPECT_GT(page_script().size(), 100'000U);
  EXPECT_NE(page_style().find("#verdict"), std::string_view::npos);
  const auto bundle = geometry::read_file(VOLUTE_SOURCE_DIR "/view/page/dist/report.js");
  ASSERT_TRUE(bundle);
  EXPECT_TRUE(page_script() == *bundle) << "the program holds another bundle than view/page/dist";
}

TEST(Page, SameRunSameBytes) {
  const RunView view = example_run({});
  EXPECT_TRUE(page_of(view, "first") == page_of(view, "second"));
}

TEST(Page, NeedsNoNetworkAndSaysTheVerdictWithoutScripts) {
  const std::string page = page_of(example_run({}), "words");
  const std::string before_data = page.substr(0, page.find("<script"));
  EXPECT_EQ(page.find("<script src"), std::string::npos);
  EXPECT_EQ(page.find("<link rel=\"stylesheet"), std::string::npos);
  EXPECT_NE(before_data.find("REJECTED: 1 finding."), std::string::npos);
  EXPECT_NE(before_data.find("wavy disc &lt;example&gt;"), std::string::npos);
}

TEST(Page, TextOfTheRunCannotEndItsElement) {
  const std::string page = page_of(example_run({}), "escape");
  const std::size_t data = page.find("<script id=\"data-report\"");
  const std::size_t end = page.find("</script>", data);
  EXPECT_NE(page.substr(data, end - data).find("holder-post meet"), std::string::npos);
  EXPECT_EQ(page[end - 1], '}') << "the element ends where the JSON does";
}

TEST(Page, HundredThousandBlocksStayUnderFifteenMegabytes) {
  const std::string page = page_of(example_run({200'000, 100'000, 120}), "size");
  RecordProperty("bytes", std::to_string(page.size()));
  EXPECT_LT(page.size(), 15'000'000U);
}

TEST(Page, ForeignProgramWithoutPartOrMachineIsShownToo) {
  RunView view = example_run({});
  view.surface_P = {};
  view.profile.reset();
  view.tool_path = {};
  view.cut.reset();
  view.report_json.clear();
  view.findings.clear();
  EXPECT_NE(page_of(view, "foreign").find("PASSED"), std::string::npos);
}

}  // namespace
}  // namespace volute::view

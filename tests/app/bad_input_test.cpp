// Bad input of any kind: status 2, one line that names the thing, and what was there before stays.
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/app/run_volute.hpp"

namespace volute::app_test {
namespace {

namespace fs = std::filesystem;

void expect_refused(const Outcome& outcome, const std::string& named) {
  EXPECT_EQ(outcome.status, 2) << outcome.err;
  EXPECT_EQ(lines_in(outcome.err), 1) << outcome.err;
  EXPECT_NE(outcome.err.find(named), std::string::npos) << outcome.err;
}

struct BadJob {
  const char* name;
  std::string text;
  const char* named;
};

class BadJobs : public testing::TestWithParam<BadJob> {};

TEST_P(BadJobs, OneLineAndNothingWritten) {
  const auto folder = scratch_folder(std::string("job-") + GetParam().name);
  write_text(folder / "plate.stl", plate_stl(10, 10));
  write_text(folder / "job.toml", GetParam().text);
  expect_refused(run_volute("run job.toml --out out", folder), GetParam().named);
  EXPECT_FALSE(fs::exists(folder / "out"));
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

INSTANTIATE_TEST_SUITE_P(
    All, BadJobs,
    testing::Values(
        BadJob{"syntax", "[part\n", "job.toml:1"}, BadJob{"unknown_key", plate_job("feed = 3\n"), "feed"},
        BadJob{"unknown_section", plate_job("[paht]\nscallop_mm = 1\n"), "paht"},
        BadJob{"negative_radius", replaced(plate_job(), "radius_mm = 3", "radius_mm = -3"), "tool.radius_mm"},
        BadJob{"scallop_over_radius", replaced(plate_job(), "scallop_mm = 0.2", "scallop_mm = 5"), "path.scallop_mm"},
        BadJob{"method", replaced(plate_job(), "even", "evn"), "even, periodic, paper"},
        BadJob{"surface_missing", replaced(plate_job(), "plate.stl", "plaet.stl"), "plaet.stl"},
        BadJob{"profile", replaced(plate_job(), "ac-head-fanuc", "ac-head-fanux"), "ac-head-fanux"},
        BadJob{"nan", replaced(plate_job(), "radius_mm = 3", "radius_mm = nan"), "tool.radius_mm"},
        BadJob{"kilometres", replaced(plate_job(), "radius_mm = 3", "radius_mm = 1e300"), "tool.radius_mm: 1e+300"},
        BadJob{"huge_in_a_list", plate_job("[holder]\nsegments = [[20, 20, 2000000]]\n"), "holder.segments: 2e+06"},
        BadJob{"holder", plate_job("[holder]\nsegments = [[20, 20]]\n"), "holder.segments"},
        BadJob{"two_stocks", plate_job("[stock]\nnear_net_mm = 0.5\nallowance_mm = 1\n"), "stock.near_net_mm"},
        BadJob{"no_feed", replaced(plate_job(), "feed_mm_min = 600", ""), "feed_mm_min"}),
    [](const testing::TestParamInfo<BadJob>& row) { return row.param.name; });

struct BadMesh {
  const char* name;
  std::string bytes;
  const char* named;
};

class BadMeshes : public testing::TestWithParam<BadMesh> {};

TEST_P(BadMeshes, RefusedByInspectAndByRun) {
  const auto folder = scratch_folder(std::string("mesh-") + GetParam().name);
  write_text(folder / "plate.stl", GetParam().bytes);
  write_text(folder / "job.toml", plate_job());
  expect_refused(run_volute("inspect plate.stl", folder), GetParam().named);
  fs::create_directories(folder / "out");
  write_text(folder / "out" / "report.json", "from before");
  expect_refused(run_volute("run job.toml --out out", folder), GetParam().named);
  EXPECT_EQ(text_of(folder / "out" / "report.json"), "from before");
}

TEST(BadWords, ComparedPathsNameTheirStrategyAndAxis) {
  const auto folder = scratch_folder("compared-paths");
  write_text(folder / "plate.stl", plate_stl(10, 10));
  write_text(folder / "job.toml", plate_job());
  expect_refused(run_volute("compare job.toml --strategies spiral,contour --out out", folder), "contour-offset");
  expect_refused(run_volute("compare job.toml --strategies spiral:vertical --out out", folder), "normal, tilted");
  EXPECT_FALSE(fs::exists(folder / "out"));
}

TEST(BadJob, ASurfaceInItsPlaceIsNamedWithTheRemedy) {
  const auto folder = scratch_folder("surface-as-job");
  write_text(folder / "plate.stl", plate_stl(10, 10));
  expect_refused(run_volute("run plate.stl --out out", folder), "surface = \"plate.stl\"");
  EXPECT_FALSE(fs::exists(folder / "out"));
}

/// A header that claims two hundred million triangles in a file of 84 bytes: 10 GB.
std::string giant_claim() { return std::string(80, ' ') + std::string("\x00\xc2\xeb\x0b", 4); }

std::string with_flipped_bit(std::string bytes, std::size_t byte, int bit) {
  bytes[byte] = static_cast<char>(bytes[byte] ^ (1 << bit));
  return bytes;
}

INSTANTIATE_TEST_SUITE_P(
    All, BadMeshes,
    testing::Values(BadMesh{"empty", "", "empty"}, BadMesh{"truncated", plate_stl(10, 10).substr(0, 3000), "plate.stl"},
                    BadMesh{"giant_claim", giant_claim(), "200000000"},
                    BadMesh{"count_bit_flipped", with_flipped_bit(plate_stl(10, 10), 82, 3), "plate.stl"},
                    BadMesh{"exponent_bit_flipped", with_flipped_bit(plate_stl(10, 10), 84 + 50 * 7 + 12 + 3, 6),
                            "plate.stl"},
                    BadMesh{"not_a_mesh", "hello, this is a letter\n", "plate.stl"}),
    [](const testing::TestParamInfo<BadMesh>& row) { return row.param.name; });

struct BadWords {
  const char* name;
  const char* words;
  const char* named;
};

class BadCommandLines : public testing::TestWithParam<BadWords> {};

TEST_P(BadCommandLines, OneShortLineAndNothingWritten) {
  const auto folder = scratch_folder(std::string("words-") + GetParam().name);
  const std::string program = "G21 G90\nG0 X0. Y0. Z10.\nG1 X10. F100\nM30\n";
  write_text(folder / "good.nc", program);
  write_text(folder / "plate.stl", plate_stl(10, 10));
  write_text(folder / "job.toml", plate_job());
  const Outcome outcome = run_volute(GetParam().words, folder);
  expect_refused(outcome, GetParam().named);
  EXPECT_LT(outcome.err.size(), 300U) << outcome.err;
  EXPECT_FALSE(fs::exists(folder / "good-simulation"));
  EXPECT_EQ(text_of(folder / "good.nc"), program);
}

INSTANTIATE_TEST_SUITE_P(
    All, BadCommandLines,
    testing::Values(
        BadWords{"no_command", "", "the command is missing: run, plan"},
        BadWords{"other_command", "nosuch", "\"nosuch\" is not a command: run, plan"},
        BadWords{"no_job", "run", "JOB is required"},
        BadWords{"length_0", "simulate good.nc --machine ac-head-fanuc --tool-length 0",
                 "--tool-length: \"0\" must be"},
        BadWords{"length_nan", "simulate good.nc --machine ac-head-fanuc --tool-length nan", "\"nan\" must be"},
        BadWords{"length_huge", "simulate good.nc --machine ac-head-fanuc --tool-length 1e300", "\"1e300\" must be"},
        BadWords{"scallop_nan", "simulate good.nc --machine ac-head-fanuc --scallop nan", "--scallop: \"nan\""},
        BadWords{"unit", "inspect plate.stl --unit -1", "--unit: \"-1\""},
        BadWords{"tolerance", "post x.cls --machine ac-head-fanuc --tolerance inf", "--tolerance: \"inf\""},
        BadWords{"setup_huge", "simulate good.nc --machine ac-head-fanuc --setup 1e300,0,0", "within a kilometre"},
        BadWords{"out_is_a_file", "simulate good.nc --machine ac-head-fanuc --out good.nc", "good.nc: is a file"},
        BadWords{"out_below_a_file", "plan job.toml --out good.nc/below", "good.nc: is a file"}),
    [](const testing::TestParamInfo<BadWords>& row) { return row.param.name; });

}  // namespace
}  // namespace volute::app_test

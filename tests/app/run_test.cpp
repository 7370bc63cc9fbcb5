// The main job as a user runs it, on a small plate: results, contract keys, determinism.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "tests/app/run_volute.hpp"

namespace volute::app_test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

fs::path plate_folder(const std::string& name) {
  const auto folder = scratch_folder(name);
  write_text(folder / "plate.stl", plate_stl(15, 30));
  write_text(folder / "plate.toml", plate_job());
  return folder;
}

/// Everything but the seconds that the run itself took.
Json without_timing(const fs::path& report) {
  Json json = Json::parse(text_of(report));
  json.erase("timing");
  if (json.contains("orientation")) json["orientation"].erase("solve_s");
  return json;
}

TEST(Run, PlateGivesAProgramThatPasses) {
  const auto folder = plate_folder("run");
  const Outcome outcome = run_volute("run plate.toml --out out --json", folder);
  ASSERT_EQ(outcome.status, 0) << outcome.err << outcome.out;
  const Json report = Json::parse(outcome.out);
  for (const char* key :
       {"program", "surface", "path", "orientation", "run", "machining", "collision", "findings", "timing"})
    EXPECT_TRUE(report.contains(key)) << key;
  EXPECT_EQ(report["path"]["rapid_traversals"], 0);
  EXPECT_EQ(report["path"]["pieces"], 1);
  EXPECT_TRUE(report["findings"].empty());
  EXPECT_LE(report["machining"]["scallop_p99_mm"].get<double>(), 0.2 * 1.05);
  EXPECT_FALSE(report["machining"]["uncut"].get<bool>());
  for (const auto& [letter, axis] : report["run"]["axes"].items())
    EXPECT_LE(axis["limit_ratio_max"].get<double>(), 1.0 + 1e-9) << letter;
  EXPECT_NEAR(report["run"]["programmed_feed_mm_min"].get<double>(), 600.0, 1.0);
  for (const char* name : {"plate.nc", "toolpath.cls", "plan.json", "report.json", "report.html", "path.png"})
    EXPECT_GT(fs::file_size(folder / "out" / name), 100U) << name;
  EXPECT_FALSE(fs::exists(folder / "out" / "plate.rejected.nc"));
}

TEST(Run, SameJobGivesTheSameBytesOnOneThreadAndTwo) {
  const auto folder = plate_folder("same-bytes");
  ASSERT_EQ(run_volute("run plate.toml --out one --threads 1 --quiet", folder).status, 0);
  ASSERT_EQ(run_volute("run plate.toml --out two --threads 2 --quiet", folder).status, 0);
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder / "one")) names.insert(entry.path().filename());
  EXPECT_GE(names.size(), 6U);
  for (const std::string& name : names) {
    if (name == "report.json" || name == "plan.json")
      EXPECT_EQ(without_timing(folder / "one" / name), without_timing(folder / "two" / name));
    else
      EXPECT_EQ(text_of(folder / "one" / name), text_of(folder / "two" / name)) << name;
  }
}

TEST(Run, WhatFailsKeepsRejectedInItsName) {
  const auto folder = plate_folder("rejected");
  ASSERT_EQ(run_volute("run plate.toml --out out --quiet", folder).status, 0);
  // Posted for LinuxCNC and judged there with one block sunk 0.5 mm: a gouge.
  std::string program = text_of(folder / "out" / "plate.nc");
  const std::size_t at = program.find(" Z", program.size() / 2);
  ASSERT_NE(at, std::string::npos);
  const std::size_t end = program.find_first_of(" \r\n", at + 2);
  const double z = std::stod(program.substr(at + 2, end - at - 2));
  program.replace(at + 2, end - at - 2, std::to_string(z - 0.5));
  write_text(folder / "sunk.nc", program);
  const Outcome judged = run_volute(
      "simulate sunk.nc --machine ac-head-fanuc --part plate.stl --cutter ball,3 --out judged --json", folder);
  EXPECT_EQ(judged.status, 1) << judged.err;
  const Json report = Json::parse(judged.out);
  ASSERT_FALSE(report["findings"].empty());
  bool gouge = false;
  for (const Json& finding : report["findings"]) gouge = gouge || finding["kind"] == "gouge";
  EXPECT_TRUE(gouge) << report["findings"].dump(1);
}

TEST(Run, PlanPostAndSimulateAgreeWithRun) {
  const auto folder = plate_folder("steps");
  ASSERT_EQ(run_volute("plan plate.toml --out planned --quiet", folder).status, 0);
  const Outcome posted =
      run_volute("post planned/toolpath.cls --machine ac-head-linuxcnc --out plate.ngc --json", folder);
  ASSERT_EQ(posted.status, 0) << posted.err;
  EXPECT_GT(Json::parse(posted.out)["blocks"].get<int>(), 100);
  const Outcome judged = run_volute(
      "simulate plate.ngc --machine ac-head-linuxcnc --part plate.stl --cutter ball,3 --tool-length 98 --scallop 0.22 "
      "--json --out sim",
      folder);
  const Json report = Json::parse(judged.out);
  EXPECT_GT(report["run"]["cycle_time_s"].get<double>(), 1.0) << judged.err;
}

TEST(Compare, TheAxisOfAPathIsTheJobsOrTurnsWithTheFeedOrStaysOnTheNormal) {
  const auto folder = plate_folder("compare-axes");
  const Outcome outcome = run_volute(
      "compare plate.toml --strategies iso-planar:normal,iso-planar:tilted,iso-planar --out out --json", folder);
  ASSERT_LE(outcome.status, 1) << outcome.err;
  const Json rows = Json::parse(outcome.out)["strategies"];
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[0]["strategy"], "iso-planar:normal");
  EXPECT_TRUE(fs::exists(folder / "out" / "iso-planar-normal" / "report.html"));
  EXPECT_EQ(rows[0]["orientation"]["smoothing"], "none");
  EXPECT_EQ(rows[1]["orientation"]["smoothing"], "none");
  EXPECT_NE(rows[2]["orientation"]["smoothing"], "none");
  // A tilted axis turns round with the feed at the end of every plane; that takes time which the job's own axis saves.
  for (const Json& row : rows) {
    const Json& run = row["run"];
    EXPECT_LE(run["unlimited_jerk"]["cycle_time_s"], run["cycle_time_s"]) << row["strategy"];
    EXPECT_GE(run["unlimited_jerk"]["machining_feed_loss_percent"], run["machining_feed_loss_percent"]);
  }
  EXPECT_LT(rows[1]["run"]["feed_loss_percent"], rows[2]["run"]["feed_loss_percent"]);
}

TEST(Compare, OnePageHasARowAndAReportForEveryStrategyWithBothLosses) {
  const auto folder = plate_folder("compare");
  const Outcome outcome = run_volute("compare plate.toml --strategies spiral,iso-planar --out out --json", folder);
  ASSERT_LE(outcome.status, 1) << outcome.err;
  const Json rows = Json::parse(outcome.out)["strategies"];
  ASSERT_EQ(rows.size(), 2U);
  const std::string page = text_of(folder / "out" / "report.html");
  for (const Json& row : rows) {
    const std::string name = row["strategy"].get<std::string>();
    EXPECT_NE(page.find("<a href=\"" + name + "/report.html\">"), std::string::npos) << name;
    EXPECT_TRUE(fs::exists(folder / "out" / name / "report.html")) << name;
    EXPECT_NE(page.find("<td>" + std::to_string(row["path"]["rapid_traversals"].get<int>()) + "</td>"),
              std::string::npos);
  }
  EXPECT_NE(page.find("data:image/png;base64,"), std::string::npos);
  // The whole machining loses what leads and rapids take.
  for (const Json& row : rows) {
    const Json& run = row["run"];
    const double machining_s = run["machining_time_s"], feed_s = run["feed_time_s"], cycle_s = run["cycle_time_s"];
    EXPECT_LT(machining_s, cycle_s) << row["strategy"];
    const double interruptions = row["path"]["rapid_traversals"];
    // Up and down by the safe distance of 3 mm, from rest to rest, at no more than the head's 3 m/s^2 along any axis.
    const double rapid_least_s = 2.0 * 2.0 * std::sqrt(0.003 / (std::sqrt(3.0) * 3.0));
    if (interruptions > 0)
      EXPECT_GT(machining_s, feed_s + rapid_least_s * interruptions) << "rapids between feed moves count";
    else
      EXPECT_NEAR(machining_s, feed_s, 0.1) << "one feed move after the other";
    // The cut's own length over all of that time.
    const double cut_mm = run["cutting_length_mm"], actual_mm_min = run["machining_feed_mm_min"];
    EXPECT_NEAR(actual_mm_min, 60.0 * cut_mm / machining_s, 1e-9 * actual_mm_min);
    EXPECT_LT(cut_mm, run["feed_length_mm"].get<double>()) << "leads are not cut";
    const double loss = run["machining_feed_loss_percent"];
    EXPECT_NEAR(loss, 100.0 * (actual_mm_min - 600.0) / 600.0, 0.01);
  }
  EXPECT_LT(rows[1]["run"]["machining_feed_loss_percent"], rows[0]["run"]["machining_feed_loss_percent"]);
}

/// A foreign program on the job's part, with a holder, past a clamp: down beside it and away in rapid through it.
TEST(Simulate, WithAJobAHolderIsFoundInAClampOnARapid) {
  const auto folder = scratch_folder("simulate-clamp");
  write_text(folder / "plate.stl", plate_stl(15, 30));
  write_text(folder / "plate.toml", plate_job("[holder]\nsegments = [[20, 24, 30]]\n"));
  // The holder's face stands 38 mm above the tip, 10 mm wide to each side; the shank passes the clamp.
  write_text(folder / "clamp.stl", box_stl({-20, -8, 20}, {-12, 8, 60}));
  const std::string program =
      "%\nO1\nG21 G90 G94 G17 G40 G49 G80\nG54\nS5000 M3\nG0 A0 C0\nG43.4 H1 X10 Y0 Z40\nG0 Z5\n"
      "G1 X5 Z1 F600\nG1 X10\nG0 X-5\nG49\nM5\nM30\n%\n";
  write_text(folder / "theirs.nc", program);
  const std::string words = "simulate theirs.nc --job plate.toml --out judged --json";
  const Outcome clean = run_volute(words, folder);
  const Json without = Json::parse(clean.out)["findings"];
  for (const Json& finding : without) EXPECT_NE(finding["kind"], "collision") << finding.dump();
  const Outcome outcome = run_volute(words + " --obstacle clamp.stl", folder);
  EXPECT_EQ(outcome.status, 1) << outcome.err;
  int met = 0;
  const Json findings = Json::parse(outcome.out)["findings"];
  for (const Json& finding : findings) {
    if (finding["kind"] != "collision") continue;
    ++met;
    EXPECT_EQ(finding["block"], 11) << "the rapid to X-5: " << finding.dump();
    EXPECT_NE(finding["axis_or_pair"].get<std::string>().find("clamp"), std::string::npos) << finding.dump();
  }
  EXPECT_GE(met, 1);
  EXPECT_EQ(run_volute("simulate theirs.nc --job plate.toml --cutter ball,3", folder).status, 2)
      << "the job has a cutter already";
}

TEST(Run, RenderDrawsTheSamePicturesAgain) {
  const auto folder = plate_folder("render");
  ASSERT_EQ(run_volute("run plate.toml --out out --quiet", folder).status, 0);
  fs::copy(folder / "out", folder / "before", fs::copy_options::recursive);
  fs::remove(folder / "out" / "path.png");
  ASSERT_EQ(run_volute("render out", folder).status, 0);
  int compared = 0;
  for (const auto& entry : fs::directory_iterator(folder / "before")) {
    const std::string kind = entry.path().extension().string();
    if (kind != ".png" && kind != ".svg" && kind != ".html") continue;
    ++compared;
    EXPECT_TRUE(text_of(folder / "out" / entry.path().filename()) == text_of(entry.path())) << entry.path().filename();
  }
  EXPECT_GE(compared, 12);
}

}  // namespace
}  // namespace volute::app_test

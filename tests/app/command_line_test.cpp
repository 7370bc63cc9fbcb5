// The command line's contract: statuses, streams, JSON.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/app/run_volute.hpp"

namespace volute::app_test {
namespace {

using Json = nlohmann::ordered_json;

TEST(CommandLine, HelpTeachesAndIsClean) {
  const auto folder = scratch_folder("help");
  const Outcome help = run_volute("--help", folder);
  EXPECT_EQ(help.status, 0);
  for (const char* word :
       {"run", "plan", "post", "simulate", "compare", "field", "inspect", "machines", "render", "Exit status"})
    EXPECT_NE(help.out.find(word), std::string::npos) << word;
  EXPECT_NE(run_volute("run --help", folder).out.find("Example"), std::string::npos);
}

TEST(CommandLine, BadUsageIsStatusTwoAndOneLine) {
  const auto folder = scratch_folder("usage");
  for (const char* words : {"", "polish part.stl", "run", "run a.toml --colour red", "inspect", "simulate p.nc",
                            "run a.toml --threads 0"}) {
    const Outcome outcome = run_volute(words, folder);
    EXPECT_EQ(outcome.status, 2) << words;
    EXPECT_EQ(lines_in(outcome.err), 1) << words << "\n" << outcome.err;
    EXPECT_TRUE(outcome.out.empty()) << words;
  }
}

TEST(CommandLine, MachinesListIsTheContractsJson) {
  const Outcome outcome = run_volute("machines --json", scratch_folder("machines"));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Json list = Json::parse(outcome.out);
  ASSERT_TRUE(list.is_array());
  ASSERT_GE(list.size(), 2U);
  bool found = false;
  for (const Json& row : list) {
    for (const char* key : {"name", "machine", "control", "kind"}) EXPECT_TRUE(row[key].is_string()) << row.dump();
    found = found || row["name"] == "ac-head-fanuc";
  }
  EXPECT_TRUE(found);
}

TEST(CommandLine, EveryListedProfileCanBeExplained) {
  const auto folder = scratch_folder("machine");
  for (const Json& row : Json::parse(run_volute("machines --json", folder).out)) {
    const Outcome outcome = run_volute("machines " + row["name"].get<std::string>() + " --json", folder);
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const Json machine = Json::parse(outcome.out);
    ASSERT_EQ(machine["axes"].size(), 5U);
    for (const Json& axis : machine["axes"]) {
      const std::string unit = axis["kind"] == "rotary" ? "deg" : "mm";
      EXPECT_GT(axis["velocity_max_" + unit + "_s"].get<double>(), 0.0);
      EXPECT_GT(axis["acceleration_max_" + unit + "_s2"].get<double>(), 0.0);
      EXPECT_GT(axis["jerk_max_" + unit + "_s3"].get<double>(), 0.0);
    }
  }
}

TEST(CommandLine, UnknownMachineNamesTheNearest) {
  const Outcome outcome = run_volute("machines ac-head-fanucc", scratch_folder("nearest"));
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(lines_in(outcome.err), 1);
  EXPECT_NE(outcome.err.find("ac-head-fanuc"), std::string::npos) << outcome.err;
}

TEST(CommandLine, InspectSaysWhatAPlateIs) {
  const auto folder = scratch_folder("inspect");
  write_text(folder / "plate.stl", plate_stl(20, 20));
  const Outcome outcome = run_volute("inspect plate.stl --json", folder);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Json report = Json::parse(outcome.out);
  EXPECT_TRUE(report["machinable"].get<bool>());
  EXPECT_EQ(report["boundary_loops"], 2);
  EXPECT_EQ(report["handles"], 0);
  EXPECT_EQ(report["triangles"], 2 * (400 - 16));
  EXPECT_NEAR(report["area_mm2"].get<double>(), 1600.0 - 64.0, 1e-3);
}

}  // namespace
}  // namespace volute::app_test

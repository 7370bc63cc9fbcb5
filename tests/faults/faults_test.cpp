// Every fault of faults.json, put into its good program, machine file or control file, must be reported by the
// simulator.
#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "geometry/file.hpp"
#include "sim/verify.hpp"
#include "tests/faults/sample_job.hpp"

namespace volute::faults {
namespace {

namespace fs = std::filesystem;

fs::path source() { return VOLUTE_SOURCE_DIR; }
fs::path here() { return source() / "tests/faults"; }

struct Fault {
  std::string name, base, change, find, replace;
  int nth = 1;
  bool all = false;
  std::vector<std::string> expect;
};

void PrintTo(const Fault& fault, std::ostream* out) { *out << fault.name; }

std::vector<Fault> all_faults() {
  std::ifstream in(here() / "faults.json");
  const nlohmann::json table = nlohmann::json::parse(in);
  std::vector<Fault> faults;
  for (const auto& entry : table.at("faults"))
    faults.push_back({entry.at("name"), entry.at("base"), entry.at("change"), entry.at("find"), entry.at("replace"),
                      entry.value("nth", 1), entry.value("all", false),
                      entry.at("expect").get<std::vector<std::string>>()});
  return faults;
}

/// "ac-head-fanuc.nc" -> the profile's machine and control files.
struct Files {
  fs::path machine, control;
};

Files files_of(const std::string& base) {
  const auto profile = kinematics::load_profile(source() / "machines", fs::path(base).stem().string());
  EXPECT_TRUE(profile.has_value()) << base;
  return {profile->machine.file, profile->control.file};
}

std::string text_of(const fs::path& file) {
  auto text = geometry::read_file(file);
  EXPECT_TRUE(text.has_value()) << file;
  return text.value_or("");
}

// The fault put in: the nth occurrence, or all of them. Fails when the good text does not hold it.
std::string broken(std::string text, const Fault& fault) {
  std::size_t at = 0;
  int seen = 0, changed = 0;
  while ((at = text.find(fault.find, at)) != std::string::npos) {
    ++seen;
    if (fault.all || seen == fault.nth) {
      text.replace(at, fault.find.size(), fault.replace);
      at += fault.replace.size();
      ++changed;
    } else {
      at += fault.find.size();
    }
  }
  EXPECT_GT(changed, 0) << fault.name << ": \"" << fault.find << "\" is not in " << fault.base;
  return text;
}

class Scratch {
 public:
  Scratch() : folder_(fs::path(::testing::TempDir()) / ("volute_faults_" + std::to_string(::getpid()))) {
    fs::create_directories(folder_);
  }
  ~Scratch() { fs::remove_all(folder_); }
  fs::path put(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return folder_ / name;
  }

 private:
  fs::path folder_;
};

struct Verdict {
  std::vector<std::string> kinds;  ///< findings, "error:CODE", and what the report's numbers say against the good run
  std::string first_text;
  double programmed_feed_mm_s = 0.0;
};

std::vector<kinematics::ToolPose> expected_poses(const kinematics::Profile& good) {
  const auto posted = post::post(request(), good);
  EXPECT_TRUE(posted.has_value());
  std::vector<kinematics::ToolPose> poses;
  for (const kinematics::AxisPathPoint& point : posted->axis_path.points)
    if (point.move != kinematics::MoveKind::rapid) poses.push_back(point.pose);
  return poses;
}

Verdict judge(const std::string& text, const fs::path& machine_file, const fs::path& control_file,
              const std::vector<kinematics::ToolPose>& expected) {
  sim::VerifyRequest request;
  auto profile = kinematics::load_profile("", machine_file.string() + ":" + control_file.string());
  if (!profile) return {{"error:" + profile.error().code}, profile.error().message};
  request.text = text;
  request.file_name = "program";
  request.profile = std::move(*profile);
  request.tool = tool();
  request.surface_P = patch();
  request.obstacles_P = {fixture()};
  request.obstacle_names = {"fixture"};
  request.cut.uncut_limit_mm = 0.02;  // the good scallop is 0.0104 mm
  // A control with feed-forward leaves nothing. One without lags by v / Kv, and the axes stop and turn at once where
  // nothing limits jerk: the first and the last point of the patch are cut round (0.292 mm2 of 36; 0.101 where an
  // S-curve makes it slower there). The test below holds that the lag is the cause.
  request.cut.uncut_area_limit_mm2 = request.profile.control.feed_forward ? 0.01 : 0.35;
  request.cut.gouge_limit_mm = 0.01;
  request.expected_poses = expected;
  request.expected_tolerance_mm = 0.002;
  request.expected_tolerance_rad = 0.0002;
  const auto result = sim::verify(request);
  if (!result) return {{"error:" + result.error().code}, result.error().message};
  Verdict verdict;
  for (const sim::Finding& finding : result->findings) verdict.kinds.push_back(finding.kind);
  if (!result->findings.empty()) verdict.first_text = result->findings.front().text;
  verdict.programmed_feed_mm_s = result->run.programmed_feed_mm_s;
  return verdict;
}

/// The good program of a base, judged once.
const Verdict& good_verdict(const std::string& base) {
  static std::map<std::string, Verdict> known;
  auto found = known.find(base);
  if (found != known.end()) return found->second;
  const Files files = files_of(base);
  const auto profile = kinematics::load_profile("", files.machine.string() + ":" + files.control.string());
  return known[base] = judge(text_of(here() / "good" / base), files.machine, files.control, expected_poses(*profile));
}

class GoodProgram : public ::testing::TestWithParam<std::string> {};

TEST_P(GoodProgram, IsWhatThePostWritesAndTheSimulatorFindsNothing) {
  const auto profile = kinematics::load_profile(source() / "machines", fs::path(GetParam()).stem().string());
  ASSERT_TRUE(profile.has_value());
  const auto posted = post::post(request(), *profile);
  ASSERT_TRUE(posted.has_value());
  if (std::getenv("VOLUTE_WRITE_GOLDEN") != nullptr) {
    ASSERT_TRUE(geometry::write_file(here() / "good" / GetParam(), posted->text).has_value());
  }
  EXPECT_EQ(posted->text, text_of(here() / "good" / GetParam()));
  const Verdict& verdict = good_verdict(GetParam());
  // LinuxCNC's planner knows no jerk limit and passes it in every program: that finding is true and no fault of the
  // program.
  std::vector<std::string> kinds = verdict.kinds;
  if (profile->control.linuxcnc_planner) std::erase(kinds, "limit");
  EXPECT_TRUE(kinds.empty()) << kinds.front() << ": " << verdict.first_text;
}

INSTANTIATE_TEST_SUITE_P(Bases, GoodProgram,
                         ::testing::Values("ac-head-fanuc.nc", "ac-head-linuxcnc.ngc", "ac-head-siemens-vector.mpf",
                                           "ac-head-heidenhain.h", "xyzac-trunnion-mazak.eia", "xyzbc-table-g93.nc"),
                         [](const auto& instance) {
                           std::string name = fs::path(instance.param).stem().string();
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(GoodProgramLag, NothingIsLeftWhereTheServosFollowWithoutError) {
  const std::string base = "xyzbc-table-g93.nc";
  const Files files = files_of(base);
  const Scratch scratch;
  std::string control = text_of(files.control);
  const std::string without = "feed_forward = false";
  ASSERT_NE(control.find(without), std::string::npos);
  control.replace(control.find(without), without.size(), "feed_forward = true");
  const auto profile = kinematics::load_profile("", files.machine.string() + ":" + files.control.string());
  for (const kinematics::Axis& axis : profile->machine.axes) EXPECT_EQ(axis.velocity_feed_forward, 1.0) << axis.letter;
  const Verdict verdict = judge(text_of(here() / "good" / base), files.machine,
                                scratch.put(files.control.filename().string(), control), expected_poses(*profile));
  EXPECT_TRUE(verdict.kinds.empty()) << verdict.first_text;  // the limit is 0.01 mm2 now
}

class Faults : public ::testing::TestWithParam<Fault> {};

TEST_P(Faults, IsReported) {
  const Fault& fault = GetParam();
  const Files files = files_of(fault.base);
  const Scratch scratch;
  const auto changed = [&](const char* what, const fs::path& file) {
    return fault.change == what ? scratch.put(file.filename().string(), broken(text_of(file), fault)) : file;
  };
  const fs::path machine = changed("machine", files.machine), control = changed("control", files.control);
  std::string text = text_of(here() / "good" / fault.base);
  if (fault.change == "program") text = broken(text, fault);

  const auto good_profile = kinematics::load_profile("", files.machine.string() + ":" + files.control.string());
  Verdict verdict = judge(text, machine, control, expected_poses(*good_profile));
  if (std::find(fault.expect.begin(), fault.expect.end(), "report:programmed_feed") != fault.expect.end()) {
    // A wrong feed moves nothing out of place: the report's own number tells it.
    const double good_feed_mm_s = good_verdict(fault.base).programmed_feed_mm_s;
    if (std::abs(verdict.programmed_feed_mm_s - good_feed_mm_s) > 0.05 * good_feed_mm_s)
      verdict.kinds.push_back("report:programmed_feed");
  }

  std::string found;
  for (const std::string& kind : verdict.kinds) found += kind + " ";
  const bool reported = std::all_of(fault.expect.begin(), fault.expect.end(), [&](const std::string& kind) {
    return std::find(verdict.kinds.begin(), verdict.kinds.end(), kind) != verdict.kinds.end();
  });
  EXPECT_TRUE(reported) << fault.name << " is reported as: [" << found << "] " << verdict.first_text;
}

INSTANTIATE_TEST_SUITE_P(Table, Faults, ::testing::ValuesIn(all_faults()), [](const auto& instance) {
  std::string name = instance.param.name;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

}  // namespace
}  // namespace volute::faults

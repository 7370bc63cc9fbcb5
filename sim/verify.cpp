#include "sim/verify.hpp"

#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <chrono>
#include <cmath>
#include <numeric>

#include "geometry/number_text.hpp"
#include "sim/controller/run_loop.hpp"
#include "sim/read_back.hpp"
#include "sim/run_watch.hpp"

namespace volute::sim {
namespace {

using geometry::short_text;
using kinematics::AxisKind;

/// Tells the stages to who listens, and how long each took: the parts of the clock's time from beginning to end.
class Stages {
 public:
  Stages(const VerifyRequest& request, VerifyResult& result) : request_(request), result_(result) {}
  ~Stages() { end(); }
  void begin(const std::string& stage) {
    end();
    stage_ = stage;
    start_ = Clock::now();
    tell(0.0);
  }
  void tell(double done) const {
    if (request_.progress) request_.progress(stage_, done);
  }
  struct Part {
    std::string stage;
    std::function<void()> work;
  };
  /// Parts that do not need each other, at the same time. Each waits for its own tasks only, so that it never stands
  /// still for another's; the clock's time is shared among them as their own times are to each other.
  void side_by_side(const std::string& name, const std::vector<Part>& parts) {
    begin(name);
    std::vector<double> own_s(parts.size());
    tbb::task_group group;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      group.run([&, i] {
        const auto start = Clock::now();
        tbb::this_task_arena::isolate(parts[i].work);
        own_s[i] = std::chrono::duration<double>(Clock::now() - start).count();
      });
    }
    group.wait();
    end();
    const auto all = result_.timing_s.extract(name);
    const double sum_s = std::accumulate(own_s.begin(), own_s.end(), 0.0);
    for (std::size_t i = 0; i < parts.size(); ++i) result_.timing_s[parts[i].stage] += all.mapped() * own_s[i] / sum_s;
  }
  void end() {
    if (stage_.empty()) return;
    tell(1.0);
    result_.timing_s[stage_] += std::chrono::duration<double>(Clock::now() - start_).count();
    stage_.clear();
  }

 private:
  using Clock = std::chrono::steady_clock;
  const VerifyRequest& request_;
  VerifyResult& result_;
  std::string stage_;
  Clock::time_point start_;
};

ProgramReader reader(const VerifyRequest& request) {
  ReaderOptions options;
  options.work_zero_machine_mm = kinematics::program_zero(request.profile.machine, request.setup, 0.0).head<3>().eval();
  options.tool_length_mm = request.tool.gauge_length_mm;
  options.start = zero_position(request.profile.machine);
  return {request.text, request.file_name, request.profile.machine, request.profile.control, options};
}

Result<void> read_back(const VerifyRequest& request, VerifyResult& result) {
  if (request.expected_poses.empty()) return {};
  ProgramReader program = reader(request);
  const auto commanded = commanded_poses(program, request.profile.machine, request.setup, request.tool.gauge_length_mm);
  if (!commanded) return tl::unexpected(commanded.error());
  result.commanded_points = static_cast<std::int64_t>(commanded->size());
  const auto found = compare_poses(request.expected_poses, *commanded,
                                   {request.expected_tolerance_mm, request.expected_tolerance_rad});
  result.findings.insert(result.findings.end(), found.begin(), found.end());
  return {};
}

ControlSetup control_setup(const VerifyRequest& request, const kinematics::Control& control) {
  ControlSetup setup;
  setup.machine = &request.profile.machine;
  setup.control = &control;
  setup.setup = request.setup;
  setup.tool_length_mm = request.tool.gauge_length_mm;
  return setup;
}

Result<RunReport> run(const VerifyRequest& request, const Stages& stages, RunWatch& watch) {
  ProgramReader program = reader(request);
  return run_program(
      program, control_setup(request, request.profile.control),
      [&](std::span<const AxisSample> samples) { watch.add(samples); }, [&](double done) { stages.tell(done); });
}

/// Where it fails, for whatever the changed speeds meet, there is no such run.
void run_unlimited_jerk(const VerifyRequest& request, VerifyResult& result) {
  kinematics::Control control = request.profile.control;
  if (control.linuxcnc_planner || control.acceleration_profile != kinematics::AccelerationProfile::s_curve) return;
  control.acceleration_profile = kinematics::AccelerationProfile::trapezoid;
  ProgramReader program = reader(request);
  MachiningSpan machining;
  const auto report = run_program(program, control_setup(request, control),
                                  [&](std::span<const AxisSample> samples) { machining.add(samples); });
  if (!report) return;
  result.unlimited_jerk = {report->cycle_time_s, report->feed_loss_percent, machining.time_s()};
}

CollisionScene scene(const VerifyRequest& request) {
  CollisionScene out;
  if (request.surface_P) out.part_P = *request.surface_P;
  out.obstacles_P = request.obstacles_P;
  out.obstacle_names = request.obstacle_names;
  if (request.stock && !request.stock->assumed) out.stock_P = blank_mesh(*request.stock);
  out.tool = request.tool;
  out.gouge_tolerance_mm = request.cut.gouge_limit_mm;
  out.clearance_mm = request.clearance_mm;
  // The chord of a linear and of a rotary axis can add up at the tip.
  out.state_error_mm = 2.0 * RunWatch::Bounds{}.state_chord_mm;
  return out;
}

/// A limit of an axis that the run passed; the control holds them, so any is a fault of the control or of the machine's
/// data.
void add_limit_findings(const VerifyRequest& request, const LimitPeaks& peaks, VerifyResult& result) {
  constexpr double rounding = 1e-6;
  for (std::size_t i = 0; i < kinematics::axis_count; ++i) {
    const double ratio = result.run.axes[i].limit_ratio_max;
    if (ratio <= 1.0 + rounding) continue;
    const LimitPeak peak = peaks.nearest_to(static_cast<int>(i), ratio);
    const std::string letter(1, request.profile.machine.axes[i].letter);
    result.findings.push_back({"limit", peak.line, peak.time_s, letter, ratio, 1.0,
                               "line " + std::to_string(peak.line) + ": " + letter + "'s " + peak.quantity + " is " +
                                   short_text(ratio, 5) + " times its limit of " + request.profile.machine.name});
  }
}

/// One finding for each end that is passed, however often: the first place and the farthest.
void add_travel_findings(const VerifyRequest& request, VerifyResult& result) {
  for (const TravelExcess& excess : result.run.out_of_travel) {
    const auto& axis = request.profile.machine.axes[static_cast<std::size_t>(excess.axis)];
    const bool rotary = axis.kind == AxisKind::rotary;
    const double scale = rotary ? geometry::Angle::radians(1.0).degrees() : 1.0;
    const char* unit = rotary ? " deg" : " mm";
    const std::string letter(1, axis.letter);
    std::string text = "line " + std::to_string(excess.first_line) + ": " + letter + " passes its end at " +
                       short_text(excess.limit * scale, 6) + unit + " of " + request.profile.machine.name + " by " +
                       short_text(std::abs(excess.farthest - excess.limit) * scale, 4) + unit;
    if (excess.times > 1 || excess.farthest_line != excess.first_line)
      text += " at most (line " + std::to_string(excess.farthest_line) + ")";
    if (excess.times > 1) text += ", " + std::to_string(excess.times) + " times";
    result.findings.push_back({"travel", excess.first_line, excess.first_time_s, letter, excess.farthest * scale,
                               excess.limit * scale, text + "; move the part or the program zero"});
  }
}

void measure_surface(const VerifyRequest& request, const std::vector<SweptPose>& moves, VerifyResult& result) {
  result.cut = measure_cut_surface(*request.surface_P, request.tool.cutter, moves, request.cut);
  if (request.picture_vertices_max == 0) return;
  // A quarter of the path interval shows every scallop; samples stand a tenth of it apart.
  result.picture = cut_picture(*request.surface_P, request.tool.cutter, moves, request.cut,
                               2.5 * result.cut->sample_spacing_mm, request.picture_vertices_max);
}

Result<void> measure_material(const VerifyRequest& request, const std::vector<SweptPose>& moves, const Stages& stages,
                              VerifyResult& result) {
  auto stock = make_stock(*request.stock);
  if (!stock) return tl::unexpected(stock.error());
  StockRunOptions options;
  options.step_mm = request.collision_step_mm;
  options.progress = [&](double done) { stages.tell(done); };
  StockOutcome outcome;
  outcome.report = run_through_stock(*stock, request.tool, moves, options);
  outcome.skin_P = stock->skin();
  outcome.box_P_mm = stock->box();
  outcome.grid_mm = stock->grid_mm();
  outcome.assumed = request.stock->assumed;
  result.stock = std::move(outcome);
  return {};
}

/// What a run meets in a stock that nobody gave is told in one line: the first place.
void add_stock_warning(const StockReport& report, std::vector<Finding>& warnings) {
  if (report.findings.empty()) return;
  Finding warning = report.findings.front();
  warning.text = "in a full block about the part the tool would meet material where it should not on " +
                 std::to_string(report.findings.size()) + (report.findings_left_out ? " or more lines" : " line(s)") +
                 ", the first is " + std::to_string(warning.line) + " (" + warning.axis_or_pair +
                 "); the stock is not given: give it to have this judged";
  warnings.push_back(std::move(warning));
}

void gather_findings(const VerifyRequest& request, const LimitPeaks& peaks, VerifyResult& result) {
  const auto take = [&](const std::vector<Finding>& findings) {
    result.findings.insert(result.findings.end(), findings.begin(), findings.end());
  };
  add_limit_findings(request, peaks, result);
  add_travel_findings(request, result);
  if (result.cut) take(result.cut->findings);
  if (result.collision) take(result.collision->findings);
  take(result.loads.findings);
  result.warnings = result.loads.warnings;
  for (const std::string& text : result.run.warnings)
    result.warnings.push_back({"program", 0, 0.0, "", 0.0, 0.0, text});
  if (result.stock && result.stock->assumed)
    add_stock_warning(result.stock->report, result.warnings);
  else if (result.stock)
    take(result.stock->report.findings);
  sort_by_severity(result.findings);
  sort_by_severity(result.warnings);
}

TraceView trace_view(const VerifyRequest& request, std::vector<AxisSample> samples) {
  TraceView view;
  const ToolMotion motion(request.profile.machine, request.setup, request.tool.gauge_length_mm);
  view.poses_P.reserve(samples.size());
  for (const AxisSample& s : samples) view.poses_P.push_back(motion.pose_P(s.actual));
  view.samples = std::move(samples);
  return view;
}

/// What the run left, met and touched. None of it needs another's result; the stock is told of, as it takes longest.
Result<void> measure(const VerifyRequest& request, RunWatch& watch, Stages& stages, VerifyResult& result) {
  const std::vector<SweptPose> moves = watch.moves();
  const std::vector<MachineState> states = watch.states();
  Result<void> stock;
  std::vector<Stages::Part> parts;
  if (request.stock) parts.push_back({"stock", [&] { stock = measure_material(request, moves, stages, result); }});
  if (request.surface_P) parts.push_back({"cut surface", [&] { measure_surface(request, moves, result); }});
  parts.push_back({"collisions", [&] {
                     result.collision = check_collisions(scene(request), request.profile.machine, request.setup, states,
                                                         request.collision_step_mm);
                   }});
  parts.push_back({"run without jerk limits", [&] { run_unlimited_jerk(request, result); }});
  parts.push_back({"samples for pictures", [&] { result.trace = trace_view(request, watch.trace()); }});
  stages.side_by_side("cut surface, stock and collisions", parts);
  return stock;
}

}  // namespace

Result<VerifyResult> verify(const VerifyRequest& request) {
  VerifyResult result;
  Stages stages(request, result);

  stages.begin("read back");
  if (auto read = read_back(request, result); !read) return tl::unexpected(read.error());

  stages.begin("run");
  RunWatch watch(request.profile.machine, request.setup, request.tool, {});
  auto report = run(request, stages, watch);
  if (!report) return tl::unexpected(report.error());
  watch.finish();
  result.run = std::move(*report);

  if (auto measured = measure(request, watch, stages, result); !measured) return tl::unexpected(measured.error());

  stages.begin("findings");
  result.loads = watch.loads();
  result.machining_time_s = watch.machining_time_s();
  gather_findings(request, watch.limit_peaks(), result);
  stages.end();
  return result;
}

}  // namespace volute::sim

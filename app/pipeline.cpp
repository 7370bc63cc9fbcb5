#include "app/pipeline.hpp"

#include <limits>

#include "geometry/mesh_report.hpp"
#include "post/cl_data.hpp"

namespace volute::app {

namespace {

/// Two roundings of a word meet when a program is read back: half a unit of the last digit of each of three words, and
/// the linear solve behind them.
constexpr double rounding_slack = 4.0;

/// The planner holds the scallop at 1.05 times the allowed one over 99.99 % of the surface and at this many times
/// everywhere.
constexpr double scallop_bound = 1.1;

double decimal_step(int decimals) {
  double step = 1.0;
  for (int i = 0; i < decimals; ++i) step /= 10.0;
  return step;
}

geometry::Result<void> load_obstacles(const std::vector<std::filesystem::path>& files, JobInputs& inputs) {
  for (const std::filesystem::path& file : files)
    if (auto loaded = load_obstacle(file, inputs); !loaded) return loaded;
  return {};
}

planner::Scene scene_of(const JobInputs& inputs) {
  planner::Scene scene;
  scene.part = inputs.surface;
  const auto first_fixture = inputs.obstacles.end() - static_cast<std::ptrdiff_t>(inputs.fixture_count);
  scene.obstacles.assign(inputs.obstacles.begin(), first_fixture);
  scene.fixtures.assign(first_fixture, inputs.obstacles.end());
  scene.names = inputs.obstacle_names;
  scene.clearance_mm = inputs.job.clearance_mm;
  scene.gouge_tolerance_mm = inputs.job.gouge_tolerance_mm;
  return scene;
}

std::vector<kinematics::ToolPose> cutting_poses(const kinematics::AxisPath& path) {
  std::vector<kinematics::ToolPose> poses;
  for (const kinematics::AxisPathPoint& point : path.points)
    if (point.move == kinematics::MoveKind::cut) poses.push_back(point.pose);
  return poses;
}

std::optional<sim::StockSetup> stock_setup(const JobInputs& inputs) {
  const StockJob& stock = inputs.job.stock;
  if (stock.skip) return std::nullopt;
  sim::StockSetup setup = sim::assumed_stock(inputs.surface, stock.allowance_mm);
  if (stock.near_net_mm) setup = sim::near_net_stock(inputs.surface, *stock.near_net_mm);
  if (stock.low_mm) setup.box_P_mm = Eigen::AlignedBox3d(*stock.low_mm, *stock.high_mm);
  if (inputs.stock) setup.solid_P = inputs.stock;
  setup.grid_mm = stock.grid_mm;
  setup.assumed = !stock.given;
  return setup;
}

}  // namespace

geometry::Result<void> load_obstacle(const std::filesystem::path& file, JobInputs& inputs) {
  auto loaded = geometry::load_mesh(file, inputs.job.unit_mm);
  if (!loaded) return tl::unexpected(loaded.error());
  for (const std::string& warning : loaded->repairs.warnings) inputs.warnings.push_back(warning);
  inputs.obstacles.push_back(std::move(loaded->mesh));
  inputs.obstacle_names.push_back(file.stem().string());
  return {};
}

geometry::Result<JobInputs> load_inputs(const std::filesystem::path& job_file, const Context& context, SurfaceUse use,
                                        const std::string& profile_name) {
  auto job = load_job(job_file);
  if (!job) return tl::unexpected(job.error());
  JobInputs inputs;
  inputs.job = std::move(*job);
  if (!profile_name.empty()) inputs.job.profile = profile_name;
  auto profile = kinematics::load_profile(context.machines_folder(), inputs.job.profile);
  if (!profile) return tl::unexpected(profile.error());
  inputs.profile = std::move(*profile);
  const auto loaded = geometry::load_mesh(inputs.job.surface_file, inputs.job.unit_mm);
  if (!loaded) return tl::unexpected(loaded.error());
  inputs.warnings = loaded->repairs.warnings;
  if (use == SurfaceUse::judged) {
    inputs.surface = loaded->mesh;
  } else {
    auto surface = geometry::machinable_surface(*loaded, inputs.job.component);
    if (!surface) {
      geometry::Error error = surface.error();
      error.message = inputs.job.surface_file.string() + ": " + error.message;
      return tl::unexpected(error);
    }
    inputs.surface = std::move(*surface);
  }
  if (auto read = load_obstacles(inputs.job.obstacle_files, inputs); !read) return tl::unexpected(read.error());
  if (auto read = load_obstacles(inputs.job.fixture_files, inputs); !read) return tl::unexpected(read.error());
  if (!inputs.job.stock.solid_file.empty()) {
    auto stock = geometry::load_mesh(inputs.job.stock.solid_file, inputs.job.unit_mm);
    if (!stock) return tl::unexpected(stock.error());
    inputs.stock = std::move(stock->mesh);
  }
  inputs.fixture_count = inputs.job.fixture_files.size();
  return inputs;
}

geometry::Result<planner::PlanResult> plan_job(const JobInputs& inputs, Progress& progress) {
  planner::PlanRequest request;
  request.surface = inputs.surface;
  request.tool = inputs.job.tool;
  request.scene = scene_of(inputs);
  if (const auto stock = stock_setup(inputs)) request.stock_P = sim::blank_mesh(*stock);
  request.path = inputs.job.path;
  request.orientation = inputs.job.orientation;
  request.process = inputs.job.process;
  request.machine = inputs.profile.machine;
  request.setup = inputs.job.setup;
  request.progress = progress.callback();
  return planner::plan(request);
}

geometry::Result<post::PostResult> post_job(const JobInputs& inputs, const planner::PlanResult& plan) {
  post::PostRequest request;
  request.program_name = inputs.job.name;
  request.path = plan.tool_path;
  request.tool = inputs.job.tool;
  request.setup = inputs.job.setup;
  request.spindle_rpm = inputs.job.spindle_rpm;
  request.coolant = inputs.job.coolant;
  request.tolerance_mm = inputs.job.path.tolerance_mm / 2.0;
  return post::post(request, inputs.profile);
}

sim::VerifyRequest verify_request(const JobInputs& inputs, bool with_material) {
  sim::VerifyRequest request;
  request.profile = inputs.profile;
  request.setup = inputs.job.setup;
  request.tool = inputs.job.tool;
  request.surface_P = inputs.surface;
  request.obstacles_P = inputs.obstacles;
  request.obstacle_names = inputs.obstacle_names;
  // Uncut is more than the planner's own bound on a scallop and the tolerance by which path and mesh may stand off the
  // surface.
  request.cut.uncut_limit_mm =
      scallop_bound * inputs.job.path.scallop_mm + inputs.job.path.allowance_mm + inputs.job.path.tolerance_mm;
  // Between two turns most of the surface is left on purpose: its uncut area is reported, and is no fault.
  if (inputs.job.path.from_turn || inputs.job.path.to_turn)
    request.cut.uncut_area_limit_mm2 = std::numeric_limits<double>::infinity();
  request.cut.gouge_limit_mm = inputs.job.gouge_tolerance_mm;
  if (with_material) {
    request.picture_vertices_max = picture_vertices_max;
    request.stock = stock_setup(inputs);
  }
  return request;
}

geometry::Result<sim::VerifyResult> verify_job(const JobInputs& inputs, const planner::PlanResult&,
                                               const post::PostResult& posted, Progress& progress, bool with_material) {
  const kinematics::Control& control = inputs.profile.control;
  sim::VerifyRequest request = verify_request(inputs, with_material);
  request.text = posted.text;
  request.file_name = inputs.job.name + control.program_extension;
  request.expected_poses = cutting_poses(posted.axis_path);
  const double rotary_step_rad = geometry::Angle::degrees(decimal_step(control.rotary_decimals)).radians();
  const double arm_mm = control.tcp ? 0.0 : inputs.job.tool.gauge_length_mm + 1000.0;
  request.expected_tolerance_mm = rounding_slack * (decimal_step(control.linear_decimals) + rotary_step_rad * arm_mm);
  // Next to the pole the axis may lean by the linearization's own tolerance.
  request.expected_tolerance_rad = rounding_slack * (rotary_step_rad + decimal_step(control.vector_decimals)) +
                                   kinematics::AxisPathOptions().rotary_tolerance_rad;
  request.progress = progress.callback();
  return sim::verify(request);
}

view::OrientationRule orientation_rule(const JobInputs& inputs, const planner::PlanResult& plan) {
  const planner::OrientationOptions& asked = inputs.job.orientation;
  return {asked.tilt,
          asked.yaw,
          asked.tilt_min,
          asked.tilt_max,
          inputs.job.clearance_mm,
          inputs.job.gouge_tolerance_mm,
          inputs.fixture_count,
          plan.rotaries_rad};
}

view::RunView run_view(const JobInputs& inputs, const planner::PlanResult& plan, const post::PostResult& posted,
                       const sim::VerifyResult& verified) {
  view::RunView view;
  view.title = inputs.job.name + " on " + inputs.profile.name;
  view.surface_P = inputs.surface;
  view.obstacles_P = inputs.obstacles;
  view.obstacle_names = inputs.obstacle_names;
  view.tool = inputs.job.tool;
  view.setup = inputs.job.setup;
  view.profile = inputs.profile;
  view.tool_path = plan.tool_path;
  view.orientation = orientation_rule(inputs, plan);
  view.trace = verified.trace;
  view.cut = verified.cut;
  view.findings = verified.findings;
  view.program_text = posted.text;
  view.map_vertices = plan.cc.map.vertices;
  view.map_triangles = plan.cc.map.triangles;
  view.map_guide_lines = plan.cc.map.guide_lines;
  return view;
}

std::string cl_text(const JobInputs& inputs, const planner::PlanResult& plan) {
  post::ClData data;
  data.part_name = inputs.job.name;
  data.tool = inputs.job.tool;
  data.spindle_rpm = inputs.job.spindle_rpm;
  data.coolant = inputs.job.coolant;
  data.path = plan.tool_path;
  return post::write_cl(data);
}

}  // namespace volute::app

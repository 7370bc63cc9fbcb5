#include "app/reproduce/workshop.hpp"

namespace volute::app {

using geometry::Result;

Result<JobInputs> Workshop::inputs(const std::string& job) const {
  return load_inputs(context_->examples_folder() / (job + ".toml"), *context_);
}

Result<std::shared_ptr<const MadeRun>> Workshop::run(const std::string& job, planner::Strategy strategy,
                                                     ComparedAxis axis) {
  const std::string key = job + " " + strategy_name(strategy) + " " + std::to_string(static_cast<int>(axis));
  if (const auto known = runs_.find(key); known != runs_.end()) return known->second;
  auto made = std::make_shared<MadeRun>();
  auto loaded = inputs(job);
  if (!loaded) return tl::unexpected(loaded.error());
  made->inputs = with_path(std::move(*loaded), strategy, axis);
  auto plan = plan_job(made->inputs, context_->progress());
  if (!plan) return tl::unexpected(plan.error());
  made->plan = std::move(*plan);
  const auto posted = post_job(made->inputs, made->plan);
  if (!posted) return tl::unexpected(posted.error());
  auto verified = verify_job(made->inputs, made->plan, *posted, context_->progress());
  if (!verified) return tl::unexpected(verified.error());
  made->verified = std::move(*verified);
  made->verified.trace = {};
  made->view = run_view(made->inputs, made->plan, *posted, made->verified);
  runs_[key] = made;
  return std::shared_ptr<const MadeRun>(made);
}

Result<std::shared_ptr<const planner::PlanResult>> Workshop::plan(const std::string& job,
                                                                  planner::Smoothing smoothing) {
  const std::string key = job + " " + smoothing_name(smoothing);
  if (const auto known = plans_.find(key); known != plans_.end()) return known->second;
  auto loaded = inputs(job);
  if (!loaded) return tl::unexpected(loaded.error());
  loaded->job.orientation.smoothing = smoothing;
  auto plan = plan_job(*loaded, context_->progress());
  if (!plan) return tl::unexpected(plan.error());
  plans_[key] = std::make_shared<const planner::PlanResult>(std::move(*plan));
  return plans_[key];
}

Result<std::string> Workshop::keep(const std::string& name, const std::vector<view::FigurePanel>& panels,
                                   int columns) const {
  const std::string file = name + ".png";
  if (auto written = figures_.write(file, view::png_bytes(view::figure_sheet(panels, columns))); !written)
    return tl::unexpected(written.error());
  return file;
}

Result<std::string> Workshop::keep(const std::string& name, const view::Plot& plot) const {
  const std::string file = name + ".svg";
  if (auto written = figures_.write(file, view::svg_text(plot)); !written) return tl::unexpected(written.error());
  return file;
}

const char* strategy_name(planner::Strategy strategy) {
  using planner::Strategy;
  switch (strategy) {
    case Strategy::spiral:
      return "spiral";
    case Strategy::contour_parallel:
      return "contour-parallel";
    case Strategy::projected_spiral:
      return "projected-spiral";
    case Strategy::contour_offset:
      return "contour-offset";
    case Strategy::iso_planar:
      break;
  }
  return "iso-planar";
}

const char* smoothing_name(planner::Smoothing smoothing) {
  using planner::Smoothing;
  switch (smoothing) {
    case Smoothing::none:
      return "none";
    case Smoothing::velocity:
      return "velocity";
    case Smoothing::acceleration:
      return "acceleration";
    case Smoothing::field:
      return "field";
    case Smoothing::corridor:
      break;
  }
  return "corridor";
}

view::RunView part_view(const JobInputs& inputs) {
  view::RunView view;
  view.title = inputs.job.name;
  view.surface_P = inputs.surface;
  view.obstacles_P = inputs.obstacles;
  view.obstacle_names = inputs.obstacle_names;
  view.tool = inputs.job.tool;
  return view;
}

view::RunView path_view(const JobInputs& inputs, const planner::CcPath& path) {
  view::RunView view = part_view(inputs);
  for (const planner::CcPiece& piece : path.pieces) {
    kinematics::ToolPathPoint above;  // every piece begins with a rapid, as in a finished tool path
    above.move = kinematics::MoveKind::rapid;
    view.tool_path.points.push_back(above);
    for (const planner::CcPoint& cc : piece.points) {
      kinematics::ToolPathPoint point;
      point.move = cc.link ? kinematics::MoveKind::link : kinematics::MoveKind::cut;
      point.contact_P_mm = cc.point_P_mm;
      point.normal_P = point.pose.axis_P = cc.normal_P;
      point.turn = cc.turn;
      view.tool_path.points.push_back(point);
    }
  }
  return view;
}

}  // namespace volute::app

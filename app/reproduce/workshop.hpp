// What the items of `volute reproduce` share: jobs, runs that several of them need, and where pictures go.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/compared_path.hpp"
#include "app/context.hpp"
#include "app/output_folder.hpp"
#include "app/pipeline.hpp"
#include "view/figure_sheet.hpp"
#include "view/plot.hpp"
#include "view/run_view.hpp"

namespace volute::app {

/// A whole run of one job with one strategy, without its samples.
struct MadeRun {
  JobInputs inputs;
  planner::PlanResult plan;
  sim::VerifyResult verified;
  view::RunView view;
};

class Workshop {
 public:
  Workshop(Context& context, OutputFolder figures) : context_(&context), figures_(std::move(figures)) {}

  /// Job and parts of examples/NAME.toml.
  [[nodiscard]] geometry::Result<JobInputs> inputs(const std::string& job) const;
  /// Plans, posts and verifies examples/JOB.toml with another strategy and axis; a second call gives the same run.
  geometry::Result<std::shared_ptr<const MadeRun>> run(const std::string& job, planner::Strategy strategy,
                                                       ComparedAxis axis = ComparedAxis::as_job);
  /// Plans examples/JOB.toml with another smoothing; a second call gives the same plan.
  geometry::Result<std::shared_ptr<const planner::PlanResult>> plan(const std::string& job,
                                                                    planner::Smoothing smoothing);

  /// Both write NAME.png or NAME.svg into the figures folder and return the file's name.
  [[nodiscard]] geometry::Result<std::string> keep(const std::string& name,
                                                   const std::vector<view::FigurePanel>& panels, int columns) const;
  [[nodiscard]] geometry::Result<std::string> keep(const std::string& name, const view::Plot& plot) const;
  [[nodiscard]] Context& context() const { return *context_; }

 private:
  Context* context_;
  OutputFolder figures_;
  std::map<std::string, std::shared_ptr<const MadeRun>> runs_;
  std::map<std::string, std::shared_ptr<const planner::PlanResult>> plans_;
};

/// What a strategy and a smoothing are called in the job file.
const char* strategy_name(planner::Strategy strategy);
const char* smoothing_name(planner::Smoothing smoothing);

/// The part of a job alone, to draw on.
view::RunView part_view(const JobInputs& inputs);
/// The part with a path that has no tool axes yet.
view::RunView path_view(const JobInputs& inputs, const planner::CcPath& path);

using view::add_panel;

}  // namespace volute::app

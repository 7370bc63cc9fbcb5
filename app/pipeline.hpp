// The steps that several commands share: from a job to its inputs, to a plan, to a program, to a verdict. No
// algorithms.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/context.hpp"
#include "app/job.hpp"
#include "planner/plan.hpp"
#include "post/post.hpp"
#include "sim/verify.hpp"
#include "view/run_view.hpp"

namespace volute::app {

/// Corners of the coloured mesh of a cut surface, at most.
constexpr std::size_t picture_vertices_max = 150'000;

/// What a job names, read.
struct JobInputs {
  Job job;
  kinematics::Profile profile;
  geometry::TriangleMesh surface;
  std::vector<geometry::TriangleMesh> obstacles;  ///< obstacles, then fixtures
  std::vector<std::string> obstacle_names;
  std::size_t fixture_count = 0;
  std::optional<geometry::TriangleMesh> stock;  ///< the blank, when the job gives it as a mesh
  std::vector<std::string> warnings;
};

/// What the surface must be: to be planned on, or only to be judged (then any mesh will do).
enum class SurfaceUse { planned, judged };

/// `profile`: instead of the job's own, where it is not empty.
geometry::Result<JobInputs> load_inputs(const std::filesystem::path& job_file, const Context& context,
                                        SurfaceUse use = SurfaceUse::planned, const std::string& profile = "");
/// One mesh more to keep clear of, named after its file.
geometry::Result<void> load_obstacle(const std::filesystem::path& file, JobInputs& inputs);

/// What the job says of a program's judgement: machine, tool, surface, obstacles, limits, and with material the stock.
sim::VerifyRequest verify_request(const JobInputs& inputs, bool with_material);

geometry::Result<planner::PlanResult> plan_job(const JobInputs& inputs, Progress& progress);
geometry::Result<post::PostResult> post_job(const JobInputs& inputs, const planner::PlanResult& plan);
/// `with_material`: the coloured mesh of the cut surface, and the stock, too.
geometry::Result<sim::VerifyResult> verify_job(const JobInputs& inputs, const planner::PlanResult& plan,
                                               const post::PostResult& posted, Progress& progress,
                                               bool with_material = false);
/// Everything that pictures and the page show of a run.
view::RunView run_view(const JobInputs& inputs, const planner::PlanResult& plan, const post::PostResult& posted,
                       const sim::VerifyResult& verified);

/// What a plan was allowed to do, for its C-space maps.
view::OrientationRule orientation_rule(const JobInputs& inputs, const planner::PlanResult& plan);

/// The plan as CL data, ISO 4343.
std::string cl_text(const JobInputs& inputs, const planner::PlanResult& plan);

}  // namespace volute::app

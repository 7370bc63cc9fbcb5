// Results as report.json: the keys of the contract, in its order. A key whose value is not known is absent.
#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "geometry/mesh_report.hpp"
#include "kinematics/model/control.hpp"
#include "planner/plan.hpp"
#include "post/post.hpp"
#include "sim/verify.hpp"

namespace volute::app {

using Json = nlohmann::ordered_json;

Json surface_json(const planner::SurfaceReport& surface);
Json path_json(const planner::PathReport& path);
Json orientation_json(const planner::OrientationReport& orientation);
Json run_json(const sim::RunReport& run, const kinematics::Machine& machine);
Json machining_json(const sim::CutSurfaceReport& cut);
Json collision_json(const sim::CollisionReport& collision, int planner_hits);
Json loads_json(const sim::LoadsReport& loads, const kinematics::Machine& machine);
/// `severity`: "error" for what ends with status 1, "warning" for what is told but not judged.
Json findings_json(const std::vector<sim::Finding>& findings, const kinematics::Machine& machine, const char* severity);
Json stock_json(const sim::StockOutcome& stock);
/// The lines of findings, for people.
std::vector<std::string> texts(const std::vector<sim::Finding>& findings);
Json timing_json(const std::map<std::string, double>& timing_s);
Json mesh_json(const geometry::MeshReport& report, const std::string& file);

/// The report less the seconds of the computation (timing, solve_s): the same bytes every time, whatever the computer.
Json without_seconds(Json report);

/// run.cutting_length_mm, machining_feed_mm_min, machining_feed_loss_percent, where they are known.
void put_machining_feed(Json& report, const kinematics::ToolPath& path, const sim::VerifyResult& verified);

/// The parts that a plan knows: surface, path, orientation, timing.
Json plan_json(const planner::PlanResult& plan);
/// program, run, machining, stock, collision, loads, findings, warnings, timing.
Json verify_json(const sim::VerifyResult& result, const kinematics::Profile& profile, int planner_hits);

}  // namespace volute::app

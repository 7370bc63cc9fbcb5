// The files of a simulated program, written side by side.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/output_folder.hpp"
#include "sim/verify.hpp"
#include "view/run_view.hpp"

namespace volute::app {

/// Writes what is left of the material, the view for `volute render`, the pictures and the page; returns the names of
/// the pictures. report.json is written by the caller, who then knows how long this took.
geometry::Result<std::vector<std::string>> write_result_files(const OutputFolder& out, const view::RunView& view,
                                                              const sim::VerifyResult& result,
                                                              std::optional<double> spindle_rpm);

}  // namespace volute::app

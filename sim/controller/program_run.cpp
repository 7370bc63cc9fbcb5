#include "sim/controller/control_run.hpp"

namespace volute::sim {

Result<RunReport> run_program(ProgramReader& program, const ControlSetup& setup, const SampleSink& sink,
                              const std::function<void(double)>& progress) {
  const auto by_line = [&](std::int64_t line) {
    progress(static_cast<double>(line) / static_cast<double>(setup.program_lines));
  };
  std::function<void(std::int64_t)> told;
  if (progress && setup.program_lines > 0) told = by_line;
  auto report = run_motions([&] { return program.next(); }, setup, sink, told);
  if (report) report->warnings.insert(report->warnings.end(), program.warnings().begin(), program.warnings().end());
  return report;
}

}  // namespace volute::sim

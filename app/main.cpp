// volute: from words to one command. Whatever escapes a command ends here in one line.
#include <tbb/global_control.h>

#include <cstdio>
#include <exception>
#include <new>
#include <thread>

#include "app/commands.hpp"
#include "app/exit_status.hpp"

namespace volute::app {

namespace {

struct Dispatch {
  Context& context;
  int operator()(const RunArguments& a) const { return run_command(a, context); }
  int operator()(const PlanArguments& a) const { return plan_command(a, context); }
  int operator()(const PostArguments& a) const { return post_command(a, context); }
  int operator()(const SimulateArguments& a) const { return simulate_command(a, context); }
  int operator()(const CompareArguments& a) const { return compare_command(a, context); }
  int operator()(const FieldArguments& a) const { return field_command(a, context); }
  int operator()(const InspectArguments& a) const { return inspect_command(a, context); }
  int operator()(const MachinesArguments& a) const { return machines_command(a, context); }
  int operator()(const RenderArguments& a) const { return render_command(a, context); }
  int operator()(const ReproduceArguments& a) const { return reproduce_command(a, context); }
};

int carry_out(const CommandLine& line) {
  const auto threads = line.common.threads > 0
                           ? static_cast<std::size_t>(line.common.threads)
                           : static_cast<std::size_t>(std::max(1U, std::thread::hardware_concurrency()));
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  Context context(line.common);
  return std::visit(Dispatch{context}, line.command);
}

}  // namespace

}  // namespace volute::app

int main(int count, char** words) {
  using namespace volute::app;
  try {
    const auto parsed = parse_command_line(count, words);
    if (const int* status = std::get_if<int>(&parsed)) return *status;
    return carry_out(std::get<CommandLine>(parsed));
  } catch (const std::bad_alloc&) {
    std::fputs("volute: error: out of memory; try a coarser part or fewer threads\n", stderr);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "volute: error: %s\n", error.what());
  }
  return exit_system;
}

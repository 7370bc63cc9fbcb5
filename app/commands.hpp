// One function a command; each stands in its own file and returns the exit status.
#pragma once

#include "app/arguments.hpp"
#include "app/context.hpp"

namespace volute::app {

int run_command(const RunArguments& arguments, Context& context);
int plan_command(const PlanArguments& arguments, Context& context);
int post_command(const PostArguments& arguments, Context& context);
int simulate_command(const SimulateArguments& arguments, Context& context);
int compare_command(const CompareArguments& arguments, Context& context);
int field_command(const FieldArguments& arguments, Context& context);
int inspect_command(const InspectArguments& arguments, Context& context);
int machines_command(const MachinesArguments& arguments, Context& context);
int render_command(const RenderArguments& arguments, Context& context);
int reproduce_command(const ReproduceArguments& arguments, Context& context);

}  // namespace volute::app

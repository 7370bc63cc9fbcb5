// The only source that sees CLI11: from words to arguments.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "app/arguments.hpp"
#include "app/exit_status.hpp"
#include "app/reproduce/item.hpp"
#include "geometry/number_text.hpp"

namespace volute::app {

namespace {

constexpr const char* overview =
    "Volute plans one continuous finishing path on a surface with holes, turns the tool smoothly in the machine's own\n"
    "axes, writes the program for your control, and runs that very text on a virtual machine.\n\n"
    "Start here:   volute inspect PART.stl           can this surface be machined?\n"
    "              volute machines                   which machines and controls are there?\n"
    "              volute run JOB.toml               plan, post, simulate, report\n";

constexpr const char* closing =
    "Exit status: 0 done and clean; 1 done, and the verifier found something; 2 bad usage or bad input;\n"
    "3 the machine failed us (disk, memory).\n"
    "A job file is explained in docs/job-file.md; examples stand in examples/*.toml.";

/// CLI11 keeps references to the places that it fills, so all arguments live here while it parses.
struct Places {
  CommonArguments common;
  RunArguments run;
  PlanArguments plan;
  PostArguments post;
  SimulateArguments simulate;
  CompareArguments compare;
  FieldArguments field;
  InspectArguments inspect;
  MachinesArguments machines;
  RenderArguments render;
  ReproduceArguments reproduce;
};

/// A length in mm: above 0, finite and no more than a kilometre.
CLI::Validator a_length_mm() {
  constexpr double greatest_mm = 1e6;
  return {[](const std::string& text) {
            const auto value = geometry::parse_number(text);
            return value && *value > 0.0 && *value <= greatest_mm
                       ? std::string()
                       : '"' + text + "\" must be a number of millimetres above 0 and at most 1000000";
          },
          "MM"};
}

CLI::App* add_command(CLI::App& app, CommonArguments& common, const char* name, const char* text) {
  CLI::App* command = app.add_subcommand(name, text);
  command
      ->add_option("--threads", common.threads, "Threads to use (default: all cores); the result does not depend on it")
      ->check(CLI::Range(1, 1024));
  command->add_flag("--quiet", common.quiet, "No progress on standard error");
  command->add_flag("--json", common.json, "Print one JSON value on standard output and nothing else there");
  return command;
}

void add_job_command(CLI::App* command, path& job, path& out, const char* out_text) {
  command->add_option("JOB", job, "Job file (TOML)")->required();
  command->add_option("--out", out, out_text);
}

void add_job_commands(CLI::App& app, Places& places) {
  constexpr const char* out_text = "Folder for the results (default: JOB's name without .toml, in the current folder)";
  CLI::App* run = add_command(app, places.common, "run", "Everything: plan, post, simulate, report");
  add_job_command(run, places.run.job, places.run.out, out_text);
  run->footer(
      "Example: volute run examples/mouse.toml --out mouse\n"
      "Writes toolpath.cls, plan.json, the program (.nc, or .rejected.nc when the verifier found something), "
      "report.json,\n"
      "report.html and pictures.");
  CLI::App* plan =
      add_command(app, places.common, "plan", "Tool path only: toolpath.cls (ISO 4343 CL data) and plan.json");
  add_job_command(plan, places.plan.job, places.plan.out, out_text);
  CLI::App* compare =
      add_command(app, places.common, "compare", "One part, several strategies, one table (Table 2 of [Sun2016])");
  add_job_command(compare, places.compare.job, places.compare.out, out_text);
  compare
      ->add_option(
          "--strategies", places.compare.strategies,
          "Comma separated: spiral,contour-parallel,projected-spiral,contour-offset,iso-planar; with :normal or "
          ":tilted the axis stays along the surface normal or at the job's initial tilt to the feed, as CAM "
          "systems leave it")
      ->delimiter(',');
  CLI::App* field = add_command(app, places.common, "field", "Orientation field from key axes ([Huang2016])");
  add_job_command(field, places.field.job, places.field.out, out_text);
}

void add_program_commands(CLI::App& app, Places& places) {
  CLI::App* post = add_command(app, places.common, "post", "CL data, from any CAM system, to G-code");
  post->add_option("FILE", places.post.cl_file, "CL data (ISO 4343 / APT)")->required();
  post->add_option("--machine", places.post.machine, "Profile name or path; `volute machines` lists them")->required();
  post->add_option("--out", places.post.out, "The program's file (default: beside FILE)");
  post->add_option("--setup", places.post.setup, "Part origin in the machine: x,y,z in mm (default 0,0,0)");
  post->add_option("--tolerance", places.post.tolerance_mm, "Linearization tolerance in mm")->check(a_length_mm());
  post->footer("Example: volute post impeller.cls --machine ac-head-siemens --out impeller.mpf");

  SimulateArguments& simulate_places = places.simulate;
  CLI::App* simulate = add_command(app, places.common, "simulate", "Anybody's program on the virtual machine");
  simulate->add_option("FILE", simulate_places.program, "The program")->required();
  simulate->add_option("--machine", simulate_places.machine, "Profile name or path (with --job: instead of the job's)");
  CLI::Option* job = simulate->add_option("--job", simulate_places.job,
                                          "Job file: its part, tool with holder, obstacles, fixtures, stock, setup and "
                                          "limits, for a program of any origin");
  const auto alone = [&](CLI::Option* option) { option->excludes(job); };
  alone(simulate->add_option("--part", simulate_places.part, "Design surface: what is left on it, what touches it"));
  alone(simulate->add_option("--cutter", simulate_places.cutter,
                             "ball,3  flat,5  bull,6,1  (radius, corner radius in mm)"));
  alone(simulate->add_option("--setup", simulate_places.setup,
                             "Part origin in the machine: x,y,z in mm (default 0,0,0)"));
  alone(simulate->add_option("--tool-length", simulate_places.tool_length_mm, "Tip to gauge line in mm")
            ->check(a_length_mm()));
  alone(simulate
            ->add_option("--scallop", simulate_places.scallop_mm,
                         "Material higher than this above the surface is uncut, in mm")
            ->check(a_length_mm()));
  simulate->add_option("--obstacle", simulate_places.obstacles,
                       "A mesh that nothing may touch: a clamp, a vice; in the part's frame, once for each");
  simulate->add_option("--compare", simulate_places.compare, "A second program to set beside the first");
  simulate->add_option("--out", simulate_places.out, "Folder for report.json, report.html, trace.csv and pictures");
  simulate->footer(
      "Examples: volute simulate theirs.nc --machine ac-head-fanuc --part part.stl --cutter ball,3 --out theirs\n"
      "          volute simulate theirs.nc --job mouse.toml --obstacle clamp.stl");
}

void add_other_commands(CLI::App& app, Places& places) {
  CLI::App* inspect = add_command(app, places.common, "inspect",
                                  "Loops, components, handles, triangle quality: can it be machined, and if not, why");
  inspect->add_option("PART", places.inspect.parts, "STL, OBJ, PLY or OFF")->required();
  inspect->add_option("--unit", places.inspect.unit_mm, "Length of one file unit in mm (25.4 for inches)")
      ->check(a_length_mm());
  CLI::App* machines =
      add_command(app, places.common, "machines", "The profiles, or one of them checked and explained");
  machines->add_option("NAME", places.machines.name, "Profile name or path");
  CLI::App* render = add_command(app, places.common, "render", "The pictures of a run again, from its files");
  render->add_option("DIR", places.render.folder, "Folder that `volute run` or `volute simulate` wrote")->required();
  render
      ->add_option("--point", places.render.points,
                   "Draw the C-space map at this CC point too: what is allowed there, and what blocks the rest")
      ->check(CLI::NonNegativeNumber);
  render
      ->add_option("--narrowest", places.render.narrowest,
                   "Draw the maps of so many places where the least is allowed (default: 1, where there are obstacles)")
      ->check(CLI::Range(0, 100));
  render->footer("Example: volute render obstacle-post --point 1200 --narrowest 3");
  CLI::App* reproduce = add_command(app, places.common, "reproduce",
                                    "Tables and figures of [Sun2016] and [Huang2016]: the paper's value beside ours");
  reproduce->add_option("ITEM", places.reproduce.items, "What to make (default: all, which takes minutes)");
  reproduce->add_option("--out", places.reproduce.out,
                        "Folder for reproduction.md and figures/reproduction (default: reproduction)");
  reproduce->footer("Items: " + reproduction_names() +
                    "\nExample: volute reproduce table-2 figure-20 --out docs\n"
                    "Sections of other items that stand in reproduction.md are kept.");
}

CommandArguments chosen(const CLI::App& app, const Places& places) {
  const std::string name = app.get_subcommands().front()->get_name();
  if (name == "run") return places.run;
  if (name == "plan") return places.plan;
  if (name == "post") return places.post;
  if (name == "simulate") return places.simulate;
  if (name == "compare") return places.compare;
  if (name == "field") return places.field;
  if (name == "inspect") return places.inspect;
  if (name == "machines") return places.machines;
  if (name == "render") return places.render;
  return places.reproduce;
}

}  // namespace

namespace {
/// What CLI11 says, but for a word in the command's place that is none.
std::string usage_text(const CLI::App& app, int count, char** words, const CLI::ParseError& error) {
  std::string names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (count > 1 && command->get_name() == words[1]) return error.what();
    names += (names.empty() ? "" : ", ") + command->get_name();
  }
  if (count > 1 && words[1][0] == '-') return error.what();
  return (count > 1 ? '"' + std::string(words[1]) + "\" is not a command" : "the command is missing") + ": " + names;
}
}  // namespace

std::variant<CommandLine, int> parse_command_line(int count, char** words) {
  Places places;
  CLI::App app(overview, "volute");
  app.footer(closing);
  app.set_version_flag("--version", "volute " VOLUTE_VERSION);
  app.require_subcommand(1);
  add_job_commands(app, places);
  add_program_commands(app, places);
  add_other_commands(app, places);
  try {
    app.parse(count, words);
  } catch (const CLI::Success& success) {
    app.exit(success);
    return exit_clean;
  } catch (const CLI::ParseError& error) {
    std::fprintf(stderr, "volute: usage: %s; try: volute --help\n", usage_text(app, count, words, error).c_str());
    return exit_bad_input;
  }
  return CommandLine{places.common, chosen(app, places)};
}

}  // namespace volute::app

// What the user typed, command by command.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace volute::app {

using std::filesystem::path;

struct CommonArguments {
  int threads = 0;     ///< 0: all cores
  bool quiet = false;  ///< no progress
  bool json = false;   ///< one JSON value on standard output, nothing else there
};

struct RunArguments {
  path job, out;
};
struct PlanArguments {
  path job, out;
};
struct PostArguments {
  path cl_file;
  std::string machine;
  path out;           ///< empty: beside the CL file, with the control's own extension
  std::string setup;  ///< "x,y,z" mm, "" for 0,0,0
  double tolerance_mm = 0.005;
};
struct SimulateArguments {
  path program;
  std::string machine;          ///< empty: the job's
  path job;                     ///< part, tool and holder, obstacles, fixtures, stock, setup; empty: those below
  path part;                    ///< empty: no cut surface
  std::vector<path> obstacles;  ///< and these besides the job's
  std::string cutter;           ///< "ball,3"; empty: no cut surface, no collisions
  std::string setup;
  double tool_length_mm = 100.0;
  double scallop_mm = 0.1;  ///< higher than this counts as uncut
  path compare;             ///< a second program to set beside the first; empty: none
  path out;
};
struct CompareArguments {
  path job;
  std::vector<std::string> strategies;
  path out;
};
struct FieldArguments {
  path job, out;
};
struct InspectArguments {
  std::vector<path> parts;
  double unit_mm = 1.0;
};
struct MachinesArguments {
  std::string name;
};
struct RenderArguments {
  path folder;
  std::vector<int> points;       ///< cutting points whose C-space maps are wanted
  std::optional<int> narrowest;  ///< and so many where the least is allowed; nothing: one, where there are obstacles
};
struct ReproduceArguments {
  std::vector<std::string> items;  ///< empty: all
  path out;
};

using CommandArguments =
    std::variant<RunArguments, PlanArguments, PostArguments, SimulateArguments, CompareArguments, FieldArguments,
                 InspectArguments, MachinesArguments, RenderArguments, ReproduceArguments>;

struct CommandLine {
  CommonArguments common;
  CommandArguments command;
};

/// Either a command line to carry out, or an exit status: help and version were printed (0), or the usage was wrong (2,
/// one line on standard error).
std::variant<CommandLine, int> parse_command_line(int count, char** words);

}  // namespace volute::app

// How fast programs are read, beside a plain scan for line ends in the same run (and LinuxCNC's rs274 where it is
// installed).
#include <benchmark/benchmark.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>

#include "geometry/number_text.hpp"
#include "kinematics/model/control.hpp"
#include "sim/interpreter/program.hpp"

namespace {

using volute::geometry::append_fixed;
using volute::kinematics::DialectFamily;

constexpr int blocks = 200'000;

void append_word(std::string& out, std::string_view address, double value, int decimals) {
  out += ' ';
  out += address;
  append_fixed(out, value, decimals);
}

/// A five-axis finishing pass: every block names five axes and F.
std::string cutting_blocks(DialectFamily family) {
  const bool heidenhain = family == DialectFamily::heidenhain;
  std::string out;
  for (int i = 0; i < blocks; ++i) {
    const double t = 0.001 * i;
    out += heidenhain ? std::to_string(i + 10) + " L" : "N" + std::to_string(i + 10) + " G1";
    append_word(out, "X", 100.0 * std::cos(t), 3);
    append_word(out, "Y", 100.0 * std::sin(t), 3);
    append_word(out, "Z", -0.01 * t, 3);
    append_word(out, "A", 20.0 + 5.0 * std::sin(3.0 * t), 3);
    append_word(out, "C", 10.0 * t, 3);
    if (heidenhain) out += " R0";
    append_word(out, "F", 2500.0 + i % 7, heidenhain ? 0 : 1);
    out += '\n';
  }
  return out;
}

std::string program_of(DialectFamily family) {
  switch (family) {
    case DialectFamily::siemens:
      return "N1 G90 G94 G71\nN2 TRAORI\nN3 ORIAXES\n" + cutting_blocks(family) + "N9 TRAFOOF\nM30\n";
    case DialectFamily::heidenhain:
      return "0 BEGIN PGM B MM\n1 TOOL CALL 1 Z S5000\n2 M128\n" + cutting_blocks(family) + "9 M129\n10 END PGM B MM\n";
    case DialectFamily::fanuc:
      return "%\nO1\nG21 G90 G94\nG0 G43.4 H1 X0. Y0. Z0.\n" + cutting_blocks(family) + "G49\nM30\n%\n";
    default:
      return "G21 G90 G94\nG0 X0 Y0 Z0\n" + cutting_blocks(family) + "M2\n";
  }
}

volute::kinematics::Machine machine() {
  volute::kinematics::Machine out;
  for (std::size_t i = 0; i < 5; ++i) out.axes[i].letter = "XYZAC"[i];
  return out;
}

void read_program(benchmark::State& state, DialectFamily family) {
  const std::string text = program_of(family);
  volute::kinematics::Control control;
  control.family = family;
  control.tcp = true;
  const auto model = machine();
  for (auto _ : state) {
    volute::sim::ProgramReader reader(text, "bench.nc", model, control);
    std::int64_t motions = 0;
    while (true) {
      auto next = reader.next();
      if (!next) {
        state.SkipWithError(next.error().message.c_str());
        return;
      }
      if (!*next) break;
      ++motions;
    }
    if (motions < blocks) state.SkipWithError("motions are missing");
  }
  state.SetItemsProcessed(state.iterations() * blocks);
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(text.size()));
}

void scan_lines(benchmark::State& state) {
  const std::string text = program_of(DialectFamily::fanuc);
  for (auto _ : state) {
    std::int64_t lines = 0;
    const char* at = text.data();
    const char* end = at + text.size();
    while (at < end) {
      const void* found = std::memchr(at, '\n', static_cast<std::size_t>(end - at));
      if (found == nullptr) break;
      at = static_cast<const char*>(found) + 1;
      ++lines;
    }
    benchmark::DoNotOptimize(lines);
  }
  state.SetItemsProcessed(state.iterations() * blocks);
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(text.size()));
}

void read_by_rs274(benchmark::State& state) {
  if (std::system("command -v rs274 >/dev/null 2>&1") != 0) {
    state.SkipWithError("rs274 (Debian package linuxcnc-uspace) is not installed");
    return;
  }
  const auto folder = std::filesystem::temp_directory_path() / "volute-interpreter-bench";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "p.ngc") << program_of(DialectFamily::linuxcnc);
  std::ofstream(folder / "tool.tbl") << "T1 P1 Z0 D10\n";
  std::ofstream(folder / "params.var");
  const std::string in =
      "cd '" + folder.string() + "' && HOME=. rs274 -g -n 2 -t tool.tbl -v params.var p.ngc >/dev/null 2>&1";
  for (auto _ : state)
    if (std::system(in.c_str()) != 0) state.SkipWithError("rs274 refused the program");
  state.SetItemsProcessed(state.iterations() * blocks);
  std::filesystem::remove_all(folder);
}

}  // namespace

BENCHMARK(scan_lines)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(read_program, linuxcnc, DialectFamily::linuxcnc)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(read_program, fanuc, DialectFamily::fanuc)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(read_program, siemens, DialectFamily::siemens)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(read_program, heidenhain, DialectFamily::heidenhain)->Unit(benchmark::kMillisecond);
BENCHMARK(read_by_rs274)->Unit(benchmark::kMillisecond)->UseRealTime();

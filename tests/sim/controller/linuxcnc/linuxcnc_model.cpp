// Runs a G-code file on the model of LinuxCNC's planner, on the plain five-axis machine that the comparison uses.
//   linuxcnc_model PROGRAM.ngc [SAMPLES.csv]
// Standard output: servo cycles from the first to the last motion of an axis. SAMPLES.csv: x,y,z,a,c a cycle, mm and
// degrees, from standstill on.
#include <cstdio>
#include <fstream>

#include "geometry/file.hpp"
#include "geometry/number_text.hpp"
#include "tests/sim/controller/linuxcnc/model_run.hpp"

int main(int argc, char** argv) {
  if (argc < 2 || argc > 3) {
    std::fputs("usage: linuxcnc_model PROGRAM.ngc [SAMPLES.csv]\n", stderr);
    return 2;
  }
  const auto text = volute::geometry::read_file(argv[1]);
  if (!text) {
    std::fprintf(stderr, "%s\n", text.error().message.c_str());
    return 2;
  }
  const auto run = volute::sim::test::run_on_model(*text);
  if (!run) {
    std::fprintf(stderr, "%s\n", run.error().message.c_str());
    return 2;
  }
  std::printf("%lld\n", static_cast<long long>(run->cycles));
  if (argc < 3) return 0;
  std::string csv = "x,y,z,a,c\n";
  for (const auto& position : run->positions)
    for (std::size_t i = 0; i < position.size(); ++i) {
      volute::geometry::append_fixed(csv, position[i], 9);
      csv += i + 1 < position.size() ? ',' : '\n';
    }
  return volute::geometry::write_file(argv[2], csv) ? 0 : 3;
}

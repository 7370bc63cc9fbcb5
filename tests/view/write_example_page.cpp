// Writes the pages that the browser test opens: FOLDER/example.html, foreign.html, large.html, and what they must show
// as expected.json.
#include <cstdlib>
#include <filesystem>
#include <string>

#include "geometry/file.hpp"
#include "geometry/number_text.hpp"
#include "tests/view/example_run.hpp"

namespace {

using namespace volute::view;

bool write_page(const RunView& view, const std::filesystem::path& file) {
  return write_report_html(view, file).has_value();
}

RunView foreign_run() {
  RunView view = example_run({});
  view.surface_P = {};
  view.obstacles_P.clear();
  view.obstacle_names.clear();
  view.tool_path = {};
  view.cut.reset();
  view.report_json.clear();
  view.findings.clear();
  return view;
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) return EXIT_FAILURE;
  const std::filesystem::path folder = arguments[1];
  const ExampleSize size;
  const RunView view = example_run(size);
  const int spike = spike_sample(size);
  const std::string expected =
      "{\"spike_line\":" + std::to_string(line_of_sample(size, spike)) +
      ",\"spike_time\":" + volute::geometry::shortest_text(view.trace.samples[static_cast<std::size_t>(spike)].time_s) +
      ",\"end_time\":" + volute::geometry::shortest_text(view.trace.samples.back().time_s) +
      ",\"finding_line\":" + std::to_string(view.findings.front().line) + "}\n";
  const bool written = write_page(view, folder / "example.html") &&
                       write_page(foreign_run(), folder / "foreign.html") &&
                       write_page(example_run({1'000'000, 100'000, 350}), folder / "million.html") &&
                       write_page(example_run({200'000, 100'000, 120}), folder / "large.html") &&
                       volute::geometry::write_file(folder / "expected.json", expected).has_value();
  return written ? EXIT_SUCCESS : EXIT_FAILURE;
}

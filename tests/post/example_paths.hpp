// The tool paths of the examples, as `volute plan examples/NAME.toml` wrote them; scripts/update-example-programs makes
// them again.
#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "geometry/check.hpp"
#include "geometry/file.hpp"
#include "post/cl_data.hpp"
#include "post/post.hpp"

namespace volute::post::testing {

inline std::vector<std::string> example_names() {
  return {"arched-strip",  "disc-wavy",     "disc-with-hole", "half-sphere",       "mouse",
          "obstacle-post", "obstacle-wall", "plate-one-hole", "plate-three-holes", "plate-two-holes"};
}

/// The examples' own machine under every control.
inline std::vector<std::string> example_profiles() {
  return {"ac-head-linuxcnc", "ac-head-linuxcnc-tcp",   "ac-head-fanuc",      "ac-head-fanuc-vector",
          "ac-head-siemens",  "ac-head-siemens-vector", "ac-head-heidenhain", "ac-head-heidenhain-vector",
          "ac-head-haas",     "ac-head-mazak",          "ac-head-g93"};
}

inline PostRequest example_request(const std::string& example) {
  const auto file = std::filesystem::path(VOLUTE_SOURCE_DIR) / "tests/post/examples" / (example + ".cls");
  const auto text = geometry::read_file(file);
  VOLUTE_CHECK(text.has_value(), example, text ? "" : text.error().message);
  auto data = parse_cl(*text, file.filename().string());
  VOLUTE_CHECK(data.has_value(), example, data ? "" : data.error().message);
  PostRequest request;
  request.program_name = example;
  request.path = std::move(data->path);
  request.tool = data->tool;
  request.spindle_rpm = data->spindle_rpm;
  request.coolant = data->coolant;
  return request;
}

}  // namespace volute::post::testing

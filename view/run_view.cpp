// The pictures of a run as a table of contents: each is written if the view has what it needs.
#include "view/run_view.hpp"

#include <tbb/parallel_for.h>

#include <functional>

#include "geometry/file.hpp"
#include "view/axis_plots.hpp"
#include "view/pictures.hpp"
#include "view/trace_store.hpp"

namespace volute::view {

namespace {

/// One picture: its name, whether the view has data for it, and its bytes.
struct PictureMaker {
  const char* name;
  bool possible;
  std::function<Result<std::string>()> bytes;
};

std::function<Result<std::string>()> png(const RunView& view, Result<Image> (*draw)(const RunView&)) {
  return [&view, draw]() -> Result<std::string> {
    const auto image = draw(view);
    if (!image) return tl::unexpected(image.error());
    return png_bytes(*image);
  };
}

std::function<Result<std::string>()> svg(const RunView& view, Plot (*draw)(const RunView&)) {
  return [&view, draw]() -> Result<std::string> { return svg_text(draw(view)); };
}

template <PathColour colour>
Result<Image> path_by(const RunView& view) {
  return coloured_path_picture(view, colour);
}
Result<Image> path_by_turn(const RunView& view) { return path_picture(view); }
Result<Image> orientations(const RunView& view) { return orientation_picture(view); }
Result<Image> map(const RunView& view) { return map_picture(view); }
Result<Image> machined(const RunView& view) { return machined_picture(view); }
Result<Image> whole_machine(const RunView& view) { return machine_picture(view, shown_moment_s(view), false); }
Result<Image> near_machine(const RunView& view) { return machine_picture(view, shown_moment_s(view), true); }

bool has_masses(const RunView& view) {
  for (const kinematics::Axis& axis : view.profile->machine.axes)
    if (axis.moved_mass_kg > 0.0) return true;
  return false;
}

}  // namespace

Result<std::vector<std::string>> write_pictures(const RunView& given, const std::filesystem::path& folder) {
  RunView view = given;
  view.trace = trace_as_stored(given.trace);
  const bool surface = !view.surface_P.triangles.empty();
  const bool planned = !view.tool_path.points.empty();
  const bool trace = view.profile.has_value() && !view.trace.samples.empty();
  const bool deviation =
      surface && view.cut && view.cut->vertex_deviation_mm.size() == view.surface_P.vertices_mm.size();
  const std::vector<PictureMaker> makers{
      {"path.png", surface || trace, png(view, path_by_turn)},
      {"path-feed.png", trace, png(view, path_by<PathColour::feed>)},
      {"path-limit.png", trace, png(view, path_by<PathColour::limit>)},
      {"path-tilt.png", planned, png(view, path_by<PathColour::tilt>)},
      {"orientation.png", planned, png(view, orientations)},
      {"map.png", !view.map_triangles.empty() || !view.map_guide_lines.empty(), png(view, map)},
      {"machined.png", deviation, png(view, machined)},
      {"machine.png", trace && !view.profile->machine.shapes.empty(), png(view, whole_machine)},
      {"machine-close.png", trace, png(view, near_machine)},
      {"rotary-axes.svg", trace, svg(view, rotary_plot)},
      {"linear-axes.svg", trace, svg(view, linear_plot)},
      {"feed.svg", trace, svg(view, feed_plot)},
      {"path.svg", trace, svg(view, path_plot)},
      {"loads.svg", trace && has_masses(view), svg(view, loads_plot)},
      {"deviation.svg", view.cut && !view.cut->histogram.empty(), svg(view, deviation_plot)},
  };
  std::vector<Result<void>> stored(makers.size());
  tbb::parallel_for(std::size_t{0}, makers.size(), [&](std::size_t i) {
    if (!makers[i].possible) return;
    const auto bytes = makers[i].bytes();
    stored[i] = bytes ? geometry::write_file(folder / makers[i].name, *bytes) : tl::unexpected(bytes.error());
  });
  std::vector<std::string> written;
  for (std::size_t i = 0; i < makers.size(); ++i) {
    if (!stored[i]) return tl::unexpected(stored[i].error());
    if (makers[i].possible) written.emplace_back(makers[i].name);
  }
  return written;
}

}  // namespace volute::view

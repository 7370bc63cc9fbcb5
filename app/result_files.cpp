#include "app/result_files.hpp"

#include <tbb/parallel_invoke.h>

#include "app/cspace_pictures.hpp"
#include "app/material_files.hpp"

namespace volute::app {

geometry::Result<std::vector<std::string>> write_result_files(const OutputFolder& out, const view::RunView& view,
                                                              const sim::VerifyResult& result,
                                                              std::optional<double> spindle_rpm) {
  geometry::Result<void> material, stored, page;
  geometry::Result<std::vector<std::string>> pictures, maps;
  tbb::parallel_invoke([&] { material = write_material(result, view.tool.cutter, spindle_rpm, out); },
                       [&] { stored = view::save_view(view, out.folder()); },
                       [&] { pictures = view::write_pictures(view, out.folder()); },
                       [&] { maps = write_cspace_pictures(view, usual_choice(view), out.folder()); },
                       [&] { page = view::write_report_html(view, out.file("report.html")); });
  for (const auto* written : {&material, &stored, &page})
    if (!*written) return tl::unexpected(written->error());
  if (!pictures) return pictures;
  if (!maps) return maps;
  pictures->insert(pictures->end(), maps->begin(), maps->end());
  return pictures;
}

}  // namespace volute::app

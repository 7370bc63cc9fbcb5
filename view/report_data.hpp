// What the page knows of a run, in parts that it can open one after the other.
#pragma once

#include <string>
#include <vector>

#include "view/run_view.hpp"

namespace volute::view {

/// One part of the page's data: plain JSON, or a zlib stream as base64.
struct PagePart {
  std::string id;
  std::string text;
  bool packed = false;
};

/// report: the numbers and findings (JSON). scene: meshes and planned path. trace: what the axes did. program: its
/// text. Deterministic; no seconds of the computation.
std::vector<PagePart> page_parts(const RunView& view);

}  // namespace volute::view

// One page for several runs of one part: a table with a row a run, and pictures of each.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "geometry/result.hpp"
#include "view/figure_sheet.hpp"

namespace volute::view {

struct ComparedRun {
  std::string name;
  bool passed = false;
  std::string verdict;             ///< one line; why there is no run, when there is none
  std::vector<std::string> cells;  ///< by Comparison::heading; empty: no run
  std::string report_link;         ///< to the run's own page, from the folder of this one; empty: none
  std::vector<FigurePanel> pictures;
};

struct Comparison {
  std::string title;
  std::vector<std::string> heading;  ///< of the columns behind the name
  std::vector<ComparedRun> runs;
  std::string legend;  ///< what the columns mean, below the table
};

/// Self-contained but for the links to the runs' own pages; needs neither network nor script. Deterministic. Requires:
/// as many cells a run as in the heading (or none).
geometry::Result<void> write_comparison_html(const Comparison& comparison, const std::filesystem::path& file);

}  // namespace volute::view

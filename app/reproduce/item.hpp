// One table or figure of a paper, made again: what is made, and what is said about it.
#pragma once

#include <string>
#include <vector>

#include "app/reproduce/workshop.hpp"

namespace volute::app {

/// Rows of equal length; the first is the heading.
using TextTable = std::vector<std::vector<std::string>>;

/// What docs/reproduction.md says of one item.
struct ItemPage {
  std::string opening;                ///< what the paper shows, and what is shown here
  std::vector<std::string> pictures;  ///< file names in the figures folder
  std::vector<TextTable> tables;
  std::vector<std::string> assumed;  ///< because the paper does not say
  std::vector<std::string> remarks;  ///< what differs, and why the paper's own number does not come out
};

struct Item {
  const char* name;    ///< as typed: "table-2"
  const char* source;  ///< "[Sun2016] Table 2"
  const char* title;
  geometry::Result<ItemPage> (*make)(Workshop& shop, const std::string& name);
};

/// All of them in the order of the document.
const std::vector<Item>& reproduction_items();
/// "table-1, table-2, ...", for help and errors.
std::string reproduction_names();

// [Sun2016]: the map
geometry::Result<ItemPage> boundary_tree(Workshop& shop, const std::string& name);
geometry::Result<ItemPage> bridge_by_slicing(Workshop& shop, const std::string& name);
geometry::Result<ItemPage> connected_boundary_page(Workshop& shop, const std::string& name);
geometry::Result<ItemPage> map_and_part(Workshop& shop, const std::string& name);
geometry::Result<ItemPage> guide_lines(Workshop& shop, const std::string& name);
// [Sun2016]: paths
geometry::Result<ItemPage> paths_one_hole(Workshop& shop, const std::string& name);
geometry::Result<ItemPage> paths_two_holes(Workshop& shop, const std::string& name);
geometry::Result<ItemPage> paths_three_holes(Workshop& shop, const std::string& name);
geometry::Result<ItemPage> two_patches(Workshop& shop, const std::string& name);
// [Sun2016]: machining
geometry::Result<ItemPage> process_parameters(Workshop& shop, const std::string& name);
geometry::Result<ItemPage> strategies_compared(Workshop& shop, const std::string& name);
geometry::Result<ItemPage> strategies_two_holes(Workshop& shop, const std::string& name);
geometry::Result<ItemPage> strategies_mouse(Workshop& shop, const std::string& name);
geometry::Result<ItemPage> machined_two_holes(Workshop& shop, const std::string& name);
geometry::Result<ItemPage> machined_mouse(Workshop& shop, const std::string& name);
// [Sun2016]: orientation
geometry::Result<ItemPage> orientations_beside_obstacle(Workshop& shop, const std::string& name);
geometry::Result<ItemPage> rotary_axes_compared(Workshop& shop, const std::string& name);
// past both
geometry::Result<ItemPage> allowed_orientations(Workshop& shop, const std::string& name);
// [Huang2016]
geometry::Result<ItemPage> open_bases(Workshop& shop, const std::string& name);
geometry::Result<ItemPage> half_open_bases(Workshop& shop, const std::string& name);
geometry::Result<ItemPage> strip_keys(Workshop& shop, const std::string& name);
geometry::Result<ItemPage> strip_fields(Workshop& shop, const std::string& name);
geometry::Result<ItemPage> strip_indexes(Workshop& shop, const std::string& name);
geometry::Result<ItemPage> pin_keys(Workshop& shop, const std::string& name);
geometry::Result<ItemPage> pin_field(Workshop& shop, const std::string& name);
geometry::Result<ItemPage> pin_indexes(Workshop& shop, const std::string& name);
geometry::Result<ItemPage> half_sphere_fields(Workshop& shop, const std::string& name);
geometry::Result<ItemPage> half_sphere_indexes(Workshop& shop, const std::string& name);

}  // namespace volute::app

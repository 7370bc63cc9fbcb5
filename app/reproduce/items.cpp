#include "app/reproduce/item.hpp"

namespace volute::app {

const std::vector<Item>& reproduction_items() {
  static const std::vector<Item> items{
      {"figure-1", "[Sun2016] Fig. 1", "The boundaries as a tree", boundary_tree},
      {"figure-2", "[Sun2016] Fig. 2", "A bridge by slicing the surface", bridge_by_slicing},
      {"figure-3", "[Sun2016] Fig. 3", "All boundaries as one curve", connected_boundary_page},
      {"figure-4", "[Sun2016] Fig. 4", "The map of the surface onto a rectangle", map_and_part},
      {"figure-5", "[Sun2016] Fig. 5", "Guide lines and paths", guide_lines},
      {"figure-11", "[Sun2016] Fig. 11", "Paths on a surface with one hole", paths_one_hole},
      {"figure-12", "[Sun2016] Fig. 12", "Paths on a surface with two holes", paths_two_holes},
      {"figure-13", "[Sun2016] Fig. 13", "Paths on a surface with three holes", paths_three_holes},
      {"figure-14", "[Sun2016] Fig. 14", "A surface of two patches", two_patches},
      {"table-1", "[Sun2016] Table 1", "Parameters of path and machining", process_parameters},
      {"table-2", "[Sun2016] Table 2", "Three kinds of path compared", strategies_compared},
      {"figure-15", "[Sun2016] Fig. 15", "Three kinds of path on the surface with two holes", strategies_two_holes},
      {"figure-16", "[Sun2016] Fig. 16", "Three kinds of path on the mouse", strategies_mouse},
      {"figure-17", "[Sun2016] Fig. 17", "The surface with two holes, machined", machined_two_holes},
      {"figure-18", "[Sun2016] Fig. 18", "The mouse, machined", machined_mouse},
      {"figure-19", "[Sun2016] Fig. 19", "Tool orientations beside an obstacle", orientations_beside_obstacle},
      {"figure-20", "[Sun2016] Fig. 20", "What A and C do", rotary_axes_compared},
      {"allowed-orientations", "Beside [Sun2016] Fig. 19", "What is allowed beside the obstacle", allowed_orientations},
      {"huang-figure-3", "[Huang2016] Fig. 3", "Basis functions for open surfaces", open_bases},
      {"huang-figure-6", "[Huang2016] Fig. 6", "Basis functions for half-open surfaces", half_open_bases},
      {"huang-figure-7", "[Huang2016] Fig. 7", "Case 1: part and key axes", strip_keys},
      {"huang-figure-8", "[Huang2016] Fig. 8", "Case 1: fields", strip_fields},
      {"huang-table-1", "[Huang2016] Table 1", "Case 1: indexes", strip_indexes},
      {"huang-figure-9", "[Huang2016] Fig. 9", "Case 2: part and key axes", pin_keys},
      {"huang-figure-10", "[Huang2016] Fig. 10", "Case 2: fields", pin_field},
      {"huang-table-2", "[Huang2016] Table 2", "Case 2: indexes", pin_indexes},
      {"huang-figure-11", "[Huang2016] Fig. 11", "Case 3: fields", half_sphere_fields},
      {"huang-table-3", "[Huang2016] Table 3", "Case 3: indexes", half_sphere_indexes},
  };
  return items;
}

std::string reproduction_names() {
  std::string names;
  for (const Item& item : reproduction_items()) names += (names.empty() ? "" : ", ") + std::string(item.name);
  return names;
}

}  // namespace volute::app

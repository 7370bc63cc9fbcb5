// Drawings of a path for docs/paths.md: seen along z, coloured by interval ratio; and its map with the guide lines.
#pragma once

#include <filesystem>
#include <string>

#include "geometry/mesh.hpp"
#include "planner/path/cc_path.hpp"

namespace volute::bench {

struct PathPicture {
  std::string name;  ///< of the files, without ending
  const geometry::TriangleMesh& surface;
  kinematics::Cutter cutter;
  planner::PathOptions options;
  const planner::CcPathResult& result;
};

/// NAME.svg: boundary loops, bridges (dashed), the path coloured by the distance to its next turn over the allowed one
/// (thin grey where there is no next turn). NAME-map.svg, where the method has a map: its guide lines. False when a
/// file cannot be written.
bool write_pictures(const PathPicture& picture, const std::filesystem::path& folder);

}  // namespace volute::bench

// Joins the boundaries of a surface with holes: tree, bridges, segments and the single boundary curve ([Sun2016] 2.1
// to 2.3).
#pragma once

#include <vector>

#include "geometry/mesh.hpp"
#include "geometry/result.hpp"
#include "planner/surface/root_child.hpp"

namespace volute::planner {

using geometry::Index;
using geometry::Result;

/// A bridge between two boundary curves, [Sun2016] definition 1 (OBridge). Every bridge has its opposite: the same
/// points backwards.
struct Bridge {
  Index from_curve = 0, to_curve = 0;  ///< numbers of boundary curves (Bcurve1, Bcurve2); parent first
  std::vector<Index> vertices;         ///< Pset: from the parent's vertex to the child's
  bool sliced = true;                  ///< false: slicing stuck and the bridge runs along edges
};

/// The same bridge in the other direction.
Bridge opposite(const Bridge& bridge);

/// A stretch of a boundary curve between two bridge ends, [Sun2016] definition 2 (OSegment), along the curve's
/// direction.
struct Segment {
  Index curve = 0;
  Index first = 0, last = 0;  ///< vertices (Epoint1, Epoint2); equal: the whole curve
};

/// The bridges divide every boundary curve into segments. Requires: each bridge end lies on its curve, no vertex ends
/// two bridges. Segments come by curve, each curve from its first bridge end on.
std::vector<Segment> segments_between(const std::vector<geometry::BoundaryLoop>& curves,
                                      const std::vector<Bridge>& bridges);

/// The single closed boundary curve of [Sun2016] 2.3: along the outer curve (number 0) from its first vertex; at a
/// bridge's end across to the child, around it, children first, and back over the opposite bridge. Each bridge vertex
/// comes twice. Requires: the bridges are a tree with root 0. Property: it equals the boundary loop of the surface cut
/// along all bridges.
std::vector<Index> connected_boundary(const std::vector<geometry::BoundaryLoop>& curves,
                                      const std::vector<Bridge>& bridges);

}  // namespace volute::planner

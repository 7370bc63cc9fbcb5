#include "planner/surface/boundary_tree.hpp"

#include <algorithm>
#include <map>

#include "geometry/check.hpp"

namespace volute::planner {

using geometry::BoundaryLoop;

namespace {

/// Where a bridge leaves a curve: the bridge as seen from that curve.
using BridgeEnds = std::map<Index, Bridge>;

/// Bridge ends by vertex, each bridge directed away from the vertex.
BridgeEnds ends_of(const std::vector<Bridge>& bridges) {
  BridgeEnds ends;
  for (const Bridge& b : bridges) {
    const bool first_free = ends.emplace(b.vertices.front(), b).second;
    const bool last_free = ends.emplace(b.vertices.back(), opposite(b)).second;
    VOLUTE_CHECK(first_free && last_free, b.vertices.front(), b.vertices.back());
  }
  return ends;
}

std::size_t place_in(const BoundaryLoop& curve, Index vertex) {
  const auto found = std::find(curve.vertices.begin(), curve.vertices.end(), vertex);
  VOLUTE_CHECK(found != curve.vertices.end(), vertex);
  return static_cast<std::size_t>(found - curve.vertices.begin());
}

/// Appends curve `number` once around from place `start`, its children first; the start comes at both ends when
/// `close`.
void walk_curve(const std::vector<BoundaryLoop>& curves, const BridgeEnds& ends, Index number, std::size_t start,
                bool close, std::vector<Index>& out) {
  const std::vector<Index>& curve = curves[static_cast<std::size_t>(number)].vertices;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const Index v = curve[(start + i) % curve.size()];
    out.push_back(v);
    const auto bridge = ends.find(v);
    if (bridge == ends.end() || (close && i == 0)) continue;  // the way back to the parent is taken last
    const std::vector<Index>& across = bridge->second.vertices;
    out.insert(out.end(), across.begin() + 1, across.end() - 1);
    const Index child = bridge->second.to_curve;
    walk_curve(curves, ends, child, place_in(curves[static_cast<std::size_t>(child)], across.back()), true, out);
    out.insert(out.end(), across.rbegin() + 1, across.rend());
  }
  if (close) out.push_back(curve[start]);
}

}  // namespace

Bridge opposite(const Bridge& bridge) {
  return {bridge.to_curve, bridge.from_curve, {bridge.vertices.rbegin(), bridge.vertices.rend()}, bridge.sliced};
}

std::vector<Segment> segments_between(const std::vector<BoundaryLoop>& curves, const std::vector<Bridge>& bridges) {
  const BridgeEnds ends = ends_of(bridges);
  std::vector<Segment> segments;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    std::vector<Index> cuts;
    for (Index v : curves[c].vertices)
      if (ends.contains(v)) cuts.push_back(v);
    for (std::size_t i = 0; i < cuts.size(); ++i)
      segments.push_back({static_cast<Index>(c), cuts[i], cuts[(i + 1) % cuts.size()]});
  }
  return segments;
}

std::vector<Index> connected_boundary(const std::vector<BoundaryLoop>& curves, const std::vector<Bridge>& bridges) {
  std::vector<Index> boundary;
  walk_curve(curves, ends_of(bridges), 0, 0, false, boundary);
  return boundary;
}

}  // namespace volute::planner

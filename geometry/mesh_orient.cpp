#include <string>

#include "geometry/edge_groups.hpp"
#include "geometry/index.hpp"
#include "geometry/mesh_io.hpp"

namespace volute::geometry {

namespace {

enum class Side : char { unknown, kept, turned };

/// The neighbour across each halfedge where exactly two triangles meet.
std::vector<Index> paired_halfedges(const TriangleMesh& mesh) {
  const EdgeGroups edges = group_edges(mesh);
  std::vector<Index> partner(3 * mesh.triangles.size(), no_index);
  for (Index e = 0; e < edges.count(); ++e) {
    const auto group = edges.group(e);
    if (group.size() != 2) continue;
    partner[at(group[0])] = group[1];
    partner[at(group[1])] = group[0];
  }
  return partner;
}

/// Gives every triangle that edges connect to the seed a side relative to it. Returns the first triangle that would
/// need both.
Index spread_side(const TriangleMesh& mesh, const std::vector<Index>& partner, Index seed, std::vector<Side>& side,
                  std::vector<Index>& members) {
  members.assign(1, seed);
  side[at(seed)] = Side::kept;
  for (std::size_t next = 0; next < members.size(); ++next) {
    const Index t = members[next];
    for (Index h = 3 * t; h < 3 * t + 3; ++h) {
      if (partner[at(h)] == no_index) continue;
      const Index neighbour = halfedge_triangle(partner[at(h)]);
      const bool agree = origin(mesh, h) != origin(mesh, partner[at(h)]);
      const Side wanted = agree == (side[at(t)] == Side::kept) ? Side::kept : Side::turned;
      if (side[at(neighbour)] == Side::unknown) {
        side[at(neighbour)] = wanted;
        members.push_back(neighbour);
      } else if (side[at(neighbour)] != wanted) {
        return neighbour;
      }
    }
  }
  return no_index;
}

}  // namespace

Result<Index> make_orientation_consistent(TriangleMesh& mesh) {
  const std::vector<Index> partner = paired_halfedges(mesh);
  std::vector<Side> side(mesh.triangles.size(), Side::unknown);
  std::vector<Index> members;
  std::vector<Index> to_turn;
  for (Index seed = 0; seed < static_cast<Index>(side.size()); ++seed) {
    if (side[at(seed)] != Side::unknown) continue;
    const Index clash = spread_side(mesh, partner, seed, side, members);
    if (clash != no_index)
      return bad_input("mesh-not-orientable",
                       "triangle " + std::to_string(clash) +
                           ": the surface has one side only (a Moebius band); no tool can be said to stand outside it");
    std::size_t turned = 0;
    for (const Index t : members) turned += side[at(t)] == Side::turned ? 1 : 0;
    const Side minority = 2 * turned <= members.size() ? Side::turned : Side::kept;
    for (const Index t : members)
      if (side[at(t)] == minority) to_turn.push_back(t);
  }
  for (const Index t : to_turn) std::swap(mesh.triangles[at(t)][1], mesh.triangles[at(t)][2]);
  return static_cast<Index>(to_turn.size());
}

}  // namespace volute::geometry

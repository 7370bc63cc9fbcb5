#include "sim/collision_scene.hpp"

#include <algorithm>
#include <cstdlib>

namespace volute::sim {
namespace {

using kinematics::ConeSegment;
using kinematics::Machine;

/// What a body is, and which body of the chain it goes with: 0 carries the workpiece, axis_count the tool.
enum class Role { cutter, cutter_core, tool, part, stock, obstacle, link };
struct Entry {
  Role role;
  int place;
};

/// Body `k + 1` of the chain follows axis chain[k] on the way from workpiece to tool; the base is body table_axes.
int place_of_link(const Machine& machine, int link) {
  if (link < 0) return machine.table_axes;
  const auto found = std::find(machine.chain.begin(), machine.chain.end(), link);
  const int k = static_cast<int>(found - machine.chain.begin());
  return k < machine.table_axes ? k : k + 1;
}

class SceneBuilder {
 public:
  SceneBuilder(const CollisionScene& scene, const Machine& machine, const kinematics::Setup& setup)
      : scene_(scene), machine_(machine), setup_(setup) {}

  CollisionPairs build() {
    add_tool();
    add_part();
    add_links();
    for (std::size_t a = 0; a < entries_.size(); ++a) {
      for (std::size_t b = a + 1; b < entries_.size(); ++b) add_pair(a, b);
    }
    return std::move(out_);
  }

 private:
  void add(Role role, int place, CollisionBody body, std::function<Transform(const AxisVector&)> X_M) {
    if (body.empty()) return;
    entries_.push_back({role, place});
    out_.bodies.push_back({std::make_shared<const CollisionBody>(std::move(body)), std::move(X_M)});
  }

  static CollisionBody single(std::string name, std::unique_ptr<ConvexPiece> piece) {
    std::vector<std::unique_ptr<ConvexPiece>> pieces;
    pieces.push_back(std::move(piece));
    return {std::move(name), std::move(pieces)};
  }

  /// How much smaller the cutter is that may not meet the part.
  [[nodiscard]] double inset_mm() const {
    const kinematics::Cutter& cutter = scene_.tool.cutter;
    return std::min(
        {scene_.gouge_tolerance_mm + scene_.state_error_mm, 0.5 * cutter.radius_mm, 0.25 * cutter.length_mm});
  }

  void add_tool() {
    const kinematics::Tool& tool = scene_.tool;
    const auto X_M = [&machine = machine_, length_mm = tool.gauge_length_mm](const AxisVector& q) {
      return kinematics::forward(machine, length_mm, q);
    };
    constexpr int place = kinematics::axis_count;
    add(Role::cutter, place, single("cutter", cutter_piece(tool.cutter, 0.0)), X_M);
    add(Role::cutter_core, place, single("cutter", cutter_piece(tool.cutter, inset_mm())), X_M);
    if (tool.stick_out_mm > tool.cutter.length_mm) {
      const ConeSegment shank{tool.shank_radius_mm, tool.shank_radius_mm, tool.cutter.length_mm,
                              tool.stick_out_mm - tool.cutter.length_mm};
      add(Role::tool, place, single("shank", frustum_piece(shank)), X_M);
    }
    std::vector<std::unique_ptr<ConvexPiece>> holder;
    for (const ConeSegment& segment : tool.holder) holder.push_back(frustum_piece(segment));
    add(Role::tool, place, CollisionBody("holder", std::move(holder)), X_M);
  }

  void add_part() {
    const auto X_M = [X_MP = setup_.part_in_machine](const AxisVector&) { return X_MP; };
    add(Role::part, 0, CollisionBody::of_triangles("part", scene_.part_P), X_M);
    add(Role::stock, 0, CollisionBody::of_components("stock", scene_.stock_P), X_M);
    for (std::size_t i = 0; i < scene_.obstacles_P.size(); ++i) {
      const std::string name =
          i < scene_.obstacle_names.size() ? scene_.obstacle_names[i] : "obstacle " + std::to_string(i + 1);
      add(Role::obstacle, 0, CollisionBody::of_components(name, scene_.obstacles_P[i]), X_M);
    }
  }

  void add_links() {
    for (const auto& shape : machine_.shapes) {
      const int link = shape.link;
      add(Role::link, place_of_link(machine_, link), CollisionBody::of_components(shape.name, shape.mesh_M),
          [&machine = machine_, link](const AxisVector& q) { return kinematics::link_motion(machine, link, q); });
    }
  }

  void add_pair(std::size_t a, std::size_t b) {
    const Entry &x = entries_[a], &y = entries_[b];
    if (x.place == y.place) return;  // they stand still to each other
    if (x.role == Role::link && y.role == Role::link && std::abs(x.place - y.place) <= 1) return;
    if (y.role == Role::stock && x.role != Role::link) return;  // the tool is held against what is left of it
    if (x.role == Role::stock && y.role != Role::link) return;
    const bool with_part = y.role == Role::part;
    if (x.role == Role::cutter && with_part) return;  // its core is looked at instead
    if (x.role == Role::cutter_core && !with_part) return;
    const bool core = x.role == Role::cutter_core;
    out_.pairs.push_back({a, b, core, core ? inset_mm() : 0.0});
  }

  const CollisionScene& scene_;
  const Machine& machine_;
  const kinematics::Setup& setup_;
  std::vector<Entry> entries_;
  CollisionPairs out_;
};

}  // namespace

CollisionPairs collision_pairs(const CollisionScene& scene, const Machine& machine, const kinematics::Setup& setup) {
  return SceneBuilder(scene, machine, setup).build();
}

}  // namespace volute::sim

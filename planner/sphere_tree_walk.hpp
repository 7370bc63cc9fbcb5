// What the walks through a SphereTree share. Private to the module.
#pragma once

#include <array>

#include "planner/sphere_tree.hpp"

namespace volute::planner {

// What stands clear by this much is clear.
constexpr double clear_rounding_mm = 1e-7;

namespace walk {

constexpr int stack_size = 128;  // two entries a level; medians halve, so 64 levels are beyond any index

struct Entry {
  int node;
  double bound;
};

/// Children to visit, the nearer one on top.
class Stack {
 public:
  void push(int node, double bound) { entries_[static_cast<std::size_t>(size_++)] = {node, bound}; }
  Entry pop() { return entries_[static_cast<std::size_t>(--size_)]; }
  [[nodiscard]] bool empty() const { return size_ == 0; }

 private:
  std::array<Entry, stack_size> entries_;
  int size_ = 0;
};

struct Piece {
  Vec3 a, b, c;
};

/// A lower bound on the distance of cone and triangle: how far apart two parallel planes hold them, square to the
/// triangle or to the way from the cone to its middle. Negative when neither parts them.
double parted_mm(const AxialCone& cone, const Piece& t);

}  // namespace walk
}  // namespace volute::planner

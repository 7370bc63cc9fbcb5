// A tree of boxes: which of many things come near a ball. Cost per question grows with the logarithm of their number.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include <Eigen/Geometry>

#include "geometry/vector.hpp"

namespace volute::sim {

using Box = Eigen::AlignedBox3d;

/// Property: a query visits every item whose box comes within `radius_mm` of `centre_mm`, in the same order for the
/// same items.
class BoxTree {
 public:
  BoxTree() = default;
  explicit BoxTree(const std::vector<Box>& boxes);

  /// Calls visit(item) for every item whose box comes within radius_mm of centre_mm.
  template <class Visit>
  void near(const geometry::Vec3& centre_mm, double radius_mm, Visit&& visit) const {
    if (nodes_.empty()) return;
    std::int32_t stack[64];
    int depth = 0;
    stack[depth++] = 0;
    while (depth > 0) {
      const Node& node = nodes_[static_cast<std::size_t>(stack[--depth])];
      if (node.box.squaredExteriorDistance(centre_mm) > radius_mm * radius_mm) continue;
      if (node.count > 0) {
        for (std::int32_t i = node.first; i < node.first + node.count; ++i) {
          const std::int32_t item = items_[static_cast<std::size_t>(i)];
          if (boxes_[static_cast<std::size_t>(i)].squaredExteriorDistance(centre_mm) <= radius_mm * radius_mm)
            visit(item);
        }
      } else {
        stack[depth++] = node.right;
        stack[depth++] = node.first;
      }
    }
  }

  /// The least of square_mm2(item) over all items, or `within_mm2` where none is less. Requires: square_mm2(item) is no
  /// less than the squared distance of its box.
  template <class Square>
  double nearest_sq(const geometry::Vec3& point_mm, double within_mm2, Square&& square_mm2) const {
    if (nodes_.empty()) return within_mm2;
    std::int32_t stack[64];
    int depth = 0;
    stack[depth++] = 0;
    double least = within_mm2;
    while (depth > 0) {
      const Node& node = nodes_[static_cast<std::size_t>(stack[--depth])];
      if (node.box.squaredExteriorDistance(point_mm) >= least) continue;
      if (node.count > 0) {
        for (std::int32_t i = node.first; i < node.first + node.count; ++i) {
          const auto at = static_cast<std::size_t>(i);
          if (boxes_[at].squaredExteriorDistance(point_mm) < least) least = std::min(least, square_mm2(items_[at]));
        }
      } else {
        // The nearer half is looked at first.
        const auto far_sq = [&](std::int32_t child) {
          return nodes_[static_cast<std::size_t>(child)].box.squaredExteriorDistance(point_mm);
        };
        const bool left_first = far_sq(node.first) <= far_sq(node.right);
        stack[depth++] = left_first ? node.right : node.first;
        stack[depth++] = left_first ? node.first : node.right;
      }
    }
    return least;
  }

 private:
  /// A leaf holds items [first, first + count); an inner node (count == 0) has the children `first` and `right`.
  struct Node {
    Box box;
    std::int32_t first = 0, right = 0, count = 0;
  };
  std::int32_t build(std::int32_t first, std::int32_t count, const std::vector<Box>& boxes);
  std::vector<Node> nodes_;
  std::vector<std::int32_t> items_;
  std::vector<Box> boxes_;  // in the order of items_
};

}  // namespace volute::sim

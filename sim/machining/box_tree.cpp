#include "sim/machining/box_tree.hpp"

#include <algorithm>
#include <numeric>

namespace volute::sim {

BoxTree::BoxTree(const std::vector<Box>& boxes) {
  if (boxes.empty()) return;
  items_.resize(boxes.size());
  std::iota(items_.begin(), items_.end(), 0);
  nodes_.reserve(boxes.size() / 2 + 1);
  build(0, static_cast<std::int32_t>(boxes.size()), boxes);
  boxes_.reserve(boxes.size());
  for (const std::int32_t item : items_) boxes_.push_back(boxes[static_cast<std::size_t>(item)]);
}

std::int32_t BoxTree::build(std::int32_t first, std::int32_t count, const std::vector<Box>& boxes) {
  constexpr std::int32_t leaf_size = 6;
  const auto index = static_cast<std::int32_t>(nodes_.size());
  nodes_.emplace_back();
  Box box, centres;
  for (std::int32_t i = first; i < first + count; ++i) {
    const Box& item = boxes[static_cast<std::size_t>(items_[static_cast<std::size_t>(i)])];
    box.extend(item);
    centres.extend(item.center());
  }
  Node node{box, first, 0, count};
  if (count > leaf_size) {
    Eigen::Index axis = 0;
    centres.sizes().maxCoeff(&axis);
    const auto begin = items_.begin() + first;
    // Ties are broken by number, so that the tree does not depend on the library's partition.
    std::nth_element(begin, begin + count / 2, begin + count, [&](std::int32_t a, std::int32_t b) {
      const double ca = boxes[static_cast<std::size_t>(a)].center()[axis],
                   cb = boxes[static_cast<std::size_t>(b)].center()[axis];
      return ca != cb ? ca < cb : a < b;
    });
    node.count = 0;
    node.first = build(first, count / 2, boxes);
    node.right = build(first + count / 2, count - count / 2, boxes);
  }
  nodes_[static_cast<std::size_t>(index)] = node;
  return index;
}

}  // namespace volute::sim

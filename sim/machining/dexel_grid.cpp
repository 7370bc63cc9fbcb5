#include "sim/machining/dexel_grid.hpp"

#include <algorithm>
#include <cmath>

namespace volute::sim {
namespace {

double common_length(const Span& a, const Span& b) {
  return std::max(0.0, std::min(a.high_mm, b.high_mm) - std::max(a.low_mm, b.low_mm));
}

}  // namespace

DexelGrid::DexelGrid(int axis, const Vec3& low_mm, const std::array<int, 3>& nodes, double grid_mm)
    : axis_(axis),
      low_mm_(low_mm),
      grid_mm_(grid_mm),
      columns_(nodes[static_cast<std::size_t>((axis + 1) % 3)]),
      rows_(nodes[static_cast<std::size_t>((axis + 2) % 3)]),
      rays_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)),
      more_(static_cast<std::size_t>(rows_)) {}

Vec3 DexelGrid::node(int column, int row) const {
  Vec3 out = Vec3::Zero();
  const int u = (axis_ + 1) % 3, v = (axis_ + 2) % 3;
  out[u] = low_mm_[u] + (column + 0.5) * grid_mm_;
  out[v] = low_mm_[v] + (row + 0.5) * grid_mm_;
  return out;
}

DexelGrid::Range DexelGrid::range(const Eigen::AlignedBox3d& box) const {
  const int u = (axis_ + 1) % 3, v = (axis_ + 2) % 3;
  const auto first = [&](int k, int count) {
    return static_cast<int>(
        std::clamp(std::ceil((box.min()[k] - low_mm_[k]) / grid_mm_ - 0.5), 0.0, static_cast<double>(count)));
  };
  const auto after = [&](int k, int count) {
    return static_cast<int>(
        std::clamp(std::floor((box.max()[k] - low_mm_[k]) / grid_mm_ - 0.5) + 1.0, 0.0, static_cast<double>(count)));
  };
  return {first(u, columns_), after(u, columns_), first(v, rows_), after(v, rows_)};
}

void DexelGrid::set(int column, int row, const std::vector<Span>& spans) {
  Ray& ray = at(column, row);
  ray.low_mm = spans.empty() ? 0.0 : spans.front().low_mm;
  ray.high_mm = spans.empty() ? 0.0 : spans.front().high_mm;
  ray.top_mm = spans.empty() ? 0.0 : spans.back().high_mm;
  auto& store = more_[static_cast<std::size_t>(row)];
  if (spans.size() > 1 && ray.more < 0) {
    ray.more = static_cast<std::int32_t>(store.size());
    store.emplace_back();
  }
  if (ray.more >= 0) {
    auto& rest = store[static_cast<std::size_t>(ray.more)];
    rest.assign(spans.begin() + (spans.empty() ? 0 : 1), spans.end());
  }
}

double DexelGrid::remove(int column, int row, const Span& span) {
  Ray& ray = at(column, row);
  if (ray.low_mm >= ray.high_mm || span.high_mm <= ray.low_mm || span.low_mm >= ray.top_mm) return 0.0;
  const bool single = ray.top_mm == ray.high_mm;
  if (single && span.low_mm <= ray.low_mm && span.high_mm < ray.high_mm) {  // from below
    const double taken = span.high_mm - ray.low_mm;
    ray.low_mm = span.high_mm;
    return taken;
  }
  if (single && span.low_mm > ray.low_mm && span.high_mm >= ray.high_mm) {  // from above
    const double taken = ray.high_mm - span.low_mm;
    ray.high_mm = ray.top_mm = span.low_mm;
    return taken;
  }
  return remove_slowly(column, row, span);
}

double DexelGrid::remove_slowly(int column, int row, const Span& span) {
  static thread_local std::vector<Span> left;  // kept from call to call: its memory is what takes the time
  left.clear();
  double taken = 0.0;
  visit(column, row, [&](const Span& s) {
    taken += common_length(s, span);
    if (s.low_mm < span.low_mm) left.push_back({s.low_mm, std::min(s.high_mm, span.low_mm)});
    if (s.high_mm > span.high_mm) left.push_back({std::max(s.low_mm, span.high_mm), s.high_mm});
  });
  if (taken > 0.0) set(column, row, left);
  return taken;
}

double DexelGrid::overlap(int column, int row, const Span& span) const {
  double length = 0.0;
  visit(column, row, [&](const Span& s) { length += common_length(s, span); });
  return length;
}

double DexelGrid::length_mm() const {
  double sum = 0.0;
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column)
      visit(column, row, [&](const Span& s) { sum += s.high_mm - s.low_mm; });
  }
  return sum;
}

}  // namespace volute::sim

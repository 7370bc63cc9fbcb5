// A queue whose elements stay in one place of memory and are used again: no allocation once it is large enough.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "geometry/check.hpp"

namespace volute::sim {

/// First in, first out. Element k counts from the oldest. T must be default-constructible and movable; an element that
/// is put in keeps what an earlier one left there until the caller sets it.
template <typename T>
class Ring {
 public:
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  T& operator[](std::size_t k) { return slots_[(first_ + k) & (slots_.size() - 1)]; }
  const T& operator[](std::size_t k) const { return slots_[(first_ + k) & (slots_.size() - 1)]; }
  T& front() { return slots_[first_]; }
  T& back() { return (*this)[size_ - 1]; }
  /// The new last element. References to other elements do not survive it.
  T& put() {
    if (size_ == slots_.size()) grow();
    ++size_;
    return back();
  }
  void drop_front() {
    VOLUTE_CHECK(size_ > 0);
    first_ = (first_ + 1) & (slots_.size() - 1);
    --size_;
  }
  void clear() { size_ = 0; }

 private:
  void grow() {
    std::vector<T> larger(slots_.empty() ? 16 : 2 * slots_.size());
    for (std::size_t k = 0; k < size_; ++k) larger[k] = std::move((*this)[k]);
    slots_ = std::move(larger);
    first_ = 0;
  }
  std::vector<T> slots_;  ///< a power of two of them
  std::size_t first_ = 0, size_ = 0;
};

}  // namespace volute::sim

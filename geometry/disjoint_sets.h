#pragma once
/// Sets that are joined one by one; the lowest member stands for each. Galler & Fischer, "An improved equivalence
/// algorithm", CACM 1964, with path halving.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace lode::geometry {

class DisjointSets {
 public:
  /// n sets of one member each, 0…n − 1.
  explicit DisjointSets(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0u); }

  /// The lowest member of i's set.
  [[nodiscard]] std::uint32_t lowest(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = lowest(a), b = lowest(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace lode::geometry

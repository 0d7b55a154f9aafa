#pragma once
/// Random numbers of the town: what they are for, and a random order.

#include <cstdint>
#include <utility>
#include <vector>

#include "geometry/random.h"

namespace lode::geometry {

/// What random numbers are for.
enum TownPurpose : std::uint32_t { for_blocks = 1, for_heights, for_walls, for_shapes, for_cars, for_trees, for_bays };

/// 0 … n − 1 in random order (Fisher and Yates).
[[nodiscard]] inline std::vector<int> shuffled(int n, Random random) {
  std::vector<int> order;
  for (int k = 0; k < n; ++k) order.push_back(k);
  for (int k = n; k > 1; --k) std::swap(order[std::size_t(k - 1)], order[random.below(std::uint32_t(k))]);
  return order;
}

}  // namespace lode::geometry

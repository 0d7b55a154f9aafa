#pragma once
/// The plan of the town: 6 × 5 blocks of 60 m along streets of 12 m, around the origin; x goes east, z south.

#include <algorithm>
#include <array>
#include <glm/vec2.hpp>
#include <vector>

namespace lode::geometry {

inline constexpr int kBlocksX = 6, kBlocksZ = 5;
inline constexpr double kBlock = 60.0, kStreet = 12.0, kPitch = kBlock + kStreet;
inline constexpr double kKerb = 0.14;     ///< height of a block's pavement
inline constexpr double kPavement = 3.5;  ///< its width around a block

struct Square {
  glm::dvec2 low, high;  ///< (x, z)
};

/// The block in column i, row j, pavement included.
[[nodiscard]] inline Square block_square(int i, int j) {
  const glm::dvec2 low(kPitch * i - 0.5 * (kPitch * kBlocksX - kStreet),
                       kPitch * j - 0.5 * (kPitch * kBlocksZ - kStreet));
  return {low, low + kBlock};
}

/// The middle of the street west of column i (0 … kBlocksX), or north of row j (0 … kBlocksZ).
[[nodiscard]] inline double street_x(int i) { return block_square(i, 0).low.x - 0.5 * kStreet; }
[[nodiscard]] inline double street_z(int j) { return block_square(0, j).low.y - 0.5 * kStreet; }

}  // namespace lode::geometry

#pragma once
/// How far a depth plane is from another, in units in the last place: float steps between two depths.

#include <array>
#include <cstdint>
#include <span>

namespace lode::experiments {

struct DepthError {
  std::uint64_t compared = 0;      ///< pixels where both have a depth
  std::uint64_t one_sided = 0;     ///< pixels where one has a depth and the other has nothing (0); not in what follows
  std::uint64_t not_a_number = 0;  ///< pixels where either is NaN; not in what follows
  std::uint32_t max_ulp = 0;
  /// Of the pixels compared: [0] equal, [k] from 2^(k−1) to 2^k − 1 ULP.
  std::array<std::uint64_t, 33> histogram{};
};

/// Steps from one float to the other; ±0 are one value, the largest float and infinity neighbours. No NaN.
[[nodiscard]] std::uint32_t ulp_distance(float a, float b);

/// Of depths [w*h] each. `where`: [w*h], 0 leaves the pixel out, where ids differ say; or empty for all. O(w·h).
/// Throws std::logic_error for other sizes.
[[nodiscard]] DepthError depth_error(std::span<const float> reference, std::span<const float> rendered,
                                     std::span<const std::uint8_t> where = {});

}  // namespace lode::experiments

#pragma once
/// Products of bytes that stand for 0…1 (0…255 code values), exact.

#include <cstdint>

namespace lode::raster {

/// ⌊a·b/255 + ½⌋ without a division: with x = a·b ≤ 255², t = x + 128, (t + (t >> 8)) >> 8 is exact for every x
/// (Blinn, "Three wrongs make a right", 1995). The quotient is never a tie: 255 is odd.
[[nodiscard]] constexpr std::uint8_t byte_product(std::uint8_t a, std::uint8_t b) {
  const std::uint32_t t = std::uint32_t{a} * b + 128u;
  return static_cast<std::uint8_t>((t + (t >> 8)) >> 8);
}

}  // namespace lode::raster

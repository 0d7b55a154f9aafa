#pragma once
/// Ordered dither: which pixels of each 4×4 a share of a picture takes, so that what is there and what comes in its place
/// never share one. Bayer, "An optimum method for two-level rendition of continuous-tone pictures", ICC 1973.

#include <array>
#include <cstdint>

namespace lode::techniques {

inline constexpr std::uint16_t kEveryPixel = 0xFFFF;

/// Those of the pixels, bit x mod 4 + 4 · (y mod 4), that the first `n` of 16 steps take, 0…16; each step takes one more.
[[nodiscard]] constexpr std::uint16_t dithered_pixels(int n) {
  constexpr std::array<int, 16> kStep = {0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5};
  unsigned pixels = 0;
  for (unsigned k = 0; k < 16; ++k) pixels |= kStep[k] < n ? 1u << k : 0u;
  return std::uint16_t(pixels);
}

}  // namespace lode::techniques

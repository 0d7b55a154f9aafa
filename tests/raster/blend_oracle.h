#pragma once
/// 8-bit blending (C8) in whole numbers: the rational result, rounded half up, by a division.

#include "raster/blend.h"

namespace lode::raster::test {

/// s + d·(255 − a)/255, or s + d, rounded half up, at most 255.
[[nodiscard]] inline int blended(Blend blend, int s, int d, int a) {
  const int numerator = s * 255 + (blend == Blend::over ? d * (255 - a) : d * 255);  // of 255
  const int rounded = (2 * numerator + 255) / (2 * 255);                             // ⌊x + ½⌋
  return rounded < 255 ? rounded : 255;
}

/// How many of the 2^16 (destination, alpha) pairs `blend_rgba8` gets wrong for one source value. Three
/// destinations share a call; alpha's own channel is the fourth.
[[nodiscard]] inline int wrong_blends(Blend blend, int s) {
  int wrong = 0;
  const auto byte = [](int value) { return static_cast<std::uint8_t>(value); };
  for (int a = 0; a < 256; ++a) {
    for (int d = 0; d < 256; ++d) {
      const int d1 = (d + 85) % 256, d2 = (d + 170) % 256;
      const glm::u8vec4 result =
          blend_rgba8(blend, {byte(s), byte(s), byte(s), byte(a)}, {byte(d), byte(d1), byte(d2), byte(d)});
      wrong += result.r != blended(blend, s, d, a) || result.g != blended(blend, s, d1, a) ||
               result.b != blended(blend, s, d2, a) || result.a != blended(blend, a, d, a);
    }
  }
  return wrong;
}

}  // namespace lode::raster::test

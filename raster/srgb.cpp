#include "raster/srgb.h"

#include "raster/srgb_tables.h"

namespace lode::raster {

float srgb_decode(std::uint8_t code) { return kSrgbDecode[code]; }

std::uint8_t srgb_encode(float linear) {
  // The thresholds ascend, so the code is the largest k with kSrgbEncode[k] ≤ linear: found bit by bit. Every
  // comparison with NaN fails, which leaves 0.
  unsigned code = 0;
  for (unsigned bit = 128; bit != 0; bit >>= 1) {
    if (linear >= kSrgbEncode[code | bit]) code |= bit;
  }
  return static_cast<std::uint8_t>(code);
}

glm::u8vec4 srgb8_from_linear(const glm::vec4& premultiplied) {
  const float alpha = premultiplied.a;
  if (!(alpha > 0.0f)) return {0, 0, 0, 0};  // below 0 and NaN count as 0
  // 255·a + ½ is exact in double wherever it could reach the next whole number.
  const auto alpha_code = static_cast<std::uint8_t>(alpha >= 1.0f ? 255.0 : 255.0 * double{alpha} + 0.5);
  return {srgb_encode(premultiplied.r / alpha), srgb_encode(premultiplied.g / alpha),
          srgb_encode(premultiplied.b / alpha), alpha_code};
}

}  // namespace lode::raster

#include "raster/blend.h"

#include <algorithm>

#include "raster/byte_product.h"

namespace lode::raster {
namespace {

std::uint8_t stored_byte(float value) {
  if (!(value > 0.0f)) return 0;  // NaN, too
  if (value >= 255.0f) return 255;
  // Half up. The sum is exact in double wherever it could reach the next whole number.
  return static_cast<std::uint8_t>(double{value} + 0.5);
}

std::uint8_t saturating_sum(std::uint8_t a, std::uint8_t b) { return static_cast<std::uint8_t>(std::min(a + b, 255)); }

}  // namespace

glm::u8vec4 store_rgba8(const glm::vec4& color) {
  return {stored_byte(color.r), stored_byte(color.g), stored_byte(color.b), stored_byte(color.a)};
}

glm::u8vec4 blend_rgba8(Blend blend, glm::u8vec4 source, glm::u8vec4 destination) {
  if (blend == Blend::none) return source;
  const auto kept = static_cast<std::uint8_t>(255 - source.a);
  glm::u8vec4 result;
  for (int c = 0; c < 4; ++c) {
    const std::uint8_t under = blend == Blend::over ? byte_product(destination[c], kept) : destination[c];
    result[c] = saturating_sum(source[c], under);
  }
  return result;
}

glm::vec4 blend_rgba32f(Blend blend, const glm::vec4& source, const glm::vec4& destination) {
  if (blend == Blend::none) return store_rgba32f(source);
  const float kept = 1.0f - source.a;
  glm::vec4 result;
  for (int c = 0; c < 4; ++c) {
    const float under = blend == Blend::over ? destination[c] * kept : destination[c];
    result[c] = source[c] + under;
  }
  return store_rgba32f(result);
}

}  // namespace lode::raster

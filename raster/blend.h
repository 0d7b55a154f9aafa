#pragma once
/// Storing and blending colours (C8). 8-bit results equal the rational result rounded half up; float targets
/// hold one NaN (0x7FC00000) and one zero (+0), because NaN payloads and signs differ between processors.

#include <bit>
#include <cstdint>
#include <glm/vec4.hpp>
#include <glm/gtc/type_precision.hpp>

#include "raster/frame.h"

namespace lode::raster {

/// Code values 0…255 as bytes: rounded half up, clamped; NaN gives 0.
[[nodiscard]] glm::u8vec4 store_rgba8(const glm::vec4& color);

/// NaN made 0x7FC00000, −0 made +0.
[[nodiscard]] inline glm::vec4 store_rgba32f(const glm::vec4& color) {
  const auto stored = [](float v) { return v == v ? v + 0.0f : std::bit_cast<float>(std::uint32_t{0x7FC00000}); };
  return {stored(color.r), stored(color.g), stored(color.b), stored(color.a)};
}

/// over: s + ⌊d·(255 − sₐ)/255 + ½⌋, at most 255; add: s + d, at most 255; none: s.
[[nodiscard]] glm::u8vec4 blend_rgba8(Blend blend, glm::u8vec4 source, glm::u8vec4 destination);

/// over: s + d·(1 − sₐ); add: s + d; none: s. In float, in this order, then as store_rgba32f.
[[nodiscard]] glm::vec4 blend_rgba32f(Blend blend, const glm::vec4& source, const glm::vec4& destination);

}  // namespace lode::raster

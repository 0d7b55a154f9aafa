#pragma once
/// The sRGB transfer functions (IEC 61966-2-1) between 8-bit codes and linear light, by table: no libm on the
/// way to a pixel, and each value correctly rounded (C9).

#include <cstdint>
#include <glm/vec4.hpp>
#include <glm/gtc/type_precision.hpp>

namespace lode::raster {

/// The float nearest to the linear value of an sRGB code.
[[nodiscard]] float srgb_decode(std::uint8_t code);

/// The code nearest to 255 · encode(x), half up; below 0 and NaN give 0, above 1 gives 255.
[[nodiscard]] std::uint8_t srgb_encode(float linear);

/// A linear premultiplied pixel as straight-alpha sRGB bytes: colour divided by alpha, then encoded; alpha is
/// ⌊255·a + ½⌋, never encoded. Alpha 0 gives (0, 0, 0, 0).
[[nodiscard]] glm::u8vec4 srgb8_from_linear(const glm::vec4& premultiplied);

}  // namespace lode::raster

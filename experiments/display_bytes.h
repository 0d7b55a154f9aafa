#pragma once
/// A linear picture as a screen shows it.

#include <glm/gtc/type_precision.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

namespace lode::experiments {

/// [n] linear premultiplied colours as straight-alpha sRGB bytes, correctly rounded (raster/srgb.h).
[[nodiscard]] std::vector<glm::u8vec4> display_bytes(std::span<const glm::vec4> linear);

}  // namespace lode::experiments

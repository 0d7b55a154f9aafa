#pragma once
/// Two pictures of one size that metrics compare: stored 8-bit values, of which alpha does not count.

#include <glm/gtc/type_precision.hpp>
#include <glm/vec2.hpp>
#include <span>

namespace lode::experiments {

struct PicturePair {
  glm::ivec2 size_px{0, 0};
  std::span<const glm::u8vec4> a, b;  ///< [w*h]
};

}  // namespace lode::experiments

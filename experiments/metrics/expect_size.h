#pragma once
/// Checks of what a metric is given. A span of another size is its caller's mistake.

#include <cstddef>
#include <glm/vec2.hpp>
#include <stdexcept>
#include <string>

namespace lode::experiments {

/// Of a picture; 0 where a side is not positive.
[[nodiscard]] inline std::size_t pixel_count(glm::ivec2 size_px) {
  return size_px.x <= 0 || size_px.y <= 0 ? 0 : std::size_t(size_px.x) * std::size_t(size_px.y);
}

/// Throws std::logic_error.
inline void expect_size(const char* what, std::size_t expected, std::size_t found) {
  if (expected == found) return;
  throw std::logic_error(std::string(what) + ": expected " + std::to_string(expected) + " elements, found " +
                         std::to_string(found));
}

}  // namespace lode::experiments

#pragma once
/// How large a hole is at its largest: a pixel here and there is not seen, a window that is gone is.

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>

namespace lode::experiments {

/// Pixels of the largest 4-connected region of pixels that are not 0; 0 if all are. `mask`: [w*h] (else
/// std::logic_error). O(w·h) time, at most 9 bytes a pixel.
[[nodiscard]] std::uint64_t largest_region(glm::ivec2 size_px, std::span<const std::uint8_t> mask);

}  // namespace lode::experiments

#pragma once
/// Where the samples of a pixel lie.

#include <glm/vec2.hpp>
#include <vector>

namespace lode::experiments {

/// Positions of n samples a pixel (n a power of two up to 128) in 1/256 px: sample k lies at
/// ((k + ½)/n, bitreverse(k)/n + 1/(2n)), a Hammersley set moved to the middle of its cells.
[[nodiscard]] std::vector<glm::ivec2> sample_positions_fx8(int n);

}  // namespace lode::experiments

#pragma once
/// The colour map "magma" of Smith and van der Walt (matplotlib): black over purple and orange to pale
/// yellow, of evenly growing lightness. FLIP's maps are shown in it.

#include <cstdint>
#include <glm/gtc/type_precision.hpp>
#include <span>
#include <vector>

namespace lode::experiments {

/// The nearest of the map's 256 colours, half up; below 0 and NaN the first, above 1 the last.
[[nodiscard]] glm::u8vec4 magma(float value);
/// [n] colours of [n] values.
[[nodiscard]] std::vector<glm::u8vec4> magma_picture(std::span<const float> values);

}  // namespace lode::experiments

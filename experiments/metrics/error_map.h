#pragma once
/// An error for each pixel, and the numbers that stand for all of them.

#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace lode::experiments {

struct ErrorMap {
  glm::ivec2 size_px{0, 0};
  std::vector<float> errors;  ///< [w*h], row 0 is the top
};

/// Summed in double, in order; 0 for no errors.
[[nodiscard]] double mean_error(std::span<const float> errors);

/// The smallest error that `percent` of 100 do not exceed (nearest rank), percent from 1 to 100; 0 for no errors. O(n).
[[nodiscard]] float error_percentile(std::span<const float> errors, int percent);

}  // namespace lode::experiments

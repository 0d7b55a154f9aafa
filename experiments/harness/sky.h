#pragma once
/// What is behind everything in pictures that people look at.

#include <glm/vec4.hpp>

namespace lode::experiments {

inline constexpr glm::vec4 kSky{0.35f, 0.5f, 0.65f, 1.0f};  ///< linear

}  // namespace lode::experiments

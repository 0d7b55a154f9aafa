#pragma once
/// Pictures of an experiment, as files that appear whole.

#include <glm/gtc/type_precision.hpp>
#include <glm/vec2.hpp>
#include <span>
#include <string>

namespace lode::experiments {

/// Throws Error (machine_failed) if it cannot be written.
void write_png(const std::string& path, glm::ivec2 size_px, std::span<const glm::u8vec4> colors);

}  // namespace lode::experiments

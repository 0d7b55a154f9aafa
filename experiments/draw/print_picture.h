#pragma once
/// A picture as text: one row a line, a letter per draw (A–Z, then a–z, then again from A), '.' for nothing.

#include <glm/vec2.hpp>
#include <span>
#include <string>

#include "raster/image.h"

namespace lode::experiments {

/// Widest picture that is printed: what a terminal shows without wrapping, or nearly so.
inline constexpr int kMaxPrintedColumns = 200;

///   ids       [w*h] whose pixel it is
///   returns   h lines of w characters, each with its line break; nothing for an empty picture
[[nodiscard]] std::string printed_picture(glm::ivec2 size_px, std::span<const raster::Ids> ids);

}  // namespace lode::experiments

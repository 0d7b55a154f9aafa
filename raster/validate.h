#pragma once
/// Everything that `render` refuses, found before any pixel is touched.

#include "raster/render.h"

namespace lode::raster {

/// Throws Error(bad_input) naming the draw, the element and what was expected.
void validate(const Frame& frame, const Image& image, const RenderOptions& options);

/// Vertices that the draw's topology sees: its indices, or its positions in order.
[[nodiscard]] std::size_t vertex_count(const Draw& draw);
[[nodiscard]] std::size_t position_count(const Draw& draw);

/// Primitives of the draw: vertex_count by topology.
[[nodiscard]] std::size_t primitive_count(const Draw& draw);

}  // namespace lode::raster

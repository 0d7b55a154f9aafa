#pragma once
/// The fast pipeline: the reference's bytes by other means. Each tile walks the draws' cluster trees front to back
/// against a hierarchical depth of its own, so that no triangle record is written and nothing waits for other tiles.
/// What the kernels do not draw (lines, points, discs, surfels, alpha tests, ordered draws, triangles that are
/// clipped) is assembled as the reference does and drawn into the same tiles.

#include "raster/render.h"

namespace lode::raster::fast {

/// As `render`, of a frame that `validate` let pass. May throw std::bad_alloc, before it touches the image.
FrameStats render_fast(const Frame& frame, Image& image, const RenderOptions& options);

}  // namespace lode::raster::fast

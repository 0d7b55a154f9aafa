#pragma once
/// The reference pipeline: plain scalar code, as close to the written rules as code can be. It stays the oracle
/// of every faster one.

#include "raster/render.h"

namespace lode::raster::reference {

/// As `render`, of a frame that `validate` let pass. May throw std::bad_alloc, before it touches the image.
FrameStats render_reference(const Frame& frame, Image& image, const RenderOptions& options);

}  // namespace lode::raster::reference

#pragma once
/// Reads a draw's "texture": its texels and how they are filtered.

#include <memory>

#include "geometry/json/json_view.h"
#include "raster/texture.h"

namespace lode::experiments {

struct SampledTexture {
  std::unique_ptr<raster::Texture> texture;  ///< raw, premultiplied, with mips unless "mips" is false
  raster::Sampler sampler;                   ///< nearest and repeat unless the picture says otherwise
};

/// Throws Error (bad_input) at the place that is wrong.
[[nodiscard]] SampledTexture read_texture(const geometry::JsonView& view);

}  // namespace lode::experiments

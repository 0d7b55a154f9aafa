#pragma once
/// Colours of samples: attributes from perspective weights (C7), texture, material, shader.

#include <span>

#include "raster/image.h"
#include "raster/reference/assemble.h"

namespace lode::raster::reference {

/// Samples of one piece to be shaded together, at most kMaxShadeBatch.
struct SampleRun {
  std::span<const glm::ivec2> pixels;
  std::span<const float> depths;
  glm::ivec2 sample_fx8{128, 128};
};

[[nodiscard]] float depth_of(const Piece& piece, glm::ivec2 p_fx8);

/// Texture coordinates of the piece's vertices, if the draw has any.
[[nodiscard]] VertexUvs piece_uvs(const Draw& draw, const Piece& piece);

/// rgba[i] is the shader's result at pixels[i], in the target's unit, not yet stored. Counts into stats.
void shade(const Draw& draw, const Piece& piece, ColorFormat format, const SampleRun& run, glm::vec4* rgba,
           FrameStats& stats);

}  // namespace lode::raster::reference

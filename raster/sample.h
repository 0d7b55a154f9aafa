#pragma once
/// Filters at several coordinates at once, for shaders that read textures where they please.

#include <span>

#include "raster/render.h"
#include "raster/texture.h"

namespace lode::raster {

inline constexpr std::size_t kMaxSampleBatch = 16;

/// Coordinates that a filter reads a texture at.
struct SampleBatch {
  alignas(64) double u[kMaxSampleBatch] = {}, v[kMaxSampleBatch] = {};
  double rho_squared = 0.0;  ///< of all: the longer derivative, squared, texels of level 0 a pixel (level_of_detail.h)
  std::uint32_t wanted = 0;  ///< a bit each
};

/// `sample_linear` at those that are wanted, to the bit, by the kernels of an instruction set that can run here.
///   texture   linear;   sampler   bilinear or trilinear
///   texels    [16]; what those become that are not wanted is not said
void sample_linear(const Texture& texture, const Sampler& sampler, const SampleBatch& batch, Target target,
                   std::span<glm::vec4, kMaxSampleBatch> texels);

}  // namespace lode::raster

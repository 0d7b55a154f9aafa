#include "raster/sample.h"

#include <algorithm>

#include "raster/fast/kernels.h"

namespace lode::raster {

void sample_linear(const Texture& texture, const Sampler& sampler, const SampleBatch& batch, Target target,
                   std::span<glm::vec4, kMaxSampleBatch> texels) {
  const fast::Kernels& kernels = *fast::find_kernels(target);
  fast::Surface surface;
  surface.texture = &texture;
  surface.sampler = sampler;
  fast::SurfaceSamples samples;
  std::fill_n(&samples.rgba[0][0], 4 * kMaxSampleBatch, 1.0f);
  std::copy_n(batch.u, kMaxSampleBatch, samples.u);
  std::copy_n(batch.v, kMaxSampleBatch, samples.v);
  std::fill_n(samples.rho_squared, kMaxSampleBatch, batch.rho_squared);
  static_cast<void>(kernels.apply_linear_texture(surface, batch.wanted, samples));
  for (std::size_t k = 0; k < kMaxSampleBatch; ++k) {
    texels[k] = {samples.rgba[0][k], samples.rgba[1][k], samples.rgba[2][k], samples.rgba[3][k]};
  }
}

}  // namespace lode::raster

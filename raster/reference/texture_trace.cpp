#include "raster/reference/texture_trace.h"

#include "raster/level_of_detail.h"
#include "raster/texture_address.h"

namespace lode::raster::reference {
namespace {

/// The four texels of a bilinear filter that have a weight.
void add_bilinear(const Texture& texture, int level, const Sampler& sampler, const glm::dvec2& uv, double weight,
                  std::vector<TexelRead>& reads) {
  const glm::ivec2 size_px = texture.levels[std::size_t(level)].size_px;
  const TexelPair x = linear_texels(uv.x, size_px.x, sampler.wrap_u),
                  y = linear_texels(uv.y, size_px.y, sampler.wrap_v);
  const double x1 = x.second_weight_fx8 / 256.0, y1 = y.second_weight_fx8 / 256.0;
  const auto add = [&](std::int32_t texel_x, std::int32_t texel_y, double share) {
    if (share * weight > 0.0) reads.push_back({level, {texel_x, texel_y}, share * weight});
  };
  add(x.first, y.first, (1.0 - y1) * (1.0 - x1));
  add(x.second, y.first, (1.0 - y1) * x1);
  add(x.first, y.second, y1 * (1.0 - x1));
  add(x.second, y.second, y1 * x1);
}

}  // namespace

TextureLookup trace_lookup(const Texture& texture, const Sampler& sampler, const Footprint& footprint) {
  TextureLookup lookup{.uv = footprint.uv,
                       .duv_dx = footprint.duv_dx,
                       .duv_dy = footprint.duv_dy,
                       .lambda_fx8 = std::nullopt,
                       .reads = {}};
  const glm::ivec2 base_px = texture.levels.front().size_px;
  if (sampler.filter == Filter::nearest) {
    const glm::ivec2 texel = {nearest_texel(footprint.uv.x, base_px.x, sampler.wrap_u),
                              nearest_texel(footprint.uv.y, base_px.y, sampler.wrap_v)};
    lookup.reads.push_back({0, texel, 1.0});
    return lookup;
  }
  Probes probes;
  if (sampler.filter == Filter::trilinear) probes = isotropic_probe(footprint, base_px);
  if (sampler.filter == Filter::anisotropic) probes = anisotropic_probes(footprint, base_px, sampler.max_anisotropy);
  if (sampler.filter != Filter::bilinear) lookup.lambda_fx8 = probes.lambda_fx8;
  lookup.probes = probes.n;
  const auto [level, f] = mip_levels(probes.lambda_fx8, static_cast<std::int32_t>(texture.levels.size()));
  for (std::int32_t i = 1; i <= probes.n; ++i) {
    const glm::dvec2 uv = probes.at(footprint.uv, i);
    add_bilinear(texture, level, sampler, uv, (256 - f) / 256.0 / probes.n, lookup.reads);
    if (f > 0) add_bilinear(texture, level + 1, sampler, uv, f / 256.0 / probes.n, lookup.reads);
  }
  return lookup;
}

}  // namespace lode::raster::reference

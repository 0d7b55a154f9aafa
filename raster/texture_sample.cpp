/// The filters (C10). Every linear filter is one sum of integer weight × texel, rounded once:
///
///   for each probe 1…n, for level l (weight 256 − f) and, if f > 0, level l + 1 (weight f), for the texels
///   (x0,y0), (x1,y0), (x0,y1), (x1,y1):   sum += weight_level · weight_y · weight_x · texel
///   result = sum / (n · 2^24)
///
/// bilinear is level 0, f = 0, one probe; trilinear is one probe. Bytes are summed in 64-bit integers and rounded
/// half up. Floats are summed in double, in the order above; a texel of weight 0 adds nothing, be it infinite.
///
/// Why floats never leave the range [min, max] of the texels read, and a constant stays constant: a weight of up to
/// 2^24 times a float's 24 bits is exact in double, and so is every partial sum of weights times one value, up to
/// n · 2^24 · max (n ≤ 16: 53 bits). Rounded addition is monotone, so a sum over texels ≤ max is at most the same sum
/// over max, which is exactly n · 2^24 · max; division and the final rounding are monotone, too. Likewise for min.

#include "raster/blend.h"
#include "raster/level_of_detail.h"
#include "raster/texture.h"
#include "raster/texture_address.h"

namespace lode::raster {
namespace {

constexpr std::int32_t kWeightOfProbe = 1 << 24;

struct RawFormat {
  using Texel = glm::u8vec4;
  static const std::vector<Texel>& texels(const TextureLevel& level) { return level.raw; }
  static Texel border(const Sampler& sampler) { return store_rgba8(sampler.border); }

  std::uint64_t sum[4]{};

  void add(const Texel& texel, std::int32_t weight) {
    for (int c = 0; c < 4; ++c) sum[c] += std::uint64_t(weight) * texel[c];
  }
  [[nodiscard]] Texel mean(std::int32_t n_probes) const {
    const std::uint64_t total = std::uint64_t(n_probes) * kWeightOfProbe;
    Texel texel;
    for (int c = 0; c < 4; ++c) texel[c] = static_cast<std::uint8_t>((sum[c] + total / 2) / total);  // half up
    return texel;
  }
};

struct LinearFormat {
  using Texel = glm::vec4;
  static const std::vector<Texel>& texels(const TextureLevel& level) { return level.linear; }
  static Texel border(const Sampler& sampler) { return store_rgba32f(sampler.border); }

  double sum[4]{};

  void add(const Texel& texel, std::int32_t weight) {
    if (weight == 0) return;
    for (int c = 0; c < 4; ++c) sum[c] += double(weight) * double{texel[c]};
  }
  [[nodiscard]] Texel mean(std::int32_t n_probes) const {
    Texel texel;
    const double total = double(n_probes) * kWeightOfProbe;
    for (int c = 0; c < 4; ++c) texel[c] = static_cast<float>(sum[c] / total);
    return store_rgba32f(texel);
  }
};

template <class Format>
typename Format::Texel texel_at(const TextureLevel& level, const Sampler& sampler, std::int32_t x, std::int32_t y) {
  if (x == kBorderTexel || y == kBorderTexel) return Format::border(sampler);
  return Format::texels(level)[std::size_t(y) * std::size_t(level.size_px.x) + std::size_t(x)];
}

template <class Format>
void add_bilinear(Format& sum, const TextureLevel& level, const Sampler& sampler, const glm::dvec2& uv,
                  std::int32_t level_weight) {
  const TexelPair x = linear_texels(uv.x, level.size_px.x, sampler.wrap_u);
  const TexelPair y = linear_texels(uv.y, level.size_px.y, sampler.wrap_v);
  const std::int32_t y0_weight = level_weight * (256 - y.second_weight_fx8);
  const std::int32_t y1_weight = level_weight * y.second_weight_fx8;
  const std::int32_t x0_weight = 256 - x.second_weight_fx8;
  const std::int32_t x1_weight = x.second_weight_fx8;
  sum.add(texel_at<Format>(level, sampler, x.first, y.first), y0_weight * x0_weight);
  sum.add(texel_at<Format>(level, sampler, x.second, y.first), y0_weight * x1_weight);
  sum.add(texel_at<Format>(level, sampler, x.first, y.second), y1_weight * x0_weight);
  sum.add(texel_at<Format>(level, sampler, x.second, y.second), y1_weight * x1_weight);
}

Probes probes_of(const Sampler& sampler, const Footprint& footprint, const glm::ivec2& size_px) {
  if (sampler.filter == Filter::trilinear) return isotropic_probe(footprint, size_px);
  if (sampler.filter == Filter::anisotropic) return anisotropic_probes(footprint, size_px, sampler.max_anisotropy);
  return {};  // bilinear: one probe of level 0
}

template <class Format>
typename Format::Texel sample(const Texture& texture, const Sampler& sampler, const glm::dvec2& uv,
                              const Probes& probes, std::uint64_t* texels_read) {
  const auto [level, f] = mip_levels(probes.lambda_fx8, static_cast<std::int32_t>(texture.levels.size()));
  Format sum;
  for (std::int32_t i = 1; i <= probes.n; ++i) {
    const glm::dvec2 at = probes.at(uv, i);
    add_bilinear(sum, texture.levels[std::size_t(level)], sampler, at, 256 - f);
    if (f > 0) add_bilinear(sum, texture.levels[std::size_t(level) + 1], sampler, at, f);
  }
  if (texels_read != nullptr) *texels_read += std::uint64_t(probes.n) * (f > 0 ? 8 : 4);
  return sum.mean(probes.n);
}

template <class Format>
typename Format::Texel nearest(const Texture& texture, const Sampler& sampler, const glm::dvec2& uv,
                               std::uint64_t* texels_read) {
  const TextureLevel& base = texture.levels.front();
  if (texels_read != nullptr) *texels_read += 1;
  return texel_at<Format>(base, sampler, nearest_texel(uv.x, base.size_px.x, sampler.wrap_u),
                          nearest_texel(uv.y, base.size_px.y, sampler.wrap_v));
}

template <class Format>
typename Format::Texel sample(const Texture& texture, const Sampler& sampler, const Footprint& footprint,
                              std::uint64_t* texels_read) {
  if (sampler.filter == Filter::nearest) return nearest<Format>(texture, sampler, footprint.uv, texels_read);
  const Probes probes = probes_of(sampler, footprint, texture.levels.front().size_px);
  return sample<Format>(texture, sampler, footprint.uv, probes, texels_read);
}

template <class Format>
typename Format::Texel sample(const Texture& texture, const Sampler& sampler, const glm::dvec2& uv,
                              std::int32_t lambda_fx8, std::uint64_t* texels_read) {
  if (sampler.filter == Filter::nearest) return nearest<Format>(texture, sampler, uv, texels_read);
  Probes probe;
  if (sampler.filter == Filter::trilinear) probe.lambda_fx8 = lambda_fx8;
  return sample<Format>(texture, sampler, uv, probe, texels_read);
}

}  // namespace

glm::u8vec4 sample_raw(const Texture& texture, const Sampler& sampler, const Footprint& footprint,
                       std::uint64_t* texels_read) {
  return sample<RawFormat>(texture, sampler, footprint, texels_read);
}

glm::vec4 sample_linear(const Texture& texture, const Sampler& sampler, const Footprint& footprint,
                        std::uint64_t* texels_read) {
  return sample<LinearFormat>(texture, sampler, footprint, texels_read);
}

glm::u8vec4 sample_raw(const Texture& texture, const Sampler& sampler, const glm::dvec2& uv, std::int32_t lambda_fx8,
                       std::uint64_t* texels_read) {
  return sample<RawFormat>(texture, sampler, uv, lambda_fx8, texels_read);
}

glm::vec4 sample_linear(const Texture& texture, const Sampler& sampler, const glm::dvec2& uv, std::int32_t lambda_fx8,
                        std::uint64_t* texels_read) {
  return sample<LinearFormat>(texture, sampler, uv, lambda_fx8, texels_read);
}

}  // namespace lode::raster

#include "experiments/draw/read_texture.h"

#include <glm/gtc/type_precision.hpp>
#include <string>
#include <vector>

namespace lode::experiments {
namespace {

using geometry::JsonView;

raster::Wrap read_wrap(const JsonView& view) {
  using enum raster::Wrap;
  constexpr raster::Wrap kWraps[] = {repeat, mirror, clamp, border};
  return kWraps[view.choice({"repeat", "mirror", "clamp", "border"})];
}

raster::Sampler read_sampler(const JsonView& view) {
  using enum raster::Filter;
  constexpr raster::Filter kFilters[] = {nearest, bilinear, trilinear, anisotropic};
  raster::Sampler sampler;
  sampler.filter = nearest;
  if (const auto filter = view.find("filter")) {
    sampler.filter = kFilters[filter->choice({"nearest", "bilinear", "trilinear", "anisotropic"})];
  }
  if (const auto wrap = view.find("wrap")) sampler.wrap_u = sampler.wrap_v = read_wrap(*wrap);
  if (const auto wrap_u = view.find("wrap_u")) sampler.wrap_u = read_wrap(*wrap_u);
  if (const auto wrap_v = view.find("wrap_v")) sampler.wrap_v = read_wrap(*wrap_v);
  if (const auto n = view.find("max_anisotropy")) sampler.max_anisotropy = int(n->integer(1, 16));
  if (const auto border = view.find("border")) sampler.border = border->color();
  return sampler;
}

std::vector<glm::u8vec4> read_texels(const JsonView& view, glm::ivec2 size_px) {
  const std::size_t n = std::size_t(size_px.x) * std::size_t(size_px.y);
  const std::string expected = "an array of " + std::to_string(4 * n) + " bytes, 4 a texel";
  if (view.size(expected) != 4 * n) view.fail_expected(expected);
  std::vector<glm::u8vec4> texels(n);
  for (std::size_t i = 0; i < 4 * n; ++i) {
    texels[i / 4][glm::length_t(i % 4)] = static_cast<std::uint8_t>(view.at(i).integer(0, 255));
  }
  return texels;
}

}  // namespace

SampledTexture read_texture(const JsonView& view) {
  constexpr std::string_view kKeys[] = {"size",   "rgba",   "filter",         "wrap", "wrap_u",
                                        "wrap_v", "border", "max_anisotropy", "mips"};
  view.check_keys(kKeys);
  const auto size = view.find("size");
  const auto rgba = view.find("rgba");
  if (!size || !rgba) view.fail("expected members \"size\" and \"rgba\"");

  if (size->size("[width, height]") != 2) size->fail_expected("[width, height]");
  const glm::ivec2 size_px{int(size->at(0).integer(1, raster::kMaxTextureSize_px)),
                           int(size->at(1).integer(1, raster::kMaxTextureSize_px))};
  const std::vector<glm::u8vec4> texels = read_texels(*rgba, size_px);
  const auto mips = view.find("mips");
  const bool with_mips = !mips || mips->boolean();

  SampledTexture result;
  result.sampler = read_sampler(view);
  result.texture = std::make_unique<raster::Texture>(
      raster::make_raw_texture(size_px, texels, with_mips ? raster::Mips::all : raster::Mips::none));
  return result;
}

}  // namespace lode::experiments

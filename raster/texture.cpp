#include "raster/texture.h"

#include <new>

#include "raster/blend.h"
#include "raster/byte_product.h"
#include "raster/error.h"
#include "raster/fp_environment.h"
#include "raster/srgb.h"
#include "raster/texture_mips.h"

namespace lode::raster {
namespace {

/// Before anything is allocated (C15).
void check_size(glm::ivec2 size_px, std::size_t n_texels) {
  const auto fits = [](int side_px) { return side_px >= 1 && side_px <= kMaxTextureSize_px; };
  if (!fits(size_px.x) || !fits(size_px.y)) {
    throw Error(ErrorKind::bad_input, "texture size %d x %d: expected 1 to %d a side", size_px.x, size_px.y,
                kMaxTextureSize_px);
  }
  const std::size_t expected = std::size_t(size_px.x) * std::size_t(size_px.y);
  if (n_texels != expected) {
    throw Error(ErrorKind::bad_input, "texture of %d x %d: expected %zu texels, found %zu", size_px.x, size_px.y,
                expected, n_texels);
  }
}

/// Level 0 is `stored(texel)` of each texel, in `plane`; the others follow from it.
template <class Stored, class Texel, class Store>
Texture make_texture(TextureFormat format, std::vector<Stored> TextureLevel::*plane, glm::ivec2 size_px,
                     std::span<const Texel> texels, Mips mips, Store stored) {
  check_size(size_px, texels.size());
  const FpEnvironment environment;
  try {
    Texture texture{.format = format, .levels = {}};
    TextureLevel& base = texture.levels.emplace_back();
    base.size_px = size_px;
    (base.*plane).reserve(texels.size());
    for (const Texel& texel : texels) (base.*plane).push_back(stored(texel));
    while (mips == Mips::all && texture.levels.back().size_px != glm::ivec2(1, 1)) {
      texture.levels.push_back(next_level(texture.levels.back(), format));
    }
    return texture;
  } catch (const std::bad_alloc&) {
    throw Error(ErrorKind::out_of_memory, "out of memory for a texture of %d x %d texels", size_px.x, size_px.y);
  }
}

glm::u8vec4 premultiplied(const glm::u8vec4& t) {
  return {byte_product(t.r, t.a), byte_product(t.g, t.a), byte_product(t.b, t.a), t.a};
}

/// decode(c)·a is exact in double; the division by 255 and the float are rounded.
glm::vec4 premultiplied_linear(const glm::u8vec4& t) {
  const double alpha = t.a;
  const auto times_alpha = [alpha](std::uint8_t code) {
    return static_cast<float>(double{srgb_decode(code)} * alpha / 255.0);
  };
  return {times_alpha(t.r), times_alpha(t.g), times_alpha(t.b), static_cast<float>(alpha / 255.0)};
}

}  // namespace

Texture make_raw_texture(glm::ivec2 size_px, std::span<const glm::u8vec4> texels, Mips mips) {
  return make_texture(TextureFormat::raw, &TextureLevel::raw, size_px, texels, mips, premultiplied);
}

Texture make_srgb_texture(glm::ivec2 size_px, std::span<const glm::u8vec4> texels, Mips mips) {
  return make_texture(TextureFormat::linear, &TextureLevel::linear, size_px, texels, mips, premultiplied_linear);
}

Texture make_linear_texture(glm::ivec2 size_px, std::span<const glm::vec4> texels, Mips mips) {
  return make_texture(TextureFormat::linear, &TextureLevel::linear, size_px, texels, mips, store_rgba32f);
}

}  // namespace lode::raster

#pragma once
/// Textures and their filters (C10). Texels are premultiplied by alpha before mips and filtering. A raw
/// texture is filtered on its bytes, in integers, and gives bytes; an sRGB texture is decoded to linear light
/// first (C9) and gives floats. Coordinates are 16.8 fixed point after wrapping, the level of detail is 8.8.

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <glm/gtc/type_precision.hpp>
#include <span>
#include <vector>

namespace lode::raster {

/// raw: bytes as they are. linear: float, linear light.
enum class TextureFormat : std::uint8_t { raw, linear };
enum class Mips : std::uint8_t { none, all };

/// What lies outside [0, 1]: the picture again, mirrored, its edge texels, or the sampler's border colour.
enum class Wrap : std::uint8_t { repeat, mirror, clamp, border };

/// nearest and bilinear read level 0 only; trilinear blends two levels; anisotropic averages up to
/// `max_anisotropy` trilinear probes along the longer axis of the pixel's footprint.
enum class Filter : std::uint8_t { nearest, bilinear, trilinear, anisotropic };

struct TextureLevel {
  glm::ivec2 size_px{0, 0};
  std::vector<glm::u8vec4> raw;   ///< [w*h] premultiplied, row 0 first, if the format is raw
  std::vector<glm::vec4> linear;  ///< [w*h] premultiplied linear light, if the format is linear
};

/// Level 0 first; level k+1 is max(1, ⌊w/2⌋) × max(1, ⌊h/2⌋) of level k, down to 1×1, or level 0 alone.
struct Texture {
  TextureFormat format = TextureFormat::raw;
  std::vector<TextureLevel> levels;
};

struct Sampler {
  Filter filter = Filter::bilinear;
  Wrap wrap_u = Wrap::repeat;
  Wrap wrap_v = Wrap::repeat;
  int max_anisotropy = 8;                  ///< 1…16
  glm::vec4 border{0.0f, 0.0f, 0.0f, 0.0f};  ///< premultiplied; 0…255 for a raw texture (whole numbers), else 0…1
};

inline constexpr int kMaxTextureSize_px = 16384;

/// A raw texture of straight-alpha bytes. Premultiplied as ⌊c·a/255 + ½⌋, mips in bytes, each rounded half up.
///   size_px   1…16384 a side;   texels [w*h], row 0 is v = 0
/// Throws Error: bad_input (size, count), out_of_memory.
[[nodiscard]] Texture make_raw_texture(glm::ivec2 size_px, std::span<const glm::u8vec4> texels, Mips mips);

/// A linear texture of straight-alpha sRGB bytes: colour decoded (C9), alpha a/255, then premultiplied.
[[nodiscard]] Texture make_srgb_texture(glm::ivec2 size_px, std::span<const glm::u8vec4> texels, Mips mips);

/// A linear texture of premultiplied linear floats (a captured picture, say).
[[nodiscard]] Texture make_linear_texture(glm::ivec2 size_px, std::span<const glm::vec4> texels, Mips mips);

/// Where a pixel looks up a texture: the coordinate at its sample, and how it moves from pixel to pixel.
/// u = 0…1 spans the picture's width, v its height; v = 0 is row 0's upper edge.
struct Footprint {
  glm::dvec2 uv{0.0, 0.0};
  glm::dvec2 duv_dx{0.0, 0.0};  ///< per pixel to the right
  glm::dvec2 duv_dy{0.0, 0.0};  ///< per pixel down
};

/// The filtered bytes of a raw texture: one rounding, half up. A coordinate that is not finite reads as 0.
/// `texels_read`, if given, grows by the texels that the filter fetched (the border counts as fetched).
[[nodiscard]] glm::u8vec4 sample_raw(const Texture& texture, const Sampler& sampler, const Footprint& footprint,
                                     std::uint64_t* texels_read = nullptr);

/// The same at a coordinate and a level of detail, 8.8 (level_of_detail.h), by a filter that is not anisotropic; only
/// trilinear ones look at the level.
[[nodiscard]] glm::u8vec4 sample_raw(const Texture& texture, const Sampler& sampler, const glm::dvec2& uv,
                                     std::int32_t lambda_fx8, std::uint64_t* texels_read = nullptr);

/// The filtered value of a linear texture: integer weights times floats, summed in double, rounded once.
[[nodiscard]] glm::vec4 sample_linear(const Texture& texture, const Sampler& sampler, const Footprint& footprint,
                                      std::uint64_t* texels_read = nullptr);
[[nodiscard]] glm::vec4 sample_linear(const Texture& texture, const Sampler& sampler, const glm::dvec2& uv,
                                      std::int32_t lambda_fx8, std::uint64_t* texels_read = nullptr);

}  // namespace lode::raster

#pragma once
/// Materials, as far as a rasterizer without lights of its own draws them: glTF 2.0's base colour, alpha modes, unlit
/// and double-sided; OBJ's Kd, d, map_Kd and map_d.

#include <cstdint>
#include <glm/gtc/type_precision.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <string>
#include <vector>

namespace lode::geometry {

/// A picture as its file has it: straight alpha, display (sRGB) values.
struct Picture {
  std::string name;  ///< for messages: its path, or its place in a file
  glm::ivec2 size_px{0, 0};
  std::vector<glm::u8vec4> texels;  ///< [w*h], row 0 is the top
  bool has_alpha = false;           ///< any texel's alpha is below 255
};

enum class TextureWrap : std::uint8_t { repeat, mirror, clamp };
enum class TextureFilter : std::uint8_t { nearest, bilinear, trilinear };

/// A picture with the way it is looked up.
struct TextureUse {
  std::uint32_t picture = 0;  ///< index in Scene::pictures
  TextureWrap wrap_u = TextureWrap::repeat;
  TextureWrap wrap_v = TextureWrap::repeat;
  TextureFilter filter = TextureFilter::trilinear;
  friend bool operator==(const TextureUse&, const TextureUse&) = default;
};

/// opaque: alpha counts as 1. mask: a sample whose alpha is at least the cutoff is opaque, others are not there.
/// blend: `over` what is behind, after everything that is opaque or masked.
enum class AlphaMode : std::uint8_t { opaque, mask, blend };

struct Material {
  std::string name;
  glm::vec4 color{1.0f, 1.0f, 1.0f, 1.0f};  ///< linear, straight alpha
  std::optional<TextureUse> color_texture;
  AlphaMode alpha_mode = AlphaMode::opaque;
  double alpha_cutoff = 0.5;
  bool double_sided = false;  ///< false: clockwise triangles are culled
  bool unlit = false;
};

}  // namespace lode::geometry

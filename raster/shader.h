#pragma once
/// Shading: a function object over a batch of samples of one primitive, structure of arrays. A shader of your
/// own is a lambda from Pixel to colour; `pixel_shader` wraps it in a loop over the batch, so that the call is
/// inlined and only the batch is an indirect call:
///
///   draw.shader = pixel_shader([](const Pixel& p) {
///     const bool dark = ((p.x_px >> 3) ^ (p.y_px >> 3)) & 1;
///     return p.color * (dark ? 0.25f : 1.0f);
///   });
///
/// A shader is a pure function of what it is given. It runs on many threads at once and must not throw.

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>

#if defined(__FAST_MATH__)
#error "lodestone's pixels are defined in IEEE arithmetic: build without -ffast-math"
#endif

namespace lode::raster {

inline constexpr int kMaxShadeBatch = 64;

/// Inputs of up to kMaxShadeBatch samples. Colours are in the target's unit: 0…255 for rgba8, linear and
/// premultiplied for rgba32f. Pointers are valid for the call only.
struct ShadeBatch {
  int n = 0;                         ///< samples in this batch, 1…kMaxShadeBatch
  std::uint32_t draw = 0;            ///< ids as the picture has them
  std::uint32_t primitive = 0;
  bool front_facing = true;          ///< counter-clockwise on screen; true for everything without a back
  const std::int32_t* x_px = nullptr;  ///< [n]
  const std::int32_t* y_px = nullptr;  ///< [n]
  const float* depth = nullptr;        ///< [n]
  const glm::vec4* material = nullptr;  ///< [n] draw colour × vertex colour × filtered texel: the default result
  const glm::vec4* color = nullptr;     ///< [n] draw colour × vertex colour
  const glm::vec4* texel = nullptr;     ///< [n] filtered texel, white where the draw has no texture
  const glm::vec3* normal = nullptr;    ///< [n] interpolated, not normalized; (0,0,0) where the draw has none
  const glm::vec2* uv = nullptr;        ///< [n] (0,0) where the draw has none
};

/// Writes rgba[0 … batch.n).
using ShadeFunction = void (*)(const void* state, const ShadeBatch& batch, glm::vec4* rgba) noexcept;

/// A batch function and what it remembers. Empty means: the material as it is.
struct Shader {
  ShadeFunction function = nullptr;
  std::shared_ptr<const void> state;
};

/// One sample of a batch.
struct Pixel {
  std::int32_t x_px, y_px;
  float depth;
  glm::vec4 material, color, texel;
  glm::vec3 normal;
  glm::vec2 uv;
  std::uint32_t draw, primitive;
  bool front_facing;
};

/// Wraps a function object `glm::vec4 shade(const Pixel&)` as a Shader.
template <class Shade>
[[nodiscard]] Shader pixel_shader(Shade shade) {
  static_assert(std::is_invocable_r_v<glm::vec4, const Shade&, const Pixel&>, "expected glm::vec4 shade(const Pixel&)");
  const ShadeFunction run = [](const void* state, const ShadeBatch& in, glm::vec4* rgba) noexcept {
    const Shade& shade_one = *static_cast<const Shade*>(state);
    for (int i = 0; i < in.n; ++i) {
      rgba[i] = shade_one(Pixel{in.x_px[i], in.y_px[i], in.depth[i], in.material[i], in.color[i], in.texel[i],
                                in.normal[i], in.uv[i], in.draw, in.primitive, in.front_facing});
    }
  };
  return Shader{run, std::make_shared<const Shade>(std::move(shade))};
}

/// Lambert: material · (ambient + (1 − ambient) · max(n·l, 0)), or |n·l| when two-sided; alpha is kept. n is the
/// interpolated normal times `light_from_normal`, made a unit vector; one that is zero or not finite has n·l = 0.
struct Lambert {
  glm::vec3 to_light{0.0f, 1.0f, 0.0f};  ///< unit vector towards the light
  float ambient = 0.25f;                 ///< 0…1
  bool two_sided = false;
  glm::mat3 light_from_normal{1.0f};  ///< takes normals to directions in the light's space, of any length
  bool turns_backs = false;           ///< the back is lit as if its normals pointed the other way
  bool front_is_clockwise = false;    ///< a mirrored draw: its back is what the renderer calls its front
};
[[nodiscard]] Shader lambert_shader(const Lambert& params);

/// The cut-out of masked materials. A sample whose alpha, of 1, is at least the cutoff becomes opaque, with its colour
/// divided by its alpha; one of alpha 0 that is kept is black. Others become 0 all over, for an alpha test to drop.
struct CutOut {
  double cutoff = 0.5;  ///< any; NaN keeps nothing
  float full = 1.0f;    ///< 1 in the target's unit: 255 for rgba8
  /// Of each 4×4 of the picture, those pixels that are kept at all, as an ordered dither has them: bit x mod 4 +
  /// 4 · (y mod 4). In the others, too, samples become 0.
  std::uint16_t pixels = 0xFFFF;
  [[nodiscard]] bool keeps(std::int32_t x_px, std::int32_t y_px) const {
    return (pixels >> ((x_px & 3) + 4 * (y_px & 3)) & 1) != 0;
  }
};

/// The material, cut out first and then lit, as far as each is there.
struct MaterialShading {
  std::optional<CutOut> cut_out;
  std::optional<Lambert> light;
};
/// An empty shader where there is neither.
[[nodiscard]] Shader material_shader(const MaterialShading& params);

/// What material_shader or lambert_shader was given; null for other shaders. The fast pipeline has kernels for these.
[[nodiscard]] const MaterialShading* material_of(const Shader& shader);

}  // namespace lode::raster

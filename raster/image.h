#pragma once
/// The target of a render: up to three planes of the same size. Row 0 is the top row, x runs right, y runs
/// down; pixel (x, y) is element y * size_px.x + x of every plane.

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <glm/gtc/type_precision.hpp>
#include <vector>

namespace lode::raster {

/// rgba8: 8-bit code values, blended as they are; colours on their way there are floats of 0…255.
/// rgba32f: linear light, premultiplied by alpha; 1 is full.
enum class ColorFormat : std::uint8_t { rgba8, rgba32f };

/// Whose sample it is: a draw's id and the primitive's index within it. kNoId twice where nothing was drawn.
struct Ids {
  std::uint32_t draw;
  std::uint32_t primitive;
  friend bool operator==(const Ids&, const Ids&) = default;
};
inline constexpr std::uint32_t kNoId = 0xFFFFFFFFu;

/// Largest width and height of a target: its last sample stays inside the guard band (C1).
inline constexpr int kMaxTargetSize_px = 32768;

/// A plane is either empty (then it is not written) or holds exactly one element a pixel; `render` checks.
struct Image {
  glm::ivec2 size_px{0, 0};
  ColorFormat format = ColorFormat::rgba8;
  std::vector<glm::u8vec4> rgba8;  ///< used when format is rgba8
  std::vector<glm::vec4> rgba32f;  ///< used when format is rgba32f
  std::vector<float> depth;        ///< [0, 1], 1 near, 0 far or nothing
  std::vector<Ids> ids;
};

/// Which planes `make_image` allocates.
struct Planes {
  bool color = true;
  bool depth = true;
  bool ids = true;
};

/// A zeroed image. Throws Error: bad_input for a size below 0 or above kMaxTargetSize_px, out_of_memory.
[[nodiscard]] Image make_image(glm::ivec2 size_px, ColorFormat format, Planes planes = {});

}  // namespace lode::raster

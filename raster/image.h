#pragma once
/// The target of a render: up to three planes of the same size. Row 0 is the top row, x runs right, y runs
/// down; pixel (x, y) is element y * size_px.x + x of every plane.

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <glm/gtc/type_precision.hpp>
#include <new>
#include <vector>

namespace lode::raster {

/// Memory that begins with a line of the cache, so that a strip of a tile's row is whole lines.
template <class T>
struct LineAllocator {
  using value_type = T;
  static constexpr std::align_val_t kAlignment{64};
  LineAllocator() = default;
  template <class U>
  LineAllocator(const LineAllocator<U>&) {}
  [[nodiscard]] T* allocate(std::size_t n) {
    if (n > std::size_t(-1) / sizeof(T)) throw std::bad_array_new_length();
    return static_cast<T*>(::operator new(n * sizeof(T), kAlignment));
  }
  void deallocate(T* p, std::size_t) { ::operator delete(p, kAlignment); }
  friend bool operator==(const LineAllocator&, const LineAllocator&) { return true; }
};
template <class T>
using PixelPlane = std::vector<T, LineAllocator<T>>;

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
  PixelPlane<glm::u8vec4> rgba8;  ///< used when format is rgba8
  PixelPlane<glm::vec4> rgba32f;  ///< used when format is rgba32f
  PixelPlane<float> depth;        ///< [0, 1], 1 near, 0 far or nothing
  PixelPlane<Ids> ids;
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

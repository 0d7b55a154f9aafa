// Texels times colours, as the reference multiplies them, and textured samples for the resolve.
// Compiled once for each instruction set (Highway's re-included headers).

#include <cstdint>

#include "raster/fast/kernels.h"

#if defined(LODE_RASTER_FAST_TINT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LODE_RASTER_FAST_TINT_INL_H_
#undef LODE_RASTER_FAST_TINT_INL_H_
#else
#define LODE_RASTER_FAST_TINT_INL_H_
#endif

#include "raster/fast/surface-inl.h"
#include "raster/fast/texture-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lode::raster::fast {
namespace HWY_NAMESPACE {

/// Weights of the vertices at half of the lanes, from lane `first` of a 4×4 on: rounded once (C7).
HWY_INLINE HalfWeights WeightsAt(const TexturedTriangle& t, int x_fx8, int y_fx8, std::size_t first) {
  const Doubles d;
  const HalfInts i32;
  const HalfFloats f;
  const auto x = hn::PromoteTo(d, hn::Add(hn::Set(i32, x_fx8), hn::Load(i32, kLaneX_fx8 + first)));
  const auto y = hn::PromoteTo(d, hn::Add(hn::Set(i32, y_fx8), hn::Load(i32, kLaneY_fx8 + first)));
  const CornerWeights w = CornerWeightsAt(t, x, y);
  return {{hn::DemoteTo(f, w.b[0]), hn::DemoteTo(f, w.b[1]), hn::DemoteTo(f, w.b[2])}};
}

/// The draw's colour times the vertices', of 255: channel c.
HWY_INLINE hn::Vec<HalfFloats> ColorAt(const TexturedTriangle& t, const HalfWeights& weights, std::size_t c) {
  const HalfFloats f;
  const auto color = hn::Set(f, t.color[c]);
  if (!t.has_vertex_colors) return color;
  const hn::Vec<HalfFloats> corners[3] = {hn::Set(f, t.vertex_colors[0][c]), hn::Set(f, t.vertex_colors[1][c]),
                                          hn::Set(f, t.vertex_colors[2][c])};
  const auto of_vertices = InHull(weights.b, corners);
  return t.has_color ? hn::Div(hn::Mul(color, of_vertices), hn::Set(f, 255.0f)) : of_vertices;
}

/// Sixteen texels become colours · texels / 255 in float, rounded to bytes (C8).
HWY_INLINE void Tint(const TexturedTriangle& t, int x_fx8, int y_fx8, std::uint32_t* bytes) {
  const Doubles d;
  const HalfInts i32;
  const HalfFloats f;
  alignas(64) float rgba[64];
  for (std::size_t first = 0; first < 16; first += hn::Lanes(d)) {
    HalfWeights weights{};
    if (t.has_vertex_colors) weights = WeightsAt(t, x_fx8, y_fx8, first);
    auto texels = hn::LoadU(i32, reinterpret_cast<const std::int32_t*>(bytes) + first);
    for (std::size_t c = 0; c < 4; ++c) {
      const auto texel = hn::ConvertTo(f, hn::And(texels, hn::Set(i32, 255)));
      hn::StoreU(hn::Div(hn::Mul(ColorAt(t, weights, c), texel), hn::Set(f, 255.0f)), f, rgba + 16 * c + first);
      texels = hn::ShiftRight<8>(texels);
    }
  }
  StoreBytes(rgba, bytes);
}

std::uint64_t ShadeTextured(const TexturedTriangle& t, int x_fx8, int y_fx8, std::uint32_t lanes,
                            std::uint32_t* bytes) {
  const std::uint64_t n_read = TexelsOf(t, x_fx8, y_fx8, lanes, bytes);
  if (t.has_color || t.has_vertex_colors) Tint(t, x_fx8, y_fx8, bytes);  // white leaves a texel as it is: 255·x/255
  return n_read;
}

}  // namespace HWY_NAMESPACE
}  // namespace lode::raster::fast
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard

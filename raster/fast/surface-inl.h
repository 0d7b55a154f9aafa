// Surfaces: colours, light and texture coordinates of sixteen samples, in the reference's order of operations (C7), and
// colours as targets keep them (C8).
// Compiled once for each instruction set (Highway's re-included headers).

#include <array>
#include <cstdint>

#include "raster/fast/kernels.h"

#if defined(LODE_RASTER_FAST_SURFACE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LODE_RASTER_FAST_SURFACE_INL_H_
#undef LODE_RASTER_FAST_SURFACE_INL_H_
#else
#define LODE_RASTER_FAST_SURFACE_INL_H_
#endif

#include "raster/fast/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lode::raster::fast {
namespace HWY_NAMESPACE {

using D = hn::Vec<Doubles>;

/// (b₀·a₀ + b₁·a₁) + b₂·a₂, inside the hull of the three (C7), in float or double.
template <class V>
HWY_INLINE V InHull(const V (&b)[3], const V (&a)[3]) {
  const auto least = [](V x, V y) HWY_ATTR { return hn::IfThenElse(hn::Lt(y, x), y, x); };  // std::min
  const auto most = [](V x, V y) HWY_ATTR { return hn::IfThenElse(hn::Lt(x, y), y, x); };   // std::max
  const V value = hn::Add(hn::Add(hn::Mul(b[0], a[0]), hn::Mul(b[1], a[1])), hn::Mul(b[2], a[2]));
  const V low = least(least(a[0], a[1]), a[2]), high = most(most(a[0], a[1]), a[2]);
  return hn::IfThenElse(hn::Lt(value, low), low, hn::IfThenElse(hn::Gt(value, high), high, value));
}
template <class Tag, class T>
HWY_INLINE hn::Vec<Tag> InHullOf(Tag tag, const hn::Vec<Tag> (&b)[3], const std::array<T, 3>& values) {
  const hn::Vec<Tag> a[3] = {hn::Set(tag, values[0]), hn::Set(tag, values[1]), hn::Set(tag, values[2])};
  return InHull(b, a);
}

/// Weights of the corners at half of the lanes.
struct CornerWeights {
  D b[3];
  D sum;  ///< of edge / w
};
HWY_INLINE CornerWeights CornerWeightsAt(const TriangleEdges& t, D x, D y) {
  const Doubles d;
  D q[3];
  for (std::size_t k = 0; k < 3; ++k) {
    q[k] = hn::Add(hn::Add(hn::Mul(hn::Set(d, t.edge_x[k]), x), hn::Mul(hn::Set(d, t.edge_y[k]), y)),
                   hn::Set(d, t.edge_c[k]));  // exact
    if (!t.affine) q[k] = hn::Div(q[k], hn::Set(d, t.w[k]));
  }
  CornerWeights w;
  w.sum = hn::Add(hn::Add(q[0], q[1]), q[2]);
  for (std::size_t k = 0; k < 3; ++k) w.b[k] = hn::Div(q[k], w.sum);
  return w;
}

/// Weights of the primitive's own vertices, rounded once.
struct HalfWeights {
  hn::Vec<HalfFloats> b[3];
};
HWY_INLINE HalfWeights VertexWeightsOf(const SurfaceTriangle& t, const CornerWeights& w) {
  const Doubles d;
  const HalfFloats f;
  HalfWeights own;
  for (std::size_t j = 0; j < 3; ++j) {
    D b = w.b[j];
    if (t.clipped) {
      const auto part = [&](std::size_t k) HWY_ATTR { return hn::Mul(w.b[k], hn::Set(d, t.polygon[k][j])); };
      b = hn::Add(hn::Add(part(0), part(1)), part(2));
    }
    own.b[j] = hn::DemoteTo(f, b);
  }
  return own;
}

/// Texture coordinates, and for trilinear filters the square of the longer derivative, of half of the lanes.
HWY_INLINE void StoreUvs(const Surface& s, const SurfaceTriangle& t, const CornerWeights& w, std::size_t lane,
                         SurfaceSamples& out) {
  const Doubles d;
  D uv[2];
  for (std::size_t c = 0; c < 2; ++c) uv[c] = InHullOf(d, w.b, t.uvs[c]);
  hn::Store(uv[0], d, out.u + lane);
  hn::Store(uv[1], d, out.v + lane);
  if (s.sampler.filter != Filter::trilinear) return;
  const glm::ivec2 size_px = s.texture->levels.front().size_px;
  D longest = hn::Zero(d);
  for (std::size_t direction = 0; direction < 2; ++direction) {
    const auto& slopes = t.weight_slopes[direction];
    D squared = hn::Zero(d);
    for (std::size_t c = 0; c < 2; ++c) {  // ∂u = Σ ∂qᵢ (uᵢ − u) / Σ qᵢ
      const auto part = [&](std::size_t k) HWY_ATTR {
        return hn::Mul(hn::Set(d, slopes[k]), hn::Sub(hn::Set(d, t.uvs[c][k]), uv[c]));
      };
      const D slope = hn::Div(hn::Add(hn::Add(part(0), part(1)), part(2)), w.sum);
      const D px = hn::Mul(slope, hn::Set(d, double(c == 0 ? size_px.x : size_px.y)));
      squared = c == 0 ? hn::Mul(px, px) : hn::Add(squared, hn::Mul(px, px));
    }
    squared = hn::IfThenElseZero(hn::Eq(squared, squared), squared);  // NaN is made 0
    longest = direction == 0 ? squared : hn::IfThenElse(hn::Lt(longest, squared), squared, longest);
  }
  hn::Store(longest, d, out.rho_squared + lane);
}

/// `Lambert` of interpolated normals: what the material is multiplied by.
HWY_INLINE F LightOn(const Lambert& lambert, const F (&normal)[3], hn::Mask<Floats> front) {
  const Floats f;
  const auto zero = hn::Zero(f);
  F n[3];
  for (int row = 0; row < 3; ++row) {
    const auto part = [&](int axis)
                          HWY_ATTR { return hn::Mul(hn::Set(f, lambert.light_from_normal[axis][row]), normal[axis]); };
    n[row] = hn::Add(hn::Add(part(0), part(1)), part(2));
  }
  const F largest = hn::Max(hn::Max(hn::Abs(n[0]), hn::Abs(n[1])), hn::Abs(n[2]));
  const auto finite = hn::And(hn::And(hn::IsFinite(n[0]), hn::IsFinite(n[1])), hn::IsFinite(n[2]));
  const auto usable = hn::And(finite, hn::Gt(largest, zero));
  for (F& axis : n) axis = hn::Div(axis, largest);
  const F length = hn::Sqrt(hn::Add(hn::Add(hn::Mul(n[0], n[0]), hn::Mul(n[1], n[1])), hn::Mul(n[2], n[2])));
  const auto along = [&](int axis)
                         HWY_ATTR { return hn::Mul(hn::Div(n[axis], length), hn::Set(f, lambert.to_light[axis])); };
  F cosine = hn::IfThenElseZero(usable, hn::Add(hn::Add(along(0), along(1)), along(2)));
  if (lambert.turns_backs) {
    const auto backs = lambert.front_is_clockwise ? front : hn::Not(front);
    cosine = hn::IfThenElse(backs, hn::Neg(cosine), cosine);
  }
  const F facing =
      lambert.two_sided ? hn::Abs(cosine) : hn::IfThenElse(hn::Lt(cosine, zero), zero, cosine);  // std::max
  return hn::Add(hn::Set(f, lambert.ambient), hn::Mul(hn::Set(f, 1.0f - lambert.ambient), facing));
}

/// Colour and light of as many samples as Floats has lanes. attribute(c, i): attribute c (0…3 colour, 4…6 normal) of
/// vertex i.
template <class Attribute>
HWY_INLINE void StoreColors(const Surface& s, const F (&b)[3], hn::Mask<Floats> front, const Attribute& attribute,
                            std::size_t lane, SurfaceSamples& out) {
  const Floats f;
  const auto interpolated = [&](std::size_t c) HWY_ATTR {
    const F a[3] = {attribute(c, 0), attribute(c, 1), attribute(c, 2)};
    return InHull(b, a);
  };
  F light = hn::Zero(f);
  if (s.lambert) {
    F normal[3] = {hn::Zero(f), hn::Zero(f), hn::Zero(f)};
    for (std::size_t axis = 0; axis < 3 && s.has_normals; ++axis) normal[axis] = interpolated(4 + axis);
    light = LightOn(*s.lambert, normal, front);
    hn::Store(light, f, out.light + lane);
  }
  for (std::size_t c = 0; c < 4; ++c) {
    F value = hn::Set(f, s.color[c]);
    if (s.has_vertex_colors) {
      const F of_vertices = interpolated(c);
      value = s.has_color ? hn::Mul(value, of_vertices) : of_vertices;
      if (s.has_color && s.full != 1.0f) value = hn::Div(value, hn::Set(f, s.full));
    }
    if (s.lambert && !s.texture && !s.cut_out && c < 3) value = hn::Mul(value, light);
    hn::Store(value, f, out.rgba[c] + lane);
  }
}

void ShadeSurface(const Surface& s, const SurfaceTriangle& t, int x_fx8, int y_fx8, SurfaceSamples& out) {
  const Doubles d;
  const HalfInts i32;
  const Floats f;
  const bool varies = !t.flat && (s.has_vertex_colors || (s.lambert && s.has_normals));
  const bool weighs = varies || s.texture;
  const auto attribute = [&](std::size_t c, std::size_t i)
                             HWY_ATTR { return hn::Set(Floats(), c < 4 ? t.colors[c][i] : t.normals[c - 4][i]); };
  const auto front = hn::RebindMask(f, hn::Eq(hn::Set(Ints(), t.front_facing ? 1 : 0), hn::Set(Ints(), 1)));
  for (std::size_t lane = 0; lane < 16; lane += hn::Lanes(f)) {
    F b[3] = {hn::Zero(f), hn::Zero(f), hn::Zero(f)};
    if (weighs) {
      HalfWeights halves[2];
      for (std::size_t h = 0; h < 2; ++h) {
        const std::size_t first = lane + h * hn::Lanes(d);
        const auto x = hn::PromoteTo(d, hn::Add(hn::Set(i32, x_fx8), hn::Load(i32, kLaneX_fx8 + first)));
        const auto y = hn::PromoteTo(d, hn::Add(hn::Set(i32, y_fx8), hn::Load(i32, kLaneY_fx8 + first)));
        const CornerWeights w = CornerWeightsAt(t, x, y);
        if (s.texture) StoreUvs(s, t, w, first, out);
        halves[h] = VertexWeightsOf(t, w);
      }
      for (std::size_t k = 0; k < 3; ++k) b[k] = BothHalves(f, halves[0].b[k], halves[1].b[k]);
    }
    StoreColors(s, b, front, attribute, lane, out);
  }
}

void CutOutSurface(const Surface& s, SurfaceSamples& samples) {
  const Floats f;
  const auto zero = hn::Zero(f), opaque = hn::Set(f, s.opaque);
  for (std::size_t lane = 0; lane < 16; lane += hn::Lanes(f)) {
    const auto alpha = hn::Load(f, samples.rgba[3] + lane);
    const auto kept = hn::Ge(alpha, hn::Set(f, s.least_kept));
    const auto has_color = hn::And(kept, hn::Gt(alpha, zero));
    for (std::size_t c = 0; c < 3; ++c) {
      const auto straight = hn::Mul(hn::Div(hn::Load(f, samples.rgba[c] + lane), alpha), opaque);
      auto value = hn::IfThenElseZero(has_color, straight);
      if (s.lambert) value = hn::Mul(value, hn::Load(f, samples.light + lane));
      hn::Store(value, f, samples.rgba[c] + lane);
    }
    hn::Store(hn::IfThenElseZero(kept, opaque), f, samples.rgba[3] + lane);
  }
}

/// Values as float targets keep them (C8): one NaN, one zero.
template <class Tag>
HWY_INLINE hn::Vec<Tag> Stored(Tag f, hn::Vec<Tag> value) {
  const auto v = hn::Add(value, hn::Zero(f));  // −0 becomes +0
  return hn::IfThenElse(hn::Eq(v, v), v, hn::BitCast(f, hn::Set(hn::RebindToSigned<Tag>(), 0x7FC00000)));
}

void StoreFloats(const SurfaceSamples& samples, float* rgba) {
  const Floats f;
  for (std::size_t lane = 0; lane < 16; lane += hn::Lanes(f)) {
    F stored[4];
    for (std::size_t c = 0; c < 4; ++c) stored[c] = Stored(f, hn::Load(f, samples.rgba[c] + lane));
    hn::StoreInterleaved4(stored[0], stored[1], stored[2], stored[3], f, rgba + 4 * lane);
  }
}

void StoreBytes(const float* rgba, std::uint32_t* bytes) {
  const Floats f;
  const Ints di;
  for (std::size_t lane = 0; lane < 16; lane += hn::Lanes(f)) {
    auto packed = hn::Zero(di);
    for (int c = 3; c >= 0; --c) {
      const auto v = hn::LoadU(f, rgba + 16 * c + lane);
      const auto whole = hn::Trunc(v);
      auto byte = hn::ConvertTo(
          di, hn::IfThenElse(hn::Ge(hn::Sub(v, whole), hn::Set(f, 0.5f)), hn::Add(whole, hn::Set(f, 1.0f)), whole));
      byte = hn::IfThenElse(hn::RebindMask(di, hn::Ge(v, hn::Set(f, 255.0f))), hn::Set(di, 255), byte);
      byte = hn::IfThenElseZero(hn::RebindMask(di, hn::Gt(v, hn::Zero(f))), byte);
      packed = hn::Or(hn::ShiftLeft<8>(packed), byte);
    }
    hn::StoreU(packed, di, reinterpret_cast<std::int32_t*>(bytes) + lane);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace lode::raster::fast
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard

#include "raster/reference/clip.h"

#include <algorithm>
#include <cmath>

#include "raster/reference/exact_sum.h"

namespace lode::raster::reference {
namespace {

constexpr double kGuard = kGuard_fx8;

double clamp_to(double value, double limit) {  // keeps NaN
  return value > limit ? limit : (value < -limit ? -limit : value);
}

/// Signed distance to plane k, up to a positive factor: ≥ 0 inside.
double plane_distance(int k, const Viewport& v, const glm::dvec4& p) {
  switch (k) {
    case 0: return p.w - p.z;
    case 1: return p.w - kMinW;
    case 2: return p.z;
    case 3: return (v.half_fx8.x * p.x + v.centre_fx8.x * p.w) + kGuard * p.w;
    case 4: return kGuard * p.w - (v.half_fx8.x * p.x + v.centre_fx8.x * p.w);
    case 5: return (v.centre_fx8.y * p.w - v.half_fx8.y * p.y) + kGuard * p.w;
    default: return kGuard * p.w - (v.centre_fx8.y * p.w - v.half_fx8.y * p.y);
  }
}

/// The same without rounding.
ExactSum exact_distance(int k, const Viewport& v, const glm::dvec4& p) {
  ExactSum d;
  if (k == 0 || k == 1) d.add(p.w);
  if (k == 0) d.add(-p.z);
  if (k == 1) d.add(-kMinW);
  if (k == 2) d.add(p.z);
  if (k < 3) return d;
  const double sign = k == 3 || k == 5 ? 1.0 : -1.0;
  d.add_product(sign * (k < 5 ? v.half_fx8.x : -v.half_fx8.y), k < 5 ? p.x : p.y);
  d.add_product(sign * (k < 5 ? v.centre_fx8.x : v.centre_fx8.y), p.w);
  d.add_product(kGuard, p.w);
  return d;
}

/// Interpolation loses what makes up a pixel where an end is much larger than the cut's w: half a place of that end is
/// then more than 2^-17 of a sub-pixel in the window.
bool needs_exact_cut(const Viewport& v, const glm::dvec4& a, const glm::dvec4& b, double w_cut) {
  double largest = 0.0;
  for (int i = 0; i < 4; ++i) largest = std::max({largest, std::abs(a[i]), std::abs(b[i])});
  return !(largest * std::max(v.half_fx8.x, v.half_fx8.y) <= 0x1p36 * w_cut);
}

/// (a·d_b − b·d_a) / (d_b − d_a): each component is rounded three times in all, whatever the ends.
glm::dvec4 exact_cut(int k, const Viewport& v, const glm::dvec4& a, const glm::dvec4& b) {
  const ExactSum d_a = exact_distance(k, v, a), d_b = exact_distance(k, v, b);
  ExactSum difference = d_b;
  difference.add_product(d_a, -1.0);
  glm::dvec4 cut;
  for (int i = 0; i < 4; ++i) {
    ExactSum numerator;
    numerator.add_product(d_b, a[i]);
    numerator.add_product(d_a, -b[i]);
    cut[i] = numerator.value() / difference.value();
  }
  return cut;
}

/// The point of an edge on plane k; its ends lie on either side. It is computed from the end nearer to the plane:
/// t ≤ ½, so the point stays between the ends and is exact to rounding even where the other end is at 2^300 (from
/// that end, everything near the screen would be lost). Where both ends are that far out it is computed exactly.
ClipVertex intersect_edge(int k, const Viewport& v, const ClipVertex& end_0, const ClipVertex& end_1) {
  const double d_0 = plane_distance(k, v, end_0.position), d_1 = plane_distance(k, v, end_1.position);
  const double far_0 = std::abs(d_0), far_1 = std::abs(d_1);
  const bool swap = far_0 != far_1 ? far_1 < far_0 : canonically_before(end_1.position, end_0.position);
  const ClipVertex& a = swap ? end_1 : end_0;
  const ClipVertex& b = swap ? end_0 : end_1;
  const double d_a = swap ? d_1 : d_0;
  const double d_b = swap ? d_0 : d_1;
  const double t = d_a / (d_a - d_b);
  ClipVertex p;
  for (int i = 0; i < 4; ++i) p.position[i] = a.position[i] + t * (b.position[i] - a.position[i]);
  if (d_a != 0.0 && needs_exact_cut(v, a.position, b.position, p.position.w)) {  // at d_a = 0 it is a itself
    p.position = exact_cut(k, v, a.position, b.position);
  }
  for (std::size_t i = 0; i < 3; ++i) p.weights[i] = a.weights[i] + t * (b.weights[i] - a.weights[i]);
  if (k == 0) p.position.z = p.position.w;
  if (k == 1) p.position.w = kMinW;
  if (k == 2) p.position.z = 0.0;
  return p;
}

ClipPolygon clip_by_plane(int k, const Viewport& v, const ClipPolygon& in) {
  ClipPolygon out;
  for (int i = 0; i < in.n; ++i) {
    const ClipVertex& a = in.vertices[std::size_t(i)];
    const ClipVertex& b = in.vertices[std::size_t((i + 1) % in.n)];
    const bool a_inside = plane_distance(k, v, a.position) >= 0.0;
    const bool b_inside = plane_distance(k, v, b.position) >= 0.0;
    if (a_inside) out.vertices[std::size_t(out.n++)] = a;
    if (a_inside != b_inside) out.vertices[std::size_t(out.n++)] = intersect_edge(k, v, a, b);
  }
  return out;
}

/// Rounds half to even (C1), from an origin that is a whole number.
std::int32_t snap_fx8(double offset_fx8, double origin_fx8) {
  return static_cast<std::int32_t>(clamp_to(std::rint(offset_fx8) + origin_fx8, kGuard));
}

}  // namespace

glm::dvec4 clip_position(const Vertices& vertices, std::uint32_t i) {
  glm::dvec4 clip;
  if (const auto* object = std::get_if<ObjectVertices>(&vertices)) {
    const glm::vec3& p = object->positions[i];
    const double x = clamp_to(p.x, 0x1p128), y = clamp_to(p.y, 0x1p128), z = clamp_to(p.z, 0x1p128);
    const glm::dmat4& m = object->clip_from_object;
    for (int row = 0; row < 4; ++row) clip[row] = ((m[0][row] * x + m[1][row] * y) + m[2][row] * z) + m[3][row];
  } else {
    clip = std::get<ClipVertices>(vertices).positions[i];
  }
  for (int c = 0; c < 4; ++c) clip[c] = clamp_to(clip[c], 0x1p300);
  return clip;
}

bool has_nan(const glm::dvec4& p) {
  return std::isnan(p.x) || std::isnan(p.y) || std::isnan(p.z) || std::isnan(p.w);
}

Viewport make_viewport(const Rect& rect) {
  return {{256.0 * rect.origin_px.x + 128.0 * rect.size_px.x, 256.0 * rect.origin_px.y + 128.0 * rect.size_px.y},
          {128.0 * rect.size_px.x, 128.0 * rect.size_px.y}};
}

std::uint32_t outside_planes(const Viewport& viewport, const glm::dvec4& p) {
  std::uint32_t outside = 0;
  for (int k = 0; k < kClipPlanes; ++k) {
    if (!(plane_distance(k, viewport, p) >= 0.0)) outside |= 1u << k;
  }
  return outside;
}

ClipPolygon clip_triangle(const Viewport& viewport, const std::array<glm::dvec4, 3>& corners) {
  ClipPolygon polygon;
  polygon.n = 3;
  for (std::size_t i = 0; i < 3; ++i) {
    polygon.vertices[i].position = corners[i];
    polygon.vertices[i].weights[i] = 1.0;
  }
  for (int k = 0; k < kClipPlanes && polygon.n > 0; ++k) polygon = clip_by_plane(k, viewport, polygon);
  if (polygon.n < 3) polygon.n = 0;
  return polygon;
}

ClipPolygon clip_segment(const Viewport& viewport, const glm::dvec4& a, const glm::dvec4& b) {
  ClipVertex ends[2] = {{a, {1.0, 0.0, 0.0}}, {b, {0.0, 1.0, 0.0}}};
  for (int k = 0; k < kClipPlanes; ++k) {
    const bool a_inside = plane_distance(k, viewport, ends[0].position) >= 0.0;
    const bool b_inside = plane_distance(k, viewport, ends[1].position) >= 0.0;
    if (!a_inside && !b_inside) return {};
    if (a_inside && b_inside) continue;
    const ClipVertex cut = intersect_edge(k, viewport, ends[0], ends[1]);
    ends[a_inside ? 1 : 0] = cut;
  }
  ClipPolygon segment;
  segment.vertices[0] = ends[0];
  segment.vertices[1] = ends[1];
  segment.n = 2;
  return segment;
}

WindowVertex window_vertex(const Viewport& viewport, const glm::dvec4& p) {
  // Rounded before the viewport's centre is added, so that a moved viewport moves the picture and nothing else.
  const std::int32_t x_fx8 = snap_fx8((p.x / p.w) * viewport.half_fx8.x, viewport.centre_fx8.x);
  const std::int32_t y_fx8 = snap_fx8(-(p.y / p.w) * viewport.half_fx8.y, viewport.centre_fx8.y);
  const double z = std::clamp(p.z / p.w, 0.0, 1.0) + 0.0;  // + 0.0: one zero
  return {{x_fx8, y_fx8}, z, p.w};
}

WindowVertex window_vertex(const glm::dvec3& p_px) {
  return {{snap_fx8(p_px.x * 256.0, 0.0), snap_fx8(p_px.y * 256.0, 0.0)}, std::clamp(p_px.z, 0.0, 1.0) + 0.0, 1.0};
}

bool canonically_before(const glm::dvec4& a, const glm::dvec4& b) {
  for (int i = 0; i < 4; ++i) {
    if (a[i] != b[i]) return a[i] < b[i];
  }
  return false;
}

}  // namespace lode::raster::reference

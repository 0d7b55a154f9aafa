#include "techniques/masked_occlusion/draw_inner_box.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <vector>

#include "geometry/hull_2d.h"
#include "geometry/projected_hull.h"

namespace lode::techniques {
namespace {

constexpr double kSmaller_px = 2.0 / 256.0;
constexpr double kDepthCircle_px = 4.0 / 256.0;
constexpr double kFloatRounding = 0x1p-22;  // of depths, here and in the picture
constexpr double kLargest_px = 0x1p20;      // so that rounding stays below a millionth of a pixel
constexpr double kAroundPicture_px = 64.0;  // kept of what is beyond: more than the buffer's padding
constexpr double kThinnest = 0x1p-20;       // faces of less area, of their size squared, are left to the outline

using Polygon = std::vector<glm::dvec3>;  ///< corners in px and depth, clockwise on screen (y down) or the other way
using Projected = std::array<glm::dvec3, 8>;

/// Counter-clockwise from outside; corner i has the box's high end along axis k where bit k of i is set.
constexpr std::array<std::array<std::size_t, 4>, 6> kFaces = {
    {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};

std::optional<Projected> projected(const geometry::Bounds& box, const glm::dmat4& clip_from_object,
                                   const glm::dvec2& size_px) {
  Projected result;
  const auto corners = geometry::corners(box);
  for (std::size_t i = 0; i < 8; ++i) {
    const glm::dvec4 p = clip_from_object * glm::dvec4(corners[i], 1.0);
    if (!(p.w > 0.0 && p.w - p.z > 0.0)) return std::nullopt;
    result[i] = {(0.5 + 0.5 * (p.x / p.w)) * size_px.x, (0.5 - 0.5 * (p.y / p.w)) * size_px.y, p.z / p.w};
    if (!(std::abs(result[i].x) <= kLargest_px && std::abs(result[i].y) <= kLargest_px)) return std::nullopt;
    if (!std::isfinite(result[i].z)) return std::nullopt;
  }
  return result;
}

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

/// Twice the area: positive if clockwise on screen.
double doubled_area(const Polygon& polygon) {
  double sum = 0.0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    sum += cross(glm::dvec2(polygon[i] - polygon[0]), glm::dvec2(polygon[i + 1] - polygon[0]));
  }
  return sum;
}

/// What is left of it where inside(p) ≥ 0; `inside` is linear. Sutherland & Hodgman (1974).
template <class Inside>
Polygon cut(const Polygon& polygon, const Inside& inside) {
  Polygon left;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double in_a = inside(a), in_b = inside(b);
    if (in_a >= 0.0) left.push_back(a);
    if ((in_a >= 0.0) != (in_b >= 0.0)) left.push_back(a + (b - a) * (in_a / (in_a - in_b)));
  }
  return left;
}

/// Without what is near its edges or far from the picture.
Polygon smaller(const Polygon& polygon, const glm::dvec2& size_px) {
  const double turn = doubled_area(polygon) > 0.0 ? 1.0 : -1.0;
  Polygon left = polygon;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec2 a(polygon[i]), edge = glm::dvec2(polygon[(i + 1) % polygon.size()]) - a;
    const double length = glm::length(edge);
    left = cut(left, [&](const glm::dvec3& p) { return turn * cross(edge, glm::dvec2(p) - a) - kSmaller_px * length; });
  }
  for (int axis = 0; axis < 2; ++axis) {
    left = cut(left, [&](const glm::dvec3& p) { return p[axis] + kAroundPicture_px; });
    left = cut(left, [&](const glm::dvec3& p) { return size_px[axis] + kAroundPicture_px - p[axis]; });
  }
  return left;
}

/// Of depth over a pixel, along x and y added up: at least what it changes over any step of that length. Nothing for a
/// face that is seen nearly edge-on.
std::optional<double> steepness(const Polygon& face) {
  const glm::dvec3 u = face[2] - face[0], v = face[3] - face[1];  // diagonals
  const double area = cross(glm::dvec2(u), glm::dvec2(v));
  const double size = glm::dot(glm::abs(glm::dvec2(u)) + glm::abs(glm::dvec2(v)), glm::dvec2(1.0));
  if (!(std::abs(area) > kThinnest * size * size)) return std::nullopt;
  return (std::abs(u.z * v.y - v.z * u.y) + std::abs(v.z * u.x - u.z * v.x)) / std::abs(area);
}

/// As a fan; every corner's depth falls by `drop`.
void draw_polygon(const Polygon& polygon, double drop, MaskedDepth& buffer, OccluderWork& work) {
  std::vector<glm::ivec2> p_fx8;
  std::vector<double> z;
  for (const glm::dvec3& p : polygon) {
    p_fx8.emplace_back(int(std::lround(256.0 * p.x)), int(std::lround(256.0 * p.y)));
    z.push_back(std::clamp(p.z - drop - kFloatRounding * std::abs(p.z), 0.0, 1.0));
  }
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    ++work.triangles;
    const ScreenTriangle triangle = {{p_fx8[0], p_fx8[i], p_fx8[i + 1]}, {z[0], z[i], z[i + 1]}};
    if (doubled_area(triangle) == 0 || sample_box(triangle, buffer.n_subtiles()).empty()) continue;
    const std::uint64_t n_subtiles = draw_triangle(triangle, buffer);
    work.drawn += n_subtiles > 0 ? 1 : 0;
    work.subtiles += n_subtiles;
  }
}

Polygon outline(const Projected& corners) {
  std::vector<glm::dvec2> flat;
  double farthest = corners[0].z;
  for (const glm::dvec3& p : corners) {
    flat.emplace_back(p);
    farthest = std::min(farthest, p.z);
  }
  Polygon result;
  for (const std::uint32_t i : geometry::convex_hull_2d(flat)) result.emplace_back(flat[i], farthest);
  return result;
}

}  // namespace

void draw_inner_box(const geometry::Bounds& box, const glm::dmat4& clip_from_object, bool mirrored, glm::ivec2 size_px,
                    MaskedDepth& buffer, OccluderWork& work) {
  const std::optional<Projected> corners = projected(box, clip_from_object, glm::dvec2(size_px));
  if (!corners) return;
  draw_polygon(smaller(outline(*corners), glm::dvec2(size_px)), 0.0, buffer, work);
  for (const auto& face : kFaces) {
    const Polygon polygon = {(*corners)[face[0]], (*corners)[face[1]], (*corners)[face[2]], (*corners)[face[3]]};
    const double area = doubled_area(polygon);
    if (mirrored ? area <= 0.0 : area >= 0.0) continue;  // seen from behind
    const std::optional<double> steep = steepness(polygon);
    if (!steep) continue;
    draw_polygon(smaller(polygon, glm::dvec2(size_px)), *steep * kDepthCircle_px, buffer, work);
  }
}

}  // namespace lode::techniques

#include "raster/reference/triangle.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

namespace lode::raster::reference {
namespace {

bool same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

std::array<double, 3> edge_values(const Triangle& t, glm::ivec2 p_fx8) {
  const std::array<EdgeFunction, 3> edges = edges_of(t);
  return {double(edges[0].at(p_fx8)), double(edges[1].at(p_fx8)), double(edges[2].at(p_fx8))};
}

/// Edge values over w: not yet normalised perspective weights of v[0], v[1], v[2].
std::array<double, 3> weights_over_w(const Triangle& t, const std::array<double, 3>& e) {
  if (t.affine) return e;
  return {e[0] / t.v[0].w, e[1] / t.v[1].w, e[2] / t.v[2].w};
}

double interpolate(const VertexWeights& b, double a0, double a1, double a2) {
  const double value = (b[0] * a0 + b[1] * a1) + b[2] * a2;
  return std::clamp(value, std::min({a0, a1, a2}), std::max({a0, a1, a2}));
}

}  // namespace

std::optional<Triangle> make_triangle(const std::array<WindowVertex, 3>& corners, std::array<int, 3>& order) {
  const std::int64_t area = doubled_area_fx16(corners[0].p_fx8, corners[1].p_fx8, corners[2].p_fx8);
  if (area == 0) return std::nullopt;
  order = {0, 1, 2};
  bool odd = false;
  const auto sort_pair = [&](std::size_t i, std::size_t j) {
    const glm::ivec2 a = corners[std::size_t(order[i])].p_fx8, b = corners[std::size_t(order[j])].p_fx8;
    if (b.x < a.x || (b.x == a.x && b.y < a.y)) {
      std::swap(order[i], order[j]);
      odd = !odd;
    }
  };
  sort_pair(0, 1);
  sort_pair(1, 2);
  sort_pair(0, 1);
  Triangle t;
  for (std::size_t i = 0; i < 3; ++i) t.v[i] = corners[std::size_t(order[i])];
  t.sign = (area > 0) != odd ? 1.0 : -1.0;
  t.affine = same_bits(t.v[0].w, t.v[1].w) && same_bits(t.v[1].w, t.v[2].w);
  return t;
}

PixelBox bounds_px(const Triangle& t, glm::ivec2 sample_fx8) {
  const glm::ivec2 a = t.v[0].p_fx8, b = t.v[1].p_fx8, c = t.v[2].p_fx8;
  return pixels_with_samples_in({std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y})},
                                {std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y})}, sample_fx8);
}

float depth_at(const Triangle& t, glm::ivec2 p_fx8) {
  const auto [e0, e1, e2] = edge_values(t, p_fx8);
  const double z0 = t.v[0].z, z1 = t.v[1].z, z2 = t.v[2].z;
  const double z = ((e0 * z0 + e1 * z1) + e2 * z2) / ((e0 + e1) + e2);  // C5: by division, in this order
  return static_cast<float>(std::clamp(z, std::min({z0, z1, z2}), std::max({z0, z1, z2})));
}

VertexWeights weights_at(const Triangle& t, glm::ivec2 p_fx8) {
  const auto [q0, q1, q2] = weights_over_w(t, edge_values(t, p_fx8));
  const double sum = (q0 + q1) + q2;
  const VertexWeights b = {q0 / sum, q1 / sum, q2 / sum};
  if (!t.polygon) return b;
  VertexWeights own = {0.0, 0.0, 0.0};  // of the primitive's vertices
  for (std::size_t j = 0; j < 3; ++j) {
    const auto& weights = t.polygon->weights;
    own[j] = (b[0] * weights[std::size_t(t.polygon_vertex[0])][j] + b[1] * weights[std::size_t(t.polygon_vertex[1])][j]) +
             b[2] * weights[std::size_t(t.polygon_vertex[2])][j];
  }
  return own;
}

std::array<glm::dvec2, 3> corner_uvs(const Triangle& t, const std::array<glm::vec2, 3>& uvs) {
  std::array<glm::dvec2, 3> corners;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!t.polygon) {
      corners[i] = glm::dvec2(uvs[i]);
    } else {
      const VertexWeights& b = t.polygon->weights[std::size_t(t.polygon_vertex[i])];
      corners[i] = {interpolate(b, uvs[0].x, uvs[1].x, uvs[2].x), interpolate(b, uvs[0].y, uvs[1].y, uvs[2].y)};
    }
  }
  return corners;
}

Footprint footprint_at(const Triangle& t, const VertexUvs& uvs, glm::ivec2 p_fx8) {
  if (!uvs) return {};
  const std::array<glm::dvec2, 3> uv = corner_uvs(t, *uvs);
  const std::array<EdgeFunction, 3> edges = edges_of(t);
  const std::array<double, 3> q = weights_over_w(t, edge_values(t, p_fx8));
  const double sum = (q[0] + q[1]) + q[2];
  const VertexWeights b = {q[0] / sum, q[1] / sum, q[2] / sum};

  Footprint f;
  f.uv = {interpolate(b, uv[0].x, uv[1].x, uv[2].x), interpolate(b, uv[0].y, uv[1].y, uv[2].y)};
  // u = Σ qᵢ uᵢ / Σ qᵢ with qᵢ linear in x and y, so ∂u = Σ ∂qᵢ (uᵢ − u) / Σ qᵢ.
  const std::array<double, 3> dq_dx =
      weights_over_w(t, {-256.0 * double(edges[0].dy), -256.0 * double(edges[1].dy), -256.0 * double(edges[2].dy)});
  const std::array<double, 3> dq_dy =
      weights_over_w(t, {256.0 * double(edges[0].dx), 256.0 * double(edges[1].dx), 256.0 * double(edges[2].dx)});
  for (int c = 0; c < 2; ++c) {
    const double d0 = uv[0][c] - f.uv[c], d1 = uv[1][c] - f.uv[c], d2 = uv[2][c] - f.uv[c];
    f.duv_dx[c] = ((dq_dx[0] * d0 + dq_dx[1] * d1) + dq_dx[2] * d2) / sum;
    f.duv_dy[c] = ((dq_dy[0] * d0 + dq_dy[1] * d1) + dq_dy[2] * d2) / sum;
  }
  return f;
}

bool owns_sample(const ClippedPolygon& polygon, int piece, glm::ivec2 p_fx8) {
  int winding = 0;
  std::array<int, 2> first = {-1, -1};  // of the negative pieces, of the positive ones
  const auto& v = polygon.vertices;
  for (std::size_t i = 0; i + 2 < v.size(); ++i) {
    std::array<int, 3> order;
    const std::optional<Triangle> t = make_triangle({v[0], v[i + 1], v[i + 2]}, order);
    if (!t) continue;
    bool inside = true;
    for (const EdgeFunction& e : edges_of(*t)) inside = inside && e.at(p_fx8) >= e.bias;
    if (!inside) continue;
    const bool positive = doubled_area_fx16(v[0].p_fx8, v[i + 1].p_fx8, v[i + 2].p_fx8) > 0;
    winding += positive ? 1 : -1;
    if (first[positive] < 0) first[positive] = int(i);
  }
  return winding != 0 && first[winding > 0] == piece;
}

}  // namespace lode::raster::reference

#pragma once
/// What is left of a triangle after clipping, on the screen: once in exact rationals, once in double with a bound.
///
/// A triangle is clipped to z ≤ w (near), w ≥ 2^-149, z ≥ 0 (far; with an infinite far plane nothing lies beyond) and
/// to the guard band of ±2^23/256 px, in the renderer's order (C4, Sutherland & Hodgman). Which side of a near or far
/// plane the renderer sees a corner on is certain only up to its rounding of M·p. So these planes can be moved by that
/// bound: outwards (`Planes::outer`: all that the renderer can keep) and inwards (`Planes::inner`: what it keeps in any
/// case).

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "experiments/truth/rational.h"
#include "experiments/truth/source_triangle.h"

namespace lode::experiments::truth {

/// What an edge of the polygon is: a piece of the triangle's own outline, or a cut at a plane.
enum class EdgeKind : std::uint8_t { outline, near_or_far, guard };

enum class Planes : std::uint8_t { exact, outer, inner };

struct ExactVertex {
  Rational x_px, y_px;                ///< window: y down
  Rational z;                         ///< depth: 1 near, 0 far
  double w = 1.0;                     ///< of the clip-space vertex, rounded
  EdgeKind edge = EdgeKind::outline;  ///< from this vertex to the next
};
/// Convex; no two neighbours coincide in place and depth; empty where nothing is left; it may have no area.
using ExactPolygon = std::vector<ExactVertex>;

[[nodiscard]] ExactPolygon exact_polygon(const SourceTriangle& triangle, glm::ivec2 size_px, Planes planes);

struct Vertex {
  double x_px = 0.0, y_px = 0.0, z = 0.0;
  EdgeKind edge = EdgeKind::outline;
};
inline constexpr int kMaxVertices = 10;  ///< 3 and one more for each of seven planes

/// The polygon in double. |x − exact|, |y − exact| ≤ error_px. |z − exact|, and |z − the renderer's own z of that
/// vertex|, ≤ error_z.
struct Polygon {
  std::array<Vertex, kMaxVertices> v;
  int n = 0;
  double error_px = 0.0;
  double error_z = 0.0;

  [[nodiscard]] const Vertex& next(int i) const { return v[std::size_t(i + 1 == n ? 0 : i + 1)]; }
};

[[nodiscard]] Polygon rounded(const ExactPolygon& exact);

}  // namespace lode::experiments::truth

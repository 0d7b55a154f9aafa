#pragma once
/// Which depths a renderer may give a sample of a triangle, over all placements of its vertices.
///
/// The depth at a sample s is z = Σ Eᵢzᵢ / Σ Eᵢ, Eᵢ twice the area of (s, the other two vertices). In any one
/// coordinate of any one vertex, Eᵢ and the sum are linear, so z is a quotient of two linear functions: monotone as
/// long as the sum, twice the area of the placed triangle, does not vanish. The area is multilinear in the six
/// coordinates, so it keeps its sign over all placements if it does at the 2⁶ corners, and then z takes its extremes
/// over all placements at corners, too: coordinate by coordinate, one of the two ends is at least as good. Where the
/// area can vanish, z is all that the rule of C5 leaves, which clamps it to its vertices' range.

#include <array>
#include <optional>

#include "experiments/truth/coverage.h"
#include "experiments/truth/polygon.h"

namespace lode::experiments::truth {

/// Depths low ≤ z ≤ high before the one rounding to float; rounded outwards, and with what the renderer's own
/// arithmetic in double may be off.
struct DepthInterval {
  double low = 0.0;
  double high = 0.0;

  /// Whether a float depth is one of them, rounded.
  [[nodiscard]] bool contains(float z) const { return float(low) <= z && z <= float(high); }
  /// Whether two triangles may have the same depth in a picture, or either be nearer.
  [[nodiscard]] bool overlaps(const DepthInterval& other) const {
    return float(low) <= float(other.high) && float(other.low) <= float(high);
  }
  void include(const DepthInterval& other) {
    if (other.low < low) low = other.low;
    if (other.high > high) high = other.high;
  }
};

/// The range of the three vertices' depths.
[[nodiscard]] DepthInterval vertex_range(const Vertex& a, const Vertex& b, const Vertex& c, double error_z);

/// Of one triangle, each vertex free within reach_px on each axis. In double, with a bound on the rounding; nothing
/// where that bound leaves the area's sign open, or would widen the interval by more than 2^-28 of its high end.
///   error_px, error_z   of the vertices, as in Polygon
[[nodiscard]] std::optional<DepthInterval> depth_interval(const std::array<Vertex, 3>& triangle, glm::dvec2 sample_px,
                                                          double reach_px, double error_px, double error_z);

/// The same in exact arithmetic, widened by error_z alone.
[[nodiscard]] DepthInterval exact_depth_interval(const std::array<ExactVertex, 3>& triangle, glm::dvec2 sample_px,
                                                 double reach_px, double error_z);

}  // namespace lode::experiments::truth

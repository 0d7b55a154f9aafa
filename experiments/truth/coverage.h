#pragma once
/// Whether a sample is covered however the vertices are snapped.
///
/// C1 lets every projected vertex, cut ones too, be placed anywhere within kSnap_px of its exact place on each axis.
/// The winding number of the outline around the sample is constant as long as no edge passes over the sample; so the
/// exact answer is everybody's answer unless some edge can. The places that an edge can reach, both its ends free in
/// their squares, are the union of the segments between two equal squares: the Minkowski sum of the segment and a
/// square, a convex hexagon. The sample lies in it where the segment meets the square around the sample, and for a
/// segment and a box there are three separating directions: x, y and across the edge. So: a pass is possible where, for
/// a sample s and an edge from a to b, with h = kSnap_px,
///
///   min(aₓ, bₓ) − h ≤ sₓ ≤ max(aₓ, bₓ) + h, the same for y, and |(b − a) × (s − a)| ≤ h·(|bₓ − aₓ| + |b_y − a_y|)
///
/// which is exact: no direction, corner or constant is left to choice.

#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>

#include "experiments/truth/polygon.h"

namespace lode::experiments::truth {

/// C1: half a sub-pixel for the snap and 2^-20 px for the arithmetic before it.
inline constexpr double kSnap_px = 1.0 / 512.0 + 0x1p-20;

enum class Coverage : std::uint8_t { out, uncertain, in };

struct PlacedCoverage {
  Coverage coverage = Coverage::out;
  /// Where uncertain: of the edges that can pass over the sample, an outline's if there is one.
  EdgeKind doubt = EdgeKind::outline;
};

/// Of a convex polygon, over all placements; in exact arithmetic.
[[nodiscard]] PlacedCoverage exact_coverage(const ExactPolygon& polygon, glm::dvec2 sample_px);

/// The same answer: in double where its error bound allows a decision, else by `exact()`.
[[nodiscard]] PlacedCoverage coverage(const Polygon& polygon, glm::dvec2 sample_px,
                                      const std::function<ExactPolygon()>& exact);

/// Whether a triangle of the polygon's vertices may cover the sample in some placement, each vertex free within
/// reach_px; errs towards yes.
[[nodiscard]] bool may_cover(const Vertex& a, const Vertex& b, const Vertex& c, glm::dvec2 sample_px, double reach_px);

}  // namespace lode::experiments::truth

#pragma once
/// The exact arbiter: what a renderer that keeps its contract (C1–C5) may answer for one triangle at one sample.
///
/// A triangle is prepared once for a view (clipped, projected, its facing judged), then judged at any number of
/// samples. Everything is decided in double with proven bounds and, where those do not suffice, in rationals. Pure
/// functions.

#include <glm/vec2.hpp>

#include "experiments/truth/coverage.h"
#include "experiments/truth/depth_interval.h"
#include "experiments/truth/polygon.h"
#include "experiments/truth/source_triangle.h"

namespace lode::experiments::truth {

struct PreparedTriangle {
  SourceTriangle source;
  glm::ivec2 size_px{0, 0};
  Polygon outer;  ///< all that may be kept; n = 0 if nothing is drawn for certain
  Polygon inner;  ///< what is kept for certain, if `two_polygons`; else outer is
  bool two_polygons = false;
  bool facing_doubtful = false;
  double reach_px = kSnap_px;  ///< how far a vertex of `outer` may be placed
  bool whole_range = false;    ///< the cuts themselves are in doubt: depth is anything between the vertices'
  DepthInterval range;         ///< of the vertices' depths
};

/// Half extents (size_px / 2) of the target map clip space onto it, y down.
[[nodiscard]] PreparedTriangle prepare(const SourceTriangle& triangle, glm::ivec2 size_px);

/// Why a sample's coverage is uncertain: an edge of the triangle's outline can pass over it, or a cut at the near or
/// far plane can.
enum class Doubt : std::uint8_t { none, outline, cut };

struct Judgement {
  Coverage coverage = Coverage::out;
  Doubt doubt = Doubt::none;
  DepthInterval depth;  ///< set unless coverage is `out`
};

[[nodiscard]] Judgement judge(const PreparedTriangle& triangle, glm::dvec2 sample_px);

/// Only whether it is covered: Judgement without depth, for a third of the price.
[[nodiscard]] Judgement judge_coverage(const PreparedTriangle& triangle, glm::dvec2 sample_px);
[[nodiscard]] DepthInterval judge_depth(const PreparedTriangle& triangle, glm::dvec2 sample_px);

/// True only if judge_depth(…) contains z: the quick test that settles nearly every pixel. Moving all three vertices
/// alike is a placement, and it gives the depths of the triangle's own plane within reach around the sample:
/// z ± reach·(|∂z/∂x| + |∂z/∂y|), as far as they stay within the vertices' range.
[[nodiscard]] bool surely_has_depth(const PreparedTriangle& triangle, glm::dvec2 sample_px, float z);

/// The exact triangle at a sample, nothing moved: what an exact ray meets.
struct ExactSample {
  bool inside = false;      ///< in the closed polygon
  bool on_outline = false;  ///< on one of its edges
  Rational depth;           ///< if inside and the polygon has area
};
[[nodiscard]] ExactSample exact_sample(const SourceTriangle& triangle, glm::ivec2 size_px, glm::dvec2 sample_px);

}  // namespace lode::experiments::truth

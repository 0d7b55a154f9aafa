#pragma once
/// The exact arbiter: what a renderer that keeps its contract (C1–C5) may answer for one triangle at one sample.
///
/// A triangle is prepared once for a view (clipped, projected, its facing judged), then judged at any number of
/// samples. Everything is decided in double with proven bounds and, where those do not suffice, in rationals. Pure
/// functions.

#include <glm/vec2.hpp>

#include "experiments/truth/prepared_triangle.h"

namespace lode::experiments::truth {

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

#pragma once
/// The surfel's predicates and depth without rounding: integers wide enough for every finite input, on the
/// stack. Slow (microseconds a sample); surfel.cpp comes here only where doubles cannot decide. The one door to
/// Boost.Multiprecision.

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "raster/reference/bounded.h"
#include "raster/reference/hit_map.h"

namespace lode::raster::reference {

/// Object space and its way to the window. All finite; the floats' range, but for the matrix.
struct SurfelInput {
  glm::dvec3 centre{0.0};
  glm::dvec3 normal{0.0, 0.0, 1.0};  ///< not zero
  double radius = 1.0;               ///< > 0
  glm::dmat4 clip_from_object{1.0};
  glm::ivec2 viewport_origin_px{0, 0};
  glm::ivec2 viewport_size_px{1, 1};  ///< > 0
};

/// The viewport's centre minus the sample, 1/256 px, and 1: what a HitMap's functions take. Exact.
[[nodiscard]] inline Triple<double> from_centre(const SurfelInput& s, glm::ivec2 p_fx8) {
  return {128.0 * (2.0 * s.viewport_origin_px.x + s.viewport_size_px.x) - p_fx8.x,
          128.0 * (2.0 * s.viewport_origin_px.y + s.viewport_size_px.y) - p_fx8.y, 1.0};
}

/// Whether the ray through the sample hits the closed disc where w ≥ kMinW and 0 ≤ z ≤ w.
[[nodiscard]] bool exact_covers(const SurfelInput& s, glm::ivec2 p_fx8);

/// z/w at the hit, within 2^-51 of its value; the sample must be covered.
[[nodiscard]] double exact_depth(const SurfelInput& s, glm::ivec2 p_fx8);

/// The map with each coefficient rounded once, turned to positive w. Functions that are compared with each
/// other (q and reach; z, gap and w) share a power of two, others do not. Nothing if w = 0: edge-on.
[[nodiscard]] std::optional<HitMap<Bounded>> exact_hit_map(const SurfelInput& s);

}  // namespace lode::raster::reference

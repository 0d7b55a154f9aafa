#pragma once
/// A triangle made ready to be judged in one view: clipped, projected, its facing judged (C1, C3, C4).

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

}  // namespace lode::experiments::truth

#pragma once
/// Which clusters of an occluder are worth drawing. Whatever is left out of an occluder hides less, never more, so that
/// nothing here has to be exact.

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "raster/frame.h"
#include "techniques/masked_occlusion/masked_depth.h"

namespace lode::techniques {

/// Goes through the tree of a draw's clusters.
class ClusterWalk {
 public:
  /// The clusters to be drawn, nearest first: not beside the picture, not behind the buffer as it is, not facing away
  /// as a whole. Valid until the next call.
  ///   draw      with clusters
  ///   n_read    grows by the subtiles looked at
  [[nodiscard]] std::span<const std::uint32_t> worth_drawing(const raster::Draw& draw, glm::ivec2 size_px,
                                                             const MaskedDepth& buffer, std::uint64_t& n_read);

 private:
  std::vector<std::uint32_t> open_, found_;
  std::vector<std::pair<float, std::uint32_t>> by_depth_;  ///< nearest depth, negated; cluster
};

/// The point of projective space that a projection maps to x = y = w = 0: (eye, 1) times any number; an orthographic
/// view's is at infinity. A triangle with the normal n through p is seen counter-clockwise if n · (e.xyz − e.w · p) >
/// 0.
[[nodiscard]] glm::dvec4 eye_of(const glm::dmat4& clip_from_object);

}  // namespace lode::techniques

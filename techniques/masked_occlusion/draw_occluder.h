#pragma once
/// Triangles of a draw into the masked depth buffer, as the renderer would draw them: the same transform, clipping,
/// snap and facing (raster/reference/clip.h and assemble.h have the rules), so that they cover the same samples.

#include <cstdint>
#include <vector>

#include "raster/frame.h"
#include "techniques/masked_occlusion/cluster_walk.h"
#include "techniques/masked_occlusion/occluder_kernels.h"
#include "techniques/masked_occlusion/occluder_vertex.h"
#include "techniques/masked_occlusion/screen_triangle.h"

namespace lode::techniques {

/// Draws one draw after the other; keeps its memory.
class OccluderDrawer {
 public:
  /// Draws nothing for what the picture would not show for sure: triangles with a NaN, and those whose clipped outline
  /// the snap turns over in part. Of a draw with clusters, leaves out those that would not show.
  ///   draw      triangles in object space, opaque, order-free
  ///   size_px   of the picture, which the buffer was begun with
  ///   target    of the kernels, which decides nothing
  void draw(const raster::Draw& draw, glm::ivec2 size_px, raster::Target target, MaskedDepth& buffer,
            OccluderWork& work);

 private:
  void draw_clusters(const raster::Draw& draw, glm::ivec2 size_px, raster::Target target, MaskedDepth& buffer,
                     OccluderWork& work);

  ClusterWalk walk_;
  std::vector<OccluderVertex> vertices_;
};

}  // namespace lode::techniques

#include "raster/stats.h"

namespace lode::raster {

FrameStats& FrameStats::operator+=(const FrameStats& o) {
  draws_in += o.draws_in;
  draws_culled_frustum += o.draws_culled_frustum;
  draws_ordered += o.draws_ordered;
  primitives_in += o.primitives_in;
  primitives_not_finite += o.primitives_not_finite;
  primitives_outside += o.primitives_outside;
  primitives_facing += o.primitives_facing;
  primitives_empty += o.primitives_empty;
  primitives_clipped += o.primitives_clipped;
  boxes_tested += o.boxes_tested;
  boxes_outside += o.boxes_outside;
  boxes_facing += o.boxes_facing;
  boxes_hidden += o.boxes_hidden;
  clusters_drawn += o.clusters_drawn;
  triangles_in += o.triangles_in;
  triangles_without_sample += o.triangles_without_sample;
  triangles_facing += o.triangles_facing;
  triangles_empty += o.triangles_empty;
  triangles_rasterized += o.triangles_rasterized;
  blocks_touched += o.blocks_touched;
  blocks_outside += o.blocks_outside;
  blocks_hidden += o.blocks_hidden;
  pieces += o.pieces;
  tiles += o.tiles;
  fragments_covered += o.fragments_covered;
  fragments_alpha_failed += o.fragments_alpha_failed;
  fragments_depth_failed += o.fragments_depth_failed;
  fragments_shaded += o.fragments_shaded;
  fragments_blended += o.fragments_blended;
  texels_read += o.texels_read;
  return *this;
}

}  // namespace lode::raster

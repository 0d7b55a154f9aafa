#include "raster/stats.h"

namespace lode::raster {

FrameStats& FrameStats::operator+=(const FrameStats& o) {
  draws_in += o.draws_in;
  draws_ordered += o.draws_ordered;
  primitives_in += o.primitives_in;
  primitives_not_finite += o.primitives_not_finite;
  primitives_outside += o.primitives_outside;
  primitives_facing += o.primitives_facing;
  primitives_empty += o.primitives_empty;
  primitives_clipped += o.primitives_clipped;
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

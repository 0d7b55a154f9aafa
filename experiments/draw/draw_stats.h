#pragma once
/// What `lodestone draw --stats` writes: the work done, and hashes of the picture.

#include <span>
#include <string>

#include "raster/image.h"
#include "raster/render.h"
#include "raster/stats.h"

namespace lode::experiments {

struct DrawReport {
  std::string picture;  ///< as named on the command line
  int threads = 1;      ///< used, not asked for
  raster::Pipeline pipeline = raster::Pipeline::fast;
  raster::Target target = raster::Target::scalar;
  raster::FrameStats counters;
  std::span<const raster::DrawStats> per_draw;
};

/// One JSON object and a line break. The hashes are over the bytes of the .npy arrays' data; planes that the
/// image does not have (several samples a pixel) have none.
[[nodiscard]] std::string draw_stats_json(const DrawReport& report, const raster::Image& image);

}  // namespace lode::experiments

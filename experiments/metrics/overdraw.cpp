#include "experiments/metrics/overdraw.h"

namespace lode::experiments {

Overdraw overdraw(const raster::FrameStats& stats, std::span<const raster::Ids> ids) {
  Overdraw result;
  for (const raster::Ids& owner : ids) result.drawn_pixels += owner.draw != raster::kNoId;
  if (result.drawn_pixels == 0) return result;
  const double n = double(result.drawn_pixels);
  result.covered = double(stats.fragments_covered) / n;
  result.hidden = double(stats.fragments_depth_failed) / n;
  result.shaded = double(stats.fragments_shaded) / n;
  return result;
}

}  // namespace lode::experiments

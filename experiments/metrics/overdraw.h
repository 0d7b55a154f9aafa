#pragma once
/// How often a pixel is touched before it is what it is.

#include <cstdint>
#include <span>

#include "raster/image.h"
#include "raster/stats.h"

namespace lode::experiments {

/// Per pixel that something was drawn to; all 0 where nothing was.
struct Overdraw {
  std::uint64_t drawn_pixels = 0;
  double covered = 0.0;  ///< samples covered: with all skips off, the depth complexity; with skips on, the work left
  double hidden = 0.0;   ///< of those, the ones that failed the depth test
  double shaded = 0.0;   ///< shader results: 1 for opaque draws without alpha test, which are shaded once
};

/// Of one render at one sample a pixel: its statistics and its ids, [w*h]. O(w·h).
[[nodiscard]] Overdraw overdraw(const raster::FrameStats& stats, std::span<const raster::Ids> ids);

}  // namespace lode::experiments

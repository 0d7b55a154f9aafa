#pragma once
/// What `lodestone render --stats` writes: times, the work done, and hashes of the picture.

#include <span>
#include <string>

#include "raster/image.h"
#include "raster/render.h"
#include "raster/stats.h"
#include "techniques/scene_draws.h"
#include "techniques/stage.h"

namespace lode::experiments {

struct RenderReport {
  std::string scene;  ///< as named on the command line
  int threads = 1;    ///< used, not asked for
  raster::Pipeline pipeline = raster::Pipeline::fast;
  raster::Target target = raster::Target::scalar;
  int samples = 1;
  techniques::ColorSpace color_space = techniques::ColorSpace::srgb;
  double prepare_ms = 0.0;
  std::vector<double> frames_ms;  ///< [n ≥ 1] in the order of the frames
  raster::FrameStats counters;    ///< of the first frame
  std::string technique = "plain";
  techniques::Counters technique_counters = {};  ///< of the first frame, as is
  techniques::StageWork stage = {};              ///< this
};

/// One JSON object and a line break. The hashes are over the bytes of the .npy arrays' data, of the planes that the
/// image has. The median of an even number of times is the mean of the two in the middle.
[[nodiscard]] std::string render_stats_json(const RenderReport& report, const raster::Image& image);

}  // namespace lode::experiments

#pragma once
/// Options that every command takes, before or after its name.

#include "raster/render.h"

namespace lode::experiments {

struct CommonOptions {
  bool quiet = false;
  int threads = 0;  ///< 0: all cores
  raster::Pipeline pipeline = raster::Pipeline::fast;
  raster::Target target = raster::best_target();  ///< of the fast pipeline; never `best`
  raster::Skips skips = {};

  /// What the renderer is told of them.
  [[nodiscard]] raster::RenderOptions render_options() const {
    return {.threads = threads, .pipeline = pipeline, .target = target, .skips = skips};
  }
};

}  // namespace lode::experiments

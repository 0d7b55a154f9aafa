#pragma once
/// What `lodestone render` does: a scene's picture to files and statistics.

#include "experiments/command.h"
#include "experiments/output_files.h"
#include "experiments/render/look_options.h"
#include "experiments/scene_options.h"

namespace lode::experiments {

struct RenderOptions {
  SceneOptions scene;
  LookOptions look;
  OutputPaths outputs;
  bool no_color = false;     ///< depth and ids only
  std::string repeat = "1";  ///< frames that are timed
  std::string orbit = "0";   ///< degrees that the camera turns by from frame to frame
  std::string after = "0";   ///< frames that come before those
};

/// Runs the command. Throws Error, geometry::Error or raster::Error; then no output has appeared but what
/// standard output had already taken.
void render(const RenderOptions& options, const CommonOptions& common, const Streams& streams);

}  // namespace lode::experiments

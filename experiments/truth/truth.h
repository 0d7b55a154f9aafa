#pragma once
/// What `lodestone truth` does: a scene's picture by ray tracing, and the check of the rasterizer's against it.

#include "experiments/command.h"
#include "experiments/output_files.h"
#include "experiments/render/look_options.h"
#include "experiments/scene_options.h"

namespace lode::experiments::truth {

struct TruthOptions {
  SceneOptions scene;
  LookOptions look;
  OutputPaths outputs;
  bool check = false;
  bool tour = false;               ///< check from eight cameras, see tour.h
  std::optional<std::string> map;  ///< a picture of the verdicts
};

/// Runs the command; check_failed where a check leaves pixels unexplained. Throws Error, geometry::Error or
/// raster::Error; then no output has appeared but what standard output had already taken.
[[nodiscard]] Status run_truth(const TruthOptions& options, const CommonOptions& common, const Streams& streams);

}  // namespace lode::experiments::truth

#pragma once
/// What `lodestone explain` does: why a pixel of a scene's picture is what it is, as text or JSON.

#include "experiments/command.h"
#include "experiments/render/render.h"

namespace lode::experiments {

struct ExplainOptions {
  RenderOptions render;      ///< outputs and times are not made
  std::string pixel;         ///< "X,Y"
  std::string sample = "0";  ///< of several: which one is told in full
  bool json = false;
};

/// Throws Error, geometry::Error or raster::Error.
void explain(const ExplainOptions& options, const CommonOptions& common, const Streams& streams);

}  // namespace lode::experiments

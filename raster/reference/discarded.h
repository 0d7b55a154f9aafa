#pragma once
/// Triangles that never became pieces where a pixel would have shown them: cut away by the near or far plane at the
/// sample, or without area after the snap. For explanations only: rendering never looks back.

#include <vector>

#include "raster/explain.h"

namespace lode::raster::reference {

/// Adds to samples[k].pieces those that sample k of the pixel would have met. O(primitives).
void add_discarded(const Frame& frame, glm::ivec2 size_px, glm::ivec2 pixel, std::vector<ExplainedSample>& samples);

}  // namespace lode::raster::reference

#pragma once
/// Eight cameras that are hard in different ways, for any scene: what `lodestone truth --tour` checks.

#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "experiments/camera_options.h"
#include "geometry/bounds.h"

namespace lode::experiments::truth {

struct TourStop {
  std::string name;
  CameraOptions options;  ///< as one would type them
};

/// With d the bounds' diagonal (1 where that is 0):
///   front         frames the scene from the front, slightly above
///   diagonal_1, diagonal_2   from 1.2 d away, above on one side and below on another
///   above         straight down
///   inside        at the centre of the bounding box
///   near_cut      from 0.8 d away with a near plane through the centre
///   far_away      a thousand d away: all of it within about a pixel, the centre on its sample
///   orthographic  from 1.2 d away
///
/// All are rolled a little: level, the edges of a box run along rows or columns of samples, where a single near miss
/// counts some hundred times, and what edges explain could not be held against the edges' length.
[[nodiscard]] std::vector<TourStop> tour(const geometry::Bounds& bounds, glm::ivec2 size_px);

/// The words of a camera on the command line, each preceded by a space; empty for the default camera.
[[nodiscard]] std::string command_line(const CameraOptions& options);

}  // namespace lode::experiments::truth

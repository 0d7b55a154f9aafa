#pragma once
/// How far features of objects that plates stand for are from where they would be: an object's vertex lies in the
/// plate's picture where the camera of the capture saw it; the plate carries that point of the picture into the world,
/// and the view's camera sees it there.

#include <cstdint>

#include "techniques/stage.h"

namespace lode::experiments {

struct Displacement {
  double max_px = 0.0;
  double sum_px = 0.0;
  std::uint64_t n = 0;  ///< vertices
  [[nodiscard]] double mean_px() const { return n > 0 ? sum_px / double(n) : 0.0; }
};

/// Of the plates of the stage's last frame, whether the vertices are hidden or not; at most so many of each instance,
/// spread over its mesh. What lies outside the picture, or at or behind either camera's near plane, does not count.
[[nodiscard]] Displacement displacement(const techniques::World& world, const techniques::Stage& stage,
                                        const techniques::View& view, std::size_t most_of_instance = 64);

}  // namespace lode::experiments

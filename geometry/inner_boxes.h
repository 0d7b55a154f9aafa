#pragma once
/// Few large boxes that lie in a model: occluders in its place that never hide what the model does not. As generators
/// of box occluders do (karimnaaji/melt fills a voxel grid), boxes grow in a grid of cells inside; in contrast to them
/// the grid follows the model's faces, each box grows on from there up to the surface itself, and each is proven to be
/// inside (Solid::contains_box).

#include <cstdint>
#include <vector>

#include "geometry/bounds.h"
#include "geometry/solid.h"

namespace lode::geometry {

struct InnerBoxesParams {
  int resolution = 32;        ///< 1…64 cells on the longest side of each part
  int n_most = 8;             ///< 0…1000 boxes of the model
  double least_share = 0.01;  ///< [0.001, 1] of the volume of the solid's parts, that a box must add
};

/// Boxes by the volume that each adds, about, from the largest; coordinates are floats. They may overlap. None for a
/// solid without closed parts; thin parts that are not along the axes may hold none.
///
///   checks   params (std::logic_error)
///   cost     for each part with a least share: O(cells), and some hundred questions to the solid for each box;
///            deterministic
[[nodiscard]] std::vector<Bounds> inner_boxes(const Solid& solid, const InnerBoxesParams& params = {});

}  // namespace lode::geometry

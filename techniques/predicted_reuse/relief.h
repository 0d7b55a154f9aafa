#pragma once
/// The picture of an object as a relief: a grid over its pixels, each corner as far away as the picture's depth says, with
/// the picture on it. Textured depth meshes: Sillion, Drettakis and Bodelet, "Efficient impostor manipulation for
/// real-time visualization of urban scenery", 1997; Jeschke and Wimmer, "Textured depth meshes for real-time rendering
/// of arbitrary scenes", 2002.

#include "techniques/stage.h"

namespace lode::techniques {

/// Cells without a covered pixel are left out. A corner has the depth of the covered pixel that is closest to it, within a
/// cell's side; every cell that is kept has one there.
///   centre    positions are from here, world
///   cell_px   side of a cell, px of the picture; at least 1
/// O(pixels).
[[nodiscard]] PictureRelief make_relief(const CapturedPicture& picture, const glm::dvec3& centre, int cell_px);

/// What the relief of a picture takes at most; 0 if cells have no size.
[[nodiscard]] std::uint64_t most_relief_bytes(glm::ivec2 size_px, int cell_px);

}  // namespace lode::techniques

#pragma once
/// Which objects are far enough for a picture to stand for them, and which pictures are worth taking.

#include <cstdint>

#include "geometry/bounds.h"
#include "raster/frame.h"
#include "techniques/technique.h"

namespace lode::techniques {

/// Objects nearer than both are drawn as they are.
struct FarRule {
  double radii = 3.0;      ///< of the sphere around the object's box
  double distance = 30.0;  ///< world units
  /// From the eye to the box's centre.
  [[nodiscard]] bool is_far(const View& view, const geometry::Bounds& box) const;
};

/// Not larger than the view: pictures that are cost more than the object's own pixels do.
[[nodiscard]] bool worth_capturing(const View& view, const raster::Rect& window_px);

/// What Stage::capture keeps of a window: colours with mips, and depth.
[[nodiscard]] std::uint64_t captured_bytes(glm::ivec2 size_px);

}  // namespace lode::techniques

#pragma once
/// What a culling method got wrong, from whose each pixel of the reference is and which objects were drawn.
///
/// An object is visible if it owns at least one pixel of the reference. One that is visible and was not drawn is
/// falsely culled, whatever is seen in its place; one that was drawn and is not visible is a missed cull. These are the
/// errors of the planes that are given: pixels for sampled cullers, several samples a pixel for continuous ones (C13).

#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <vector>

#include "raster/image.h"

namespace lode::experiments {

/// One frame. What is drawn in an object's place counts as the object.
struct CulledFrame {
  glm::ivec2 size_px{0, 0};
  std::span<const raster::Ids> reference;         ///< [w*h] without culling
  std::span<const std::uint32_t> object_of_draw;  ///< [draws] below n_objects
  std::span<const std::uint8_t> drawn;            ///< [n_objects] 0: culled
};

struct CullingErrors {
  std::uint64_t n_objects = 0;               ///< outside the view or in it
  std::uint64_t owned_pixels = 0;            ///< of the reference: those that show any object
  std::uint64_t visible = 0;                 ///< objects
  std::uint64_t culled = 0;                  ///< objects, rightly or not
  std::uint64_t falsely_culled_objects = 0;  ///< visible, but culled
  std::uint64_t falsely_culled_pixels = 0;   ///< that they own
  std::uint64_t largest_missing_region = 0;  ///< pixels, 4-connected, of all of them together
  std::uint64_t missed_culls = 0;            ///< objects drawn that are not visible

  /// Falsely culled of owned pixels, 0 to 1; 0 where there are none.
  [[nodiscard]] double falsely_culled_share() const;
  [[nodiscard]] std::uint64_t could_be_culled() const { return n_objects - visible; }
  /// Rightly culled of what could be culled, 0 to 1; nothing where nothing could be.
  [[nodiscard]] std::optional<double> culled_share() const;
};

/// Pixels of the reference that each object owns: [n_objects]. O(w·h).
/// Throws std::logic_error for an id of no draw, or a draw of no object.
[[nodiscard]] std::vector<std::uint64_t> owned_pixels(std::span<const raster::Ids> reference,
                                                      std::span<const std::uint32_t> object_of_draw,
                                                      std::size_t n_objects);

/// O(w·h + objects). Throws std::logic_error as above, or if the reference is not of the size stated.
[[nodiscard]] CullingErrors culling_errors(const CulledFrame& frame);

}  // namespace lode::experiments

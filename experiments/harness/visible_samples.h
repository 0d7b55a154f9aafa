#pragma once
/// The truth that culling is held against: how many samples of a view each object owns, at the pixels' centres, on a
/// 4×4 grid in every pixel, and at random places in every pixel. Item buffers of the whole scene, drawn by the
/// rasterizer with nothing left out; rays (Embree) are the judge of the rasterizer (experiments/truth).

#include <cstdint>
#include <string>
#include <vector>

#include "raster/render.h"
#include "techniques/technique.h"
#include "techniques/world.h"

namespace lode::experiments {

/// [objects] each.
struct VisibleSamples {
  std::vector<std::uint32_t> centre;  ///< of w · h
  std::vector<std::uint32_t> grid;    ///< of 16 · w · h
  std::vector<std::uint32_t> random;  ///< of kRandomOffsets · w · h; the same offset in all pixels of a buffer
};
inline constexpr int kRandomOffsets = 8;

/// The random offsets belong to the seed and the view's number. Deterministic; 1 + 16 + kRandomOffsets pictures.
[[nodiscard]] VisibleSamples visible_samples(const techniques::World& world, const techniques::View& view,
                                             std::uint64_t seed, std::uint64_t view_number,
                                             const raster::RenderOptions& options);

/// Adds the pixels that each object owns in a picture with ids of the whole scene.
///   owned  [objects]
void add_owned_samples(const raster::Image& image, const techniques::World& world, std::vector<std::uint32_t>& owned);

/// As text, to be kept; and back: false for a text that is not one, or is of another number of objects.
[[nodiscard]] std::string text_of(const VisibleSamples& samples);
[[nodiscard]] bool read_visible_samples(std::string_view text, std::size_t n_objects, VisibleSamples& samples);

}  // namespace lode::experiments

#pragma once
/// Surfaces of a tile's samples: by whole 4×4s where one triangle owns many of it, else with others of the draw.

#include <algorithm>
#include <array>
#include <cstdint>

#include "raster/fast/surface.h"
#include "raster/fast/tile.h"

namespace lode::raster::fast {

/// Colours of the lanes (a bit each) of a 4×4 of one triangle, done: textured, cut out and lit.
///   first_fx8   its first sample, from the tile's corner
void shade_samples(const Kernels& kernels, const Surface& surface, const SurfaceTriangle& triangle,
                   glm::ivec2 first_fx8, std::uint32_t lanes, FrameStats& stats, SurfaceSamples& samples);

class SurfaceResolver {
 public:
  /// All of them outlive it.
  SurfaceResolver(const Scene& scene, Worker& worker, const Owners& owners, const PixelBox& box, glm::ivec2 sample_fx8,
                  ColorFormat format);

  /// Shades samples of one owner, a bit each, in the 4×4 whose first pixel in the tile is given: now, or before
  /// `finish` ends. False if the owner is not a surface's triangle: nothing is done.
  [[nodiscard]] bool shade(std::uint32_t owner, int x_px, int y_px, std::uint32_t lanes);

  /// Shades the sample of a pixel of the tile, before `finish` ends.
  ///   owner   a kernels' triangle, of a surface without a texture
  void shade_later(std::uint32_t owner, int x_px, int y_px);

  /// Shades a 4×4 of one owner whose surface has one colour and was shaded before; false, with nothing done, if it is
  /// not such a one. For targets of floats.
  ///   base   the first sample's place in the tile
  [[nodiscard]] bool fill_alone(const std::uint32_t* owners, std::size_t base) {
    if (owners[0] != one_color_owner_ || one_color_owner_ == kNoOwner) return false;
    std::uint32_t differ = 0;
    for (std::size_t k = 1; k < 16; ++k) differ |= owners[k] ^ owners[0];
    if (differ != 0) return false;
    std::fill_n(w_.rgba32f.begin() + std::ptrdiff_t(base), 16, one_color_);
    return true;
  }

  void finish();

 private:
  /// Samples of one draw that wait for others of it.
  struct Batch {
    std::uint32_t fast_draw = 0;
    std::size_t n = 0;
    std::array<std::uint32_t, 16> owners, places;
    std::array<std::int32_t, 16> x_fx8, y_fx8;
  };

  [[nodiscard]] bool shade_alone(const Surface& surface, std::uint32_t owner, int x_px, int y_px, std::uint32_t lanes);
  void flush(Batch& batch);
  void keep(KeptSurface& kept, std::uint32_t owner, const SurfaceTriangle& triangle, const Surface& surface);
  /// Samples of a 4×4, a bit each, of a surface of one colour.
  ///   base   the first one's place in the tile
  void fill(const KeptSurface& kept, std::size_t base, std::uint32_t lanes);
  /// for_each(visit) calls visit(sample, place in the tile).
  template <class ForEach>
  void store(const SurfaceSamples& samples, ForEach for_each);

  const Scene& scene_;
  Worker& w_;
  const Owners& owners_;
  glm::ivec2 origin_px_;
  glm::ivec2 sample_fx8_;
  ColorFormat format_;
  std::array<Batch, 4> batches_;
  std::uint32_t one_color_owner_ = kNoOwner;  ///< the last one whose surface has one colour, of a target of floats
  glm::vec4 one_color_{0.0f};
};

}  // namespace lode::raster::fast

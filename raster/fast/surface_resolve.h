#pragma once
/// Surfaces of a tile's samples: by whole 4×4s where one triangle owns many of it, else with others of the draw.

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
};

}  // namespace lode::raster::fast

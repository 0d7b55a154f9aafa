#pragma once
/// Triangles of a draw into the masked depth buffer, as the renderer would draw them: the same transform, clipping,
/// snap and facing (raster/reference/clip.h and assemble.h have the rules), so that they cover the same samples.

#include <cstdint>
#include <vector>

#include "raster/frame.h"
#include "raster/reference/clip.h"
#include "techniques/masked_occlusion/screen_triangle.h"

namespace lode::techniques {

/// Work done, added up.
struct OccluderWork {
  std::uint64_t triangles = 0;  ///< looked at
  std::uint64_t drawn = 0;      ///< of them, with a sample
  std::uint64_t subtiles = 0;   ///< given a part of one
};

/// Draws one draw after the other; keeps its memory.
class OccluderDrawer {
 public:
  /// Draws nothing for what the picture would not show for sure: triangles with a NaN, and those whose clipped outline
  /// the snap turns over in part.
  ///   draw      triangles in object space, opaque, order-free
  ///   size_px   of the picture, which the buffer was begun with
  void draw(const raster::Draw& draw, glm::ivec2 size_px, MaskedDepth& buffer, OccluderWork& work);

 private:
  struct Vertex {
    glm::dvec4 clip;
    glm::ivec2 p_fx8;
    double z;
    std::uint32_t outside;  ///< planes; all bits where it has a NaN; where not 0, neither p_fx8 nor z is there
  };
  void draw_triangle(std::uint32_t i, std::uint32_t j, std::uint32_t k, MaskedDepth& buffer, OccluderWork& work);
  void draw_clipped(const Vertex& a, const Vertex& b, const Vertex& c, MaskedDepth& buffer, OccluderWork& work) const;

  raster::reference::Viewport viewport_;
  raster::Cull cull_ = raster::Cull::none;
  std::vector<Vertex> vertices_;
};

}  // namespace lode::techniques

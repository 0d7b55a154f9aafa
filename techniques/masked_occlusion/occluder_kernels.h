#pragma once
/// The inner loops of masked occlusion culling, built for the instruction sets of the renderer's kernels
/// (raster/fast/kernels.h) and chosen like those. Each gives the bits of draw_triangle (screen_triangle.h) for one
/// triangle after the other. In the lanes of a vector unit are the triangles of a cluster up to their set-up and then
/// the samples of a subtile, or, of a large triangle, rows of samples.

#include <cstdint>

#include "raster/fast/kernels.h"
#include "techniques/masked_occlusion/masked_depth.h"
#include "techniques/masked_occlusion/screen_triangle.h"

namespace lode::techniques {

/// Work done, added up.
struct OccluderWork {
  std::uint64_t triangles = 0;         ///< looked at
  std::uint64_t drawn = 0;             ///< of them, with a sample
  std::uint64_t subtiles_written = 0;  ///< given a part of one
  std::uint64_t subtiles_read = 0;     ///< to find what is hidden already
};

struct ClusterJob {
  const std::uint8_t* corners = nullptr;                      ///< [3·n]
  int n_triangles = 0;                                        ///< at most raster::kMaxClusterTriangles
  const raster::fast::WindowVertices128* vertices = nullptr;  ///< from the picture's corner; clean
  raster::Cull cull = raster::Cull::none;
  void* context = nullptr;
  /// Draws a triangle by itself: one that is wider than 64 px, or so thin that the snap may have turned it over. It is
  /// called in its turn.
  void (*draw_other)(void* context, int triangle) = nullptr;
};

struct OccluderKernels {
  raster::Target target;
  /// Whether all of the first n vertices are surely within every clip plane, so that no clamp of the transform acted.
  bool (*clean)(const raster::fast::WindowVertices128& vertices, int n);
  /// Draws the triangles in their order. Those left to draw_other are not counted here.
  void (*draw_cluster)(const ClusterJob& job, MaskedDepth& buffer, OccluderWork& work);
  /// As draw_triangle of screen_triangle.h.
  std::uint64_t (*draw_triangle)(const ScreenTriangle& triangle, MaskedDepth& buffer);
};

/// The kernels of a target that can run here.
[[nodiscard]] const OccluderKernels& occluder_kernels(raster::Target target);

}  // namespace lode::techniques

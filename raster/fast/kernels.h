#pragma once
/// The inner loops of the fast pipeline, built for several instruction sets and chosen at run time. Every one gives the
/// bits of the reference pipeline: the same operations in the same order, sixteen samples at a time.

#include <array>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "raster/clusters.h"
#include "raster/fast/textured.h"
#include "raster/frame.h"
#include "raster/render.h"

namespace lode::raster::fast {

inline constexpr int kTile_px = kFastTile_px;
inline constexpr int kTilePixels = kTile_px * kTile_px;
inline constexpr int kBlock_px = 8;
inline constexpr int kBlocksPerRow = kTile_px / kBlock_px;
inline constexpr std::uint32_t kNoOwner = 0xFFFFFFFFu;

/// Where a pixel of the tile is kept: 8×8 blocks in rows, each as four 4×4 quarters, rows inside.
[[nodiscard]] constexpr int place_in_tile(int x, int y) {
  return ((y >> 3) * kBlocksPerRow + (x >> 3)) * 64 + ((y >> 2) & 1) * 32 + ((x >> 2) & 1) * 16 + (y & 3) * 4 + (x & 3);
}

/// One draw as a frame's camera sees it.
struct DrawView {
  std::array<double, 16> clip_from_object{};  ///< rows
  glm::dvec2 centre_fx8{0.0}, half_fx8{0.0};  ///< viewport
  Cull cull = Cull::none;
};

/// A box on the screen.
struct Projected {
  bool outside = false;  ///< no point of it is in the view
  bool clean = false;  ///< every point of it is inside the near and far planes and the guard band, sure under rounding
  int begin_x = 0, begin_y = 0, end_x = 0, end_y = 0;  ///< if clean: pixels that it may cover
  float nearest = 1.0f;                                ///< if clean: no depth of it is greater
};

/// A cluster's vertices in the window.
struct WindowVertices128 {
  alignas(64) std::int32_t x_fx8[kMaxClusterVertices];  ///< from the tile's corner
  alignas(64) std::int32_t y_fx8[kMaxClusterVertices];
  alignas(64) double z[kMaxClusterVertices];
  alignas(64) double w[kMaxClusterVertices];
};

/// One tile's samples, places as place_in_tile. A sample that nothing owns has depth −1.
struct TileBuffers {
  alignas(64) float depth[kTilePixels];
  alignas(64) std::uint32_t owner[kTilePixels];
  alignas(64) float block_min[kBlocksPerRow * kBlocksPerRow];  ///< least depth of each block, if it is fresh
  alignas(64) std::uint8_t stale[kBlocksPerRow * kBlocksPerRow];
};

struct RasterCounts {
  std::uint64_t triangles_in = 0, facing = 0, empty = 0, no_sample = 0, rasterized = 0;
  std::uint64_t blocks = 0, blocks_hidden = 0, fragments_passed = 0;
};

/// What rasterizing a cluster needs.
struct RasterJob {
  const std::uint8_t* corners = nullptr;  ///< [3·n]
  int n_triangles = 0;
  const WindowVertices128* vertices = nullptr;
  Cull cull = Cull::none;
  int begin_x = 0, begin_y = 0, end_x = 0, end_y = 0;  ///< pixels of the tile that may be written
  int sample_x_fx8 = 128, sample_y_fx8 = 128;
  std::uint32_t first_owner = 0;  ///< triangle k owns its samples as first_owner + k
  const void* context = nullptr;
  /// Which of two owners at equal depth has the lower key.
  bool (*key_before)(const void* context, std::uint32_t a, std::uint32_t b) = nullptr;
  /// The sign of a triangle's unsnapped determinant, where its snapped area is too small to tell.
  int (*facing_sign)(const void* context, std::uint32_t triangle) = nullptr;
};

/// A cluster with samples in the tile: where its vertices and triangles begin in its draw's clusters.
struct Resident {
  std::uint32_t first_vertex = 0;
  std::uint32_t first_triangle = 0;
  std::uint32_t fast_draw = 0;
  std::uint32_t cluster = 0;
};

/// Samples of one draw whose colour is its vertices' colours times its own: no texture, no shader.
struct FlatJob {
  const Resident* residents = nullptr;
  const WindowVertices128* vertices = nullptr;  ///< [residents]
  const std::uint8_t* corners = nullptr;        ///< of the draw's clusters
  const std::uint32_t* mesh_vertices = nullptr;
  const float* colors = nullptr;  ///< [4 · mesh vertices], or null
  std::array<float, 4> color{};   ///< the draw's, if has_color
  bool has_color = false;
  float full = 255.0f;       ///< 255 for bytes, 1 for floats
  int x_fx8 = 0, y_fx8 = 0;  ///< the first sample of the 4×4, from the tile's corner
};

/// A textured triangle of an ordered draw that writes no depth, over a tile.
struct OrderedJob {
  const TexturedTriangle* triangle = nullptr;
  int begin_x = 0, begin_y = 0, end_x = 0, end_y = 0;  ///< pixels of the tile that may be written
  int sample_x_fx8 = 128, sample_y_fx8 = 128;
  bool depth_test = true;  ///< strictly nearer than the tile's depth passes
  Blend blend = Blend::none;
  const TileBuffers* tile = nullptr;
  std::uint32_t* rgba8 = nullptr;  ///< [kTilePixels], places as place_in_tile, 64-byte aligned
};

struct OrderedCounts {
  std::uint64_t covered = 0, depth_failed = 0, shaded = 0, blended = 0, texels_read = 0;
};

struct Kernels {
  Target target;
  Projected (*project)(const DrawView& view, const glm::vec3& low, const glm::vec3& high);
  /// x, y, z [n, padded]
  void (*transform)(const DrawView& view, const float* x, const float* y, const float* z, int n,
                    std::int32_t origin_x_fx8, std::int32_t origin_y_fx8, WindowVertices128* out);
  /// True if any sample's owner has changed.
  bool (*rasterize)(const RasterJob& job, TileBuffers& tile, RasterCounts& counts);
  /// Least depth over the blocks that the pixels [begin, end) touch; refreshes the stale ones.
  float (*least_depth)(TileBuffers& tile, int begin_x, int begin_y, int end_x, int end_y);
  /// Colours of a 4×4's samples, [4][16]: red, green, blue, alpha; each of the owners is a triangle of the draw.
  void (*shade_flat)(const FlatJob& job, const std::uint32_t* owners, float* rgba);
  /// Sixteen colours as bytes: rounded half up, clamped; NaN gives 0 (C8).
  void (*store_bytes)(const float* rgba, std::uint32_t* bytes);
  /// Bytes [16] of a 4×4's samples in `lanes` (bit 4·y + x; at least one), each covered by the triangle; what the others
  /// become is not said. x_fx8, y_fx8: the first sample, from the tile's corner. Returns how many texels were read.
  std::uint64_t (*shade_textured)(const TexturedTriangle& triangle, int x_fx8, int y_fx8, std::uint32_t lanes,
                                  std::uint32_t* bytes);
  /// Draws the triangle's samples into the tile's colours and adds to the counts.
  void (*draw_textured)(const OrderedJob& job, OrderedCounts& counts);
};

/// The kernels of a target (`best`: of the widest set that this processor has); null if it cannot run here.
[[nodiscard]] const Kernels* find_kernels(Target target);

}  // namespace lode::raster::fast

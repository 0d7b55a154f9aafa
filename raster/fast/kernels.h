#pragma once
/// The inner loops of the fast pipeline, built for several instruction sets and chosen at run time. Every one gives the
/// bits of the reference pipeline: the same operations in the same order, sixteen samples at a time.

#include <array>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "raster/clusters.h"
#include "raster/fast/surface.h"
#include "raster/fast/textured.h"
#include "raster/frame.h"
#include "raster/reference/primitive.h"
#include "raster/render.h"

namespace lode::raster::fast {

inline constexpr int kTile_px = kFastTile_px;
inline constexpr int kTilePixels = kTile_px * kTile_px;
inline constexpr int kBlock_px = 8;
inline constexpr int kBlocksPerRow = kTile_px / kBlock_px;
inline constexpr std::size_t kBlocks = std::size_t(kBlocksPerRow) * kBlocksPerRow;
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
  bool boxes_may_face = true;  ///< false where the numbers below may have lost their precision
  /// det(x, y, w) of a triangle's corners in clip space is n · (eye − eye_w · p), n = (b − a) × (c − a), p any of them.
  glm::dvec3 eye{0.0};
  double eye_w = 0.0;
};

/// A box as the camera sees it.
enum class Sight : std::uint32_t {
  clean,    ///< every point of it is inside the near and far planes and the guard band, sure under rounding
  unclean,  ///< some may be cut
  outside,  ///< no point of it is in the view and the window
  facing,   ///< all triangles in it are culled by facing, sure under rounding
};
struct BoxSight {
  Sight sight = Sight::outside;
  float nearest = 1.0f;        ///< if clean: no depth of it is greater
  reference::PixelBox pixels;  ///< if clean: of the window, those that it may cover
};

/// A cluster's vertices in the window.
struct WindowVertices128 {
  alignas(64) std::uint64_t xy_fx8[kMaxClusterVertices];  ///< from the tile's corner: x low, y high
  alignas(64) double z[kMaxClusterVertices];
  alignas(64) double w[kMaxClusterVertices];
  [[nodiscard]] std::int32_t x_fx8(std::size_t i) const { return std::int32_t(std::uint32_t(xy_fx8[i])); }
  [[nodiscard]] std::int32_t y_fx8(std::size_t i) const { return std::int32_t(xy_fx8[i] >> 32); }
};

inline constexpr std::uint8_t kStale = 1, kTouched = 2;

/// One tile's samples, places as place_in_tile. A sample that nothing owns has depth −1.
struct TileBuffers {
  alignas(64) float depth[kTilePixels];
  alignas(64) std::uint32_t owner[kTilePixels];
  alignas(64) float block_min[kBlocks];       ///< no depth of a block is less; the least one unless stale
  alignas(64) std::uint8_t written[kBlocks];  ///< kStale: since block_min was found; kTouched: at all
};

/// Whether anything was drawn in the block of a pixel of the tile.
[[nodiscard]] inline bool touched(const TileBuffers& tile, int x_px, int y_px) {
  return (tile.written[y_px / kBlock_px * kBlocksPerRow + x_px / kBlock_px] & kTouched) != 0;
}

/// What the kernels of one tile did and did not do.
struct RasterCounts {
  std::uint64_t triangles_in = 0, facing = 0, empty = 0, no_sample = 0, tiny = 0, medium = 0, large = 0;
  std::uint64_t blocks = 0, blocks_outside = 0, blocks_hidden = 0, fragments = 0;
  std::uint64_t fragments_passed = 0;  ///< nearer when they came; their order depends on the number of lanes
  /// Those that do not count as failed: nearer when they came; of tiny triangles, whose order depends on the number of
  /// lanes, those where nothing was.
  std::uint64_t fragments_kept = 0;
  std::uint64_t alpha_failed = 0;
};

/// Marks of a triangle: it has won a sample, though it may have lost it since; it owns one in the end; it has been
/// looked at by itself, and its corners may be far apart.
inline constexpr std::uint8_t kWon = 1, kOwns = 2, kWide = 4;

/// What rasterizing a cluster needs.
struct RasterJob {
  const std::uint8_t* corners = nullptr;  ///< [3·n]
  int n_triangles = 0;
  const std::uint64_t* wanted = nullptr;  ///< [2] bit k: triangle k; null: all
  const WindowVertices128* vertices = nullptr;
  Cull cull = Cull::none;
  Skips skips;
  int begin_x = 0, begin_y = 0, end_x = 0, end_y = 0;  ///< pixels of the tile that may be written
  int sample_x_fx8 = 128, sample_y_fx8 = 128;
  std::uint32_t first_owner = 0;  ///< triangle k owns its samples as first_owner + k
  std::uint8_t* marks = nullptr;  ///< [n, all 0] triangle k's: kWon, kWide
  const void* context = nullptr;
  /// Which of two owners at equal depth has the lower key.
  bool (*key_before)(const void* context, std::uint32_t a, std::uint32_t b) = nullptr;
  /// The sign of a triangle's unsnapped determinant, where its snapped area is too small to tell.
  int (*facing_sign)(const void* context, std::uint32_t triangle) = nullptr;
  /// Of those samples of a 4×4, a bit each, that nothing nearer hides: which pass the draw's alpha test; null: all. Only
  /// for triangles by themselves.
  std::uint32_t (*passing)(const void* context, int x_px, int y_px, std::uint32_t lanes) = nullptr;
  /// Then, if any of them is nearest now: which. May be null.
  void (*won)(const void* context, int x_px, int y_px, std::uint32_t lanes) = nullptr;
};

/// A triangle by itself.
struct LoneTriangle {
  std::array<std::int32_t, 3> x_fx8{}, y_fx8{};  ///< from the tile's corner, canonical order
  std::array<double, 3> z{};
  std::uint32_t owner = 0;
};

/// A cluster with samples in the tile: where its vertices and triangles begin in its draw's clusters.
struct Resident {
  std::uint32_t first_vertex = 0;
  std::uint32_t first_triangle = 0;
  std::uint32_t fast_draw = 0;
  std::uint32_t cluster = 0;
};

/// Samples of one draw that is a surface without a texture, each with an owner of its own.
struct OwnersJob {
  const Surface* surface = nullptr;
  const Resident* residents = nullptr;
  const WindowVertices128* vertices = nullptr;  ///< [residents]
  const std::uint8_t* corners = nullptr;        ///< of the draw's clusters
  const std::uint32_t* mesh_vertices = nullptr;
  const float* colors = nullptr;        ///< [4 · mesh vertices], if the surface has some
  const float* normals = nullptr;       ///< [3 · mesh vertices], likewise
  const std::int32_t* x_fx8 = nullptr;  ///< [16] samples, from the tile's corner
  const std::int32_t* y_fx8 = nullptr;
};

/// A triangle's colours: (value + right·dx + down·dy) / (1 + d_right·dx + d_down·dy), pixels from a reference one.
struct alignas(64) ColorRecord {
  float quads[4][4];  ///< d_right, d_down, reference pixel (bits: x + 256·y), error; value; right; down (rgba each)
};

/// A record's error as a share of its terms (the sum of its weights' absolute values at the reference pixel and of what
/// they change up to the farthest, times the greatest colour). In roundings u = 2^-24: a weight takes 4, its product
/// and sum 3, the planes' evaluation 3, the divisor likewise 9, the corners' scaling 2; quotient and fraction 3; C7's
/// own value 6. The terms are at least the divisor, so that the last two are covered, too: 30 u < 2^-19.
inline constexpr float kRecordError = 0x1p-19f;

/// What colour records of a cluster are made from.
struct RecordJob {
  const std::uint8_t* corners = nullptr;               ///< [3 · 128] of the cluster
  const WindowVertices128* vertices = nullptr;         ///< of the cluster
  const std::uint32_t* mesh_vertices = nullptr;        ///< of the cluster
  const float* colors = nullptr;                       ///< [4 · mesh vertices]
  std::array<float, 4> scale{1.0f, 1.0f, 1.0f, 1.0f};  ///< the draw's colour, of 1
  bool scaled = false;
  int sample_x_fx8 = 128, sample_y_fx8 = 128;
  const std::uint8_t* marks = nullptr;  ///< [128]
  std::uint8_t wanted = 0;              ///< which of them gives a triangle a record
  std::uint32_t first_record = 0;
  std::uint32_t* record_of = nullptr;  ///< [128] for those that get one
  ColorRecord* records = nullptr;      ///< where the first one goes
  std::int32_t* wide = nullptr;        ///< [128 + 16] those wanted that are kWide, and get none here
};
struct RecordCounts {
  int made = 0, wide = 0;
};

/// A sample whose byte the records could not tell.
struct Doubtful {
  std::uint32_t place;
  std::uint16_t x_px, y_px;  ///< in the tile
};

/// Bytes of a tile's samples from the records of their owners.
struct ResolveJob {
  const TileBuffers* tile = nullptr;
  const std::uint32_t* record_of = nullptr;  ///< [owners of the kernels] or kNoRecord
  const ColorRecord* records = nullptr;
  std::uint32_t clear = 0;
  bool fill = false;  ///< whether strips of two blocks that nothing has touched get the clear's colour, too
  std::uint32_t* rgba8 = nullptr;
  int width_px = 0, height_px = 0;
  Doubtful* doubtful = nullptr;  ///< room for every sample
  std::size_t* n_doubtful = nullptr;
  std::uint64_t* n_shaded = nullptr;
  const void* context = nullptr;
  /// Shades those samples of a 4×4 that have no record.
  void (*shade_others)(const void* context, int x_px, int y_px, std::uint32_t lanes) = nullptr;
};
inline constexpr std::uint32_t kNoRecord = 0xFFFFFFFFu;

/// A tile's planes of 32-bit values to the image's rows.
struct WriteJob {
  const void* from = nullptr;  ///< null: all is the clear's
  void* to = nullptr;          ///< the tile's first pixel
  std::size_t pitch_px = 0;
  int width_px = 0, height_px = 0;
  const std::uint8_t* written = nullptr;  ///< [blocks] those not kTouched are the clear's; null: all are written
  std::uint32_t clear = 0;
  bool depths = false;  ///< what nothing owns becomes 0
  bool stream = false;  ///< past the caches: for images that they would not hold
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
  /// Looks at the boxes of a group, or at one box.
  void (*look)(const DrawView& view, const ClusterGroup& group, const reference::PixelBox& window, const Skips& skips,
               BoxSight* out);
  /// x, y, z [n, padded]
  void (*transform)(const DrawView& view, const float* x, const float* y, const float* z, int n,
                    std::int32_t origin_x_fx8, std::int32_t origin_y_fx8, WindowVertices128* out);
  /// True if any sample's owner has changed.
  bool (*rasterize)(const RasterJob& job, TileBuffers& tile, RasterCounts& counts);
  bool (*rasterize_lone)(const RasterJob& job, const LoneTriangle& triangle, TileBuffers& tile, RasterCounts& counts);
  /// True if every sample of the blocks that the pixels (of the tile, not empty) touch is nearer than `nearest`.
  bool (*hidden)(TileBuffers& tile, const reference::PixelBox& pixels, float nearest);
  /// Of those of a cluster's triangles that are wanted.
  RecordCounts (*make_records)(const RecordJob& job);
  /// Bytes of a 4×4 whose first pixel in the tile is given; each sample has its record. Returns the samples, a bit
  /// each, that must be shaded exactly instead.
  std::uint32_t (*shade_records)(const ColorRecord* records, const std::uint32_t* index, int x_px, int y_px,
                                 std::uint32_t* bytes);
  void (*resolve_records)(const ResolveJob& job);
  void (*write_tile)(const WriteJob& job);
  /// n pixels of one value, one behind the other.
  void (*clear)(std::uint32_t* to, std::size_t n, std::uint32_t value);
  /// Sixteen samples; each of the owners is a triangle of the draw.
  void (*shade_owners)(const OwnersJob& job, const std::uint32_t* owners, SurfaceSamples& out);
  /// The sixteen samples of a 4×4 of which the first is given, from the tile's corner; what those become that the
  /// triangle does not cover is not said.
  void (*shade_surface)(const Surface& surface, const SurfaceTriangle& triangle, int x_fx8, int y_fx8,
                        SurfaceSamples& out);
  /// apply_texture of a linear texture by a bilinear or trilinear filter.
  std::uint64_t (*apply_linear_texture)(const Surface& surface, std::uint32_t lanes, SurfaceSamples& samples);
  /// `CutOut` of a surface that has one, then its light.
  void (*cut_out_surface)(const Surface& surface, SurfaceSamples& samples);
  /// [4·16] Sixteen colours as a float target keeps them (C8).
  void (*store_floats)(const SurfaceSamples& samples, float* rgba);
  /// Sixteen colours as bytes: rounded half up, clamped; NaN gives 0 (C8).
  void (*store_bytes)(const float* rgba, std::uint32_t* bytes);
  /// Bytes [16] of a 4×4's samples in `lanes` (bit 4·y + x; at least one), each covered by the triangle; what the
  /// others become is not said. x_fx8, y_fx8: the first sample, from the tile's corner. Returns how many texels were
  /// read.
  std::uint64_t (*shade_textured)(const TexturedTriangle& triangle, int x_fx8, int y_fx8, std::uint32_t lanes,
                                  std::uint32_t* bytes);
  /// Draws the triangle's samples into the tile's colours and adds to the counts.
  void (*draw_textured)(const OrderedJob& job, OrderedCounts& counts);
};

/// The kernels of a target (`best`: of the widest set that this processor has); null if it cannot run here.
[[nodiscard]] const Kernels* find_kernels(Target target);

}  // namespace lode::raster::fast

#pragma once
/// One tile of a frame: visibility first, front to back, then each visible sample's colour once, then what is ordered.

#include <array>
#include <bit>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "raster/fast/scene.h"
#include "raster/fast/surface.h"
#include "raster/fast/textured.h"

namespace lode::raster::fast {

/// Owners: slot · 128 + triangle for the kernels' clusters, kPieceBit | piece for pieces, or kNoOwner.
inline constexpr std::uint32_t kPieceBit = 0x80000000u;
inline constexpr std::uint32_t kSlotTriangles = kMaxClusterTriangles;
/// Slots: as many clusters as a tile has samples may own one each, and one is being drawn.
inline constexpr std::size_t kSlots = kTilePixels + 1;

/// Records of one tile: fewer than samples were won, as long as these are few (see Records::make), and some for pieces.
inline constexpr std::size_t kMostRecords = 3 * kTilePixels;

/// A part of a draw's tree that waits for its turn: the nearest first, then by draw and part.
struct Waiting {
  float nearest = 0.0f;
  std::uint32_t fast_draw = 0;
  std::uint32_t child = 0;                                       ///< as in ClusterGroup
  std::int32_t unclean = -1;                                     ///< which of the draw's unclean clusters
  std::uint16_t begin_x = 0, begin_y = 0, end_x = 0, end_y = 0;  ///< pixels of the tile
  friend bool operator<(const Waiting& a, const Waiting& b) {
    if (a.nearest != b.nearest) return a.nearest < b.nearest;
    if (a.fast_draw != b.fast_draw) return a.fast_draw > b.fast_draw;
    return a.child > b.child;
  }
};

/// Visits the samples of a 4×4 that have a bit in `lanes`.
template <class Visit>
void for_each_lane(std::uint32_t lanes, Visit visit) {
  for (; lanes != 0; lanes &= lanes - 1) visit(std::size_t(std::countr_zero(lanes)));
}

struct TileBytes {
  alignas(64) glm::u8vec4 rgba8[kTilePixels];
};

/// A textured triangle made ready, and whose it is.
struct Textured {
  std::uint32_t owner = kNoOwner;
  TexturedTriangle triangle;
};

/// A triangle made ready for exact shading, and whose it is.
struct KeptSurface {
  std::uint32_t owner = kNoOwner;
  SurfaceTriangle triangle;
  bool one_color = false;  ///< all of its samples have the one below that the target keeps
  glm::vec4 rgba32f{0.0f};
  std::uint32_t rgba8 = 0;
};

/// Memory of a worker, allocated before the first tile, so that no tile can fail. Most of it is never touched.
struct Worker {
  std::unique_ptr<TileBuffers> tile;
  bool whole_tile = false;  ///< the last one was: its blocks that nothing has touched are clear, to their edges
  std::vector<Waiting> heap;
  std::vector<Resident> residents;  ///< of the slots in use
  std::vector<std::uint32_t> free_slots;
  std::unique_ptr<WindowVertices128[]> vertices;          ///< [kSlots]
  std::unique_ptr<std::uint8_t[]> marks;                  ///< [kSlots · 128 + 1] kWon, kOwns, kWide
  std::unique_ptr<std::uint32_t[]> record_of;             ///< [kSlots · 128] of visible triangles of flat draws
  std::unique_ptr<ColorRecord[]> records;                 ///< [kMostRecords]
  std::unique_ptr<std::array<Textured, 16>> textured;     ///< kept while their neighbours ask for them
  std::unique_ptr<std::array<KeptSurface, 64>> surfaces;  ///< likewise
  std::unique_ptr<Doubtful[]> doubtful;                   ///< [kTilePixels]
  std::vector<Ids> ids;
  std::unique_ptr<TileBytes> bytes;
  std::span<glm::u8vec4> rgba8;  ///< in `bytes`; empty if the image has none
  std::vector<glm::vec4> rgba32f;
  std::vector<glm::uvec4> sum_rgba8;  ///< over samples, if there are several
  std::vector<glm::dvec4> sum_rgba32f;
  FrameStats stats;
  RasterCounts counts;

  /// Makes room; throws std::bad_alloc.
  void prepare(const Scene& scene, const Image& image);
};

/// Whose samples a tile's are.
class Owners {
 public:
  Owners(const Scene& scene, const Worker& worker, const PixelBox& box) : scene_(scene), w_(worker), box_(box) {}

  [[nodiscard]] const Piece& piece(std::uint32_t i) const { return scene_.assembly.pieces[i]; }
  [[nodiscard]] const FastDraw& fast_draw(std::uint32_t owner) const {
    return scene_.fast[w_.residents[owner / kSlotTriangles].fast_draw];
  }
  [[nodiscard]] Ids ids(std::uint32_t owner) const;
  /// Whether a sample at equal depth is `a`'s rather than `b`'s (C6).
  [[nodiscard]] bool key_before(std::uint32_t a, std::uint32_t b) const;
  /// The sign of the unsnapped determinant of a triangle of the cluster in a slot.
  [[nodiscard]] int facing_sign(std::uint32_t slot, std::uint32_t triangle) const;
  /// Which of the frame's draws it is of.
  [[nodiscard]] std::uint32_t draw(std::uint32_t owner) const {
    return owner & kPieceBit ? piece(owner & ~kPieceBit).draw : fast_draw(owner).draw;
  }
  /// A kernel's triangle as the reference has it; its bounds are the tile's.
  void make_piece(std::uint32_t owner, Piece& p) const;
  /// The owner as the reference has it: the scene's, or made in `room`.
  [[nodiscard]] const Piece& piece_of(std::uint32_t owner, Piece& room) const {
    if (owner & kPieceBit) return piece(owner & ~kPieceBit);
    make_piece(owner, room);
    return room;
  }

 private:
  struct Key {
    std::uint32_t draw_id, primitive_id, number, draw, primitive;  // the last where ids are overridden
    friend auto operator<=>(const Key&, const Key&) = default;
  };
  [[nodiscard]] Key key(std::uint32_t owner) const;
  [[nodiscard]] std::uint32_t primitive(std::uint32_t owner) const;

  const Scene& scene_;
  const Worker& w_;
  PixelBox box_;
};

/// Colours and ids of the tile's samples, from their owners.
///   fill    also the bytes of blocks that nothing has touched
///   n_won   how often a sample of the tile was won by a triangle of the kernels
void resolve(const Scene& scene, Worker& worker, const Image& image, const PixelBox& box, glm::ivec2 sample_fx8,
             bool fill, std::uint64_t n_won);

/// Draws the pixels of the box, which lies in row `row` of tiles, and writes them to the image.
void draw_tile(const Scene& scene, Worker& worker, Image& image, const PixelBox& box, std::size_t row);

}  // namespace lode::raster::fast

#pragma once
/// A frame made ready for its tiles: draws whose clusters the kernels draw, and all else as the reference's pieces.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "raster/fast/kernels.h"
#include "raster/reference/assemble.h"

namespace lode::raster::fast {

using reference::Assembly;
using reference::Piece;
using reference::PixelBox;

/// A cluster that reaches beyond a clip plane. Its triangles that do not are drawn by the kernels, the others as
/// pieces.
struct UncleanCluster {
  std::uint32_t cluster = 0;
  std::array<std::uint64_t, 2> wanted{};  ///< bit k: triangle k is the kernels'
  PixelBox pixels;                        ///< that those may cover
  float nearest = 1.0f;
};

/// A draw that the kernels draw.
struct FastDraw {
  std::uint32_t draw = 0;
  const Clusters* clusters = nullptr;
  DrawView view;
  PixelBox limits;  ///< pixels that it may write
  PixelBox pixels;  ///< of them, those that its box may cover
  float nearest = 2.0f;
  bool flat = false;      ///< neither texture nor shader: colours by records, if the target has bytes
  bool constant = false;  ///< one colour, `bytes`
  std::uint32_t bytes = 0;
  std::array<float, 4> scale{1.0f, 1.0f, 1.0f, 1.0f};  ///< its colour, of 1, for records
  OwnersJob owners_job;                                ///< the draw's share of it
  std::vector<UncleanCluster> unclean;
  std::vector<std::uint32_t> cut;  ///< primitives that become pieces
};

struct Scene {
  const Frame* frame = nullptr;
  const RenderOptions* options = nullptr;
  const Kernels* kernels = nullptr;
  glm::ivec2 size_px{0, 0};
  std::vector<FastDraw> fast;  ///< [n_fast], and more whose memory is kept
  std::size_t n_fast = 0;
  std::vector<std::optional<Surface>> surfaces;  ///< [draws]
  std::vector<Clusters> made;                    ///< for draws that brought none
  std::vector<reference::Selection> selections;
  Assembly assembly;
  std::vector<std::size_t> row_first;     ///< [rows of tiles + 1]
  std::vector<std::uint32_t> row_pieces;  ///< pieces that may touch each row, in order
  std::size_t n_boxes = 0;                ///< groups, clusters and draws: no more can wait at once
  FrameStats stats;

  [[nodiscard]] std::span<const std::uint32_t> row(std::size_t r) const {
    return {row_pieces.data() + row_first[r], row_first[r + 1] - row_first[r]};
  }
};

/// Whether the kernels draw the draw's triangles from its clusters, if it has some: then only they read its indices.
[[nodiscard]] bool drawn_by_clusters(const Draw& draw);

/// Whether the kernels draw a piece of an order-free draw. If its draw has an alpha test, they shade it then, too, and
/// targets of floats keep the colours.
[[nodiscard]] bool drawn_by_kernels(const Piece& piece);

/// Fills the scene, whose memory it uses again.
void make_scene(const Frame& frame, const Image& image, const RenderOptions& options, int threads, Scene& scene);

}  // namespace lode::raster::fast

#include "raster/reference/pipeline.h"

#include <algorithm>
#include <vector>

#include "raster/parallel.h"
#include "raster/reference/assemble.h"
#include "raster/reference/tile.h"

namespace lode::raster::reference {
namespace {

/// For each row of tiles, the pieces whose bounds touch it, in submission order.
struct RowBins {
  std::vector<std::size_t> first;      ///< [rows + 1]
  std::vector<std::uint32_t> pieces;

  [[nodiscard]] std::span<const std::uint32_t> row(std::size_t r) const {
    return {pieces.data() + first[r], first[r + 1] - first[r]};
  }
};

RowBins bin_rows(const std::vector<Piece>& pieces, std::size_t n_rows, int tile_size_px) {
  const auto first_row = [&](const Piece& p) { return std::size_t(p.bounds_px.begin_px.y / tile_size_px); };
  const auto last_row = [&](const Piece& p) { return std::size_t((p.bounds_px.end_px.y - 1) / tile_size_px); };
  RowBins bins;
  bins.first.assign(n_rows + 1, 0);
  for (const Piece& p : pieces) {
    for (std::size_t r = first_row(p); r <= last_row(p); ++r) ++bins.first[r + 1];
  }
  for (std::size_t r = 0; r < n_rows; ++r) bins.first[r + 1] += bins.first[r];
  bins.pieces.resize(bins.first[n_rows]);
  std::vector<std::size_t> next(bins.first.begin(), bins.first.end() - 1);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    for (std::size_t r = first_row(pieces[i]); r <= last_row(pieces[i]); ++r) {
      bins.pieces[next[r]++] = std::uint32_t(i);
    }
  }
  return bins;
}

}  // namespace

FrameStats render_reference(const Frame& frame, Image& image, const RenderOptions& options) {
  const glm::ivec2 size = image.size_px;
  const int tile = options.tile_size_px;
  const std::size_t n_columns = std::size_t((size.x + tile - 1) / tile), n_rows = std::size_t((size.y + tile - 1) / tile);
  const std::size_t n_tiles = n_columns * n_rows;
  const int threads = worker_count(options.threads);

  const Assembly assembly = assemble(frame, size, threads);
  const RowBins bins = bin_rows(assembly.pieces, n_rows, tile);

  // Everything that can fail has been done once the scratch stands: from here on the image is written.
  const int n_workers = int(std::min<std::size_t>(std::size_t(threads), n_tiles));
  std::vector<TileScratch> scratch;
  scratch.reserve(std::size_t(n_workers));
  for (int w = 0; w < n_workers; ++w) scratch.emplace_back(frame, image, tile, !options.per_draw.empty());

  parallel_for(n_tiles, n_workers, [&](std::size_t t, int worker) {
    const glm::ivec2 begin = {int(t % n_columns) * tile, int(t / n_columns) * tile};
    const PixelBox box = {begin, {std::min(begin.x + tile, size.x), std::min(begin.y + tile, size.y)}};
    const TileJob job{frame, assembly.pieces, bins.row(t / n_columns), box, options.ids_from_ordered_draws};
    draw_tile(job, scratch[std::size_t(worker)], image);
    if (options.on_tile) options.on_tile();
  });

  FrameStats stats = assembly.stats;
  std::fill(options.per_draw.begin(), options.per_draw.end(), DrawStats{});
  for (const TileScratch& s : scratch) {
    stats += s.stats;
    for (std::size_t d = 0; d < s.per_draw.size(); ++d) {
      options.per_draw[d].covered += s.per_draw[d].covered;
      options.per_draw[d].visible += s.per_draw[d].visible;
    }
  }
  return stats;
}

}  // namespace lode::raster::reference

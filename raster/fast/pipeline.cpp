#include "raster/fast/pipeline.h"

#include <algorithm>
#include <cstring>
#include <functional>
#include <memory>
#include <vector>

#include "raster/blend.h"
#include "raster/fast/scene.h"
#include "raster/fast/tile.h"
#include "raster/parallel.h"
#include "raster/reference/pipeline.h"

namespace lode::raster {

struct FrameMemory::Parts {
  fast::Scene scene;
  std::vector<std::unique_ptr<fast::Worker>> workers;
};

FrameMemory::FrameMemory() = default;
FrameMemory::~FrameMemory() = default;
FrameMemory::FrameMemory(FrameMemory&&) noexcept = default;
FrameMemory& FrameMemory::operator=(FrameMemory&&) noexcept = default;

}  // namespace lode::raster

namespace lode::raster::fast {
namespace {

void add_counts(const RasterCounts& c, FrameStats& stats) {
  stats.triangles_in += c.triangles_in;
  stats.triangles_facing += c.facing;
  stats.triangles_empty += c.empty;
  stats.triangles_without_sample += c.no_sample;
  stats.triangles_rasterized += c.tiny + c.medium + c.large;
  stats.blocks_touched += c.blocks;
  stats.blocks_outside += c.blocks_outside;
  stats.blocks_hidden += c.blocks_hidden;
  stats.fragments_covered += c.fragments;
  stats.fragments_alpha_failed += c.alpha_failed;
  stats.fragments_depth_failed += c.fragments - c.fragments_kept - c.alpha_failed;
}

/// Whether no draw can touch the image.
bool is_empty(const Scene& scene) {
  return scene.assembly.pieces.empty() &&
         std::all_of(scene.fast.begin(), scene.fast.begin() + std::ptrdiff_t(scene.n_fast),
                     [](const FastDraw& f) { return f.pixels.empty(); });
}

/// The clear alone, in whole rows: the tiles' rows one behind the other are what memory likes best.
void clear(const Scene& scene, Image& image, int n_workers, const std::function<void()>& on_tile) {
  const auto columns = std::size_t(image.size_px.x);
  const auto height_px = std::size_t(image.size_px.y), rows_px = std::size_t(kTile_px);
  const std::size_t n_rows = (height_px + rows_px - 1) / rows_px;
  const glm::u8vec4 clear8 = store_rgba8(scene.frame->clear);
  const glm::vec4 clear32 = store_rgba32f(scene.frame->clear);
  std::uint32_t bytes;
  std::memcpy(&bytes, &clear8, 4);
  parallel_for(n_rows, n_workers, [&](std::size_t row, int) {
    const std::size_t first = row * rows_px * columns, n = std::min(rows_px, height_px - row * rows_px) * columns;
    const auto words = [&](auto& plane, std::uint32_t value) {
      if (!plane.empty()) scene.kernels->clear(reinterpret_cast<std::uint32_t*>(&plane[first]), n, value);
    };
    words(image.rgba8, bytes), words(image.depth, 0);
    if (!image.rgba32f.empty()) std::fill_n(&image.rgba32f[first], n, clear32);
    if (!image.ids.empty()) std::fill_n(&image.ids[first], n, Ids{kNoId, kNoId});
    for (std::size_t x = 0; on_tile && x < columns; x += rows_px) on_tile();
  });
}

}  // namespace

FrameStats render_fast(const Frame& frame, Image& image, const RenderOptions& options) {
  if (!options.per_draw.empty()) return reference::render_reference(frame, image, options);  // looks at every sample
  FrameMemory own;
  FrameMemory& memory = options.memory ? *options.memory : own;
  if (!memory.parts) memory.parts = std::make_unique<FrameMemory::Parts>();
  Scene& scene = memory.parts->scene;
  auto& workers = memory.parts->workers;

  const glm::ivec2 size = image.size_px;
  const std::size_t n_columns = std::size_t((size.x + kTile_px - 1) / kTile_px);
  const std::size_t n_tiles = n_columns * std::size_t((size.y + kTile_px - 1) / kTile_px);
  const int threads = worker_count(options.threads);
  make_scene(frame, image, options, threads, scene);
  // Everything that can fail has been done once the workers stand: from here on the image is written.
  const auto n_workers = std::min<std::size_t>(std::size_t(threads), n_tiles);
  while (workers.size() < n_workers) workers.push_back(std::make_unique<Worker>());
  for (std::size_t w = 0; w < n_workers; ++w) workers[w]->prepare(scene, image);

  if (is_empty(scene)) {
    clear(scene, image, int(n_workers), options.on_tile);
    return scene.stats;
  }
  parallel_for(n_tiles, int(n_workers), [&](std::size_t t, int worker) {
    const glm::ivec2 begin = {int(t % n_columns) * kTile_px, int(t / n_columns) * kTile_px};
    const PixelBox box = {begin, {std::min(begin.x + kTile_px, size.x), std::min(begin.y + kTile_px, size.y)}};
    draw_tile(scene, *workers[std::size_t(worker)], image, box, t / n_columns);
    if (options.on_tile) options.on_tile();
  });

  FrameStats stats = scene.stats;
  for (std::size_t w = 0; w < n_workers; ++w) {
    stats += workers[w]->stats;
    add_counts(workers[w]->counts, stats);
  }
  return stats;
}

}  // namespace lode::raster::fast

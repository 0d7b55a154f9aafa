#pragma once
/// A tile and triangles for its kernels: a grid of right triangles of one size, 8 × 8 cells a cluster, covers it once.

#include <algorithm>
#include <string>
#include <vector>

#include "raster/fast/kernels.h"

namespace lode::bench {

using namespace raster;
using namespace raster::fast;

/// Calls add(kernels, "/avx512") for every target that can run here.
template <class Add>
void for_each_target(Add add) {
  for (const Target t : {Target::scalar, Target::sse4, Target::avx2, Target::avx512, Target::neon, Target::wasm}) {
    if (const Kernels* const kernels = find_kernels(t)) add(kernels, std::string("/") + name_of(t));
  }
}

/// A cluster's triangles in the window of the tile.
struct TileCluster {
  WindowVertices128 vertices;
  std::vector<std::uint8_t> corners;  ///< and a byte to spare: kernels read four at a time
  mutable std::vector<std::uint8_t> marks = std::vector<std::uint8_t>(kMaxClusterTriangles);
  [[nodiscard]] int n_triangles() const { return int(corners.size() / 3); }
};

/// 8 × 8 cells, or fewer, from the cell on.
inline TileCluster tile_cluster(glm::ivec2 first, int n_cells, int side_px, int origin_px) {
  TileCluster cluster;
  for (int y = 0; y <= n_cells; ++y) {
    for (int x = 0; x <= n_cells; ++x) {
      const int k = y * (n_cells + 1) + x;
      const auto x_fx8 = std::uint32_t(((first.x + x) * side_px + origin_px) * 256 + 37);
      const auto y_fx8 = std::uint32_t(((first.y + y) * side_px + origin_px) * 256 + 91);
      cluster.vertices.xy_fx8[k] = std::uint64_t(y_fx8) << 32 | x_fx8;
      cluster.vertices.z[k] = 0.3 + 0.025 * ((x * 5 + y * 3) % 8);
      cluster.vertices.w[k] = 1.0 + 0.25 * x;
    }
  }
  for (int y = 0; y < n_cells; ++y) {
    for (int x = 0; x < n_cells; ++x) {
      const int a = y * (n_cells + 1) + x, c = a + n_cells + 1;
      for (const int corner : {a, a + 1, c, a + 1, c + 1, c}) cluster.corners.push_back(std::uint8_t(corner));
    }
  }
  cluster.corners.push_back(0);
  return cluster;
}

inline std::vector<TileCluster> tile_clusters(int side_px) {
  const int n_cells = std::max(1, kTile_px / side_px), per_cluster = std::min(8, n_cells);
  const int origin_px = side_px > kTile_px ? (kTile_px - side_px) / 2 : 0;
  std::vector<TileCluster> clusters;
  for (int y = 0; y < n_cells; y += per_cluster) {
    for (int x = 0; x < n_cells; x += per_cluster) {
      clusters.push_back(tile_cluster({x, y}, per_cluster, side_px, origin_px));
    }
  }
  return clusters;
}

inline bool lower(const void*, std::uint32_t a, std::uint32_t b) { return a < b; }
inline int faces(const void*, std::uint32_t) { return 1; }

inline RasterJob raster_job(const TileCluster& cluster, std::size_t number) {
  RasterJob job;
  job.corners = cluster.corners.data();
  job.n_triangles = cluster.n_triangles();
  job.vertices = &cluster.vertices;
  job.end_x = job.end_y = kTile_px;
  job.first_owner = std::uint32_t(number) * kMaxClusterTriangles;
  job.key_before = lower;
  job.facing_sign = faces;
  job.marks = cluster.marks.data();
  return job;
}

inline void fill(TileBuffers& tile, float depth) {
  std::fill_n(tile.depth, kTilePixels, depth);
  std::fill_n(tile.owner, kTilePixels, kNoOwner);
  std::fill_n(tile.block_min, std::size(tile.block_min), depth);
  std::fill_n(tile.written, std::size(tile.written), kTouched);
}

}  // namespace lode::bench

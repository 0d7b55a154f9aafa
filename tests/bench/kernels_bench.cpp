// The fast pipeline's kernels on one tile, target by target. The tile's triangles come from a grid of right triangles
// of one size, 8 × 8 cells a cluster, and cover it once.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <string>

#include "bench.h"
#include "grid_mesh.h"
#include "raster/fast/kernels.h"

namespace lode::bench {
namespace {

using namespace raster;
using namespace raster::fast;

/// A cluster's triangles in the window of the tile.
struct TileCluster {
  WindowVertices128 vertices;
  std::vector<std::uint8_t> corners;  ///< and a byte to spare: kernels read four at a time
  [[nodiscard]] int n_triangles() const { return int(corners.size() / 3); }
};

/// 8 × 8 cells, or fewer, from the cell on.
TileCluster tile_cluster(glm::ivec2 first, int n_cells, int side_px, int origin_px) {
  TileCluster cluster;
  for (int y = 0; y <= n_cells; ++y) {
    for (int x = 0; x <= n_cells; ++x) {
      const int k = y * (n_cells + 1) + x;
      cluster.vertices.x_fx8[k] = ((first.x + x) * side_px + origin_px) * 256 + 37;
      cluster.vertices.y_fx8[k] = ((first.y + y) * side_px + origin_px) * 256 + 91;
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

std::vector<TileCluster> tile_clusters(int side_px) {
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

bool lower(const void*, std::uint32_t a, std::uint32_t b) { return a < b; }
int faces(const void*, std::uint32_t) { return 1; }

RasterJob raster_job(const TileCluster& cluster, std::size_t number) {
  RasterJob job;
  job.corners = cluster.corners.data();
  job.n_triangles = cluster.n_triangles();
  job.vertices = &cluster.vertices;
  job.end_x = job.end_y = kTile_px;
  job.first_owner = std::uint32_t(number) * kMaxClusterTriangles;
  job.key_before = lower;
  job.facing_sign = faces;
  return job;
}

void fill(TileBuffers& tile, float depth) {
  std::fill_n(tile.depth, kTilePixels, depth);
  std::fill_n(tile.owner, kTilePixels, kNoOwner);
  std::fill_n(tile.block_min, std::size(tile.block_min), depth);
  std::fill_n(tile.stale, std::size(tile.stale), std::uint8_t(0));
}

/// Items are the tile's pixels.
void clear_tile(benchmark::State& state, const Kernels*) {
  const auto tile = std::make_unique<TileBuffers>();
  for (auto _ : state) {
    fill(*tile, -1.0f);
    benchmark::DoNotOptimize(tile->depth[0]);
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * kTilePixels);
}

/// Set-up, coverage and depth of a tile, its clear included; items are triangles. Behind what is there: all are hidden.
void rasterize(benchmark::State& state, const Kernels* kernels, bool hidden) {
  const std::vector<TileCluster> clusters = tile_clusters(int(state.range(0)));
  const auto tile = std::make_unique<TileBuffers>();
  std::int64_t n_triangles = 0;
  for (const TileCluster& cluster : clusters) n_triangles += cluster.n_triangles();
  RasterCounts counts;
  for (auto _ : state) {
    fill(*tile, hidden ? 0.9f : -1.0f);
    for (std::size_t i = 0; i < clusters.size(); ++i) {
      benchmark::DoNotOptimize(kernels->rasterize(raster_job(clusters[i], i), *tile, counts));
    }
  }
  state.SetItemsProcessed(state.iterations() * n_triangles);
  state.counters["px"] = benchmark::Counter(kTilePixels, benchmark::Counter::kIsIterationInvariantRate);
}

/// Items are vertices.
void transform(benchmark::State& state, const Kernels* kernels) {
  alignas(64) float x[kMaxClusterVertices], y[kMaxClusterVertices], z[kMaxClusterVertices];
  for (int i = 0; i < kMaxClusterVertices; ++i) {
    x[i] = 0.01f * float(i % 16);
    y[i] = 0.02f * float(i / 16);
    z[i] = -4.0f - 0.03f * float(i % 7);
  }
  DrawView view;
  view.clip_from_object = {1.5, 0.1, 0.0, 0.2, -0.1, 1.4, 0.2, 0.1, 0.0, 0.0, 0.0, 0.1, 0.0, 0.0, -1.0, 0.0};
  view.centre_fx8 = view.half_fx8 = {960.0 * 256.0, 540.0 * 256.0};
  WindowVertices128 window;
  for (auto _ : state) {
    kernels->transform(view, x, y, z, kMaxClusterVertices, 0, 0, &window);
    benchmark::DoNotOptimize(window);
  }
  state.SetItemsProcessed(state.iterations() * kMaxClusterVertices);
}

/// Boxes to the screen; items are boxes.
void project(benchmark::State& state, const Kernels* kernels) {
  DrawView view;
  view.clip_from_object = {1.5, 0.1, 0.0, 0.2, -0.1, 1.4, 0.2, 0.1, 0.0, 0.0, 0.0, 0.1, 0.0, 0.0, -1.0, 0.0};
  view.centre_fx8 = view.half_fx8 = {960.0 * 256.0, 540.0 * 256.0};
  for (auto _ : state) benchmark::DoNotOptimize(kernels->project(view, {-0.1f, 0.2f, -5.0f}, {0.3f, 0.4f, -4.5f}));
  state.SetItemsProcessed(state.iterations());
}

/// The hierarchical depth of a tile, all of it stale; items are blocks.
void least_depth(benchmark::State& state, const Kernels* kernels) {
  const auto tile = std::make_unique<TileBuffers>();
  fill(*tile, 0.25f);
  for (auto _ : state) {
    std::fill_n(tile->stale, std::size(tile->stale), std::uint8_t(1));
    benchmark::DoNotOptimize(kernels->least_depth(*tile, 0, 0, kTile_px, kTile_px));
  }
  state.SetItemsProcessed(state.iterations() * std::int64_t(std::size(tile->stale)));
}

/// Vertex colours of a tile's samples; items are samples.
void shade_flat(benchmark::State& state, const Kernels* kernels) {
  const TileCluster cluster = tile_cluster({0, 0}, 8, 16, 0);
  const auto tile = std::make_unique<TileBuffers>();
  fill(*tile, -1.0f);
  RasterCounts counts;
  kernels->rasterize(raster_job(cluster, 0), *tile, counts);
  std::replace(tile->owner, tile->owner + kTilePixels, kNoOwner, 0u);
  const Resident resident;
  std::vector<std::uint32_t> mesh_vertices(kMaxClusterVertices);
  std::vector<float> colors;
  for (std::uint32_t i = 0; i < kMaxClusterVertices; ++i) {
    mesh_vertices[i] = i;
    for (int c = 0; c < 4; ++c) colors.push_back(float((i * 37 + std::uint32_t(c) * 11) % 256));
  }
  FlatJob job;
  job.residents = &resident;
  job.vertices = &cluster.vertices;
  job.corners = cluster.corners.data();
  job.mesh_vertices = mesh_vertices.data();
  job.colors = colors.data();
  alignas(64) float rgba[64];
  for (auto _ : state) {
    for (int y = 0; y < kTile_px; y += 4) {
      for (int x = 0; x < kTile_px; x += 4) {
        job.x_fx8 = x * 256 + 128;
        job.y_fx8 = y * 256 + 128;
        kernels->shade_flat(job, tile->owner + place_in_tile(x, y), rgba);
        benchmark::DoNotOptimize(rgba);
      }
    }
  }
  state.SetItemsProcessed(state.iterations() * kTilePixels);
}

/// Items are samples.
void store_bytes(benchmark::State& state, const Kernels* kernels) {
  alignas(64) float rgba[64];
  std::uint32_t bytes[16];
  for (int i = 0; i < 64; ++i) rgba[i] = 4.1f * float(i);
  for (auto _ : state) {
    kernels->store_bytes(rgba, bytes);
    benchmark::DoNotOptimize(bytes);
  }
  state.SetItemsProcessed(state.iterations() * 16);
}

/// Items are triangles.
void cut_clusters(benchmark::State& state) {
  const GridMesh mesh = grid_mesh(256);
  for (auto _ : state) {
    benchmark::DoNotOptimize(make_clusters(mesh.positions, mesh.indices, int(state.range(0))).clusters.size());
  }
  state.SetItemsProcessed(state.iterations() * std::int64_t(mesh.n_triangles()));
}

}  // namespace

void register_kernels() {
  const auto add = [](const std::string& name, auto function, auto... arguments) {
    return benchmark::RegisterBenchmark(name.c_str(), function, arguments...);
  };
  add("ClearTile", clear_tile, nullptr);
  for (const Target t : {Target::scalar, Target::sse4, Target::avx2, Target::avx512, Target::neon, Target::wasm}) {
    const Kernels* const kernels = find_kernels(t);
    if (!kernels) continue;
    const std::string target = std::string("/") + name_of(t);
    add("Transform" + target, transform, kernels);
    add("ProjectBox" + target, project, kernels);
    for (const int side_px : {2, 8, 64, 512}) {
      add("Coverage" + target + "/side_px", rasterize, kernels, false)->Arg(side_px);
      add("CoverageHidden" + target + "/side_px", rasterize, kernels, true)->Arg(side_px);
    }
    add("LeastDepth" + target, least_depth, kernels);
    add("ShadeFlat" + target, shade_flat, kernels);
    add("StoreBytes" + target, store_bytes, kernels);
  }
  add("CutClusters/threads", cut_clusters)->Arg(1)->Arg(0)->Unit(benchmark::kMillisecond)->UseRealTime();
}

}  // namespace lode::bench

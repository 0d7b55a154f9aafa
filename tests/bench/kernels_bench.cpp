// From boxes and vertices to a tile's depths and owners, target by target, and cutting meshes into clusters.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <memory>

#include "bench.h"
#include "grid_mesh.h"
#include "tile_fixture.h"

namespace lode::bench {
namespace {

/// Items are the tile's pixels.
void clear_tile(benchmark::State& state) {
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

DrawView tilted_view() {
  DrawView view;
  view.clip_from_object = {1.5, 0.1, 0.0, 0.2, -0.1, 1.4, 0.2, 0.1, 0.0, 0.0, 0.0, 0.1, 0.0, 0.0, -1.0, 0.0};
  view.centre_fx8 = view.half_fx8 = {960.0 * 256.0, 540.0 * 256.0};
  return view;
}

/// Items are vertices.
void transform(benchmark::State& state, const Kernels* kernels) {
  alignas(64) float x[kMaxClusterVertices], y[kMaxClusterVertices], z[kMaxClusterVertices];
  for (int i = 0; i < kMaxClusterVertices; ++i) {
    x[i] = 0.01f * float(i % 16);
    y[i] = 0.02f * float(i / 16);
    z[i] = -4.0f - 0.03f * float(i % 7);
  }
  const DrawView view = tilted_view();
  WindowVertices128 window;
  for (auto _ : state) {
    kernels->transform(view, x, y, z, kMaxClusterVertices, 0, 0, &window);
    benchmark::DoNotOptimize(window);
  }
  state.SetItemsProcessed(state.iterations() * kMaxClusterVertices);
}

/// A group of sixteen boxes, all in the view; items are boxes.
void look(benchmark::State& state, const Kernels* kernels) {
  ClusterGroup group{};
  group.n = ClusterGroup::kMost;
  for (int i = 0; i < group.n; ++i) {
    const float low[] = {-0.2f + 0.02f * float(i), 0.2f - 0.01f * float(i), -5.0f - 0.1f * float(i)};
    for (int axis = 0; axis < 3; ++axis) {
      group.low[axis][i] = low[axis];
      group.high[axis][i] = low[axis] + 0.1f;
    }
  }
  const DrawView view = tilted_view();
  BoxSight sights[ClusterGroup::kMost];
  for (auto _ : state) {
    kernels->look(view, group, {{0, 0}, {1920, 1080}}, Skips{}, sights);
    benchmark::DoNotOptimize(sights);
  }
  state.SetItemsProcessed(state.iterations() * group.n);
}

/// The hierarchical depth of a tile, all of it stale; items are blocks.
void hidden(benchmark::State& state, const Kernels* kernels) {
  const auto tile = std::make_unique<TileBuffers>();
  fill(*tile, 0.25f);
  for (auto _ : state) {
    std::fill_n(tile->written, std::size(tile->written), std::uint8_t(kStale | kTouched));
    std::fill_n(tile->block_min, std::size(tile->block_min), -1.0f);
    benchmark::DoNotOptimize(kernels->hidden(*tile, {{0, 0}, {kTile_px, kTile_px}}, 0.2f));
  }
  state.SetItemsProcessed(state.iterations() * std::int64_t(std::size(tile->written)));
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
  benchmark::RegisterBenchmark("ClearTile", clear_tile);
  for_each_target([](const Kernels* kernels, const std::string& target) {
    benchmark::RegisterBenchmark(("Transform" + target).c_str(), transform, kernels);
    benchmark::RegisterBenchmark(("LookAtBoxes" + target).c_str(), look, kernels);
    for (const int side_px : {2, 8, 64, 512}) {
      benchmark::RegisterBenchmark(("Coverage" + target + "/side_px").c_str(), rasterize, kernels, false)->Arg(side_px);
      benchmark::RegisterBenchmark(("CoverageHidden" + target + "/side_px").c_str(), rasterize, kernels, true)
          ->Arg(side_px);
    }
    benchmark::RegisterBenchmark(("HiddenTile" + target).c_str(), hidden, kernels);
  });
  benchmark::RegisterBenchmark("CutClusters/threads", cut_clusters)
      ->Arg(1)
      ->Arg(0)
      ->Unit(benchmark::kMillisecond)
      ->UseRealTime();
}

}  // namespace lode::bench

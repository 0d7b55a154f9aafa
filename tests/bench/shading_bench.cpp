// From a tile's owners to the image's bytes, target by target.
#include <benchmark/benchmark.h>

#include <memory>
#include <numeric>

#include "bench.h"
#include "tile_fixture.h"

namespace lode::bench {
namespace {

/// A tile covered by 8 × 8 cells of 16 px, with colours at the vertices.
struct ColoredTile {
  TileCluster cluster = tile_cluster({0, 0}, 8, 16, 0);
  std::unique_ptr<TileBuffers> tile = std::make_unique<TileBuffers>();
  std::vector<float> colors;

  explicit ColoredTile(const Kernels* kernels) {
    fill(*tile, -1.0f);
    RasterCounts counts;
    kernels->rasterize(raster_job(cluster, 0), *tile, counts);
    std::replace(tile->owner, tile->owner + kTilePixels, kNoOwner, 0u);
    for (std::uint32_t i = 0; i < kMaxClusterVertices; ++i) {
      for (std::uint32_t c = 0; c < 4; ++c) colors.push_back(float((i * 37 + c * 11) % 256));
    }
  }

  /// Calls visit(owners, x, y) for each 4 × 4 of the tile.
  template <class Visit>
  void for_each_quarter(Visit visit) const {
    for (int y = 0; y < kTile_px; y += 4) {
      for (int x = 0; x < kTile_px; x += 4) visit(tile->owner + place_in_tile(x, y), x, y);
    }
  }
};

/// Vertex colours of a tile's samples as C7 has them, in double; items are samples.
void shade_owners(benchmark::State& state, const Kernels* kernels) {
  const ColoredTile colored(kernels);
  const Resident resident;
  std::vector<std::uint32_t> mesh_vertices(kMaxClusterVertices);
  std::iota(mesh_vertices.begin(), mesh_vertices.end(), 0u);
  std::int32_t x_fx8[16], y_fx8[16];
  Surface surface;
  surface.has_vertex_colors = true, surface.full = 255.0f;
  OwnersJob job;
  job.surface = &surface;
  job.residents = &resident;
  job.vertices = &colored.cluster.vertices;
  job.corners = colored.cluster.corners.data();
  job.mesh_vertices = mesh_vertices.data();
  job.colors = colored.colors.data();
  job.x_fx8 = x_fx8;
  job.y_fx8 = y_fx8;
  SurfaceSamples samples;
  for (auto _ : state) {
    colored.for_each_quarter([&](const std::uint32_t* owners, int x, int y) {
      for (int k = 0; k < 16; ++k) {
        x_fx8[k] = (x + k % 4) * 256 + 128;
        y_fx8[k] = (y + k / 4) * 256 + 128;
      }
      kernels->shade_owners(job, owners, samples);
      benchmark::DoNotOptimize(samples);
    });
  }
  state.SetItemsProcessed(state.iterations() * kTilePixels);
}

/// Colour, normal and light of a 4×4 of one triangle, for a float target; items are samples.
void shade_surface(benchmark::State& state, const Kernels* kernels) {
  const Lambert lambert;
  Surface surface;
  surface.has_vertex_colors = true;
  surface.lambert = &lambert, surface.has_normals = true;
  SurfaceTriangle triangle;
  triangle.edge_x = {-256.0, 128.0, 128.0}, triangle.edge_y = {0.0, 256.0, -256.0};
  triangle.edge_c = {8e6, 1e6, 1e6}, triangle.w = {1.0, 1.5, 2.0};
  triangle.affine = false;
  triangle.normals = {{{0.1f, 0.2f, 0.3f}, {0.9f, 0.8f, 1.0f}, {0.3f, -0.2f, 0.1f}}};
  triangle.colors = {{{0.1f, 0.5f, 0.9f}, {0.3f, 0.2f, 0.7f}, {0.0f, 1.0f, 0.5f}, {1.0f, 1.0f, 1.0f}}};
  SurfaceSamples samples;
  for (auto _ : state) {
    for (int y = 0; y < kTile_px; y += 4) {
      for (int x = 0; x < kTile_px; x += 4) {
        kernels->shade_surface(surface, triangle, x * 256 + 128, y * 256 + 128, samples);
        benchmark::DoNotOptimize(samples);
      }
    }
  }
  state.SetItemsProcessed(state.iterations() * kTilePixels);
}

/// The same as bytes, by the triangles' planes, which are made anew for each tile; items are samples.
void shade_records(benchmark::State& state, const Kernels* kernels) {
  const ColoredTile colored(kernels);
  const auto n = std::size_t(colored.cluster.n_triangles());
  std::vector<std::uint32_t> mesh_vertices(kMaxClusterVertices), record_of(kMaxClusterTriangles), index(16);
  std::iota(mesh_vertices.begin(), mesh_vertices.end(), 0u);
  std::vector<std::uint8_t> marks(kMaxClusterTriangles, 0);
  std::fill_n(marks.begin(), n, kWon);
  std::vector<ColorRecord> records(kMaxClusterTriangles + 16);
  std::vector<std::int32_t> wide(kMaxClusterTriangles + 16);
  RecordJob job;
  job.corners = colored.cluster.corners.data();
  job.vertices = &colored.cluster.vertices;
  job.mesh_vertices = mesh_vertices.data();
  job.colors = colored.colors.data();
  job.marks = marks.data(), job.wanted = kWon;
  job.record_of = record_of.data(), job.records = records.data();
  job.wide = wide.data();
  std::uint32_t bytes[16];
  for (auto _ : state) {
    kernels->make_records(job);
    colored.for_each_quarter([&](const std::uint32_t* owners, int x, int y) {
      for (std::size_t k = 0; k < 16; ++k) index[k] = record_of[owners[k] % kMaxClusterTriangles];
      benchmark::DoNotOptimize(kernels->shade_records(records.data(), index.data(), x, y, bytes));
    });
  }
  state.SetItemsProcessed(state.iterations() * kTilePixels);
}

/// A tile's depths to the image; items are pixels.
void write_tile(benchmark::State& state, const Kernels* kernels) {
  const auto tile = std::make_unique<TileBuffers>();
  fill(*tile, 0.25f);
  std::vector<float> image(1920 * kTile_px);
  const WriteJob job{.from = tile->depth,
                     .to = image.data(),
                     .pitch_px = 1920,
                     .width_px = kTile_px,
                     .height_px = kTile_px,
                     .depths = true};
  for (auto _ : state) {
    kernels->write_tile(job);
    benchmark::ClobberMemory();
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

}  // namespace

void register_shading() {
  for_each_target([](const Kernels* kernels, const std::string& target) {
    benchmark::RegisterBenchmark(("ShadeExactly" + target).c_str(), shade_owners, kernels);
    benchmark::RegisterBenchmark(("ShadeByRecords" + target).c_str(), shade_records, kernels);
    benchmark::RegisterBenchmark(("ShadeSurface" + target).c_str(), shade_surface, kernels);
    benchmark::RegisterBenchmark(("StoreBytes" + target).c_str(), store_bytes, kernels);
    benchmark::RegisterBenchmark(("WriteTile" + target).c_str(), write_tile, kernels);
  });
}

}  // namespace lode::bench

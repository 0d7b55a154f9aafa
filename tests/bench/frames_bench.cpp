// Whole frames by either pipeline, in a steady state: memory is kept from frame to frame, clusters are cut before.
// Items are the frame's pixels (times layers), triangles where the name has side_px.
#include <benchmark/benchmark.h>

#include <memory>
#include <optional>
#include <string>

#include "../determinism/pictures.h"
#include "bench.h"
#include "grid_mesh.h"
#include "raster/clusters.h"
#include "raster/render.h"

namespace lode::bench {
namespace {

using namespace raster;
using pictures::Picture;

constexpr Pipeline kPipelines[] = {Pipeline::fast, Pipeline::reference};
const char* name_of(Pipeline pipeline) { return pipeline == Pipeline::fast ? "fast" : "reference"; }

/// Draws the frame again and again.
void render_frames(benchmark::State& state, const Frame& frame, Image& image, Pipeline pipeline, int threads,
                   std::int64_t items) {
  FrameMemory memory;
  const RenderOptions options{.threads = threads, .pipeline = pipeline, .memory = &memory};
  for (auto _ : state) render(frame, image, options);
  state.SetItemsProcessed(state.iterations() * items);
}

/// Nothing but the clear, at 1920 × 1080.
void clear_frame(benchmark::State& state, Pipeline pipeline) {
  Image image = make_image({1920, 1080}, ColorFormat::rgba8, {.color = true, .depth = true, .ids = false});
  const Frame frame{.draws = {}, .clear = {9, 8, 7, 255}, .viewport = {}, .scissor = {}};
  render_frames(state, frame, image, pipeline, int(state.range(0)), 1920 * 1080);
  state.SetBytesProcessed(state.iterations() * 1920 * 1080 * 8);
}

/// A 1024² target covered once by vertex-coloured triangles of one size.
void mesh_frame(benchmark::State& state, Pipeline pipeline) {
  const GridMesh mesh = grid_mesh(1024 / int(state.range(0)));
  const Clusters clusters = make_clusters(mesh.positions, mesh.indices);
  std::vector<glm::vec4> colors;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) colors.emplace_back(i % 256, i / 3 % 256, i / 7 % 256, 255);
  Draw draw;
  draw.vertices = ObjectVertices{mesh.positions, glm::dmat4(1.0)};
  draw.indices = mesh.indices;
  draw.clusters = &clusters;
  draw.colors = colors;
  Image image = make_image({1024, 1024}, ColorFormat::rgba8, {.color = true, .depth = true, .ids = false});
  const Frame frame{.draws = {&draw, 1}, .viewport = {}, .scissor = {}};
  render_frames(state, frame, image, pipeline, int(state.range(1)), std::int64_t(mesh.n_triangles()));
}

/// A square across the target in perspective, and what it borrows.
struct TexturedSquare {
  GridMesh mesh = grid_mesh(1, 4.0f);
  Clusters clusters = make_clusters(mesh.positions, mesh.indices, 1);
  std::vector<glm::vec2> uvs{{0, 0}, {9, 0}, {0, 9}, {9, 9}};
  Texture texture;
  Draw draw;

  explicit TexturedSquare(Filter filter) {
    const glm::ivec2 size_px{256, 256};
    std::vector<glm::u8vec4> texels;
    for (int i = 0; i < size_px.x * size_px.y; ++i) texels.emplace_back(i & 255, (i >> 3) & 255, (i >> 7) & 255, 200);
    texture = make_raw_texture(size_px, texels, Mips::all);
    glm::dmat4 tilted(1.0);
    tilted[0][3] = 0.1;
    tilted[1][3] = 0.15;
    draw.vertices = ObjectVertices{mesh.positions, tilted};
    draw.indices = mesh.indices;
    draw.clusters = &clusters;
    draw.uvs = uvs;
    draw.texture = &texture;
    draw.sampler.filter = filter;
  }
};

/// Every pixel of 1024² is shaded once.
void shade_frame(benchmark::State& state, Pipeline pipeline, Filter filter) {
  const TexturedSquare square(filter);
  Image image = make_image({1024, 1024}, ColorFormat::rgba8, {.color = true, .depth = true, .ids = false});
  const Frame frame{.draws = {&square.draw, 1}, .viewport = {}, .scissor = {}};
  render_frames(state, frame, image, pipeline, 1, 1024 * 1024);
}

/// Eight bilinear layers, one over the other.
void blend_frame(benchmark::State& state, Pipeline pipeline, Blend blend) {
  constexpr int kLayers = 8;
  TexturedSquare square(Filter::bilinear);
  square.draw.blend = blend;
  const std::vector<Draw> draws(kLayers, square.draw);
  Image image = make_image({1024, 1024}, ColorFormat::rgba8, {.color = true, .depth = true, .ids = false});
  const Frame frame{.draws = draws, .viewport = {}, .scissor = {}};
  render_frames(state, frame, image, pipeline, 1, kLayers * 1024 * 1024);
}

void picture_frame(benchmark::State& state, Pipeline pipeline, const std::shared_ptr<const Picture>& picture) {
  Image image = picture->image();
  render_frames(state, picture->frame(), image, pipeline, 1,
                std::int64_t(picture->size_px.x) * std::int64_t(picture->size_px.y));
}

constexpr std::pair<const char*, Filter> kFilters[] = {{"nearest", Filter::nearest},
                                                       {"bilinear", Filter::bilinear},
                                                       {"trilinear", Filter::trilinear},
                                                       {"anisotropic", Filter::anisotropic}};

}  // namespace

void register_frames() {
  std::vector<std::shared_ptr<const Picture>> all;
  for (const Picture& picture : pictures::all_pictures()) all.push_back(std::make_shared<const Picture>(picture));
  for (const Pipeline pipeline : kPipelines) {
    const auto add = [&](const std::string& name, auto function, auto... arguments) {
      return benchmark::RegisterBenchmark((name + "/" + name_of(pipeline)).c_str(), function, pipeline, arguments...)
          ->Unit(benchmark::kMillisecond)
          ->UseRealTime();
    };
    add("Clear/threads", clear_frame)->Arg(1)->Arg(0);
    add("Mesh/side_px/threads", mesh_frame)->ArgsProduct({{2, 8, 64, 512}, {1, 0}});
    for (const auto& [name, filter] : kFilters) add(std::string("Shade/") + name, shade_frame, filter);
    add("Blend/over", blend_frame, Blend::over);
    add("Blend/add", blend_frame, Blend::add);
    for (const auto& picture : all) add("Picture/" + picture->name, picture_frame, picture);
  }
}

}  // namespace lode::bench

// Micro benchmarks of the rasterizer's parts: filters, blending, sRGB, and whole renders of the determinism pictures
// and of triangles of one size. Times are of one machine; what the work was is in the counters.
#include <benchmark/benchmark.h>

#include <string>

#include "../determinism/pictures.h"
#include "raster/blend.h"
#include "raster/srgb.h"

namespace {

using namespace lode::raster;
using lode::pictures::Picture;

void report(benchmark::State& state, const FrameStats& stats, glm::ivec2 size_px) {
  const auto per_second = [](double n) { return benchmark::Counter(n, benchmark::Counter::kIsIterationInvariantRate); };
  state.counters["px"] = per_second(double(size_px.x) * size_px.y);
  state.counters["primitives"] = per_second(double(stats.primitives_in));
  state.counters["fragments"] = per_second(double(stats.fragments_covered));
}

void render_picture(benchmark::State& state, const Picture& picture, int threads) {
  Image image = picture.image();
  RenderOptions options;
  options.threads = threads;
  FrameStats stats;
  for (auto _ : state) stats = render(picture.frame(), image, options);
  report(state, stats, picture.size_px);
}

/// A 1024² target covered once by right triangles of the given side, and again by their mirror images.
void render_grid(benchmark::State& state) {
  const int side_px = int(state.range(0));
  const glm::ivec2 size_px{1024, 1024};
  std::vector<glm::dvec3> corners;
  for (int y = 0; y < size_px.y; y += side_px) {
    for (int x = 0; x < size_px.x; x += side_px) {
      const glm::dvec3 a{x, y, 0.5}, b{x, y + side_px, 0.4}, c{x + side_px, y + side_px, 0.3}, d{x + side_px, y, 0.6};
      for (const glm::dvec3& corner : {a, b, d, b, c, d}) corners.push_back(corner);
    }
  }
  Draw draw;
  draw.vertices = WindowVertices{corners};
  Frame frame;
  frame.draws = {&draw, 1};
  Image image = make_image(size_px, ColorFormat::rgba8);
  RenderOptions options;
  options.threads = int(state.range(1));
  FrameStats stats;
  for (auto _ : state) stats = render(frame, image, options);
  report(state, stats, size_px);
}

void sample(benchmark::State& state, Filter filter, bool linear) {
  const glm::ivec2 size_px{256, 256};
  std::vector<glm::u8vec4> texels;
  for (int i = 0; i < size_px.x * size_px.y; ++i) texels.emplace_back(i & 255, (i >> 3) & 255, (i >> 7) & 255, 255);
  const Texture texture = linear ? make_srgb_texture(size_px, texels, Mips::all) : make_raw_texture(size_px, texels, Mips::all);
  Sampler sampler;
  sampler.filter = filter;
  double u = 0.0;
  for (auto _ : state) {
    u += 0.0137;
    const Footprint footprint{{u, u * 0.31}, {0.011, 0.002}, {0.001, 0.017}};
    if (linear) {
      benchmark::DoNotOptimize(sample_linear(texture, sampler, footprint));
    } else {
      benchmark::DoNotOptimize(sample_raw(texture, sampler, footprint));
    }
  }
}

void blend_bytes(benchmark::State& state, Blend blend) {
  glm::u8vec4 pixel{10, 20, 30, 255};
  std::uint8_t k = 0;
  for (auto _ : state) {
    pixel = blend_rgba8(blend, {std::uint8_t(k / 2), k, std::uint8_t(k / 3), k}, pixel);
    ++k;
  }
  benchmark::DoNotOptimize(pixel);
}

void encode_srgb(benchmark::State& state) {
  float x = 0.0f;
  for (auto _ : state) {
    benchmark::DoNotOptimize(srgb_encode(x));
    x = x > 1.0f ? 0.0f : x + 0.00137f;
  }
}

}  // namespace

int main(int n_arguments, char** arguments) {
  constexpr std::pair<const char*, Filter> kFilters[] = {{"nearest", Filter::nearest}, {"bilinear", Filter::bilinear},
                                                         {"trilinear", Filter::trilinear}, {"anisotropic", Filter::anisotropic}};
  for (const auto& [name, filter] : kFilters) {
    benchmark::RegisterBenchmark((std::string("Sample/raw/") + name).c_str(), sample, filter, false);
    benchmark::RegisterBenchmark((std::string("Sample/linear/") + name).c_str(), sample, filter, true);
  }
  benchmark::RegisterBenchmark("Blend/over", blend_bytes, Blend::over);
  benchmark::RegisterBenchmark("Blend/add", blend_bytes, Blend::add);
  benchmark::RegisterBenchmark("EncodeSrgb", encode_srgb);
  benchmark::RegisterBenchmark("RenderGrid/side_px/threads", render_grid)
      ->ArgsProduct({{4, 16, 64, 1024}, {1, 0}})->Unit(benchmark::kMillisecond)->UseRealTime();
  const std::vector<Picture> pictures = lode::pictures::all_pictures();
  for (const Picture& picture : pictures) {
    benchmark::RegisterBenchmark(("Render/" + picture.name).c_str(),
                                 [&picture](benchmark::State& state) { render_picture(state, picture, 1); })->Unit(benchmark::kMillisecond);
  }
  benchmark::Initialize(&n_arguments, arguments);
  if (benchmark::ReportUnrecognizedArguments(n_arguments, arguments)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}

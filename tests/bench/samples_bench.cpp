// One sample at a time: items are samples, texels filtered or pixels blended.
#include <benchmark/benchmark.h>

#include <string>
#include <vector>

#include "bench.h"
#include "raster/blend.h"
#include "raster/srgb.h"
#include "raster/texture.h"

namespace lode::bench {
namespace {

using namespace raster;

void count_items(benchmark::State& state) { state.SetItemsProcessed(state.iterations()); }

void sample(benchmark::State& state, Filter filter, bool linear) {
  const glm::ivec2 size_px{256, 256};
  std::vector<glm::u8vec4> texels;
  for (int i = 0; i < size_px.x * size_px.y; ++i) texels.emplace_back(i & 255, (i >> 3) & 255, (i >> 7) & 255, 255);
  const Texture texture =
      linear ? make_srgb_texture(size_px, texels, Mips::all) : make_raw_texture(size_px, texels, Mips::all);
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
  count_items(state);
}

void blend_bytes(benchmark::State& state, Blend blend) {
  glm::u8vec4 pixel{10, 20, 30, 255};
  std::uint8_t k = 0;
  for (auto _ : state) {
    pixel = blend_rgba8(blend, {std::uint8_t(k / 2), k, std::uint8_t(k / 3), k}, pixel);
    ++k;
  }
  benchmark::DoNotOptimize(pixel);
  count_items(state);
}

void encode_srgb(benchmark::State& state) {
  float x = 0.0f;
  for (auto _ : state) {
    benchmark::DoNotOptimize(srgb_encode(x));
    x = x > 1.0f ? 0.0f : x + 0.00137f;
  }
  count_items(state);
}

}  // namespace

void register_samples() {
  constexpr std::pair<const char*, Filter> kFilters[] = {{"nearest", Filter::nearest},
                                                         {"bilinear", Filter::bilinear},
                                                         {"trilinear", Filter::trilinear},
                                                         {"anisotropic", Filter::anisotropic}};
  for (const auto& [name, filter] : kFilters) {
    benchmark::RegisterBenchmark((std::string("Sample/raw/") + name).c_str(), sample, filter, false);
    benchmark::RegisterBenchmark((std::string("Sample/linear/") + name).c_str(), sample, filter, true);
  }
  benchmark::RegisterBenchmark("BlendSample/over", blend_bytes, Blend::over);
  benchmark::RegisterBenchmark("BlendSample/add", blend_bytes, Blend::add);
  benchmark::RegisterBenchmark("EncodeSrgb", encode_srgb);
}

}  // namespace lode::bench

/// The texture kernels give the reference pipeline's bytes and counts, on every target that runs here.

#include <gtest/gtest.h>

#include <bit>
#include <span>

#include "raster/blend.h"
#include "raster/reference/shade.h"
#include "textured_cases.h"

namespace lode::raster::fast {
namespace {

using test::HashedNumbers;
using test::TexturedCase;

class TextureKernels : public testing::TestWithParam<Target> {
 protected:
  void SetUp() override {
    kernels_ = find_kernels(GetParam());
    if (!kernels_) GTEST_SKIP() << "this processor lacks the target";
  }
  const Kernels* kernels_ = nullptr;
};

/// Samples of a 4×4 that the triangle covers.
std::uint32_t covered_lanes(const TexturedCase& c, glm::ivec2 first_px) {
  std::uint32_t lanes = 0;
  const auto& shape = std::get<reference::Triangle>(c.piece.shape);
  for_each_covered(shape, {first_px, first_px + 4}, c.sample_fx8, [&](glm::ivec2 px) {
    lanes |= 1u << (4 * (px.y - first_px.y) + (px.x - first_px.x));
  });
  return lanes;
}

/// The reference's bytes at one sample.
std::uint32_t shaded(const TexturedCase& c, glm::ivec2 px, FrameStats& stats) {
  const float depth = 0.0f;
  glm::vec4 rgba;
  reference::shade(c.draw, c.piece, ColorFormat::rgba8, {{&px, 1}, {&depth, 1}, c.sample_fx8}, &rgba, stats);
  return std::bit_cast<std::uint32_t>(store_rgba8(rgba));
}

TEST_P(TextureKernels, ShadeA4x4AsTheReferenceDoes) {
  int n_samples = 0;
  for (std::uint64_t seed = 0; seed < 6000; ++seed) {
    HashedNumbers random(seed);
    TexturedCase c;
    if (!test::make_textured_case(random, c)) continue;
    ASSERT_TRUE(can_texture(c.draw, ColorFormat::rgba8));
    const TexturedTriangle triangle = make_textured(c.draw, c.piece, c.tile_origin_px);
    for (int i = 0; i < 12; ++i) {
      const glm::ivec2 place = {4 * random.between(0, 31), 4 * random.between(0, 31)};
      const glm::ivec2 first_px = c.tile_origin_px + place;
      const std::uint32_t lanes = covered_lanes(c, first_px);
      if (lanes == 0) continue;
      std::array<std::uint32_t, 16> bytes{};
      const std::uint64_t n_read = kernels_->shade_textured(triangle, place.x * 256 + c.sample_fx8.x,
                                                            place.y * 256 + c.sample_fx8.y, lanes, bytes.data());
      FrameStats stats;
      for (int k = 0; k < 16; ++k) {
        if (!(lanes >> k & 1)) continue;
        ++n_samples;
        ASSERT_EQ(bytes[std::size_t(k)], shaded(c, first_px + glm::ivec2(k & 3, k >> 2), stats))
            << "seed " << seed << ", lane " << k << " at " << first_px.x << ", " << first_px.y;
      }
      ASSERT_EQ(n_read, stats.texels_read) << "seed " << seed;
    }
  }
  EXPECT_GT(n_samples, 100000);
}

INSTANTIATE_TEST_SUITE_P(Targets, TextureKernels, testing::Values(Target::sse4, Target::avx2, Target::avx512),
                         [](const auto& info) {
                           return info.param == Target::sse4 ? "sse4" : info.param == Target::avx2 ? "avx2" : "avx512";
                         });

}  // namespace
}  // namespace lode::raster::fast

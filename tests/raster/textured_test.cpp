/// The texture kernels give the reference pipeline's bytes and counts, on every target that runs here.

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

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
  for_each_covered(shape, {first_px, first_px + 4}, c.sample_fx8,
                   [&](glm::ivec2 px) { lanes |= 1u << (4 * (px.y - first_px.y) + (px.x - first_px.x)); });
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
  int n_samples = 0, n_bounded = 0;
  for (std::uint64_t seed = 0; seed < 4000; ++seed) {
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
        if (triangle.bounded) ++n_bounded;
        ASSERT_EQ(bytes[std::size_t(k)], shaded(c, first_px + glm::ivec2(k & 3, k >> 2), stats))
            << "seed " << seed << ", lane " << k << " at " << first_px.x << ", " << first_px.y;
      }
      ASSERT_EQ(n_read, stats.texels_read) << "seed " << seed;
    }
  }
  EXPECT_GT(n_samples, 100000);
  EXPECT_GT(n_bounded, n_samples / 2);  // the others are the reference's own
}

/// A tile with random colours; depths random or, in whole quarters, of nothing yet.
struct Tile {
  explicit Tile(HashedNumbers& random) : rgba8(std::make_unique<Bytes>()), buffers(std::make_unique<TileBuffers>()) {
    for (int k = 0; k < kTilePixels; ++k) {
      rgba8->at[k] = std::uint32_t(random.bits());
      buffers->depth[k] = (k >> 4) % 3 == 0 ? -1.0f : float(random.unit());
    }
  }
  struct Bytes {
    alignas(64) std::uint32_t at[kTilePixels];
  };
  std::unique_ptr<Bytes> rgba8;
  std::unique_ptr<TileBuffers> buffers;
};

/// The same by the reference's functions, sample by sample.
OrderedCounts draw_by_reference(const TexturedCase& c, const OrderedJob& job, std::uint32_t* rgba8) {
  OrderedCounts counts;
  FrameStats stats;
  const glm::ivec2 begin(job.begin_x, job.begin_y), end(job.end_x, job.end_y);
  const auto& shape = std::get<reference::Triangle>(c.piece.shape);
  for_each_covered(shape, {c.tile_origin_px + begin, c.tile_origin_px + end}, c.sample_fx8, [&](glm::ivec2 px) {
    ++counts.covered;
    const glm::ivec2 in_tile = px - c.tile_origin_px;
    const int place = place_in_tile(in_tile.x, in_tile.y);
    const float depth = reference::depth_of(c.piece, reference::sample_position_fx8(px, c.sample_fx8));
    if (job.depth_test && !(depth > job.tile->depth[place])) {
      ++counts.depth_failed;
      return;
    }
    const auto source = std::bit_cast<glm::u8vec4>(shaded(c, px, stats));
    rgba8[place] =
        std::bit_cast<std::uint32_t>(blend_rgba8(job.blend, source, std::bit_cast<glm::u8vec4>(rgba8[place])));
    if (job.blend != Blend::none) ++counts.blended;
  });
  counts.shaded = stats.fragments_shaded;
  counts.texels_read = stats.texels_read;
  return counts;
}

/// Draws both ways into the tile's colours; returns the samples shaded.
std::uint64_t expect_the_reference_tile(const Kernels& kernels, const TexturedCase& c, OrderedJob job, Tile& tile,
                                        const std::string& what) {
  SCOPED_TRACE(what);
  job.tile = tile.buffers.get();
  std::vector<std::uint32_t> expected(tile.rgba8->at, tile.rgba8->at + kTilePixels);
  const OrderedCounts expected_counts = draw_by_reference(c, job, expected.data());
  job.rgba8 = tile.rgba8->at;
  OrderedCounts counts;
  kernels.draw_textured(job, counts);
  const auto differs = std::mismatch(expected.begin(), expected.end(), tile.rgba8->at);
  EXPECT_EQ(differs.first, expected.end()) << "first at place " << differs.first - expected.begin();
  EXPECT_EQ(counts.covered, expected_counts.covered);
  EXPECT_EQ(counts.depth_failed, expected_counts.depth_failed);
  EXPECT_EQ(counts.shaded, expected_counts.shaded);
  EXPECT_EQ(counts.blended, expected_counts.blended);
  EXPECT_EQ(counts.texels_read, expected_counts.texels_read);
  return counts.shaded;
}

/// Whole blocks away from the picture's edges, magnified and minified: the affine kernels' own ground.
TEST_P(TextureKernels, DrawAffineTexturesOverWholeBlocks) {
  HashedNumbers random(7);
  TexturedCase c;
  c.texture = make_raw_texture({1024, 512}, test::random_texels(random, {1024, 512}), Mips::all);
  std::array<int, 3> order;
  c.piece.shape = *reference::make_triangle(
      {{{{-99999, -9999}, 0.5, 2.0}, {{99999, -9999}, 0.5, 2.0}, {{0, 99999}, 0.5, 2.0}}}, order);
  c.piece.n_vertices = 3;
  c.piece.vertices = {0, 1, 2};
  c.draw.texture = &c.texture;
  for (int i = 0; i < 24; ++i) {
    const double angle = i * 0.7, texels_per_px = 0.25 * (1 + i % 6);
    c.uvs.clear();
    for (const reference::WindowVertex& v : std::get<reference::Triangle>(c.piece.shape).v) {
      const double x = v.p_fx8.x / 256.0 * texels_per_px, y = v.p_fx8.y / 256.0 * texels_per_px;
      c.uvs.emplace_back((x * std::cos(angle) - y * std::sin(angle)) / 1024.0 + 0.4,
                         (x * std::sin(angle) + y * std::cos(angle)) / 512.0 + 0.5);
    }
    c.draw.uvs = c.uvs;
    c.draw.sampler.filter = i % 2 == 0 ? Filter::bilinear : Filter::trilinear;
    c.draw.sampler.wrap_u = test::kWraps[i % 3];
    const TexturedTriangle triangle = make_textured(c.draw, c.piece, c.tile_origin_px);
    OrderedJob job;
    job.triangle = &triangle;
    job.end_x = job.end_y = kTile_px;
    job.depth_test = false;
    job.blend = Blend::over;
    Tile tile(random);
    EXPECT_EQ(expect_the_reference_tile(*kernels_, c, job, tile, "picture " + std::to_string(i)), 128u * 128u);
  }
}

TEST_P(TextureKernels, DrawOverATileAsTheReferenceDoes) {
  std::uint64_t n_shaded = 0;
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    HashedNumbers random(seed + 1'000'000);
    TexturedCase c;
    if (!test::make_textured_case(random, c)) continue;
    const TexturedTriangle triangle = make_textured(c.draw, c.piece, c.tile_origin_px);
    Tile tile(random);
    OrderedJob job;
    job.triangle = &triangle;
    if (random.below(2) == 0) {
      job.begin_x = random.between(0, 127), job.begin_y = random.between(0, 127);
      job.end_x = random.between(job.begin_x, 128), job.end_y = random.between(job.begin_y, 128);
    } else {
      job.end_x = job.end_y = kTile_px;
    }
    job.sample_x_fx8 = c.sample_fx8.x, job.sample_y_fx8 = c.sample_fx8.y;
    job.depth_test = random.below(2) == 0;
    job.blend = std::array{Blend::none, Blend::over, Blend::add}[random.below(3)];
    n_shaded += expect_the_reference_tile(*kernels_, c, job, tile, "seed " + std::to_string(seed));
  }
  EXPECT_GT(n_shaded, 100000u);
}

INSTANTIATE_TEST_SUITE_P(Targets, TextureKernels, testing::Values(Target::sse4, Target::avx2, Target::avx512),
                         [](const auto& target) {
                           return target.param == Target::sse4   ? "sse4"
                                  : target.param == Target::avx2 ? "avx2"
                                                                 : "avx512";
                         });

}  // namespace
}  // namespace lode::raster::fast

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include "raster/level_of_detail.h"
#include "raster/sample.h"
#include "raster/texture.h"
#include "texture_cases.h"
#include "texture_filter_oracle.h"

namespace lode::raster {
namespace {

constexpr Filter kLinearFilters[] = {Filter::bilinear, Filter::trilinear, Filter::anisotropic};

float texel_channel(const Texture& texture, const Sampler& sampler, std::size_t level, int x, int y, int c) {
  const TextureLevel& from = texture.levels[level];
  return x < 0 || y < 0 ? sampler.border[c] : from.linear[std::size_t(y * from.size_px.x + x)][c];
}

/// visit(texture, sampler, footprint, plan) for n random cases.
template <class Visit>
void for_each_case(std::uint64_t seed, int n, Visit visit) {
  test::HashedNumbers random(seed);
  for (int t = 0; t < n / 50; ++t) {
    const glm::ivec2 size_px = test::random_size_px(random, 40);
    const Texture texture = make_linear_texture(size_px, test::random_linear_texels(random, size_px), Mips::all);
    for (int i = 0; i < 50 && !testing::Test::HasFatalFailure(); ++i) {
      Sampler sampler = test::random_sampler(random, kLinearFilters[i % 3]);
      sampler.border = glm::vec4(0.1f, 0.7f, 1e-9f, -0.3f);
      const Footprint footprint = test::random_footprint(random, size_px);
      visit(texture, sampler, footprint, test::fast_plan(texture, sampler, footprint));
    }
  }
}

// 0.501 ULP: the float's ½, and up to 128 roundings in double of sums of one sign, 2^-46 of the value.
TEST(SampleLinear, IsWithinHalfAnUlpOfTheRationalMean) {
  for_each_case(1, 2000,
                [](const Texture& texture, const Sampler& sampler, const Footprint& footprint, const test::Plan& plan) {
                  const glm::vec4 found = sample_linear(texture, sampler, footprint);
                  mpq_class sum[4];
                  test::for_each_texel<test::Int128>(
                      texture, sampler, footprint.uv, plan, [&](std::size_t level, int x, int y, int weight) {
                        for (int c = 0; c < 4; ++c)
                          sum[c] += mpq_class(texel_channel(texture, sampler, level, x, y, c)) * weight;
                      });
                  for (int c = 0; c < 4; ++c) {
                    const mpq_class exact = sum[c] / (plan.n * (1 << 24));
                    const double ulp = std::nextafter(std::abs(found[c]), 2.0f) - std::abs(found[c]);
                    ASSERT_LE(abs(mpq_class(found[c]) - exact), mpq_class(0.501 * ulp)) << found[c];
                  }
                });
}

TEST(SampleLinear, SumsInTheWrittenOrder) {
  for_each_case(2, 10'000,
                [](const Texture& texture, const Sampler& sampler, const Footprint& footprint, const test::Plan& plan) {
                  ASSERT_EQ(sample_linear(texture, sampler, footprint),
                            test::filtered_linear(texture, sampler, footprint.uv, plan));
                });
}

TEST(SampleLinear, NeverLeavesTheRangeOfItsTexels) {
  test::HashedNumbers random(3);
  for (int t = 0; t < 100; ++t) {
    // Two neighbouring floats: a sum that drifts by one part in 2^24 leaves the range.
    const float low = static_cast<float>(random.unit() - 0.5), high = std::nextafter(low, 1.0f);
    const glm::ivec2 size_px = test::random_size_px(random, 40);
    std::vector<glm::vec4> texels(std::size_t(size_px.x * size_px.y));
    for (glm::vec4& texel : texels) texel = glm::vec4(random.below(2) == 0 ? low : high);
    const Texture texture = make_linear_texture(size_px, texels, Mips::all);
    for (int i = 0; i < 100; ++i) {
      Sampler sampler = test::random_sampler(random, kLinearFilters[i % 3]);
      sampler.border = glm::vec4(high);
      const float found = sample_linear(texture, sampler, test::random_footprint(random, size_px)).r;
      ASSERT_TRUE(found == low || found == high) << found;
    }
  }
}

TEST(SampleLinear, ATexelWithoutWeightAddsNothingEvenIfInfinite) {
  const float inf = std::numeric_limits<float>::infinity();
  const std::vector<glm::vec4> texels{glm::vec4(0.25f), glm::vec4(inf)};
  const Texture texture = make_linear_texture({2, 1}, texels, Mips::none);
  EXPECT_EQ(sample_linear(texture, {}, {.uv = {0.25, 0.5}}), glm::vec4(0.25f));
  EXPECT_EQ(sample_linear(texture, {}, {.uv = {0.3, 0.5}}), glm::vec4(inf));
}

TEST(SampleLinear, ManyAtOnceReadNoTexelWithoutWeight) {
  const float inf = std::numeric_limits<float>::infinity();
  const std::vector<glm::vec4> texels{glm::vec4(0.25f), glm::vec4(inf), glm::vec4(0.25f), glm::vec4(inf)};
  const Texture texture = make_linear_texture({2, 2}, texels, Mips::none);
  SampleBatch batch;
  batch.wanted = 3;
  batch.u[0] = batch.v[0] = 0.25;          // the first texel's centre
  batch.u[1] = 0.25, batch.v[1] = 0.5;     // between two
  std::array<glm::vec4, kMaxSampleBatch> found;
  for (const Target target : {Target::scalar, Target::sse4, Target::avx2, Target::avx512}) {
    if (!can_run(target)) continue;
    sample_linear(texture, {}, batch, target, found);
    EXPECT_EQ(found[0], glm::vec4(0.25f)) << name_of(target);
    EXPECT_EQ(found[1], glm::vec4(0.25f)) << name_of(target);
  }
}

TEST(SampleLinear, ResultsHaveOneNanAndOneZero) {
  const std::vector<glm::vec4> texels{{std::bit_cast<float>(0xFFC00001u), -0.0f, 1.0f, 1.0f},
                                      {1.0f, -0.0f, -1.0f, -0.0f}};
  const Texture texture = make_linear_texture({2, 1}, texels, Mips::all);
  for (const Filter filter : {Filter::nearest, Filter::bilinear, Filter::trilinear, Filter::anisotropic}) {
    const glm::vec4 found =
        sample_linear(texture, {.filter = filter}, {.uv = {0.4, 0.5}, .duv_dx = {0.6, 0.0}, .duv_dy = {0.0, 0.9}});
    EXPECT_EQ(std::bit_cast<std::uint32_t>(found.r), 0x7FC00000u);
    EXPECT_EQ(std::bit_cast<std::uint32_t>(found.g), 0u);
  }
  EXPECT_EQ(std::bit_cast<std::uint32_t>(sample_linear(texture, {}, {.uv = {0.5, 0.5}}).b), 0u);  // 1 − 1
  const Sampler border{.filter = Filter::nearest, .wrap_u = Wrap::border, .border = glm::vec4(-0.0f)};
  EXPECT_EQ(std::bit_cast<std::uint32_t>(sample_linear(texture, border, {.uv = {2.0, 0.5}}).r), 0u);
}

TEST(SampleLinear, ManyAtOnceHaveTheBitsOfEach) {
  test::HashedNumbers random(5);
  for (int t = 0; t < 200; ++t) {
    const glm::ivec2 size_px = test::random_size_px(random, 40);
    const Texture texture = make_linear_texture(size_px, test::random_linear_texels(random, size_px), Mips::all);
    Sampler sampler = test::random_sampler(random, kLinearFilters[t % 2]);
    sampler.border = glm::vec4(0.1f, 0.7f, 1e-9f, -0.3f);
    SampleBatch batch;
    batch.rho_squared = std::exp2(12.0 * random.unit() - 4.0);
    batch.wanted = random.below(0x10000);
    for (std::size_t k = 0; k < kMaxSampleBatch; ++k) {
      const Footprint footprint = test::random_footprint(random, size_px);
      batch.u[k] = footprint.uv.x, batch.v[k] = footprint.uv.y;
    }
    for (const Target target : {Target::best, Target::scalar, Target::sse4, Target::avx2, Target::avx512}) {
      if (!can_run(target)) continue;
      std::array<glm::vec4, kMaxSampleBatch> texels;
      sample_linear(texture, sampler, batch, target, texels);
      for (std::size_t k = 0; k < kMaxSampleBatch; ++k) {
        if (!(batch.wanted >> k & 1)) continue;
        const glm::vec4 one =
            sample_linear(texture, sampler, {batch.u[k], batch.v[k]}, lambda_fx8(batch.rho_squared), nullptr);
        ASSERT_EQ(texels[k], one) << name_of(target) << ", " << t << ", " << k;
      }
    }
  }
}

}  // namespace
}  // namespace lode::raster

#include <gtest/gtest.h>

#include <cmath>

#include "raster/texture.h"
#include "texture_cases.h"
#include "texture_filter_oracle.h"

namespace lode::raster {
namespace {

constexpr Filter kFilters[] = {Filter::nearest, Filter::bilinear, Filter::trilinear, Filter::anisotropic};

Texture grey_texture(glm::ivec2 size_px, std::vector<int> greys, Mips mips) {
  std::vector<glm::u8vec4> texels;
  for (const int grey : greys) texels.emplace_back(grey, grey, grey, 255);
  return make_raw_texture(size_px, texels, mips);
}

int grey_at(const Texture& texture, const Sampler& sampler, const Footprint& footprint) {
  return sample_raw(texture, sampler, footprint).r;
}

// Texels 0 and 255, centres at u = ¼ and ¾. Half way: 127½, rounded up. An eighth after the first centre: 63¾.
TEST(Bilinear, BlendsTheTwoNearestCentresWithOneRoundingHalfUp) {
  const Texture texture = grey_texture({2, 1}, {0, 255}, Mips::none);
  const Sampler clamp{.filter = Filter::bilinear, .wrap_u = Wrap::clamp, .wrap_v = Wrap::clamp};
  EXPECT_EQ(grey_at(texture, clamp, {.uv = {0.25, 0.5}}), 0);
  EXPECT_EQ(grey_at(texture, clamp, {.uv = {0.5, 0.5}}), 128);
  EXPECT_EQ(grey_at(texture, clamp, {.uv = {0.375, 0.5}}), 64);
  EXPECT_EQ(grey_at(texture, clamp, {.uv = {0.75, 0.5}}), 255);
  EXPECT_EQ(grey_at(texture, clamp, {.uv = {0.0, 0.5}}), 0);
}

TEST(Bilinear, BeyondThePictureIsWhatTheWrapModeSays) {
  const Texture texture = grey_texture({2, 1}, {0, 200}, Mips::none);
  const auto at_zero = [&](Wrap wrap) {
    const Sampler sampler{.wrap_u = wrap, .wrap_v = Wrap::clamp, .border = glm::vec4(100.0f)};
    return grey_at(texture, sampler, {.uv = {0.0, 0.5}});  // half of texel 0, half of its left neighbour
  };
  EXPECT_EQ(at_zero(Wrap::repeat), 100);
  EXPECT_EQ(at_zero(Wrap::mirror), 0);
  EXPECT_EQ(at_zero(Wrap::clamp), 0);
  EXPECT_EQ(at_zero(Wrap::border), 50);
}

// Level 0 is 0 0 100 100 (mean 50), level 1 is 0 100, level 2 is 50; u = ⅛ is level 0's first centre. λ = log2(2^¾).
TEST(Trilinear, BlendsTwoLevelsByTheFractionOfTheirLogarithm) {
  const Texture texture = grey_texture({4, 1}, {0, 0, 100, 100}, Mips::all);
  const Sampler sampler{.filter = Filter::trilinear, .wrap_u = Wrap::clamp, .wrap_v = Wrap::clamp};
  const auto at_lambda = [&](double lambda) {
    return grey_at(texture, sampler, {.uv = {0.125, 0.5}, .duv_dx = {std::exp2(lambda) / 4.0, 0.0}});
  };
  EXPECT_EQ(at_lambda(-3.0), 0);
  EXPECT_EQ(at_lambda(1.0), 0);
  EXPECT_EQ(at_lambda(1.5), 25);
  EXPECT_EQ(at_lambda(1.75), 38);  // 37½
  EXPECT_EQ(at_lambda(2.0), 50);
  EXPECT_EQ(at_lambda(9.0), 50);
}

// Twelve texels, white (200) from 6 on. ∂x is 4 texels long, ∂y 1: four probes at λ = 0, at −1.2, −0.4, 0.4 and 1.2
// texels from the sample. Around texel 6.0 they stand at 4.8, 5.6, 6.4 and 7.2, where bilinear has 0, 0.1, 0.9 and 1 of
// white: a half. Around 4.0 the last one stands at 5.2, left of the centre 5.5 where white begins to count.
TEST(Anisotropic, AveragesProbesAlongTheLongerDerivative) {
  const Texture texture = grey_texture({12, 1}, {0, 0, 0, 0, 0, 0, 200, 200, 200, 200, 200, 200}, Mips::all);
  const Sampler sampler{
      .filter = Filter::anisotropic, .wrap_u = Wrap::clamp, .wrap_v = Wrap::clamp, .max_anisotropy = 16};
  std::uint64_t texels_read = 0;
  const Footprint centre{.uv = {0.5, 0.5}, .duv_dx = {4.0 / 12.0, 0.0}, .duv_dy = {0.0, 1.0}};
  EXPECT_EQ(int{sample_raw(texture, sampler, centre, &texels_read).r}, 100);
  EXPECT_EQ(texels_read, 16u);
  const Footprint left{.uv = {4.0 / 12.0, 0.5}, .duv_dx = {4.0 / 12.0, 0.0}, .duv_dy = {0.0, 1.0}};
  EXPECT_EQ(grey_at(texture, sampler, left), 0);
}

TEST(Sampling, EqualsTheRationalOracle) {
  test::HashedNumbers random(1);
  for (int t = 0; t < 150; ++t) {
    const glm::ivec2 size_px = test::random_size_px(random, 40);
    const Mips mips = random.below(8) == 0 ? Mips::none : Mips::all;
    const Texture texture = make_raw_texture(size_px, test::random_texels(random, size_px), mips);
    for (int i = 0; i < 100; ++i) {
      const Sampler sampler = test::random_sampler(random, kFilters[i % 4]);
      const Footprint footprint = test::random_footprint(random, size_px);
      const glm::u8vec4 expected = sampler.filter == Filter::nearest
                                       ? test::nearest_raw<test::Int128>(texture, sampler, footprint.uv)
                                       : test::filtered_raw<test::Int128>(texture, sampler, footprint.uv,
                                                                          test::fast_plan(texture, sampler, footprint));
      ASSERT_EQ(sample_raw(texture, sampler, footprint), expected) << "texture " << t << " case " << i;
    }
  }
}

TEST(Sampling, EqualsTheGmpOracle) {
  test::HashedNumbers random(2);
  for (int t = 0; t < 20; ++t) {
    const glm::ivec2 size_px = test::random_size_px(random, 40);
    const Texture texture = make_raw_texture(size_px, test::random_texels(random, size_px), Mips::all);
    for (int i = 0; i < 60; ++i) {
      const Sampler sampler = test::random_sampler(random, kFilters[1 + i % 3]);
      const Footprint footprint = test::random_footprint(random, size_px);
      const test::Plan plan = test::exact_plan(texture, sampler, footprint);
      ASSERT_EQ(sample_raw(texture, sampler, footprint),
                test::filtered_raw<mpz_class>(texture, sampler, footprint.uv, plan))
          << "texture " << t << " case " << i;
    }
  }
}

TEST(Sampling, TheWidestTextureReadsEachOfItsTexels) {
  std::vector<glm::u8vec4> texels;
  for (int x = 0; x < 16384; ++x) texels.emplace_back(x & 255, x >> 8, 7, 255);
  const Texture texture = make_raw_texture({16384, 1}, texels, Mips::all);
  for (int x = 0; x < 16384; x += 61) {
    const Footprint centre{.uv = {(x + 0.5) / 16384.0 - 3.0, 0.5}};
    EXPECT_EQ(sample_raw(texture, {.filter = Filter::nearest}, centre), texels[std::size_t(x)]);
    EXPECT_EQ(sample_raw(texture, {.filter = Filter::bilinear}, centre), texels[std::size_t(x)]);
  }
}

TEST(Sampling, LevelZeroHasTheSameBytesUnderBilinearAndTrilinear) {
  test::HashedNumbers random(3);
  const Texture texture = make_raw_texture({13, 9}, test::random_texels(random, {13, 9}), Mips::all);
  for (int i = 0; i < 1000; ++i) {
    Footprint footprint = test::random_footprint(random, {13, 9});
    footprint.duv_dx = {0.01, 0.02};
    footprint.duv_dy = {-0.03, 0.04};
    const glm::u8vec4 bilinear = sample_raw(texture, {.filter = Filter::bilinear}, footprint);
    ASSERT_EQ(sample_raw(texture, {.filter = Filter::trilinear}, footprint), bilinear);
  }
}

TEST(Sampling, MissingMipsReadLevelZero) {
  const Texture texture = grey_texture({4, 1}, {10, 20, 30, 40}, Mips::none);
  for (const Filter filter : {Filter::bilinear, Filter::trilinear}) {
    EXPECT_EQ(grey_at(texture, {.filter = filter}, {.uv = {0.375, 0.5}, .duv_dx = {8.0, 0.0}, .duv_dy = {0.0, 8.0}}),
              20);
  }
}

TEST(Sampling, CountsTheTexelsItFetches) {
  const Texture texture = grey_texture({4, 4}, std::vector<int>(16, 9), Mips::all);
  const auto count = [&](Filter filter, double x_px, double y_px) {
    std::uint64_t texels_read = 1000;
    (void)sample_raw(texture, {.filter = filter, .wrap_u = Wrap::border},
                     {.uv = {-1.0, 0.5}, .duv_dx = {x_px / 4.0, 0.0}, .duv_dy = {0.0, y_px / 4.0}}, &texels_read);
    return texels_read - 1000;
  };
  EXPECT_EQ(count(Filter::nearest, 3.0, 1.0), 1u);
  EXPECT_EQ(count(Filter::bilinear, 3.0, 1.0), 4u);
  EXPECT_EQ(count(Filter::trilinear, 3.0, 1.0), 8u);
  EXPECT_EQ(count(Filter::trilinear, 2.0, 1.0), 4u);  // λ = 1, one level
  EXPECT_EQ(count(Filter::trilinear, 99.0, 1.0), 4u);
  EXPECT_EQ(count(Filter::anisotropic, 3.0, 1.0), 12u);  // three probes at λ = 0
  EXPECT_EQ(count(Filter::anisotropic, 4.5, 1.5), 24u);  // three probes at λ = log2 1.5
}

}  // namespace
}  // namespace lode::raster

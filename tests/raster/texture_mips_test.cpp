#include "raster/texture_mips.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "texture_cases.h"

namespace lode::raster {
namespace {

/// Length that [j, j + 1] and [i·s/d, (i + 1)·s/d] have in common.
mpq_class overlap(int i, int j, int s, int d) {
  const mpq_class begin = std::max(mpq_class(i * s, d), mpq_class(j)),
                  end = std::min(mpq_class((i + 1) * s, d), mpq_class(j + 1));
  return end > begin ? mpq_class(end - begin) : mpq_class(0);
}

/// The mean over texel (x, y) of the smaller level, from all texels of the larger one; `at(index)` is a channel.
template <class At>
mpq_class box_mean(glm::ivec2 from_px, glm::ivec2 to_px, int x, int y, At at) {
  mpq_class sum = 0;
  for (int j = 0; j < from_px.y; ++j) {
    const mpq_class height = overlap(y, j, from_px.y, to_px.y);
    if (height == 0) continue;
    for (int i = 0; i < from_px.x; ++i) {
      const mpq_class width = overlap(x, i, from_px.x, to_px.x);
      if (width != 0) sum += width * height * mpq_class(at(std::size_t(j * from_px.x + i)));
    }
  }
  return sum / (mpq_class(from_px.x, to_px.x) * mpq_class(from_px.y, to_px.y));
}

int rounded_half_up(const mpq_class& value) {
  mpz_class floor;
  const mpz_class numerator = value.get_num() * 2 + value.get_den(), denominator = value.get_den() * 2;
  mpz_fdiv_q(floor.get_mpz_t(), numerator.get_mpz_t(), denominator.get_mpz_t());
  return static_cast<int>(floor.get_si());
}

constexpr glm::ivec2 kSizes[] = {{1, 1}, {2, 2}, {3, 7}, {7, 3},  {1, 9},   {9, 1},
                                 {2, 5}, {5, 5}, {6, 1}, {15, 4}, {13, 11}, {32, 17}};

TEST(Mips, LevelsHalveDownToOneTexel) {
  const auto sizes = [](glm::ivec2 size_px, Mips mips) {
    const std::vector<glm::u8vec4> texels(std::size_t(size_px.x * size_px.y));
    std::vector<glm::ivec2> result;
    for (const TextureLevel& level : make_raw_texture(size_px, texels, mips).levels) result.push_back(level.size_px);
    return result;
  };
  EXPECT_EQ(sizes({7, 3}, Mips::all), (std::vector<glm::ivec2>{{7, 3}, {3, 1}, {1, 1}}));
  EXPECT_EQ(sizes({1, 5}, Mips::all), (std::vector<glm::ivec2>{{1, 5}, {1, 2}, {1, 1}}));
  EXPECT_EQ(sizes({1, 1}, Mips::all), (std::vector<glm::ivec2>{{1, 1}}));
  EXPECT_EQ(sizes({7, 3}, Mips::none), (std::vector<glm::ivec2>{{7, 3}}));
  EXPECT_EQ(sizes({16384, 1}, Mips::all).size(), 15u);
}

// Four texels 0 0 0 1: ¼, 0. 0 0 1 1: ½, 1 (half to even would be 0). 0 1 1 1: ¾, 1. 254 255 254 255: 254½, 255.
TEST(Mips, BytesRoundHalfUp) {
  const std::vector<glm::u8vec4> texels{{0, 0, 0, 254}, {0, 0, 1, 255}, {0, 1, 1, 254}, {1, 1, 1, 255}};
  const TextureLevel base{.size_px = {2, 2}, .raw = texels, .linear = {}};
  EXPECT_EQ(next_level(base, TextureFormat::raw).raw, (std::vector<glm::u8vec4>{{0, 1, 1, 255}}));
}

// Three texels under one: a third of each. Five under two: 1, 1, ½ and ½, 1, 1, of 2½.
TEST(Mips, OddSizesLoseNothingAtTheirEdges) {
  const TextureLevel three{.size_px = {3, 1}, .raw = {glm::u8vec4(30), glm::u8vec4(60), glm::u8vec4(91)}, .linear = {}};
  EXPECT_EQ(next_level(three, TextureFormat::raw).raw[0].r, 60);  // 181/3 = 60⅓
  const TextureLevel five{
      .size_px = {1, 5},
      .raw = {glm::u8vec4(0), glm::u8vec4(50), glm::u8vec4(100), glm::u8vec4(200), glm::u8vec4(250)},
      .linear = {}};
  const TextureLevel two = next_level(five, TextureFormat::raw);
  EXPECT_EQ(two.raw[0].r, 40);   // (0 + 50 + 50)/2½
  EXPECT_EQ(two.raw[1].r, 200);  // (50 + 200 + 250)/2½
}

TEST(Mips, BytesEqualTheRationalMeanOfTheStoredLevelRoundedHalfUp) {
  test::HashedNumbers random(1);
  for (const glm::ivec2& size_px : kSizes) {
    const Texture texture = make_raw_texture(size_px, test::random_texels(random, size_px), Mips::all);
    for (std::size_t k = 1; k < texture.levels.size(); ++k) {
      const TextureLevel &from = texture.levels[k - 1], &to = texture.levels[k];
      for (int p = 0; p < to.size_px.x * to.size_px.y; ++p) {
        for (int c = 0; c < 4; ++c) {
          const mpq_class mean = box_mean(from.size_px, to.size_px, p % to.size_px.x, p / to.size_px.x,
                                          [&](std::size_t i) { return int{from.raw[i][c]}; });
          ASSERT_EQ(int{to.raw[std::size_t(p)][c]}, rounded_half_up(mean))
              << size_px.x << "x" << size_px.y << " level " << k;
        }
      }
    }
  }
}

// 0.501 ULP: the float's ½, and up to 10 roundings in double of sums of one sign, 10 · 2^-53 of the value.
TEST(Mips, FloatsAreWithinHalfAnUlpOfTheRationalMean) {
  test::HashedNumbers random(2);
  for (const glm::ivec2& size_px : kSizes) {
    const Texture texture = make_linear_texture(size_px, test::random_linear_texels(random, size_px), Mips::all);
    for (std::size_t k = 1; k < texture.levels.size(); ++k) {
      const TextureLevel &from = texture.levels[k - 1], &to = texture.levels[k];
      for (int p = 0; p < to.size_px.x * to.size_px.y; ++p) {
        const mpq_class mean = box_mean(from.size_px, to.size_px, p % to.size_px.x, p / to.size_px.x,
                                        [&](std::size_t i) { return from.linear[i][p % 4]; });
        const float found = to.linear[std::size_t(p)][p % 4];
        const double ulp = std::nextafter(std::abs(found), 2.0f) - std::abs(found);
        ASSERT_LE(abs(mpq_class(found) - mean), mpq_class(0.501 * ulp)) << size_px.x << "x" << size_px.y;
      }
    }
  }
}

TEST(Mips, AConstantStaysConstantDownToOneTexel) {
  test::HashedNumbers random(3);
  for (const glm::ivec2& size_px :
       {glm::ivec2(16384, 1), glm::ivec2(1, 12345), glm::ivec2(127, 63), glm::ivec2(3, 7)}) {
    const auto n = std::size_t(size_px.x * size_px.y);
    const glm::u8vec4 bytes(17, 200, 254, 255);
    for (const TextureLevel& level : make_raw_texture(size_px, std::vector(n, bytes), Mips::all).levels) {
      for (const glm::u8vec4& t : level.raw) ASSERT_EQ(t, bytes);
    }
    const glm::vec4 floats(static_cast<float>(random.unit()), -1.0f / 3.0f, 16777215.0f, 3e38f);
    for (const TextureLevel& level : make_linear_texture(size_px, std::vector(n, floats), Mips::all).levels) {
      for (const glm::vec4& t : level.linear) ASSERT_EQ(t, floats);
    }
  }
}

TEST(Mips, NoTexelLeavesTheRangeOfThoseBeneathIt) {
  test::HashedNumbers random(4);
  for (int round = 0; round < 50; ++round) {
    // Two neighbouring floats: a sum that drifts by one part in 2^24 leaves the range.
    const float low = static_cast<float>(random.unit() - 0.5), high = std::nextafter(low, 1.0f);
    const glm::ivec2 size_px = test::random_size_px(random, 60);
    std::vector<glm::vec4> texels(std::size_t(size_px.x * size_px.y));
    for (glm::vec4& t : texels) t = glm::vec4(random.below(2) == 0 ? low : high);
    for (const TextureLevel& level : make_linear_texture(size_px, texels, Mips::all).levels) {
      for (const glm::vec4& t : level.linear) ASSERT_TRUE(t.r == low || t.r == high);
    }
  }
}

TEST(Mips, NanSpreadsAsOneBitPatternAndZeroIsPositive) {
  const float nan = std::bit_cast<float>(0xFFC00001u);
  const std::vector<glm::vec4> texels{{nan, -0.0f, 1.0f, -1.0f}, {1.0f, -0.0f, 1.0f, 1.0f}};
  const Texture texture = make_linear_texture({2, 1}, texels, Mips::all);
  for (const TextureLevel& level : texture.levels) {
    EXPECT_EQ(std::bit_cast<std::uint32_t>(level.linear[0].r), 0x7FC00000u);
    EXPECT_EQ(std::bit_cast<std::uint32_t>(level.linear[0].g), 0u);
  }
  EXPECT_EQ(std::bit_cast<std::uint32_t>(texture.levels[1].linear[0].a), 0u);
}

}  // namespace
}  // namespace lode::raster

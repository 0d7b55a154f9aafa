#include <gtest/gtest.h>

#include "raster/level_of_detail.h"
#include "raster/texture.h"
#include "stress_count.h"
#include "texture_cases.h"
#include "texture_filter_oracle.h"

namespace lode::raster {
namespace {

using test::stress_count;

constexpr std::uint64_t kCasesPerTexture = 1000;

/// Wrong results among n random look-ups with one filter; the first one is named.
template <class Integer>
std::uint64_t wrong_samples(std::uint64_t seed, std::uint64_t n, Filter filter) {
  test::HashedNumbers random(seed);
  std::uint64_t wrong = 0;
  for (std::uint64_t done = 0; done < n; done += kCasesPerTexture) {
    const glm::ivec2 size_px = test::random_size_px(random, 100);
    const Texture texture = make_raw_texture(size_px, test::random_texels(random, size_px), Mips::all);
    for (std::uint64_t i = 0; i < kCasesPerTexture; ++i) {
      const Sampler sampler = test::random_sampler(random, filter);
      const Footprint footprint = test::random_footprint(random, size_px);
      const glm::u8vec4 expected = filter == Filter::nearest
                                       ? test::nearest_raw<Integer>(texture, sampler, footprint.uv)
                                       : test::filtered_raw<Integer>(texture, sampler, footprint.uv,
                                                                     test::fast_plan(texture, sampler, footprint));
      if (sample_raw(texture, sampler, footprint) == expected) continue;
      EXPECT_GT(wrong++, 0u) << "first wrong: case " << done + i << " of seed " << seed << ", uv " << footprint.uv.x
                             << " " << footprint.uv.y << ", texture " << size_px.x << "x" << size_px.y;
    }
  }
  return wrong;
}

TEST(TextureStress, NearestEqualsTheRationalOracle) {
  const auto n = stress_count("nearest look-ups", 10'000'000, 10'000'000'000);
  EXPECT_EQ(wrong_samples<test::Int128>(1, n, Filter::nearest), 0u);
}

TEST(TextureStress, BilinearEqualsTheRationalOracle) {
  const auto n = stress_count("bilinear look-ups", 10'000'000, 10'000'000'000);
  EXPECT_EQ(wrong_samples<test::Int128>(2, n, Filter::bilinear), 0u);
}

TEST(TextureStress, TrilinearEqualsTheRationalOracle) {
  const auto n = stress_count("trilinear look-ups", 10'000'000, 10'000'000'000);
  EXPECT_EQ(wrong_samples<test::Int128>(3, n, Filter::trilinear), 0u);
}

TEST(TextureStress, AnisotropicEqualsTheRationalOracle) {
  const auto n = stress_count("anisotropic look-ups of up to 16 probes", 1'000'000, 1'000'000'000);
  EXPECT_EQ(wrong_samples<test::Int128>(4, n, Filter::anisotropic), 0u);
}

TEST(TextureStress, EveryFilterEqualsTheGmpOracle) {
  const auto n = stress_count("look-ups per filter in GMP", 100'000, 10'000'000);
  EXPECT_EQ(wrong_samples<mpz_class>(5, n, Filter::nearest), 0u);
  EXPECT_EQ(wrong_samples<mpz_class>(6, n, Filter::bilinear), 0u);
  EXPECT_EQ(wrong_samples<mpz_class>(7, n, Filter::trilinear), 0u);
  EXPECT_EQ(wrong_samples<mpz_class>(8, n / 10, Filter::anisotropic), 0u);
}

TEST(TextureStress, LinearTexturesSumInTheWrittenOrder) {
  const auto n = stress_count("look-ups in linear textures", 1'000'000, 1'000'000'000);
  test::HashedNumbers random(11);
  std::uint64_t wrong = 0;
  for (std::uint64_t done = 0; done < n; done += kCasesPerTexture) {
    const glm::ivec2 size_px = test::random_size_px(random, 100);
    const Texture texture = make_linear_texture(size_px, test::random_linear_texels(random, size_px), Mips::all);
    for (std::uint64_t i = 0; i < kCasesPerTexture; ++i) {
      const Sampler sampler = test::random_sampler(random, i % 4 == 0 ? Filter::anisotropic : Filter::trilinear);
      const Footprint footprint = test::random_footprint(random, size_px);
      const test::Plan plan = test::fast_plan(texture, sampler, footprint);
      wrong +=
          sample_linear(texture, sampler, footprint) != test::filtered_linear(texture, sampler, footprint.uv, plan);
    }
  }
  EXPECT_EQ(wrong, 0u);
}

TEST(TextureStress, LevelOfDetailEqualsMpfr) {
  const auto n = stress_count("levels of detail", 10'000'000, 10'000'000'000);
  test::HashedNumbers random(9);
  std::uint64_t wrong = 0;
  for (std::uint64_t i = 0; i < n; ++i) {
    const double rho_squared = random.of_magnitude(-1022, 1023);
    const double steps = 128.0 * std::log2(rho_squared);
    const bool close = !(std::abs(steps - std::floor(steps) - 0.5) > 1e-6);
    wrong += lambda_fx8(rho_squared) != (close ? test::exact_lambda_fx8(mpq_class(rho_squared)) : std::lround(steps));
  }
  EXPECT_EQ(wrong, 0u);
}

// 1 GiB of texels, 1.4 GiB with mips. Texel (x, y) has four bytes of a hash of its place.
TEST(TextureStress, TheLargestTextureIsExactToItsLastTexel) {
  constexpr int kSide_px = kMaxTextureSize_px;
  Texture texture;
  {
    std::vector<glm::u8vec4> texels(std::size_t{kSide_px} * kSide_px);
    for (std::size_t i = 0; i < texels.size(); ++i) {
      const std::uint64_t hash = (i + 1) * 0x9E37'79B9'7F4A'7C15ull;
      texels[i] = glm::u8vec4(hash >> 56, hash >> 48, hash >> 40, 255);
    }
    texture = make_raw_texture({kSide_px, kSide_px}, texels, Mips::all);
  }
  ASSERT_EQ(texture.levels.size(), 15u);
  const auto n = stress_count("look-ups in 16384 x 16384 texels", 400'000, 400'000'000);
  test::HashedNumbers random(10);
  std::uint64_t wrong = 0;
  for (std::uint64_t i = 0; i < n; ++i) {
    const Sampler sampler = test::random_sampler(random, i % 2 == 0 ? Filter::trilinear : Filter::bilinear);
    const Footprint footprint = test::random_footprint(random, {kSide_px, kSide_px});
    const test::Plan plan = test::fast_plan(texture, sampler, footprint);
    wrong += sample_raw(texture, sampler, footprint) !=
             test::filtered_raw<test::Int128>(texture, sampler, footprint.uv, plan);
  }
  EXPECT_EQ(wrong, 0u);
}

}  // namespace
}  // namespace lode::raster

#include <gtest/gtest.h>

#include <limits>

#include "raster/texture.h"
#include "texture_cases.h"

namespace lode::raster {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr Filter kFilters[] = {Filter::nearest, Filter::bilinear, Filter::trilinear, Filter::anisotropic};

TEST(Sampling, AConstantStaysConstantUnderEveryFilter) {
  test::HashedNumbers random(4);
  for (int t = 0; t < 60; ++t) {
    const glm::ivec2 size_px = test::random_size_px(random, 60);
    const auto n = std::size_t(size_px.x * size_px.y);
    const glm::u8vec4 bytes = test::random_texels(random, {1, 1})[0] | glm::u8vec4(0, 0, 0, 255);
    const glm::vec4 floats(static_cast<float>(random.unit()), -1.0f / 3.0f, 3e38f, 1e-42f);
    const Texture raw = make_raw_texture(size_px, std::vector(n, bytes), Mips::all);
    const Texture linear = make_linear_texture(size_px, std::vector(n, floats), Mips::all);
    for (int i = 0; i < 60; ++i) {
      Sampler sampler = test::random_sampler(random, kFilters[i % 4]);
      const Footprint footprint = test::random_footprint(random, size_px);
      sampler.border = bytes;
      ASSERT_EQ(sample_raw(raw, sampler, footprint), bytes);
      sampler.border = floats;
      ASSERT_EQ(sample_linear(linear, sampler, footprint), floats);
    }
  }
}

TEST(Sampling, CoordinatesThatAreNotFiniteReadAsZero) {
  test::HashedNumbers random(5);
  const Texture texture = make_raw_texture({3, 7}, test::random_texels(random, {3, 7}), Mips::all);
  for (const Filter filter : kFilters) {
    for (const Wrap wrap : test::kWraps) {
      const Sampler sampler{.filter = filter, .wrap_u = wrap, .wrap_v = wrap, .border = glm::vec4(77.0f)};
      const auto at = [&](double u, double v) { return sample_raw(texture, sampler, {.uv = {u, v}}); };
      for (const double bad : {kNan, kInf, -kInf}) {
        EXPECT_EQ(at(bad, 0.3), at(0.0, 0.3));
        EXPECT_EQ(at(0.3, bad), at(0.3, 0.0));
      }
    }
  }
}

TEST(Sampling, AnyDerivativeHasADefinedResult) {
  test::HashedNumbers random(6);
  const Texture texture = make_raw_texture({3, 7}, test::random_texels(random, {3, 7}), Mips::all);
  const glm::u8vec4 smallest = texture.levels.back().raw[0];
  const Sampler trilinear{.filter = Filter::trilinear}, anisotropic{.filter = Filter::anisotropic};
  const auto footprint = [](double x, double y) {
    return Footprint{.uv = {0.4, 0.3}, .duv_dx = {x, 0.0}, .duv_dy = {0.0, y}};
  };
  const glm::u8vec4 sharp = sample_raw(texture, {.filter = Filter::bilinear}, footprint(0.0, 0.0));
  for (const Sampler& sampler : {trilinear, anisotropic}) {
    for (const double none : {0.0, -0.0, kNan, 1e-200, 0x1p-1074})
      EXPECT_EQ(sample_raw(texture, sampler, footprint(none, none)), sharp);
    for (const double most : {kInf, -kInf, 1e300, 1e18}) {
      EXPECT_EQ(sample_raw(texture, sampler, footprint(most, most)), smallest);
      EXPECT_EQ(sample_raw(texture, sampler, footprint(kNan, most)), smallest);
      EXPECT_EQ(sample_raw(texture, sampler, footprint(most, 0.0)), smallest);
    }
  }
}

TEST(Sampling, BorderColourOfARawTextureIsMadeBytes) {
  const std::vector<glm::u8vec4> texels{glm::u8vec4(9)};
  const Texture texture = make_raw_texture({1, 1}, texels, Mips::none);
  const Sampler sampler{
      .filter = Filter::nearest, .wrap_u = Wrap::border, .border = {300.0f, -4.0f, 17.0f, static_cast<float>(kNan)}};
  EXPECT_EQ(sample_raw(texture, sampler, {.uv = {1.5, 0.5}}), glm::u8vec4(255, 0, 17, 0));
}

}  // namespace
}  // namespace lode::raster

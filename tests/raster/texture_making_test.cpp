#include <gmpxx.h>
#include <gtest/gtest.h>

#include <climits>
#include <cmath>
#include <string>

#include "raster/error.h"
#include "raster/srgb.h"
#include "raster/texture.h"

namespace lode::raster {
namespace {

/// All (colour, alpha) pairs: x is the colour, y the alpha.
std::vector<glm::u8vec4> every_colour_and_alpha() {
  std::vector<glm::u8vec4> texels;
  for (int a = 0; a < 256; ++a) {
    for (int c = 0; c < 256; ++c) texels.emplace_back(c, 255 - c, c / 2, a);
  }
  return texels;
}

TEST(MakeRawTexture, PremultipliesWithOneRoundingHalfUp) {
  const std::vector<glm::u8vec4> texels = every_colour_and_alpha();
  const Texture texture = make_raw_texture({256, 256}, texels, Mips::none);
  EXPECT_EQ(texture.format, TextureFormat::raw);
  for (std::size_t i = 0; i < texels.size(); ++i) {
    for (int c = 0; c < 3; ++c) {
      ASSERT_EQ(int{texture.levels[0].raw[i][c]}, (2 * texels[i][c] * texels[i].a + 255) / 510);  // ⌊c·a/255 + ½⌋
    }
    ASSERT_EQ(texture.levels[0].raw[i].a, texels[i].a);
  }
}

TEST(MakeSrgbTexture, DecodesThenPremultipliesWithinHalfAnUlp) {
  const std::vector<glm::u8vec4> texels = every_colour_and_alpha();
  const Texture texture = make_srgb_texture({256, 256}, texels, Mips::none);
  EXPECT_EQ(texture.format, TextureFormat::linear);
  for (std::size_t i = 0; i < texels.size(); ++i) {
    const glm::vec4& found = texture.levels[0].linear[i];
    const mpq_class exact = mpq_class(srgb_decode(texels[i].r)) * int{texels[i].a} / 255;
    const double ulp = std::nextafter(found.r, 2.0f) - found.r;
    ASSERT_LE(abs(mpq_class(found.r) - exact), mpq_class(0.501 * ulp)) << i;
    if (texels[i].a == 255) {
      ASSERT_EQ(found.g, srgb_decode(texels[i].g));
    }
    ASSERT_EQ(found.a, static_cast<float>(int{texels[i].a} / 255.0));
  }
}

TEST(MakeLinearTexture, KeepsFloatsAsTheyAre) {
  const std::vector<glm::vec4> texels{{0.1f, 2.0f, -3.0f, 0.5f}, {1e-40f, 3e38f, 0.0f, 1.0f}};
  EXPECT_EQ(make_linear_texture({1, 2}, texels, Mips::none).levels[0].linear, texels);
}

/// The message of the Error that `make` throws, which must be bad input in one line.
template <class Make>
std::string refusal(Make make) {
  try {
    (void)make();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_input);
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    return error.what();
  }
  return "accepted";
}

TEST(MakeTexture, RefusesSizesOutOfRangeWithoutReadingOrAllocating) {
  const glm::u8vec4 byte_texel(0);
  const glm::vec4 float_texel(0.0f);
  const std::span<const glm::u8vec4> bytes(&byte_texel, 1);
  const std::span<const glm::vec4> floats(&float_texel, 1);
  for (const glm::ivec2& size_px :
       {glm::ivec2(0, 1), glm::ivec2(1, 0), glm::ivec2(0, 0), glm::ivec2(-1, -1), glm::ivec2(16385, 1),
        glm::ivec2(1, 16385), glm::ivec2(INT_MAX, INT_MAX), glm::ivec2(INT_MIN, 1), glm::ivec2(65536, 65536)}) {
    const std::string expected = "texture size " + std::to_string(size_px.x) + " x " + std::to_string(size_px.y) +
                                 ": expected 1 to 16384 a side";
    EXPECT_EQ(refusal([&] { return make_raw_texture(size_px, bytes, Mips::all); }), expected);
    EXPECT_EQ(refusal([&] { return make_srgb_texture(size_px, bytes, Mips::all); }), expected);
    EXPECT_EQ(refusal([&] { return make_linear_texture(size_px, floats, Mips::all); }), expected);
  }
}

TEST(MakeTexture, RefusesACountOfTexelsThatIsNotWidthTimesHeight) {
  const std::vector<glm::u8vec4> texels(7);
  for (const std::size_t n : {std::size_t{0}, std::size_t{5}, std::size_t{7}}) {
    EXPECT_EQ(refusal([&] {
                return make_raw_texture({2, 3}, std::span(texels).first(n), Mips::none);
              }),
              "texture of 2 x 3: expected 6 texels, found " + std::to_string(n));
  }
  EXPECT_EQ(refusal([&] {
              return make_srgb_texture({16384, 16384}, texels, Mips::none);
            }),
            "texture of 16384 x 16384: expected 268435456 texels, found 7");
}

}  // namespace
}  // namespace lode::raster

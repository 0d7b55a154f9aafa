// Several samples a pixel: exactly the average of the pictures of each sample alone.
#include <gmpxx.h>

#include "everything.h"
#include "raster/blend.h"
#include "raster/error.h"

namespace lode::raster::test {
namespace {

constexpr Planes kColorOnly{.color = true, .depth = false, .ids = false};

/// Sample k of a power of two N, as the program places them: ((k + ½)/N, bitreverse(k)/N + 1/(2N)).
std::vector<glm::ivec2> sample_pattern(int n) {
  std::vector<glm::ivec2> samples;
  for (int k = 0; k < n; ++k) {
    int reversed = 0;
    for (int bit = 1; bit < n; bit *= 2) reversed = 2 * reversed + ((k & bit) != 0 ? 1 : 0);
    samples.push_back({256 * k / n + 128 / n, 256 * reversed / n + 128 / n});
  }
  return samples;
}

/// The pictures of each sample alone.
std::vector<Image> pictures_alone(SmallScene& scene, const std::vector<glm::ivec2>& samples) {
  std::vector<Image> pictures;
  for (const glm::ivec2& sample : samples) {
    scene.frame.samples_fx8 = {&sample, 1};
    scene.render();
    pictures.push_back(scene.image);
  }
  return pictures;
}

TEST(Samples, OfABytePictureAreAveragedExactlyAndRoundedHalfUp) {
  for (int n = 2; n <= 128; n *= 2) {
    SmallScene scene({40, 24}, ColorFormat::rgba8, kColorOnly);
    add_everything(scene);
    const std::vector<glm::ivec2> samples = sample_pattern(n);
    const std::vector<Image> alone = pictures_alone(scene, samples);
    scene.frame.samples_fx8 = samples;
    scene.render();
    for (std::size_t i = 0; i < scene.image.rgba8.size(); ++i) {
      for (int c = 0; c < 4; ++c) {
        int sum = 0;
        for (const Image& picture : alone) sum += picture.rgba8[i][c];
        ASSERT_EQ(scene.image.rgba8[i][c], (2 * sum + n) / (2 * n))
            << n << " samples, pixel " << i << ", channel " << c;
      }
    }
  }
}

// The float nearest to the rational mean, but for the one rounding of the sum to double on the way: the colours here
// are of one size, so that sums of 128 of them are exact in double.
TEST(Samples, OfAFloatPictureAreAveragedExactlyAndRoundedOnce) {
  for (int n = 2; n <= 128; n *= 4) {
    SmallScene scene({40, 24}, ColorFormat::rgba32f, kColorOnly);
    scene.frame.clear = glm::vec4(0.5f, 0.25f, 0.75f, 1.0f);
    add_everything(scene);
    const std::vector<glm::ivec2> samples = sample_pattern(n);
    const std::vector<Image> alone = pictures_alone(scene, samples);
    scene.frame.samples_fx8 = samples;
    scene.render();
    for (std::size_t i = 0; i < scene.image.rgba32f.size(); ++i) {
      for (int c = 0; c < 4; ++c) {
        mpq_class sum = 0;
        for (const Image& picture : alone) sum += mpq_class(double(picture.rgba32f[i][c]));
        const mpq_class mean = sum / n;
        const float got = scene.image.rgba32f[i][c];
        const mpq_class error = abs(mpq_class(double(got)) - mean);
        for (const float other : {std::nextafter(got, -1e9f), std::nextafter(got, 1e9f)}) {
          ASSERT_LE(error, abs(mpq_class(double(other)) - mean)) << n << " samples, pixel " << i << ", channel " << c;
        }
      }
    }
  }
}

TEST(Samples, LieWhereTheyAreSaidToBe) {
  // A rectangle that covers the left quarter of a pixel, its edge through x = 64/256: samples on x < 64 are inside, a
  // sample on the right edge is not, one on the left edge is. 3 of 4: ⌊255·3/4 + ½⌋ = 191.
  SmallScene scene({1, 1}, ColorFormat::rgba8, kColorOnly);
  scene.window(Topology::quads, {{0, 0, 0.5}, {0.25, 0, 0.5}, {0.25, 1, 0.5}, {0, 1, 0.5}});
  const glm::ivec2 samples[] = {{0, 0}, {63, 255}, {10, 0}, {64, 7}};
  scene.frame.samples_fx8 = samples;
  scene.render();
  EXPECT_EQ(scene.image.rgba8[0], glm::u8vec4(191));
}

TEST(Samples, RoundHalvesUp) {
  // One of two samples covered by 255 over 0: 127.5 becomes 128.
  SmallScene scene({1, 1}, ColorFormat::rgba8, kColorOnly);
  scene.window(Topology::quads, {{0, 0, 0.5}, {0.5, 0, 0.5}, {0.5, 1, 0.5}, {0, 1, 0.5}});
  const glm::ivec2 samples[] = {{64, 128}, {192, 128}};
  scene.frame.samples_fx8 = samples;
  scene.render();
  EXPECT_EQ(scene.image.rgba8[0], glm::u8vec4(128));
}

TEST(Samples, KeepOneNanInAFloatPicture) {
  SmallScene scene({1, 1}, ColorFormat::rgba32f, kColorOnly);
  scene.rect({0, 0}, {1, 1}, 0.5, {-std::numeric_limits<float>::quiet_NaN(), -0.0f, 1.0f, 1.0f});
  const glm::ivec2 samples[] = {{64, 128}, {192, 128}};
  scene.frame.samples_fx8 = samples;
  scene.render();
  const std::uint32_t expected[] = {0x7FC00000u, 0u, 0x3F800000u, 0x3F800000u};
  EXPECT_EQ(std::memcmp(&scene.image.rgba32f[0], expected, sizeof expected), 0);
}

void expect_refused(SmallScene& scene, const std::string& message) {
  const Image before = scene.image;
  try {
    scene.render();
    FAIL() << "nothing thrown, expected: " << message;
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_input);
    EXPECT_EQ(error.what(), message);
  }
  EXPECT_TRUE(same_bytes(scene.image, before));
}

TEST(Samples, AreRefusedWithADepthOrIdPlaneIfThereAreSeveral) {
  const glm::ivec2 samples[] = {{64, 128}, {192, 128}};
  for (const Planes planes :
       {Planes{.color = true, .depth = true, .ids = false}, Planes{.color = true, .depth = false, .ids = true}}) {
    SmallScene scene({2, 2}, ColorFormat::rgba8, planes);
    scene.frame.samples_fx8 = samples;
    expect_refused(scene, "image: depth and ids cannot be averaged; use one sample a pixel");
  }
}

TEST(Samples, AreRefusedIfThereAreNoneTooManyOrOneOutsideThePixel) {
  SmallScene scene({2, 2}, ColorFormat::rgba8, kColorOnly);
  scene.frame.samples_fx8 = {};
  expect_refused(scene, "frame: 0 samples a pixel, expected 1 to 1024");
  const std::vector<glm::ivec2> many(1025, {1, 1});
  scene.frame.samples_fx8 = many;
  expect_refused(scene, "frame: 1025 samples a pixel, expected 1 to 1024");
  const glm::ivec2 outside[] = {{0, 256}};
  scene.frame.samples_fx8 = outside;
  expect_refused(scene, "frame: sample (0, 256), expected 0 to 255 in 1/256 px");
}

}  // namespace
}  // namespace lode::raster::test

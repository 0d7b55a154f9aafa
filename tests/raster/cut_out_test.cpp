// Masked materials: what is cut out, what an alpha test lets pass, and what is not shaded since it is hidden.
#include <cmath>
#include <limits>
#include <utility>

#include "small_scene.h"

namespace lode::raster::test {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN(), kInf = std::numeric_limits<float>::infinity();

Shader cut_out(double cutoff, float full) {
  return material_shader({.cut_out = CutOut{.cutoff = cutoff, .full = full}, .light = {}});
}

/// Of one pixel with the colour.
glm::vec4 kept_of(const glm::vec4& color, double cutoff) {
  SmallScene scene({1, 1}, ColorFormat::rgba32f);
  scene.rect({0, 0}, {1, 1}, 0.5, color).shader = cut_out(cutoff, 1.0f);
  scene.render();
  return scene.image.rgba32f[0];
}

TEST(CutOut, KeepsWhatHasTheCutoffsAlphaAndMakesItOpaqueAndStraight) {
  EXPECT_EQ(kept_of({0.125f, 0.25f, 0.5f, 0.5f}, 0.5), glm::vec4(0.25f, 0.5f, 1.0f, 1.0f));
  EXPECT_EQ(kept_of({0.125f, 0.25f, 0.5f, std::nextafter(0.5f, 0.0f)}, 0.5), glm::vec4(0.0f));
  EXPECT_EQ(kept_of({1, 1, 1, kNan}, 0.0), glm::vec4(0.0f));
  EXPECT_EQ(kept_of({1, 1, 1, 1}, std::nan("")), glm::vec4(0.0f));
}

TEST(CutOut, IsBlackAndOpaqueWhereAlphaIsZeroAndKept) {
  EXPECT_EQ(kept_of({0.5f, 0.5f, 0.5f, 0.0f}, 0.0), glm::vec4(0, 0, 0, 1));
  EXPECT_EQ(kept_of({0.5f, 0.5f, 0.5f, -0.25f}, -1.0), glm::vec4(0, 0, 0, 1));
}

TEST(CutOut, ComesBeforeTheLight) {
  SmallScene scene({1, 1}, ColorFormat::rgba32f);
  Draw& draw = scene.rect({0, 0}, {1, 1}, 0.5, {0.25f, 0.25f, 0.25f, 0.5f});
  draw.normals = scene.keep(std::vector<glm::vec3>(4, {0, 0, 1}));
  draw.shader = material_shader({.cut_out = CutOut{}, .light = Lambert{.to_light = {1, 0, 0}, .ambient = 0.5f}});
  scene.render();
  EXPECT_EQ(scene.image.rgba32f[0], glm::vec4(0.25f, 0.25f, 0.25f, 1.0f));
}

TEST(CutOut, KeepsThePixelsOfADitherOnly) {
  constexpr std::uint16_t kPixels = 0b1000'0010'0100'0001;  // (0, 0), (2, 1), (1, 2), (3, 3)
  for (const bool tested : {false, true}) {
    SmallScene scene({11, 9}, ColorFormat::rgba32f);
    Draw& draw = scene.rect({0, 0}, {11, 9}, 0.5, {0.25f, 0.5f, 0.75f, 1.0f});
    draw.shader = material_shader({.cut_out = CutOut{.pixels = kPixels}, .light = {}});
    if (tested) draw.alpha_test = 0.5;
    scene.render();
    for (int y = 0; y < 9; ++y) {
      for (int x = 0; x < 11; ++x) {
        const bool kept = (kPixels >> (x % 4 + 4 * (y % 4)) & 1) != 0;
        const auto i = std::size_t(y * 11 + x);
        EXPECT_EQ(scene.image.rgba32f[i], kept ? glm::vec4(0.25f, 0.5f, 0.75f, 1.0f) : glm::vec4(0.0f)) << x << " " << y;
        EXPECT_EQ(scene.image.depth[i], kept || !tested ? 0.5f : 0.0f);
      }
    }
  }
}

TEST(CutOut, AnEmptyMaterialIsNoShader) {
  EXPECT_EQ(material_shader({}).function, nullptr);
  const Shader shader = cut_out(0.25, 255.0f);
  EXPECT_EQ(material_of(shader)->cut_out->cutoff, 0.25);
  EXPECT_FALSE(material_of(shader)->light);
}

// Each alpha at each threshold, a pixel each; the fast pipeline compares floats, the definition is by division in
// double. Thresholds are quotients of alphas, their neighbours, and what has none.
TEST(AlphaTest, IsExactAtItsThreshold) {
  for (const ColorFormat format : {ColorFormat::rgba8, ColorFormat::rgba32f}) {
    const float full = format == ColorFormat::rgba8 ? 255.0f : 1.0f;
    std::vector<float> alphas = {0.0f, -0.0f, 1e-45f, -1e-45f, 3.4e38f, -3.4e38f, kInf, -kInf, kNan};
    for (const float a : {0.1f, 1.0f / 3.0f, 0.5f, 1.0f, 85.0f, 127.0f, 1e-39f}) {
      for (const float v : {std::nextafter(a, -kInf), a, std::nextafter(a, kInf)}) alphas.push_back(v);
    }
    std::vector<double> thresholds = {1e-320, -1e-320, 1e300, -1e300, 0.0, -0.0};
    for (const float a : alphas) {
      const double quotient = double{a} / double{full};
      for (const double t : {std::nextafter(quotient, -INFINITY), quotient, std::nextafter(quotient, INFINITY)}) {
        if (!std::isnan(t)) thresholds.push_back(t);  // NaN is refused
      }
    }
    for (const double threshold : thresholds) {
      SmallScene scene({int(alphas.size()), 1}, format);
      for (std::size_t i = 0; i < alphas.size(); ++i) {
        const int x = int(i);
        scene.rect({x, 0}, {x + 1, 1}, 0.5, {full, full, full, alphas[i]}).alpha_test = threshold;
      }
      scene.render();
      for (std::size_t i = 0; i < alphas.size(); ++i) {
        const bool passes = double{alphas[i]} / double{full} >= threshold;
        EXPECT_EQ(scene.image.depth[i] > 0.0f, passes) << alphas[i] << " at " << threshold;
      }
      if (HasFailure()) return;
    }
  }
}

// 32 × 32 samples, some columns of them behind an opaque rectangle: a whole 8 × 8 that is hidden is left out by itself,
// hidden samples of others one by one.
TEST(AlphaTest, DoesNotShadeWhatIsHidden) {
  for (const int hidden_px : {8, 6}) {
    SmallScene scene({32, 32});
    scene.rect({0, 0}, {hidden_px, 32}, 0.75, {255, 0, 0, 255});
    scene.rect({0, 0}, {32, 32}, 0.5, {0, 255, 0, 255}).alpha_test = 0.5;
    const FrameStats stats = scene.render();
    // For the test, and where they are seen in the end.
    EXPECT_EQ(stats.fragments_shaded, unsigned(32 - hidden_px) * 32u + 32u * 32u);
    EXPECT_EQ(stats.fragments_alpha_failed, 0u);
  }
}

TEST(AlphaTest, AtEqualDepthTheLowerDrawWins) {
  for (const auto& [first, second] : {std::pair(5u, 1u), std::pair(1u, 5u)}) {
    SmallScene scene({32, 32}, ColorFormat::rgba32f);
    scene.rect({0, 0}, {30, 32}, 0.5, {1, 0, 0, 1}).draw_id = first;
    Draw& tested = scene.rect({0, 0}, {32, 32}, 0.5, {0, 1, 0, 1});
    tested.alpha_test = 0.5;
    tested.draw_id = second;
    scene.render();
    EXPECT_EQ(scene.image.rgba32f[0], first < second ? glm::vec4(1, 0, 0, 1) : glm::vec4(0, 1, 0, 1));
    EXPECT_EQ(scene.image.rgba32f[31], glm::vec4(0, 1, 0, 1));
  }
}

// Targets of floats keep the colours of the test; an owner that lost its sample has lost its colour, too.
TEST(AlphaTest, IsNotShadedAgainWhereFloatsAreKept) {
  SmallScene scene({32, 32}, ColorFormat::rgba32f);
  scene.rect({0, 0}, {8, 32}, 0.75, {1, 0, 0, 1});
  scene.rect({0, 0}, {32, 32}, 0.5, {0, 1, 0, 1}).alpha_test = 0.5;
  scene.rect({16, 0}, {32, 32}, 0.625, {0, 0, 1, 1}).alpha_test = 0.5;
  const FrameStats stats = scene.render();
  EXPECT_EQ(stats.fragments_shaded, 24u * 32u + 16u * 32u + 8u * 32u);
}

TEST(AlphaTest, CountsWhatFails) {
  SmallScene scene({32, 32});
  scene.rect({0, 0}, {8, 32}, 0.75, {255, 0, 0, 255});
  scene.rect({0, 0}, {32, 32}, 0.5, {0, 255, 0, 100}).alpha_test = 0.5;
  const FrameStats stats = scene.render();
  EXPECT_EQ(stats.fragments_alpha_failed, 24u * 32u);
  EXPECT_EQ(stats.fragments_shaded, 24u * 32u + 8u * 32u);
}

// A weight of 0 times an infinite colour is no colour, on the rectangle's diagonal; elsewhere the sum is infinite.
TEST(Surfaces, InfiniteColorsAreWeighedLikeOthers) {
  SmallScene scene({16, 16}, ColorFormat::rgba32f);
  Draw& draw = scene.rect({0, 0}, {16, 16}, 0.5, {1, 1, 1, 1});
  draw.colors = scene.keep(std::vector<glm::vec4>(4, glm::vec4(kInf, 1, 1, 1)));
  scene.render();  // by both pipelines
  int n_nan = 0, n_infinite = 0;
  for (const glm::vec4& color : scene.image.rgba32f) n_nan += std::isnan(color.r), n_infinite += std::isinf(color.r);
  EXPECT_EQ(n_nan, 16);
  EXPECT_EQ(n_infinite, 16 * 15);
}

}  // namespace
}  // namespace lode::raster::test

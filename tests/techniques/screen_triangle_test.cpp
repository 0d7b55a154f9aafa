/// Triangles in the masked depth buffer against the renderer's.

#include "techniques/masked_occlusion/screen_triangle.h"

#include <gtest/gtest.h>

#include "geometry/random.h"
#include "raster/render.h"

namespace lode::tests {
namespace {

using techniques::MaskedDepth;
using techniques::ScreenTriangle;

constexpr glm::ivec2 kSize(45, 23);

raster::Image rendered(const ScreenTriangle& t) {
  glm::dvec3 corners_px[3];
  for (std::size_t k = 0; k < 3; ++k) corners_px[k] = {t.p_fx8[k].x / 256.0, t.p_fx8[k].y / 256.0, t.z[k]};
  raster::Draw draw;
  draw.vertices = raster::WindowVertices{corners_px};
  raster::Image image = raster::make_image(kSize, raster::ColorFormat::rgba8, {.color = false});
  raster::render({.draws = {&draw, 1}, .clear = {}, .viewport = {}, .scissor = {}}, image, {.threads = 1});
  return image;
}

/// Draws into an empty buffer and expects the renderer's samples, each at the renderer's depth or behind it.
void expect_like_rendered(const ScreenTriangle& t) {
  MaskedDepth buffer;
  buffer.begin(kSize);
  techniques::draw_triangle(t, buffer);
  const raster::Image image = rendered(t);
  const float farthest = float(std::min({t.z[0], t.z[1], t.z[2]}));
  for (int y = 0; y < kSize.y; ++y) {
    for (int x = 0; x < kSize.x; ++x) {
      const auto i = std::size_t(y * kSize.x + x);
      const float bound = buffer.bound_at({x, y});
      ASSERT_EQ(bound > 0.0f, image.ids[i].draw != raster::kNoId)
          << x << "," << y << " of " << t.p_fx8[0].x << "," << t.p_fx8[0].y << " " << t.p_fx8[1].x << ","
          << t.p_fx8[1].y << " " << t.p_fx8[2].x << "," << t.p_fx8[2].y;
      ASSERT_LE(bound, image.depth[i]);
      if (bound > 0.0f) {
        ASSERT_GE(bound, farthest);
      }
    }
  }
}

/// Half of the coordinates on sample positions and pixel edges, so that the top-left rule decides often.
ScreenTriangle random_triangle(geometry::Random& random, int reach_px) {
  ScreenTriangle t;
  for (std::size_t k = 0; k < 3; ++k) {
    for (int axis = 0; axis < 2; ++axis) {
      const int p_fx8 = int(random.below(std::uint32_t(256 * (2 * reach_px + 45)))) - 256 * reach_px;
      t.p_fx8[k][axis] = random.below(2) == 0 ? p_fx8 & ~127 : p_fx8;
    }
    t.z[k] = random.uniform(0.001, 1.0);
  }
  return t;
}

TEST(ScreenTriangle, CoversTheRenderersSamplesAndIsNowhereNearer) {
  for (const int reach_px : {0, 3, 100, 20000}) {
    geometry::Random random(5, std::uint32_t(reach_px));
    for (int k = 0; k < 400; ++k) expect_like_rendered(random_triangle(random, reach_px));
  }
}

TEST(ScreenTriangle, SliversTooAndSmallOnes) {
  geometry::Random random(6, 0);
  for (int k = 0; k < 400; ++k) {
    ScreenTriangle t = random_triangle(random, 3);
    const glm::ivec2 way = t.p_fx8[1] - t.p_fx8[0];
    const bool sliver = k % 2 == 0;
    t.p_fx8[2] = sliver ? t.p_fx8[0] + way / 3 : t.p_fx8[0] + glm::ivec2(int(random.below(600)), 200);
    t.p_fx8[2].y += sliver ? int(random.below(3)) - 1 : 0;
    if (!sliver) t.p_fx8[1] = t.p_fx8[0] + way / 20;
    expect_like_rendered(t);
  }
}

TEST(ScreenTriangle, OfNoAreaCoversNothing) {
  MaskedDepth buffer;
  buffer.begin(kSize);
  EXPECT_EQ(techniques::draw_triangle({{glm::ivec2(0, 0), {2000, 1000}, {4000, 2000}}, {1, 1, 1}}, buffer), 0u);
}

TEST(ScreenTriangle, AFlatOneIsAtItsDepth) {
  // 16 × 8 px and beyond: two subtiles in x and two in y are covered wholly, at a depth that float holds.
  MaskedDepth buffer;
  buffer.begin(kSize);
  const ScreenTriangle t = {{glm::ivec2(-256, -256), {-256, 30000}, {30000, -256}}, {0.5, 0.5, 0.5}};
  EXPECT_GT(techniques::draw_triangle(t, buffer), 4u);
  EXPECT_EQ(buffer.bound_at({9, 5}), 0.5f);
}

}  // namespace
}  // namespace lode::tests

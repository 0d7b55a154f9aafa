// Scissors and the viewport: which pixels a frame may touch, and where clip space lands.
#include <limits>

#include "small_scene.h"

namespace lode::raster::test {
namespace {

constexpr glm::vec4 kRed{255, 0, 0, 255};
constexpr int kMin = std::numeric_limits<int>::min(), kMax = std::numeric_limits<int>::max();

TEST(Scissor, OfADrawLimitsThatDrawAlone) {
  SmallScene scene({4, 3});
  scene.rect({0, 0}, {4, 3}, 0.5, kRed).scissor = Rect{{1, 1}, {2, 1}};
  scene.rect({0, 0}, {1, 3}, 0.5, kRed);
  scene.render();
  EXPECT_EQ(ids_picture(scene.image), "B...\nBAA.\nB...\n");
}

TEST(Scissor, OfTheFrameLimitsEveryDrawTogetherWithItsOwnButNotTheClear) {
  SmallScene scene({4, 3});
  scene.frame.clear = {7, 7, 7, 7};
  scene.frame.scissor = Rect{{0, 1}, {3, 2}};
  scene.rect({0, 0}, {4, 3}, 0.5, kRed);
  scene.rect({0, 0}, {4, 3}, 0.75, kRed).scissor = Rect{{2, 0}, {2, 2}};
  scene.render();
  EXPECT_EQ(ids_picture(scene.image), "....\nAAB.\nAAA.\n");
  EXPECT_EQ(scene.image.rgba8[0], glm::u8vec4(7));
  EXPECT_EQ(scene.image.rgba8[11], glm::u8vec4(7));
}

/// What each of these leaves of a draw that covers 4×3 pixels, as a frame's scissor and as a draw's.
struct Case {
  Rect rect;
  const char* left;
};
const Case kCases[] = {
    {{{1, 1}, {0, 0}}, "....\n....\n....\n"},              // empty
    {{{1, 0}, {2, 0}}, "....\n....\n....\n"},              // empty in one axis
    {{{4, 0}, {5, 5}}, "....\n....\n....\n"},              // outside, right
    {{{-7, -7}, {7, 7}}, "....\n....\n....\n"},            // outside, its far corner on the origin
    {{{-7, -7}, {9, 8}}, "AA..\n....\n....\n"},            // partly outside
    {{{3, 2}, {kMax, kMax}}, "....\n....\n...A\n"},        // its far corner overflows an int
    {{{kMin, kMin}, {kMax, kMax}}, "....\n....\n....\n"},  // ends at −1
    {{{kMax, kMax}, {kMax, kMax}}, "....\n....\n....\n"},
    {{{-kMax, 1}, {kMax, 1}}, "....\n....\n....\n"},     // ends at 0
    {{{1 - kMax, 1}, {kMax, 1}}, "....\nA...\n....\n"},  // ends at 1
    {{{-1, -1}, {kMax, kMax}}, "AAAA\nAAAA\nAAAA\n"},
};

TEST(Scissor, MayBeEmptyOutsidePartlyOutsideOrBeyondTheRangeOfInt) {
  for (const Case& c : kCases) {
    for (const bool of_frame : {false, true}) {
      SmallScene scene({4, 3});
      Draw& draw = scene.rect({0, 0}, {4, 3}, 0.5, kRed);
      (of_frame ? scene.frame.scissor : draw.scissor) = c.rect;
      scene.render();
      EXPECT_EQ(ids_picture(scene.image), c.left)
          << c.rect.size_px.x << "x" << c.rect.size_px.y << " at " << c.rect.origin_px.x << ", " << c.rect.origin_px.y;
    }
  }
}

TEST(Scissor, LimitsLinesPointsAndDiscsToo) {
  for (const Topology topology : {Topology::lines, Topology::points, Topology::discs}) {
    SmallScene scene({4, 3});
    Draw& draw = scene.window(topology, {{-3, 1.5, 0.5}, {9, 1.5, 0.5}, {2, 1.5, 0.5}, {2, 1.5, 0.5}});
    draw.point_size_px = 20;
    draw.radii = scene.keep<float>({20, 20, 20, 20});
    draw.scissor = Rect{{1, 1}, {2, 1}};
    scene.render();
    EXPECT_EQ(ids_picture(scene.image), "....\n.AA.\n....\n") << int(topology);
  }
}

/// Clip space's whole square.
Draw& full_square(SmallScene& scene) {
  Draw& draw = scene.clip(Topology::quads, {{-1, 1, 0.5, 1}, {1, 1, 0.5, 1}, {1, -1, 0.5, 1}, {-1, -1, 0.5, 1}});
  draw.color = kRed;
  return draw;
}

TEST(Viewport, IsWhereClipSpaceLands) {
  SmallScene scene({5, 4});
  scene.frame.viewport = Rect{{1, 2}, {3, 1}};
  full_square(scene);
  scene.render();
  EXPECT_EQ(ids_picture(scene.image), ".....\n.....\n.AAA.\n.....\n");
}

TEST(Viewport, PutsPositiveYUpAndPositiveXRight) {
  SmallScene scene({4, 4});
  // The quadrant x > 0, y > 0.
  scene.clip(Topology::quads, {{0, 1, 0.5, 1}, {1, 1, 0.5, 1}, {1, 0, 0.5, 1}, {0, 0, 0.5, 1}});
  scene.render();
  EXPECT_EQ(ids_picture(scene.image), "..AA\n..AA\n....\n....\n");
}

TEST(Viewport, MayLeaveTheTargetSoThatTilesOfABigPictureAreItsCrops) {
  const auto draw_into = [](SmallScene& scene) {
    Draw& draw = scene.clip(Topology::triangles, {{-0.9, -0.7, 0.3, 1.5}, {2.1, -1.9, 0.9, 2.7}, {0.2, 0.8, 0.1, 0.9}});
    draw.colors = scene.keep<glm::vec4>({{255, 0, 0, 255}, {0, 255, 0, 255}, {0, 0, 255, 255}});
  };
  SmallScene whole({24, 16});
  draw_into(whole);
  whole.render();
  for (const glm::ivec2 corner : {glm::ivec2{0, 0}, {8, 0}, {5, 3}, {16, 8}}) {
    SmallScene crop({8, 8});
    crop.frame.viewport = Rect{-corner, {24, 16}};
    draw_into(crop);
    crop.render();
    for (int y = 0; y < 8; ++y) {
      for (int x = 0; x < 8; ++x) {
        const std::size_t i = std::size_t(8 * y + x), k = std::size_t(24 * (y + corner.y) + x + corner.x);
        ASSERT_EQ(crop.image.rgba8[i], whole.image.rgba8[k]) << x << ", " << y;
        ASSERT_EQ(crop.image.depth[i], whole.image.depth[k]) << x << ", " << y;
        ASSERT_EQ(crop.image.ids[i], whole.image.ids[k]) << x << ", " << y;
      }
    }
  }
}

TEST(Viewport, OfNoSizeDrawsNothing) {
  SmallScene scene({4, 4});
  scene.frame.viewport = Rect{{1, 1}, {0, 3}};
  full_square(scene);
  scene.render();
  EXPECT_EQ(ids_picture(scene.image), "....\n....\n....\n....\n");
}

TEST(Viewport, DoesNotMoveWindowSpace) {
  SmallScene scene({4, 1});
  scene.frame.viewport = Rect{{2, 0}, {1, 1}};
  scene.rect({0, 0}, {2, 1}, 0.5, kRed);
  scene.render();
  EXPECT_EQ(ids_picture(scene.image), "AA..\n");
}

}  // namespace
}  // namespace lode::raster::test

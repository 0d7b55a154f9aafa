// Who owns a sample (C6; notes/rasterization.md, "Depth and order"): order-free draws by depth and key, ordered
// draws in submission order after them.
#include <algorithm>
#include <array>

#include "small_scene.h"

namespace lode::raster::test {
namespace {

constexpr glm::vec4 kRed{255, 0, 0, 255}, kGreen{0, 255, 0, 255}, kBlue{0, 0, 255, 255}, kGrey{80, 80, 80, 255};
/// Premultiplied half red, half blue.
constexpr glm::vec4 kHalfRed{128, 0, 0, 128}, kHalfBlue{0, 0, 128, 128};

glm::u8vec4 only_pixel(const SmallScene& scene) { return scene.image.rgba8.at(0); }

/// A scene of one pixel.
SmallScene one_pixel() { return SmallScene({1, 1}); }
Draw& cover(SmallScene& scene, double z, const glm::vec4& color) { return scene.rect({0, 0}, {1, 1}, z, color); }

TEST(OrderFreeDraws, GiveTheSameBytesInAllSubmissionOrdersOfFiveDraws) {
  struct Rectangle {
    glm::ivec2 from, to;
    double z;
    std::optional<float> alpha_test;
  };
  // C and D share a depth; E is nearest of all but fails its alpha test (alpha is 1 everywhere); A is at depth 0.
  const std::array<Rectangle, 5> rectangles = {{{{0, 0}, {6, 2}, 0.0, {}},
                                                {{1, 1}, {5, 5}, 0.25, {}},
                                                {{2, 0}, {4, 4}, 0.5, {}},
                                                {{3, 3}, {6, 6}, 0.5, {}},
                                                {{0, 0}, {6, 6}, 0.75, 1.5f}}};
  const std::string expected =
      "AACCAA\n"
      "ABCCBA\n"
      ".BCCB.\n"
      ".BCCDD\n"
      ".BBDDD\n"
      "...DDD\n";
  std::array<std::uint32_t, 5> order = {0, 1, 2, 3, 4};
  std::optional<Image> first;
  do {
    SmallScene scene({6, 6});
    for (const std::uint32_t k : order) {
      const Rectangle& r = rectangles[k];
      Draw& draw = scene.rect(r.from, r.to, r.z, {40.0f * float(k), 255.0f - 30.0f * float(k), 10.0f, 255.0f});
      draw.draw_id = k;
      draw.alpha_test = r.alpha_test;
    }
    scene.render();
    ASSERT_EQ(ids_picture(scene.image), expected);
    if (!first) first = scene.image;
    ASSERT_TRUE(same_bytes(scene.image, *first));
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST(OrderFreeDraws, GiveEqualDepthToTheLowerDrawIdEvenIfSubmittedLast) {
  SmallScene scene = one_pixel();
  cover(scene, 0.5, kRed).draw_id = 7;
  cover(scene, 0.5, kGreen).draw_id = 3;
  cover(scene, 0.5, kBlue).draw_id = 5;
  scene.render();
  EXPECT_EQ(scene.image.ids[0], (Ids{3, 0}));
  EXPECT_EQ(only_pixel(scene), glm::u8vec4(kGreen));
}

TEST(OrderFreeDraws, CompareDrawIdsBeforePrimitiveIds) {
  SmallScene scene = one_pixel();
  Draw& later_draw = cover(scene, 0.5, kRed);
  later_draw.draw_id = 1;
  later_draw.primitive_id = 0;
  Draw& earlier_draw = cover(scene, 0.5, kGreen);
  earlier_draw.draw_id = 0;
  earlier_draw.primitive_id = 9;
  scene.render();
  EXPECT_EQ(scene.image.ids[0], (Ids{0, 9}));
}

TEST(OrderFreeDraws, GiveEqualDepthWithinADrawToTheLowerPrimitive) {
  SmallScene scene = one_pixel();
  // Three times the same rectangle; the last two are nearer, at one depth.
  std::vector<glm::dvec3> corners;
  for (const double z : {0.25, 0.5, 0.5}) {
    for (const glm::dvec3 p : {glm::dvec3{0, 0, z}, {1, 0, z}, {1, 1, z}, {0, 1, z}}) corners.push_back(p);
  }
  scene.window(Topology::quads, corners);
  scene.render();
  EXPECT_EQ(scene.image.ids[0], (Ids{0, 1}));
}

TEST(OrderFreeDraws, GiveEqualDepthWithinAPrimitiveToTheLowerPiece) {
  // A quad folded onto itself: triangles 0 1 2 and 0 2 3 both cover the pixel, at one depth. Corner 1 is red, corner
  // 3 blue, both far away, corners 0 and 2 black: the winner's colour has red in it or blue.
  SmallScene scene = one_pixel();
  Draw& quad = scene.window(Topology::quads, {{-1, 4, 0.5}, {4, 1, 0.5}, {-1, -2, 0.5}, {4, 1, 0.5}});
  quad.colors = scene.keep<glm::vec4>({{0, 0, 0, 255}, kRed, {0, 0, 0, 255}, kBlue});
  scene.render();
  EXPECT_GT(only_pixel(scene).r, 0);
  EXPECT_EQ(only_pixel(scene).b, 0);
}

TEST(OrderFreeDraws, FallBackToSubmissionOrderWhereTwoKeysAreEqual) {
  SmallScene scene = one_pixel();
  cover(scene, 0.5, kRed).draw_id = 4;
  cover(scene, 0.5, kGreen).draw_id = 4;
  scene.render();
  EXPECT_EQ(only_pixel(scene), glm::u8vec4(kRed));
}

TEST(Clear, LosesToAFragmentAtDepthZeroOfEitherSignAndEitherKindOfDraw) {
  for (const double z : {0.0, -0.0, -5.0}) {  // a window depth below 0 is clamped to it
    for (const bool ordered : {false, true}) {
      SmallScene scene = one_pixel();
      scene.frame.clear = kGrey;
      Draw& draw = cover(scene, z, kRed);
      if (ordered) {
        draw.blend = Blend::over;
        draw.depth_write = true;
      }
      scene.render();
      EXPECT_EQ(only_pixel(scene), glm::u8vec4(kRed)) << z << " " << ordered;
      EXPECT_EQ(scene.image.ids[0], (Ids{0, 0}));
      EXPECT_EQ(std::memcmp(scene.image.depth.data(), "\0\0\0\0", 4), 0) << "depth is +0";
    }
  }
}

TEST(Clear, FillsWhatNothingCovers) {
  SmallScene scene({2, 1});
  scene.frame.clear = {10, 20.5f, 30.49f, 300};
  scene.rect({1, 0}, {2, 1}, 0.5, kRed);
  scene.render();
  EXPECT_EQ(scene.image.rgba8[0], glm::u8vec4(10, 21, 30, 255));
  EXPECT_EQ(scene.image.depth[0], 0.0f);
  EXPECT_EQ(scene.image.ids[0], (Ids{kNoId, kNoId}));
}

TEST(OrderedDraws, RunAfterAllOrderFreeOnesWhereverTheyWereSubmitted) {
  SmallScene scene = one_pixel();
  cover(scene, 0.75, kHalfRed).blend = Blend::over;
  cover(scene, 0.5, kBlue);  // submitted later, drawn first
  scene.render();
  // 128 + 0 and 0 + ⌊255·127/255 + ½⌋.
  EXPECT_EQ(only_pixel(scene), glm::u8vec4(128, 0, 127, 255));
}

TEST(OrderedDraws, PassOnlyIfStrictlyNearer) {
  const float z = 0.5f;
  for (const float own : {std::nextafter(z, 0.0f), z, std::nextafter(z, 1.0f)}) {
    SmallScene scene = one_pixel();
    cover(scene, z, kBlue);
    cover(scene, own, kRed).blend = Blend::add;
    scene.render();
    EXPECT_EQ(only_pixel(scene).r, own > z ? 255 : 0) << own;
  }
}

TEST(OrderedDraws, AreBlendedInSubmissionOrderNotByDepthOrKey) {
  SmallScene scene = one_pixel();
  Draw& first = cover(scene, 0.75, kHalfRed);  // nearer and with the higher key, and yet first
  first.blend = Blend::over;
  first.draw_id = 9;
  Draw& second = cover(scene, 0.5, kHalfBlue);
  second.blend = Blend::over;
  second.draw_id = 1;
  scene.render();
  // Red on the clear (0): (128, 0, 0, 128). Blue over it: red and alpha kept by ⌊128·127/255 + ½⌋ = 64.
  EXPECT_EQ(only_pixel(scene), glm::u8vec4(64, 0, 128, 192));
}

TEST(OrderedDraws, LeaveDepthAndIdsAloneUnlessTheyWriteDepth) {
  SmallScene scene = one_pixel();
  cover(scene, 0.25, kBlue);
  cover(scene, 0.5, kHalfRed).blend = Blend::over;
  Draw& opaque = cover(scene, 0.75, kGreen);  // opaque, but not into depth: ordered
  opaque.depth_write = false;
  cover(scene, 0.3, kHalfRed).blend = Blend::over;  // nearer than what stands in depth
  scene.render();
  EXPECT_EQ(scene.image.depth[0], 0.25f);
  EXPECT_EQ(scene.image.ids[0], (Ids{0, 0}));
  EXPECT_EQ(only_pixel(scene), glm::u8vec4(128, 127, 0, 255));
}

TEST(OrderedDraws, HideWhatIsBehindThemIfTheyWriteDepth) {
  SmallScene scene = one_pixel();
  cover(scene, 0.25, kBlue);
  Draw& writer = cover(scene, 0.5, kHalfRed);
  writer.blend = Blend::over;
  writer.depth_write = true;
  cover(scene, 0.4, kGreen).blend = Blend::over;  // behind the writer now
  scene.render();
  EXPECT_EQ(scene.image.depth[0], 0.5f);
  EXPECT_EQ(scene.image.ids[0], (Ids{1, 0}));
  EXPECT_EQ(only_pixel(scene), glm::u8vec4(128, 0, 127, 255));
}

TEST(OrderedDraws, WithoutDepthTestPassEverywhereAndMayPushDepthBack) {
  SmallScene scene = one_pixel();
  cover(scene, 0.75, kBlue);
  Draw& untested = cover(scene, 0.25, kGreen);  // farther, untested: ordered, drawn over the nearer one
  untested.depth_test = false;
  cover(scene, 0.5, kHalfRed).blend = Blend::over;  // nearer than 0.25, which now stands in depth
  scene.render();
  EXPECT_EQ(scene.image.depth[0], 0.25f);
  EXPECT_EQ(scene.image.ids[0], (Ids{1, 0}));
  EXPECT_EQ(only_pixel(scene), glm::u8vec4(128, 127, 0, 255));
}

TEST(OrderedDraws, NoLongerOwnTheSamplesOfPrimitivesInOneDrawByKey) {
  // Within one ordered draw that writes depth the nearer of two primitives hides the other only if it comes first.
  for (const bool near_first : {false, true}) {
    SmallScene scene = one_pixel();
    std::vector<glm::dvec3> corners;
    for (const double z : near_first ? std::array{0.75, 0.5} : std::array{0.5, 0.75}) {
      for (const glm::dvec3 p : {glm::dvec3{0, 0, z}, {1, 0, z}, {1, 1, z}, {0, 1, z}}) corners.push_back(p);
    }
    Draw& draw = scene.window(Topology::quads, corners);
    draw.color = glm::vec4(100, 0, 0, 0);
    draw.blend = Blend::add;
    draw.depth_write = true;
    scene.render();
    EXPECT_EQ(only_pixel(scene).r, near_first ? 100 : 200);
    EXPECT_EQ(scene.image.depth[0], 0.75f);
  }
}

TEST(OrderedDraws, LeaveTheirIdsOnlyIfAskedTo) {
  for (const bool asked : {false, true}) {
    SmallScene scene = one_pixel();
    cover(scene, 0.25, kBlue);
    cover(scene, 0.5, kHalfRed).blend = Blend::over;
    scene.render({.threads = 1, .ids_from_ordered_draws = asked});
    EXPECT_EQ(scene.image.ids[0], (Ids{asked ? 1u : 0u, 0}));
    EXPECT_EQ(scene.image.depth[0], 0.25f);
  }
}

TEST(AlphaTest, KeepsASampleWhoseAlphaIsExactlyTheThreshold) {
  const float half = 127.5f;  // 0.5 in an rgba8 target's unit: tested before it is stored
  for (const float alpha : {std::nextafter(half, 0.0f), half, std::nextafter(half, 255.0f)}) {
    SmallScene scene = one_pixel();
    cover(scene, 0.5, {9, 9, 9, alpha}).alpha_test = 0.5f;
    scene.render();
    EXPECT_EQ(scene.image.ids[0].draw, alpha >= half ? 0u : kNoId) << alpha;
  }
  for (int code = 0; code < 256; ++code) {  // of every code at its own threshold, as a text file would have it
    SmallScene scene = one_pixel();
    cover(scene, 0.5, {9, 9, 9, float(code)}).alpha_test = code / 255.0;
    scene.render();
    EXPECT_EQ(scene.image.ids[0].draw, 0u) << code;
  }
  for (const float alpha : {std::nextafter(0.25f, 0.0f), 0.25f}) {
    SmallScene scene({1, 1}, ColorFormat::rgba32f);
    cover(scene, 0.5, {1, 1, 1, alpha}).alpha_test = 0.25f;
    scene.render();
    EXPECT_EQ(scene.image.ids[0].draw, alpha >= 0.25f ? 0u : kNoId) << alpha;
  }
}

TEST(AlphaTest, DropsASampleWhoseAlphaIsNotANumber) {
  SmallScene scene({1, 1}, ColorFormat::rgba32f);
  const float infinity = std::numeric_limits<float>::infinity();
  cover(scene, 0.5, {1, 1, 1, std::numeric_limits<float>::quiet_NaN()}).alpha_test = -infinity;
  scene.render();
  EXPECT_EQ(scene.image.ids[0].draw, kNoId);
}

TEST(AlphaTest, IsPartOfCoverageSoLosersLeaveNoDepth) {
  // A row whose alpha runs 0.5, 1.5, 2.5, 3.5 (of 4); what lies behind shows where it is below 2, blended or not.
  for (const Blend blend : {Blend::none, Blend::over}) {
    SmallScene scene({4, 1});
    scene.rect({0, 0}, {4, 1}, 0.25, kBlue);
    Draw& cut = scene.window(Topology::quads, {{0, 0, 0.75}, {4, 0, 0.75}, {4, 1, 0.75}, {0, 1, 0.75}});
    cut.colors = scene.keep<glm::vec4>({{255, 0, 0, 0}, {255, 0, 0, 255}, {255, 0, 0, 255}, {255, 0, 0, 0}});
    cut.alpha_test = 0.5f;
    cut.blend = blend;
    cut.depth_write = true;
    scene.render();
    EXPECT_EQ(ids_picture(scene.image), "AABB\n");
    EXPECT_EQ(scene.image.depth, (PixelPlane<float>{0.25f, 0.25f, 0.75f, 0.75f}));
    EXPECT_EQ(scene.image.rgba8[1], glm::u8vec4(kBlue));
  }
}

TEST(AlphaTest, LetsAFartherDrawWinWhereTheNearerOneFailsWhicheverComesFirst) {
  for (const bool cut_first : {false, true}) {
    SmallScene scene = one_pixel();
    const auto cut = [&] {
      Draw& draw = cover(scene, 0.75, {255, 0, 0, 10});
      draw.alpha_test = 0.5f;
      draw.draw_id = 0;
    };
    if (cut_first) cut();
    cover(scene, 0.25, kBlue).draw_id = 1;
    if (!cut_first) cut();
    scene.render();
    EXPECT_EQ(scene.image.ids[0].draw, 1u);
    EXPECT_EQ(scene.image.depth[0], 0.25f);
  }
}

TEST(Ids, AreTheDrawsOwnUnlessTheyAreOverridden) {
  constexpr std::uint32_t kPlate = 4294967294u;
  SmallScene scene({3, 1});
  scene.rect({0, 0}, {1, 1}, 0.5, kRed);
  scene.rect({1, 0}, {2, 1}, 0.5, kRed).primitive_id = kPlate;
  Draw& both = scene.rect({2, 0}, {3, 1}, 0.5, kRed);
  both.draw_id = 77;
  both.primitive_id = kPlate;
  scene.render();
  EXPECT_EQ(scene.image.ids, (PixelPlane<Ids>{{0, 0}, {1, kPlate}, {77, kPlate}}));
}

TEST(Ids, CountPrimitivesAsTheDrawHasThemEvenIfSomeAreNotDrawn) {
  // Quad 0 lies outside, quad 1 has no area, quad 2 covers the pixel.
  SmallScene scene = one_pixel();
  scene.window(Topology::quads, {{5, 5, 0},
                                 {6, 5, 0},
                                 {6, 6, 0},
                                 {5, 6, 0},
                                 {0, 0, 0},
                                 {0, 0, 0},
                                 {0, 0, 0},
                                 {0, 0, 0},
                                 {0, 0, 0},
                                 {1, 0, 0},
                                 {1, 1, 0},
                                 {0, 1, 0}});
  scene.render();
  EXPECT_EQ(scene.image.ids[0], (Ids{0, 2}));
}

}  // namespace
}  // namespace lode::raster::test

// Counters of one render, each derived by hand.
#include <limits>

#include "small_scene.h"

namespace lode::raster::test {
namespace {

constexpr glm::vec4 kRed{255, 0, 0, 255}, kBlue{0, 0, 255, 255};
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// A draw as DrawStats sees it.
struct Count {
  std::uint64_t covered, visible;
  friend bool operator==(const Count&, const Count&) = default;
};
std::ostream& operator<<(std::ostream& out, const Count& c) {
  return out << c.covered << " covered, " << c.visible << " visible";
}

std::vector<Count> counts_of(SmallScene& scene) {
  std::vector<DrawStats> stats(scene.draws.size(), {12345, 12345});  // whatever was there is overwritten
  scene.render({.threads = 1, .per_draw = stats});
  std::vector<Count> counts;
  for (const DrawStats& s : stats) counts.push_back({s.covered, s.visible});
  return counts;
}

TEST(DrawStats, CountSamplesAfterTheAlphaTestAndSamplesOwnedAtTheEnd) {
  SmallScene scene({4, 4});
  scene.rect({0, 0}, {4, 4}, 0.25, kBlue);                          // 16 covered; loses 4 to draw 1
  scene.rect({1, 1}, {3, 3}, 0.5, kRed);                            // 4 covered, 4 owned
  scene.rect({0, 0}, {4, 1}, 0.125, kRed);                          // 4 covered, all hidden by draw 0
  scene.rect({0, 0}, {4, 4}, 0.9, {0, 0, 0, 1}).alpha_test = 0.5f;  // all 16 fail the alpha test
  scene.rect({3, 3}, {9, 9}, 0.5, kRed);                            // 1 sample in the target, owned
  EXPECT_EQ(counts_of(scene), (std::vector<Count>{{16, 11}, {4, 4}, {4, 0}, {0, 0}, {1, 1}}));
}

TEST(DrawStats, CountSamplesThatPassedTheDepthTestForDrawsThatBlendOrWriteNoDepth) {
  SmallScene scene({4, 4});
  scene.rect({0, 0}, {4, 2}, 0.5, kBlue);                      // 8 covered, 8 owned: what follows writes no depth
  scene.rect({0, 0}, {4, 4}, 0.25, kRed).blend = Blend::add;   // 16 covered, 8 hidden
  scene.rect({0, 0}, {4, 4}, 0.75, kRed).blend = Blend::over;  // 16 covered, 16 passed
  scene.rect({0, 1}, {4, 4}, 0.75, kRed).depth_write = false;  // 12 covered, 12 passed
  Draw& untested = scene.rect({0, 3}, {4, 4}, 0.0, kRed);      // 4 covered, 4 passed without a test
  untested.depth_test = false;
  untested.depth_write = false;
  EXPECT_EQ(counts_of(scene), (std::vector<Count>{{8, 8}, {16, 8}, {16, 16}, {12, 12}, {4, 4}}));
}

TEST(DrawStats, GiveASampleToTheOpaqueOrderedDrawThatLastWroteItsDepth) {
  SmallScene scene({4, 1});
  scene.rect({0, 0}, {4, 1}, 0.5, kBlue);  // 4 covered, 2 left
  Draw& untested = scene.rect({1, 0}, {3, 1}, 0.25, kRed);
  untested.depth_test = false;  // 2 covered, 2 owned
  EXPECT_EQ(counts_of(scene), (std::vector<Count>{{4, 2}, {2, 2}}));
}

TEST(DrawStats, CountByTheDrawsPlaceInTheFrameNotByItsId) {
  SmallScene scene({2, 1});
  scene.rect({0, 0}, {1, 1}, 0.5, kBlue).draw_id = 1;
  scene.rect({0, 0}, {2, 1}, 0.25, kRed).draw_id = 0;
  EXPECT_EQ(counts_of(scene), (std::vector<Count>{{1, 1}, {2, 1}}));
}

TEST(DrawStats, AreZeroedForATargetWithoutPixels) {
  SmallScene scene({0, 4});
  scene.rect({0, 0}, {1, 1}, 0.5, kBlue);
  EXPECT_EQ(counts_of(scene), (std::vector<Count>{{0, 0}}));
}

// A 16×16 target of 8-px tiles. "in" counts triangles, two for each quad.
//   draw 0  quad on [0, 8)²: 2 in, 2 pieces, tile (0, 0); 64 fragments
//   draw 1  quad on [4, 12) × [0, 4) behind it: 2 in, 2 pieces, tiles (0, 0) and (1, 0); 32 fragments, 16 of them
//   hidden draw 2  quad on [0, 16) × [14, 16), alpha 0: 2 in, 2 pieces, tiles (0, 1) and (1, 1); 32 fragments shaded
//   for the
//           alpha test, all fail
//   draw 3  blended quad on [0, 8) × [0, 2), in front of everything: 2 in, 2 pieces; 16 fragments shaded and blended
//   draw 4  blended quad on [0, 2)², behind draw 0: 2 in, 2 pieces; 4 fragments hidden, not shaded
//   draw 5  triangles: one with a NaN, one without area, one clockwise on screen and so culled
// Shaded: 64 + 16 visible opaque samples once each, 32 for the alpha test, 16 blended.
TEST(FrameStats, CountAWindowSpaceFrame) {
  SmallScene scene({16, 16});
  scene.rect({0, 0}, {8, 8}, 0.5, kBlue);
  scene.rect({4, 0}, {12, 4}, 0.25, kRed);
  scene.rect({0, 14}, {16, 16}, 0.75, {0, 0, 0, 0}).alpha_test = 0.5f;
  scene.rect({0, 0}, {8, 2}, 0.75, {9, 9, 9, 9}).blend = Blend::over;
  scene.rect({0, 0}, {2, 2}, 0.25, {9, 9, 9, 9}).blend = Blend::add;
  scene
      .window(Topology::triangles, {{0, 0, kNan},
                                    {9, 0, 0},
                                    {0, 9, 0},  // not finite
                                    {1, 1, 0},
                                    {5, 5, 0},
                                    {9, 9, 0},  // empty
                                    {0, 0, 0},
                                    {9, 0, 0},
                                    {0, 9, 0}})
      .cull = Cull::back;
  FrameStats expected;
  expected.draws_in = 6;
  expected.draws_ordered = 2;
  expected.primitives_in = 13;
  expected.primitives_not_finite = 1;
  expected.primitives_facing = 1;
  expected.primitives_empty = 1;
  expected.pieces = 10;
  expected.tiles = 4;
  expected.fragments_covered = 64 + 32 + 32 + 16 + 4;
  expected.fragments_alpha_failed = 32;
  expected.fragments_depth_failed = 16 + 4;
  expected.fragments_shaded = 64 + 16 + 32 + 16;
  expected.fragments_blended = 16;
  EXPECT_EQ(text_of(scene.render({.threads = 1, .tile_size_px = 8, .pipeline = Pipeline::reference})), text_of(expected));
}

// The same in clip space, 8×8 pixels, depth z/w, near plane z = w:
//   triangle 0  the lower left half, z = ½. The diagonal is a right edge, so row r has r samples: 28
//   triangle 1  the same with z = y + 1: cut at the near plane half way up, a quad of 2 pieces is left. Rows 4 to 7:
//               22 samples. z is 2 − (2r + 1)/8 in row r: in front of ½ in rows 4 and 5, behind it in 6 and 7 (13)
//   triangle 2  all corners beyond the near plane: outside
//   triangle 3  all corners behind the eye: outside
//   triangle 4  triangle 0 clockwise: kept, as nothing is culled; 28 samples, all hidden
TEST(FrameStats, CountAClipSpaceFrame) {
  SmallScene scene({8, 8});
  scene.clip(Topology::triangles, {{-1, -1, 0.5, 1},
                                   {1, -1, 0.5, 1},
                                   {-1, 1, 0.5, 1},
                                   {-1, -1, 0, 1},
                                   {1, -1, 0, 1},
                                   {-1, 1, 2, 1},
                                   {-1, -1, 2, 1},
                                   {1, -1, 2, 1},
                                   {-1, 1, 2, 1},
                                   {-1, -1, -0.5, -1},
                                   {1, -1, -0.5, -1},
                                   {-1, 1, -0.5, -1},
                                   {-1, 1, 0.5, 1},
                                   {1, -1, 0.5, 1},
                                   {-1, -1, 0.5, 1}});
  FrameStats expected;
  expected.draws_in = 1;
  expected.primitives_in = 5;
  expected.primitives_outside = 2;
  expected.primitives_clipped = 1;
  expected.pieces = 4;
  expected.tiles = 1;
  expected.fragments_covered = 28 + 22 + 28;
  expected.fragments_depth_failed = 13 + 28;
  expected.fragments_shaded = 28;
  EXPECT_EQ(text_of(scene.render({.threads = 1, .tile_size_px = 8, .pipeline = Pipeline::reference})), text_of(expected));
}

// 8 × 8 samples of a bilinear texture read 4 texels each, those of an untextured draw none; a nearest one reads 1.
TEST(FrameStats, CountTexelsThatTheFilterFetched) {
  const std::vector<glm::u8vec4> texels(4, glm::u8vec4(255));
  const Texture texture = make_raw_texture({2, 2}, texels, Mips::none);
  for (const Filter filter : {Filter::nearest, Filter::bilinear}) {
    SmallScene scene({8, 8});
    Draw& draw = scene.rect({0, 0}, {8, 8}, 0.5, kRed);
    draw.uvs = scene.keep<glm::vec2>({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    draw.texture = &texture;
    draw.sampler.filter = filter;
    scene.rect({0, 0}, {4, 4}, 0.25, kBlue);
    EXPECT_EQ(scene.render().texels_read, filter == Filter::nearest ? 64u : 256u);
  }
}

TEST(FrameStats, CountNoShadingWithoutAColourPlaneExceptForAlphaTests) {
  SmallScene scene({4, 4}, ColorFormat::rgba8, {.color = false});
  scene.rect({0, 0}, {4, 4}, 0.5, kRed);
  scene.rect({0, 0}, {2, 2}, 0.75, kRed).alpha_test = 0.5f;
  scene.rect({0, 0}, {1, 1}, 0.875, kRed).blend = Blend::over;
  const FrameStats stats = scene.render();
  EXPECT_EQ(stats.fragments_shaded, 4u);
  EXPECT_EQ(stats.fragments_blended, 0u);
  EXPECT_EQ(ids_picture(scene.image), "BBAA\nBBAA\nAAAA\nAAAA\n");
}

// Every sample position counts anew; tiles do not.
TEST(FrameStats, CountFragmentsOfEverySamplePosition) {
  SmallScene scene({4, 4}, ColorFormat::rgba8, {.color = true, .depth = false, .ids = false});
  const glm::ivec2 samples[] = {{64, 64}, {192, 64}, {128, 192}};
  scene.frame.samples_fx8 = samples;
  scene.rect({1, 1}, {3, 3}, 0.5, kRed);
  const FrameStats stats = scene.render();
  EXPECT_EQ(stats.fragments_covered, 12u);
  EXPECT_EQ(stats.fragments_shaded, 12u);
  EXPECT_EQ(stats.pieces, 2u);
  EXPECT_EQ(stats.tiles, 1u);
}

TEST(FrameStats, CountDrawsAndPrimitivesForATargetWithoutPixels) {
  SmallScene scene({4, 0});
  scene.rect({0, 0}, {1, 1}, 0.5, kBlue);
  scene.rect({0, 0}, {1, 1}, 0.5, kBlue).blend = Blend::over;
  const FrameStats stats = scene.render();
  EXPECT_EQ(stats.draws_in, 2u);
  EXPECT_EQ(stats.draws_ordered, 1u);
  EXPECT_EQ(stats.primitives_in, 4u);
  EXPECT_EQ(stats.fragments_covered, 0u);
}

}  // namespace
}  // namespace lode::raster::test

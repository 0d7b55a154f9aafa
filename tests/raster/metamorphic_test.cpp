// What may be changed without a bit of the picture changing (notes/numerics.md, stress counts), a few thousand cases each;
// metamorphic_stress.cpp has the large counts.

#include <gtest/gtest.h>

#include "metamorphic_cases.h"

namespace lode::raster {
namespace {

using namespace test;

void expect_no_difference(int (*wrong)(std::uint64_t), std::uint64_t n_cases) {
  for (std::uint64_t seed = 0; seed < n_cases; ++seed) ASSERT_EQ(wrong(seed), 0) << "seed " << seed;
}

TEST(Metamorphic, PicturesOfTheCasesAreNotEmpty) {
  int n_drawn = 0, n_cut = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    HashedNumbers random(seed);
    const Picture picture = random_picture(random, 24);
    Image image = make_image(picture.size_px, ColorFormat::rgba32f);
    const FrameStats stats = render_by_both(frame_of(picture.draws), image);
    n_drawn += std::any_of(image.ids.begin(), image.ids.end(), [](const Ids& ids) { return ids.draw != kNoId; });
    n_cut += stats.primitives_clipped > 0;
  }
  EXPECT_GT(n_drawn, 80);
  EXPECT_GT(n_cut, 30);
}

TEST(Metamorphic, RotatingATrianglesVerticesChangesNoBit) { expect_no_difference(wrong_after_rotation, 1500); }
TEST(Metamorphic, TurningATriangleOverWithoutCullingChangesNoBit) { expect_no_difference(wrong_after_turning, 1500); }
TEST(Metamorphic, TileSizeAndThreadsChangeNoBit) { expect_no_difference(wrong_in_tiles_and_threads, 300); }
TEST(Metamorphic, ACropIsAPartOfThePicture) { expect_no_difference(wrong_in_crop, 1500); }
TEST(Metamorphic, TheOrderOfOrderFreeDrawsChangesNoBit) { expect_no_difference(wrong_in_another_order, 1500); }
TEST(Metamorphic, AScissorLeavesAPartOfThePicture) { expect_no_difference(wrong_in_scissor, 1500); }
TEST(Metamorphic, SamplesAreCentresOfAMovedPicture) { expect_no_difference(wrong_in_samples, 1000); }
TEST(Metamorphic, TranslatingByWholePixelsMovesThePicture) { expect_no_difference(wrong_after_translation, 2000); }
TEST(Metamorphic, MirroringMirrorsCoverageButForTheFillRulesSide) {
  expect_no_difference(wrong_after_mirroring, 10'000);
}
TEST(Metamorphic, SplittingOnTheGridCoversTheSameSamplesOnce) { expect_no_difference(wrong_after_splitting, 10'000); }

// A coarse crop case by hand: the triangle's vertices are ties of the snap in a target of 16384 px, and a little more.
TEST(Metamorphic, ACropOfALargeTargetSnapsAlike) {
  const double tie = (0.5 + 0x1p-36) / 0x1p21;  // half a sub-pixel right of the middle
  const std::vector<glm::dvec4> p = {
      {tie, tie, 0.5, 1.0}, {tie + 64.0 / 8192.0, tie, 0.5, 1.0}, {tie, tie - 64.0 / 8192.0, 0.5, 1.0}};
  const Draw draw = triangles_of(ClipVertices{p});
  Frame frame = frame_of(draw);
  const auto corners_at = [&](glm::ivec2 origin) {
    frame.viewport = Rect{origin, {16384, 16384}};
    const reference::Assembly assembly = reference::assemble(frame, {16384, 16384}, 1);
    return std::get<reference::Triangle>(assembly.pieces.at(0).shape).v;
  };
  const auto whole = corners_at({0, 0}), crop = corners_at({-8000, -8000});
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(whole[i].p_fx8 - glm::ivec2(8000 * 256), crop[i].p_fx8);
}

// Ordered draws do depend on the order: "over" in submission order, draw by draw and triangle by triangle.
TEST(Metamorphic, BlendedTrianglesAreDrawnInSubmissionOrder) {
  const std::vector<glm::dvec3> full = {{-8, -8, 0.5}, {40, -8, 0.5}, {-8, 40, 0.5}};
  std::vector<glm::dvec3> twice = full;
  twice.insert(twice.end(), full.begin(), full.end());
  const std::vector<glm::vec4> colors = {{1, 0, 0, 1}, {1, 0, 0, 1}, {1, 0, 0, 1},
                                         {0, 1, 0, 1}, {0, 1, 0, 1}, {0, 1, 0, 1}};
  std::array<Draw, 2> draws = {triangles_of(WindowVertices{twice}), triangles_of(WindowVertices{full})};
  for (Draw& draw : draws) {
    draw.blend = Blend::over;
    draw.depth_test = false;
  }
  draws[0].colors = colors;
  draws[1].color = glm::vec4(0.0f, 0.0f, 0.5f, 0.5f);
  const Image image = rendered(frame_of(draws), {16, 16}, workers_and_tiles(2, 8));
  for (const glm::vec4& c : image.rgba32f) ASSERT_EQ(c, glm::vec4(0.0f, 0.5f, 0.5f, 1.0f));
}

}  // namespace
}  // namespace lode::raster

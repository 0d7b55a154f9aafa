// What explain_pixel says of a pixel is what render did to it.
#include "raster/explain.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "everything.h"
#include "raster/error.h"

namespace lode::raster::test {
namespace {

constexpr glm::vec4 kRed(255, 0, 0, 255), kGreen(0, 255, 0, 255);

PixelExplanation explain(SmallScene& scene, glm::ivec2 pixel) {
  scene.frame.draws = scene.draws;
  return explain_pixel(scene.frame, scene.image.size_px, scene.image.format, pixel, 1);
}

/// Pieces of a draw in the only sample, in the order of the explanation.
std::vector<ExplainedPiece> pieces_of(const PixelExplanation& explanation, std::uint32_t draw) {
  std::vector<ExplainedPiece> pieces;
  for (const ExplainedPiece& piece : explanation.samples.at(0).pieces) {
    if (piece.draw == draw) pieces.push_back(piece);
  }
  return pieces;
}
std::vector<Fate> fates_of(const PixelExplanation& explanation, std::uint32_t draw) {
  std::vector<Fate> fates;
  for (const ExplainedPiece& piece : pieces_of(explanation, draw)) fates.push_back(piece.fate);
  return fates;
}

/// Every claim that can be checked against the picture.
void expect_agreement(const SmallScene& scene, const PixelExplanation& e, glm::ivec2 pixel) {
  const auto i = std::size_t(pixel.y * scene.image.size_px.x + pixel.x);
  const bool bytes = scene.image.format == ColorFormat::rgba8;
  const glm::vec4 color = bytes ? glm::vec4(scene.image.rgba8[i]) : scene.image.rgba32f[i];
  ASSERT_TRUE(std::memcmp(&e.color, &color, sizeof color) == 0) << pixel.x << "," << pixel.y;
  if (e.samples.size() > 1) return;
  const ExplainedSample& sample = e.samples[0];
  ASSERT_EQ(sample.ids, scene.image.ids[i]) << pixel.x << "," << pixel.y;
  ASSERT_EQ(sample.depth, scene.image.depth[i]) << pixel.x << "," << pixel.y;
  glm::vec4 before = bytes ? glm::vec4(glm::u8vec4(scene.frame.clear + 0.5f)) : scene.frame.clear;
  for (const ExplainedPiece& piece : sample.pieces) {
    if (!piece.after) continue;
    ASSERT_EQ(*piece.before, before) << "colours follow one another";
    before = *piece.after;
  }
  ASSERT_EQ(before, sample.color);
}

/// Weights of the texels read, and their weighted sum as far from the filtered texel as one rounding can be.
void expect_texels_add_up(const SmallScene& scene, const ExplainedPiece& piece) {
  if (!piece.lookup || !piece.color) return;
  const Draw& draw = scene.draws[piece.draw];
  glm::dvec4 sum(0.0);
  double weights = 0.0;
  for (const TexelRead& read : piece.lookup->reads) {
    const TextureLevel& level = draw.texture->levels.at(std::size_t(read.level));
    weights += read.weight;
    if (read.texel.x < 0 || read.texel.y < 0) continue;  // the border is 0
    sum += read.weight * glm::dvec4(level.raw.at(std::size_t(read.texel.y * level.size_px.x + read.texel.x)));
  }
  ASSERT_NEAR(weights, 1.0, 1e-12);
  const double full = scene.image.format == ColorFormat::rgba8 ? 1.0 : 255.0;
  for (int c = 0; c < 4; ++c) ASSERT_NEAR(sum[c], piece.color->texel[c] * full, 0.5001);
}

class ExplainEverything : public testing::TestWithParam<ColorFormat> {};

TEST_P(ExplainEverything, AgreesWithThePictureInEveryPixel) {
  SmallScene scene({48, 32}, GetParam());
  add_everything(scene);
  scene.render();
  for (int y = 0; y < 32; ++y) {
    for (int x = 0; x < 48; ++x) {
      const PixelExplanation e = explain(scene, {x, y});
      ASSERT_NO_FATAL_FAILURE(expect_agreement(scene, e, {x, y}));
      for (const ExplainedPiece& piece : e.samples[0].pieces) {
        ASSERT_NO_FATAL_FAILURE(expect_texels_add_up(scene, piece));
      }
    }
  }
}

TEST_P(ExplainEverything, AgreesWithTheAverageOfSeveralSamples) {
  SmallScene scene({40, 24}, GetParam(), {.color = true, .depth = false, .ids = false});
  add_everything(scene);
  const glm::ivec2 samples[] = {{32, 96}, {160, 200}, {255, 0}};
  scene.frame.samples_fx8 = samples;
  scene.render();
  for (int k = 0; k < 240; ++k) {
    const glm::ivec2 pixel = {(k * 7) % 40, k / 10};
    const PixelExplanation e = explain(scene, pixel);
    ASSERT_EQ(e.samples.size(), 3u);
    ASSERT_NO_FATAL_FAILURE(expect_agreement(scene, e, pixel));
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, ExplainEverything, testing::Values(ColorFormat::rgba8, ColorFormat::rgba32f));

TEST(Explain, CountsWhatTheFrameDiscards) {
  SmallScene scene({48, 32});
  add_everything(scene);
  const FrameStats stats = scene.render();
  const FrameStats counted = explain(scene, {0, 0}).discarded;
  EXPECT_EQ(counted.primitives_in, stats.primitives_in);
  EXPECT_EQ(counted.primitives_not_finite, stats.primitives_not_finite);
  EXPECT_EQ(counted.primitives_outside, stats.primitives_outside);
  EXPECT_EQ(counted.primitives_facing, stats.primitives_facing);
  EXPECT_EQ(counted.primitives_empty, stats.primitives_empty);
}

TEST(Explain, EdgeValuesAreExactAndTellWhoOwnsASharedEdge) {
  // The sample of pixel (2, 2) of a 4 x 4 square, at (640, 640), lies on its diagonal from (0, 0) to (1024, 1024). The
  // upper right triangle, walked clockwise on screen, walks it upwards: its left edge, so that it has the sample.
  SmallScene scene({4, 4});
  scene.rect({0, 0}, {4, 4}, 0.5, kRed);  // triangles 0 1 2 (upper right) and 0 2 3 (lower left)
  const std::vector<ExplainedPiece> pieces = pieces_of(explain(scene, {2, 2}), 0);
  ASSERT_EQ(pieces.size(), 2u);
  EXPECT_EQ(pieces[0].fate, Fate::shown);
  EXPECT_EQ(pieces[1].fate, Fate::not_covered);
  for (const ExplainedPiece& piece : pieces) {
    ASSERT_EQ(piece.edges.size(), 3u);
    int on_edge = 0;
    std::int64_t sum = 0;
    for (const ExplainedEdge& edge : piece.edges) {
      const std::int64_t e = std::int64_t(edge.b_fx8.x - edge.a_fx8.x) * (640 - edge.a_fx8.y) -
                             std::int64_t(edge.b_fx8.y - edge.a_fx8.y) * (640 - edge.a_fx8.x);
      EXPECT_EQ(edge.value, e);
      sum += e;
      if (edge.value != 0) continue;
      ++on_edge;
      EXPECT_EQ(edge.top_left, piece.fate == Fate::shown);
    }
    EXPECT_EQ(on_edge, 1);
    EXPECT_EQ(sum, 1024 * 1024);  // the doubled area
  }
}

TEST(Explain, NearerHidesAndEqualDepthGoesToTheLowerKey) {
  SmallScene scene({1, 1});
  scene.rect({0, 0}, {1, 1}, 0.25, kRed);
  scene.rect({0, 0}, {1, 1}, 0.75, kGreen).draw_id = 9;
  scene.rect({0, 0}, {1, 1}, 0.75, kRed);
  const PixelExplanation e = explain(scene, {0, 0});
  std::vector<std::uint32_t> order;
  for (const ExplainedPiece& piece : e.samples[0].pieces) {
    if (piece.fate == Fate::shown || piece.fate == Fate::hidden) order.push_back(piece.draw);
  }
  EXPECT_EQ(order, (std::vector<std::uint32_t>{2, 1, 0}));  // key 2 comes before key 9
  EXPECT_EQ(e.samples[0].ids.draw, 2u);
}

TEST(Explain, OrderedDrawsAreToldOneAfterTheOther) {
  SmallScene scene({1, 1});
  scene.frame.clear = {0, 0, 0, 255};
  scene.rect({0, 0}, {1, 1}, 0.5, kRed);
  for (const double z : {0.6, 0.4, 0.5}) {
    scene.rect({0, 0}, {1, 1}, z, {0, 0, 100, 128}).blend = Blend::over;
  }
  const PixelExplanation e = explain(scene, {0, 0});
  EXPECT_THAT(fates_of(e, 1), testing::Contains(Fate::drawn));
  EXPECT_THAT(fates_of(e, 2), testing::Contains(Fate::behind));
  EXPECT_THAT(fates_of(e, 3), testing::Contains(Fate::behind));  // equal is not strictly nearer
  const ExplainedPiece over = pieces_of(e, 1)[0];
  EXPECT_EQ(*over.before, kRed);
  EXPECT_EQ(*over.after, glm::vec4(127, 0, 100, 255));  // 255 · (255 − 128)/255
  EXPECT_EQ(*over.depth_before, 0.5f);
}

TEST(Explain, WhatIsDroppedHasItsTest) {
  SmallScene scene({4, 4});
  const auto triangle = [&](double z, double w) {  // large, counter-clockwise
    return std::vector<glm::dvec4>{{-5 * w, -5 * w, z, w}, {5 * w, -5 * w, z, w}, {0, 9 * w, z, w}};
  };
  scene.clip(Topology::triangles, triangle(0.5, 1)).cull = Cull::front;              // 0
  scene.clip(Topology::triangles, triangle(1.5, 1));                                 // 1: nearer than near
  scene.clip(Topology::triangles, triangle(-0.5, 1));                                // 2: beyond far
  scene.clip(Topology::triangles, triangle(0.5, 1)).scissor = Rect{{0, 0}, {1, 4}};  // 3
  Draw& faint = scene.clip(Topology::triangles, triangle(0.5, 1));                   // 4
  faint.color = glm::vec4(255, 255, 255, 127);
  faint.alpha_test = 0.5;
  scene.window(Topology::triangles, {{2.1, 2.1, 0.5}, {2.4, 2.4, 0.5}, {2.9, 2.9, 0.5}});  // 5: no area
  scene.window(Topology::triangles, {{2, 2, 0.5}, {2, 3, 0.5}, {2.9, 2, 0.5}});            // 6: misses the sample
  scene.clip(Topology::triangles, {{-5, -5, 3, 1}, {5, -5, 3, 1}, {0, 9, -0.5, 1}});       // 7: cut, part is left
  const PixelExplanation e = explain(scene, {2, 2});
  using testing::ElementsAre;
  EXPECT_THAT(fates_of(e, 0), ElementsAre(Fate::facing));
  EXPECT_THAT(fates_of(e, 1), ElementsAre(Fate::near_clipped));
  EXPECT_THAT(fates_of(e, 2), ElementsAre(Fate::far_clipped));
  EXPECT_THAT(fates_of(e, 3), ElementsAre(Fate::scissored));
  EXPECT_THAT(fates_of(e, 4), ElementsAre(Fate::alpha_failed));
  EXPECT_THAT(fates_of(e, 5), ElementsAre(Fate::empty));
  EXPECT_THAT(fates_of(e, 6), ElementsAre(Fate::not_covered));
  EXPECT_THAT(fates_of(e, 7), testing::Contains(Fate::near_clipped));
  EXPECT_EQ(e.samples[0].ids.draw, kNoId);
}

TEST(Explain, APixelOutsideAndAFrameThatIsNoneAreBadInput) {
  SmallScene scene({4, 3});
  for (const glm::ivec2 pixel : {glm::ivec2(-1, 0), {4, 0}, {0, 3}}) EXPECT_THROW(explain(scene, pixel), Error);
  scene.window(Topology::triangles, {{0, 0, 0}});
  EXPECT_THROW(explain(scene, {0, 0}), Error);
}

}  // namespace
}  // namespace lode::raster::test

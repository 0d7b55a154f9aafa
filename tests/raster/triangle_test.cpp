// The fill rule (C3): pictures first, then the 128-bit oracle, then what must not matter.

#include <gmpxx.h>
#include <gtest/gtest.h>

#include "coverage_count.h"
#include "frames.h"
#include "raster/reference/assemble.h"

namespace lode::raster {
namespace {

using namespace test;
using reference::PixelBox;

using CornersPx = std::array<glm::dvec2, 3>;

/// Renders triangles given in window pixels: the letter of the triangle that covers a sample, '!' where several do.
std::string picture(glm::ivec2 size_px, const std::vector<CornersPx>& triangles, Cull cull = Cull::none,
                    const RenderOptions& options = {}) {
  std::vector<glm::dvec3> positions;
  for (const CornersPx& t : triangles) {
    for (const glm::dvec2& p : t) positions.push_back({p, 0.5});
  }
  const auto count_and_number = [](const Pixel& p) { return glm::vec4(1.0f, float(p.primitive), 0.0f, 0.0f); };
  Draw draw = triangles_of(WindowVertices{positions});
  draw.shader = pixel_shader(count_and_number);
  draw.cull = cull;
  draw.blend = Blend::add;
  draw.depth_test = false;
  Image image = make_image(size_px, ColorFormat::rgba32f, {.color = true, .depth = false, .ids = false});
  render_by_both(frame_of(draw), image, options);
  std::string rows;
  for (std::size_t i = 0; i < image.rgba32f.size(); ++i) {
    const float n = image.rgba32f[i].r;
    rows += n == 0.0f ? '.' : (n == 1.0f ? char('a' + int(image.rgba32f[i].g)) : '!');
    if ((i + 1) % std::size_t(size_px.x) == 0) rows += '\n';
  }
  return rows;
}

// ---- Pictures. Sample centres are at n + 0.5.

TEST(TriangleFillRule, TopAndLeftEdgesThroughCentresAreInside) {
  EXPECT_EQ(picture({6, 5}, {{{{0.5, 0.5}, {4.5, 0.5}, {0.5, 4.5}}}}),
            "aaaa..\n"
            "aaa...\n"
            "aa....\n"
            "a.....\n"
            "......\n");
}

TEST(TriangleFillRule, BottomAndRightEdgesThroughCentresAreOutside) {
  EXPECT_EQ(picture({6, 5}, {{{{4.5, 0.5}, {4.5, 4.5}, {0.5, 4.5}}}}),
            "......\n"
            "...a..\n"
            "..aa..\n"
            ".aaa..\n"
            "......\n");
}

TEST(TriangleFillRule, ASlantedRightEdgeThroughCentresIsOutside) {
  EXPECT_EQ(picture({6, 5}, {{{{0.5, 0.5}, {4.5, 4.5}, {0.5, 4.5}}}}),
            "......\n"
            "a.....\n"
            "aa....\n"
            "aaa...\n"
            "......\n");
}

TEST(TriangleFillRule, ASlantedLeftEdgeThroughCentresIsInside) {
  EXPECT_EQ(picture({6, 5}, {{{{0.5, 0.5}, {4.5, 0.5}, {4.5, 4.5}}}}),
            "aaaa..\n"
            ".aaa..\n"
            "..aa..\n"
            "...a..\n"
            "......\n");
}

TEST(TriangleFillRule, AnEdgeSharedThroughCentresBelongsToTheTriangleItIsTheLeftEdgeOf) {
  EXPECT_EQ(picture({5, 4}, {{{{0.5, 0.5}, {3.5, 0.5}, {3.5, 3.5}}}, {{{0.5, 0.5}, {3.5, 3.5}, {0.5, 3.5}}}}),
            "aaa..\n"
            "baa..\n"
            "bba..\n"
            ".....\n");
}

TEST(TriangleFillRule, AHorizontalEdgeSharedThroughCentresBelongsToTheTriangleBelow) {
  EXPECT_EQ(
      picture({5, 5}, {{{{0.5, 2.5}, {4.5, 2.5}, {2.5, 0.5}}}, {{{0.5, 2.5}, {4.5, 2.5}, {2.5, 4.5}}}}),
      ".....\n"  // both slanted edges meet in the centre of (2, 0): the displaced sample is right of the right one
      ".aa..\n"
      "bbbb.\n"
      ".bb..\n"
      ".....\n");
}

// Eight triangles around the centre of pixel (2, 2), clockwise from the one between east and south-east. A sample on
// an edge goes to what lies to its right; on the two horizontal edges, to what lies below.
TEST(TriangleFillRule, SamplesOnAFansEdgesAndSharedVertexBelongToExactlyOneTriangle) {
  const glm::dvec2 m{2.5, 2.5};
  const glm::dvec2 ring[] = {{4.5, 2.5}, {4.5, 4.5}, {2.5, 4.5}, {0.5, 4.5},
                             {0.5, 2.5}, {0.5, 0.5}, {2.5, 0.5}, {4.5, 0.5}};
  std::vector<CornersPx> fan;
  for (std::size_t i = 0; i < 8; ++i) fan.push_back({m, ring[i], ring[(i + 1) % 8]});
  EXPECT_EQ(picture({5, 5}, fan),
            "ffgg.\n"
            "efgh.\n"
            "ddaa.\n"
            "dcba.\n"
            ".....\n");
}

TEST(TriangleFillRule, ATriangleSmallerThanAPixelCoversItOnlyIfTheCentreIsInside) {
  EXPECT_EQ(picture({3, 1}, {{{{1.25, 0.25}, {1.75, 0.25}, {1.5, 0.75}}}}), ".a.\n");
  EXPECT_EQ(picture({3, 1}, {{{{1.0, 0.0}, {1.4, 0.0}, {1.2, 0.9}}}}), "...\n");
}

// One sub-pixel wide and high, a corner or an edge in the centre (0.5, 0.5) of the first pixel.
TEST(TriangleFillRule, TheSmallestTriangleCoversACentreThatIsItsTopLeftCornerOnly) {
  const double e = 1.0 / 256.0, c = 0.5;
  EXPECT_EQ(picture({1, 1}, {{{{c, c}, {c + e, c}, {c, c + e}}}}), "a\n");
  EXPECT_EQ(picture({1, 1}, {{{{c, c}, {c - e, c}, {c, c + e}}}}), ".\n");
  EXPECT_EQ(picture({1, 1}, {{{{c, c}, {c + e, c}, {c, c - e}}}}), ".\n");
  EXPECT_EQ(picture({1, 1}, {{{{c, c}, {c - e, c}, {c, c - e}}}}), ".\n");
  EXPECT_EQ(picture({1, 1}, {{{{c, c}, {c + e, c}, {c + e, c + e}}}}), "a\n");
  EXPECT_EQ(picture({1, 1}, {{{{c, c}, {c, c + e}, {c + e, c + e}}}}), ".\n");
}

TEST(TriangleFillRule, ASliverOneSubPixelHighCoversARowIfItsTopEdgeRunsThroughTheCentres) {
  const double e = 1.0 / 256.0;
  EXPECT_EQ(picture({8, 2}, {{{{0.0, 0.5}, {8.0, 0.5}, {8.0, 0.5 + e}}}}), "aaaaaaaa\n........\n");
  EXPECT_EQ(picture({8, 2}, {{{{0.0, 0.5}, {8.0, 0.5}, {8.0, 0.5 - e}}}}), "........\n........\n");
  // The slanted edge crosses the row of centres at x = 4: right of it the sliver reaches below them.
  EXPECT_EQ(picture({8, 2}, {{{{0.0, 0.5 - e}, {8.0, 0.5 - e}, {8.0, 0.5 + e}}}}), "....aaaa\n........\n");
}

TEST(TriangleFillRule, AVerticalSliverOneSubPixelWideCoversAColumnIfItsLeftEdgeRunsThroughTheCentres) {
  const double e = 1.0 / 256.0;
  EXPECT_EQ(picture({2, 4}, {{{{0.5, 0.0}, {0.5, 4.0}, {0.5 + e, 4.0}}}}), "a.\na.\na.\na.\n");
  EXPECT_EQ(picture({2, 4}, {{{{0.5, 0.0}, {0.5, 4.0}, {0.5 - e, 4.0}}}}), "..\n..\n..\n..\n");
}

TEST(TriangleFillRule, TheWholeTargetIsCoveredUpToItsLastRowAndColumn) {
  EXPECT_EQ(picture({3, 2}, {{{{-9.0, -9.0}, {30.0, -9.0}, {-9.0, 30.0}}}}), "aaa\naaa\n");
}

TEST(TriangleFillRule, ZeroAreaCoversNothingAndIsCounted) {
  const std::vector<CornersPx> flat = {{{{0.5, 0.5}, {4.5, 4.5}, {2.5, 2.5}}},
                                       {{{0.5, 0.5}, {4.5, 0.5}, {4.5, 0.5}}},
                                       {{{1.5, 1.5}, {1.5, 1.5}, {1.5, 1.5}}},
                                       {{{0.5, 0.5}, {4.5, 0.5}, {2.5, 0.501}}}};  // 0.501 snaps to 0.5
  EXPECT_EQ(picture({5, 2}, flat), ".....\n.....\n");
  std::vector<glm::dvec3> positions;
  for (const CornersPx& t : flat) {
    for (const glm::dvec2& p : t) positions.push_back({p, 0.5});
  }
  const Draw draw = triangles_of(WindowVertices{positions});
  Image image = make_image({5, 5}, ColorFormat::rgba8);
  const FrameStats stats = render_by_both(frame_of(draw), image);
  EXPECT_EQ(stats.primitives_empty, 4u);
  EXPECT_EQ(stats.pieces, 0u);
}

TEST(TriangleFacing, FrontIsCounterClockwiseAsSeenAndEachCullModeKeepsItsSide) {
  const CornersPx clockwise = {{{0.0, 0.0}, {2.0, 0.0}, {0.0, 2.0}}};
  const CornersPx counter_clockwise = {{{0.0, 0.0}, {0.0, 2.0}, {2.0, 0.0}}};
  EXPECT_EQ(picture({2, 2}, {clockwise}, Cull::none), "a.\n..\n");
  EXPECT_EQ(picture({2, 2}, {clockwise}, Cull::back), "..\n..\n");
  EXPECT_EQ(picture({2, 2}, {clockwise}, Cull::front), "a.\n..\n");
  EXPECT_EQ(picture({2, 2}, {counter_clockwise}, Cull::none), "a.\n..\n");
  EXPECT_EQ(picture({2, 2}, {counter_clockwise}, Cull::back), "a.\n..\n");
  EXPECT_EQ(picture({2, 2}, {counter_clockwise}, Cull::front), "..\n..\n");
}

/// Counter-clockwise is +1; the exact sign of det(x, y, w) of three clip-space corners.
int exact_facing(const std::array<glm::dvec4, 3>& p) {
  const mpq_class ax(p[0].x), ay(p[0].y), aw(p[0].w), bx(p[1].x), by(p[1].y), bw(p[1].w), cx(p[2].x), cy(p[2].y),
      cw(p[2].w);
  return sgn(mpq_class(ax * (by * cw - cy * bw) - ay * (bx * cw - cx * bw) + aw * (bx * cy - cx * by)));
}

// Triangles of about a sub-pixel, which the snap often turns over (C3). Their determinants are far above the rounding
// of a double: the exact sign is the contract's.
TEST(TriangleFacing, CullingKeepsATriangleOnlyIfBothTheUnsnappedAndTheSnappedSignAllowIt) {
  HashedNumbers random(11);
  int turned_by_the_snap = 0;
  for (int i = 0; i < 4000; ++i) {
    const Rect viewport{{0, 0}, {64, 64}};
    const glm::dvec2 at{random.unit() * 1.8 - 0.9, random.unit() * 1.8 - 0.9};
    std::array<glm::dvec4, 3> corners;
    for (glm::dvec4& p : corners) {
      const double w = 0.5 + random.unit();
      p = {w * (at.x + random.unit() * 3e-4), w * (at.y + random.unit() * 3e-4), 0.25 * w, w};  // 0.01 px
    }
    const reference::Viewport window = reference::make_viewport(viewport);
    Corners snapped;
    for (std::size_t k = 0; k < 3; ++k) snapped[k] = reference::window_vertex(window, corners[k]).p_fx8;
    const std::int64_t area = doubled_area(snapped);
    const int facing = exact_facing(corners), snapped_facing = area < 0 ? 1 : (area > 0 ? -1 : 0);
    ASSERT_NE(facing, 0);
    if (facing * snapped_facing < 0) ++turned_by_the_snap;
    for (const Cull cull : {Cull::none, Cull::back, Cull::front}) {
      Draw draw = triangles_of(ClipVertices{corners});
      draw.cull = cull;
      Image image = make_image({64, 64}, ColorFormat::rgba8, {.color = false, .depth = false, .ids = true});
      const FrameStats stats =
          i < 40 ? render_by_both(frame_of(draw), image) : reference::assemble(frame_of(draw), {64, 64}, 1).stats;
      const int wanted = cull == Cull::back ? 1 : -1;
      const bool kept = snapped_facing != 0 && (cull == Cull::none || (facing == wanted && snapped_facing == wanted));
      ASSERT_EQ(stats.pieces, kept ? 1u : 0u) << "case " << i;
    }
  }
  EXPECT_GT(turned_by_the_snap, 50);
}

// ---- The oracle.

void expect_as_oracle(const Corners& t, const PixelBox& window) {
  CoverageCount count(window);
  count.add(t);
  int wrong = 0;
  count.for_each([&](glm::ivec2 px, int n) { wrong += n != int(covers(t, centre_of(px))); });
  ASSERT_EQ(wrong, 0) << to_string(t) << "\n" << count.picture();
}

TEST(TriangleCoverage, SmallTrianglesEqualThe128BitOracle) {
  HashedNumbers random(1);
  for (int i = 0; i < 20000; ++i) {
    const int limit_px = 1 << random.below(5);
    Corners t;
    for (glm::ivec2& p : t) p = random_point_fx8(random, limit_px) - glm::ivec2(256);
    expect_as_oracle(t, {{-2, -2}, {limit_px + 1, limit_px + 1}});
  }
}

// Up to the whole guard band: windows beside the corners and across the edges.
TEST(TriangleCoverage, LargeTrianglesEqualThe128BitOracle) {
  HashedNumbers random(2);
  for (int i = 0; i < 4000; ++i) {
    const int limit = 1 << (16 + random.below(8));
    Corners t;
    for (glm::ivec2& p : t) p = {random.between(-limit, limit), random.between(-limit, limit)};
    if (i % 8 == 0) t[random.below(3)] = {reference::kGuard_fx8, -reference::kGuard_fx8};
    const std::size_t k = random.below(3);
    const glm::dvec2 a(t[k]), b(t[(k + 1) % 3]);
    const glm::dvec2 near_px = (a + (b - a) * (i % 2 == 0 ? random.unit() : 0.0)) / 256.0;
    const glm::ivec2 begin = glm::ivec2(int(near_px.x), int(near_px.y)) - glm::ivec2(6);
    expect_as_oracle(t, {begin, begin + glm::ivec2(12)});
  }
}

TEST(TriangleCoverage, EverySamplePositionInThePixelEqualsTheOracle) {
  HashedNumbers random(3);
  const PixelBox window{{-2, -2}, {6, 6}};
  for (int i = 0; i < 3000; ++i) {
    const Corners t = {random_point_fx8(random, 4), random_point_fx8(random, 4), random_point_fx8(random, 4)};
    const glm::ivec2 sample{random.between(0, 255), random.between(0, 255)};
    const std::optional<reference::Triangle> triangle = triangle_of(t);
    if (!triangle) continue;
    int expected = 0, wrong = 0, visited = 0;
    for (int y = -2; y < 6; ++y) {
      for (int x = -2; x < 6; ++x) expected += covers(t, reference::sample_position_fx8({x, y}, sample));
    }
    reference::for_each_covered(*triangle, window, sample, [&](glm::ivec2 px) {
      ++visited;
      wrong += !covers(t, reference::sample_position_fx8(px, sample));
    });
    ASSERT_EQ(visited, expected) << to_string(t);
    ASSERT_EQ(wrong, 0) << to_string(t);
  }
}

// ---- What must not matter.

TEST(TriangleCoverage, IsTheSameForEveryOrderOfTheCorners) {
  HashedNumbers random(4);
  for (int i = 0; i < 3000; ++i) {
    Corners t = {random_point_fx8(random, 8), random_point_fx8(random, 8), random_point_fx8(random, 8)};
    CoverageCount count({{0, 0}, {8, 8}});
    count.add(t);
    const std::string first = count.picture();
    constexpr int kOrders[][3] = {{1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
    for (const auto& order : kOrders) {
      CoverageCount other({{0, 0}, {8, 8}});
      other.add(Corners{t[std::size_t(order[0])], t[std::size_t(order[1])], t[std::size_t(order[2])]});
      ASSERT_EQ(other.picture(), first) << to_string(t);
    }
  }
}

TEST(TriangleCoverage, MovesWithTheTriangleByWholePixels) {
  HashedNumbers random(5);
  for (int i = 0; i < 3000; ++i) {
    Corners t = {random_point_fx8(random, 8), random_point_fx8(random, 8), random_point_fx8(random, 8)};
    CoverageCount count({{0, 0}, {8, 8}});
    count.add(t);
    const glm::ivec2 by_px{random.between(-32000, 32000), random.between(-32000, 32000)};
    for (glm::ivec2& p : t) p += 256 * by_px;
    CoverageCount moved({by_px, by_px + glm::ivec2(8)});
    moved.add(t);
    ASSERT_EQ(moved.picture(), count.picture()) << to_string(t);
  }
}

TEST(TriangleCoverage, IsTheSameForEveryTileSizeAndThreadCount) {
  HashedNumbers random(6);
  std::vector<CornersPx> triangles;
  for (int i = 0; i < 20; ++i) {  // letters a to t
    CornersPx t;
    for (glm::dvec2& p : t) p = glm::dvec2(random_point_fx8(random, 150)) / 256.0 - 10.0;
    triangles.push_back(t);
  }
  const std::string first = picture({131, 77}, triangles, Cull::none, workers_and_tiles(1, 256));
  EXPECT_NE(first.find('!'), std::string::npos);
  for (const int tile : {8, 16, 32, 64, 128}) {
    for (const int threads : {1, 2, 3, 5, 8, 16, 64}) {
      EXPECT_EQ(picture({131, 77}, triangles, Cull::none, workers_and_tiles(threads, tile)), first)
          << "tile " << tile << ", threads " << threads;
    }
  }
}

TEST(TriangleCoverage, AWindowSeesExactlyItsPartOfTheTriangle) {
  HashedNumbers random(7);
  for (int i = 0; i < 3000; ++i) {
    const Corners t = {random_point_fx8(random, 16), random_point_fx8(random, 16), random_point_fx8(random, 16)};
    CoverageCount whole({{0, 0}, {16, 16}}), in_parts({{0, 0}, {16, 16}});
    whole.add(t);
    const std::optional<reference::Triangle> triangle = triangle_of(t);
    if (!triangle) continue;
    const int x = random.between(0, 16), y = random.between(0, 16);
    for (const PixelBox& part :
         {PixelBox{{0, 0}, {x, y}}, PixelBox{{x, 0}, {16, y}}, PixelBox{{0, y}, {x, 16}}, PixelBox{{x, y}, {16, 16}}}) {
      reference::for_each_covered(*triangle, part, kCentre_fx8, [&](glm::ivec2 px) {
        ASSERT_TRUE(!reference::intersect(part, {px, px + glm::ivec2(1)}).empty());
        ++in_parts.at(px);
      });
    }
    ASSERT_EQ(in_parts.picture(), whole.picture()) << to_string(t);
  }
}

}  // namespace
}  // namespace lode::raster

#include "raster/reference/line.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/raster/counter_random.h"
#include "tests/raster/covered_pixels.h"
#include "tests/raster/line_oracle.h"

namespace lode::tests {
namespace {

using namespace raster;
using namespace raster::reference;

/// Ends in 1/256 px; z 0.5, w 1.
Line line_of(glm::ivec2 a, glm::ivec2 b) {
  const std::optional<Line> line = make_line({a, 0.5, 1.0}, {b, 0.5, 1.0});
  EXPECT_TRUE(line.has_value());
  return line.value_or(Line{});
}
/// Ends at pixel centres.
Line centre_line(glm::ivec2 a_px, glm::ivec2 b_px) { return line_of(a_px * 256 + 128, b_px * 256 + 128); }

Pixels oracle_covered(const Line& line, const PixelBox& window, glm::ivec2 sample_fx8 = kCentre) {
  Pixels pixels;
  for (int y = window.begin_px.y; y < window.end_px.y; ++y) {
    for (int x = window.begin_px.x; x < window.end_px.x; ++x) {
      if (oracle_exits_diamond(line.a_fx8, line.b_fx8, sample_position_fx8({x, y}, sample_fx8)))
        pixels.emplace_back(y, x);
    }
  }
  return pixels;
}

TEST(LineCoverage, FirstEndIsDrawnAndLastEndIsNot) {
  EXPECT_EQ(picture_of(centre_line({1, 0}, {5, 0}), {7, 1}), "\n.####..\n");
  EXPECT_EQ(picture_of(centre_line({5, 0}, {1, 0}), {7, 1}), "\n..####.\n");
}

TEST(LineCoverage, AStarHasItsCentreInEachOfItsEightRays) {
  // Eight rays from one pixel centre: each draws it, and none draws its own far end.
  Pixels pixels;
  for (const glm::ivec2 end : {glm::ivec2{12, 6}, {12, 12}, {6, 12}, {0, 12}, {0, 6}, {0, 0}, {6, 0}, {12, 0}}) {
    add_covered(pixels, centre_line({6, 6}, end), {{0, 0}, {13, 13}});
  }
  EXPECT_EQ(picture(pixels, {13, 13}), R"(
.............
.#....#....#.
..#...#...#..
...#..#..#...
....#.#.#....
.....###.....
.#####8#####.
.....###.....
....#.#.#....
...#..#..#...
..#...#...#..
.#....#....#.
.............
)");
}

TEST(LineCoverage, RaysOfSlopeOneHalfInAllOctants) {
  // A ray (12, 6) crosses odd columns exactly between two rows: (−ε, −ε²) then moves the crossing by
  // ε·slope − ε²: down for slope ½, up for slope −½, whichever way the ray goes. In rows instead of columns
  // (steep rays) it moves by −ε: to the left.
  Pixels pixels;
  for (const glm::ivec2 d : {glm::ivec2{8, 4}, {4, 8}, {-4, 8}, {-8, 4}, {-8, -4}, {-4, -8}, {4, -8}, {8, -4}}) {
    add_covered(pixels, centre_line({8, 8}, glm::ivec2{8, 8} + d), {{0, 0}, {17, 17}});
  }
  EXPECT_EQ(picture(pixels, {17, 17}), R"(
.................
....#......#.....
.....#.....#.....
.....#....#......
......#...#....#.
.##...#..#...##..
...##..#.#.##....
.....######......
.......28........
.....######......
...##..#.#.##....
.##...#..#...##..
......#...#....#.
.....#....#......
.....#.....#.....
....#......#.....
.................
)");
}

TEST(LineCoverage, ASegmentThatStaysInADiamondDrawsNothing) {
  EXPECT_EQ(picture_of(line_of({100, 128}, {150, 128}), {2, 1}), "\n..\n");
  // Leaving it by 1/256 px to the right is enough, but (−ε) keeps an end on the diamond's right corner inside.
  EXPECT_EQ(picture_of(line_of({100, 128}, {256, 128}), {2, 1}), "\n..\n");
  EXPECT_EQ(picture_of(line_of({100, 128}, {257, 128}), {2, 1}), "\n#.\n");
  // To the left an end on the corner is outside.
  EXPECT_EQ(picture_of(line_of({400, 128}, {257, 128}), {2, 1}), "\n..\n");
  EXPECT_EQ(picture_of(line_of({400, 128}, {256, 128}), {2, 1}), "\n.#\n");
}

TEST(LineCoverage, ASegmentBetweenTheDiamondsDrawsNothing) {
  // Around the pixels' common corner (1, 1) px no diamond is nearer than √½/2 px.
  EXPECT_EQ(picture_of(line_of({200, 256}, {310, 260}), {2, 2}), "\n..\n..\n");
}

TEST(LineCoverage, OnThePixelsBoundariesTheUpperAndTheLeftPixelAreDrawn) {
  EXPECT_EQ(picture_of(line_of({128, 256}, {4 * 256 + 128, 256}), {5, 2}), "\n####.\n.....\n");
  EXPECT_EQ(picture_of(line_of({256, 128}, {256, 3 * 256 + 128}), {2, 4}), "\n#.\n#.\n#.\n..\n");
}

TEST(LineCoverage, ALineAlongTheDiamondsSidesDrawsOneSideOnly) {
  // y = x + ½ and y = x − ½ both touch two chains of diamonds; −ε in x moves them down, into the lower chain, in
  // whose last diamond they end.
  EXPECT_EQ(picture_of(line_of({0, 128}, {4 * 256, 4 * 256 + 128}), {4, 5}), "\n....\n#...\n.#..\n..#.\n....\n");
  EXPECT_EQ(picture_of(line_of({128, 0}, {4 * 256 + 128, 4 * 256}), {5, 4}), "\n#....\n.#...\n..#..\n...#.\n");
}

TEST(LineCoverage, EqualsTheOracleForAllSegmentsOnAFineGrid) {
  // Ends on all multiples of a quarter pixel in 2 × 2 px: centres, diamonds' corners and sides, between them.
  const PixelBox window{{-2, -2}, {4, 4}};
  int segments = 0;
  for (int ay = 0; ay <= 512; ay += 64) {
    for (int ax = 0; ax <= 512; ax += 64) {
      for (int by = 0; by <= 512; by += 64) {
        for (int bx = 0; bx <= 512; bx += 64) {
          if (ax == bx && ay == by) continue;
          const Line line = line_of({ax, ay}, {bx, by});
          const Pixels expected = oracle_covered(line, window);
          ASSERT_EQ(covered(line, window), expected) << ax << ',' << ay << " to " << bx << ',' << by;
          ASSERT_EQ(fragment_count(line, kCentre), expected.size()) << ax << ',' << ay << " to " << bx << ',' << by;
          ++segments;
        }
      }
    }
  }
  EXPECT_EQ(segments, 81 * 80);
}

TEST(LineCoverage, EqualsTheOracleAtAnySamplePosition) {
  for (std::uint64_t i = 0; i < 3000; ++i) {
    const CounterRandom random{11, i};
    const glm::ivec2 a{random.integer(0, -700, 700), random.integer(1, -700, 700)};
    const glm::ivec2 b{random.integer(2, -700, 700), random.integer(3, -700, 700)};
    const glm::ivec2 sample{random.integer(4, 0, 255), random.integer(5, 0, 255)};
    if (a == b) continue;
    const PixelBox window{{-5, -5}, {5, 5}};
    ASSERT_EQ(covered(line_of(a, b), window, sample), oracle_covered(line_of(a, b), window, sample)) << "case " << i;
  }
}

TEST(LineCoverage, ASegmentCutInItsOwnPointsHasTheSameFragmentsOnceEach) {
  for (std::uint64_t i = 0; i < 1000; ++i) {
    const CounterRandom random{12, i};
    const glm::ivec2 a{random.integer(0, 0, 4000), random.integer(1, 0, 4000)};
    const glm::ivec2 step{random.integer(2, -80, 80), random.integer(3, -80, 80)};
    if (step == glm::ivec2(0)) continue;
    const int n = random.integer(4, 2, 40);
    const PixelBox window{{-40, -40}, {60, 60}};
    Pixels pieces;
    for (int k = 0; k < n; ++k) add_covered(pieces, line_of(a + k * step, a + (k + 1) * step), window);
    ASSERT_EQ(pieces, covered(line_of(a, a + n * step), window)) << "case " << i;
  }
}

TEST(LineCoverage, ClosedConvexOutlineHasNoGapAndNoDouble) {
  // Corners on pixel centres, turning by less than 90°.
  const glm::ivec2 corners[] = {{5, 0}, {9, 0}, {14, 3}, {14, 8}, {10, 12}, {4, 12}, {0, 9}, {0, 4}};
  Pixels pixels;
  for (std::size_t i = 0; i < 8; ++i)
    add_covered(pixels, centre_line(corners[i], corners[(i + 1) % 8]), {{0, 0}, {15, 13}});
  EXPECT_EQ(picture(pixels, {15, 13}), R"(
.....#####.....
....#.....##...
..##........##.
.#............#
#.............#
#.............#
#.............#
#.............#
#.............#
#............#.
.#..........#..
..##.......#...
....#######....
)");
}

TEST(LineCoverage, EqualEndsMakeNoLine) {
  EXPECT_FALSE(make_line({{7, 9}, 0.5, 1.0}, {{7, 9}, 0.25, 2.0}).has_value());
}

TEST(LineCoverage, AcrossTheWholeGuardBandEveryColumnHasOneFragment) {
  const int guard = kGuard_fx8;
  for (const glm::ivec2 b : {glm::ivec2{guard, guard}, {guard, guard - 1}, {guard - 1, guard}, {guard, -guard + 77}}) {
    const Line line = line_of({-guard, -guard}, b);
    // From −32768 px to 32768 px: columns −32768 … 32767.
    EXPECT_NEAR(double(fragment_count(line, kCentre)), 65536.0, 1.0);
    for (const int at_px : {-32768, -1234, 0, 20000, 32760}) {
      const PixelBox window{{at_px, -32770}, {at_px + 8, 32770}};
      Pixels pixels = covered(line, window);
      for (const auto& [y, x] : pixels) {
        EXPECT_TRUE(oracle_exits_diamond(line.a_fx8, line.b_fx8, sample_position_fx8({x, y}, kCentre)));
      }
      EXPECT_GE(pixels.size(), 7u);
      EXPECT_LE(pixels.size(), 8u);
    }
  }
}

TEST(LineStipple, LowestBitComesFirst) {
  Line line = centre_line({0, 0}, {16, 0});
  line.stipple = LineStipple{{0x80F5, 1}, 0};  // 1010 1111 0000 0001, lowest bit first
  EXPECT_EQ(picture_of(line, {17, 1}), "\n#.#.####.......#.\n");
}

TEST(LineStipple, EachBitLastsForFactorFragments) {
  Line line = centre_line({0, 0}, {40, 0});
  line.stipple = LineStipple{{0x0005, 3}, 0};
  EXPECT_EQ(picture_of(line, {20, 1}), "\n###...###...........\n");
}

TEST(LineStipple, CountsFromTheFirstEnd) {
  Line line = centre_line({16, 0}, {0, 0});
  line.stipple = LineStipple{{0x0013, 1}, 0};
  EXPECT_EQ(picture_of(line, {17, 1}), "\n............#..##\n");
}

TEST(LineStipple, GoesOnAlongAStrip) {
  const glm::ivec2 corners[] = {{0, 1}, {5, 1}, {5, 6}, {11, 6}};
  std::uint64_t n = 0;
  Pixels pixels;
  for (std::size_t i = 0; i + 1 < 4; ++i) {
    Line line = centre_line(corners[i], corners[i + 1]);
    line.stipple = LineStipple{{0x5553, 1}, n};  // ##..#.#.#.#.#.#.
    n += fragment_count(line, kCentre);
    add_covered(pixels, line, {{0, 0}, {12, 8}});
  }
  EXPECT_EQ(n, 16u);
  EXPECT_EQ(picture(pixels, {12, 8}), R"(
............
##..#.......
.....#......
............
.....#......
............
.....#.#.#..
............
)");
}

TEST(LineStipple, ABitGoesOnAcrossAJoint) {
  // Factor 3, every second bit, in pieces of four fragments: ###...###...
  std::uint64_t n = 0;
  Pixels pixels;
  for (int x = 0; x < 12; x += 4) {
    Line line = centre_line({x, 0}, {x + 4, 0});
    line.stipple = LineStipple{{0x5555, 3}, n};
    n += fragment_count(line, kCentre);
    add_covered(pixels, line, {{0, 0}, {12, 1}});
  }
  EXPECT_EQ(picture(pixels, {12, 1}), "\n###...###...\n");
}

TEST(LineStipple, AndCoverageDoNotDependOnTheWindow) {
  for (std::uint64_t i = 0; i < 500; ++i) {
    const CounterRandom random{13, i};
    const glm::ivec2 a{random.integer(0, -9000, 9000), random.integer(1, -9000, 9000)};
    const glm::ivec2 b{random.integer(2, -9000, 9000), random.integer(3, -9000, 9000)};
    if (a == b) continue;
    Line line = line_of(a, b);
    line.stipple = LineStipple{{std::uint16_t(random.bits(4)), random.integer(5, 1, 9)}, random.bits(6) >> 40};
    Pixels tiles;
    for (int y = -36; y < 36; y += 9) {
      for (int x = -36; x < 36; x += 8) add_covered(tiles, line, {{x, y}, {x + 8, y + 9}});
    }
    ASSERT_EQ(tiles, covered(line, {{-1000, -1000}, {1000, 1000}})) << "case " << i;
  }
}

TEST(LineDepth, IsWithin0501UlpOfTheRationalAndBetweenTheEnds) {
  double worst = 0.0;
  for (std::uint64_t i = 0; i < 2000; ++i) {
    const CounterRandom random{14, i};
    const glm::ivec2 a{random.integer(0, -9000, 9000), random.integer(1, -9000, 9000)};
    const glm::ivec2 b{random.integer(2, -9000, 9000), random.integer(3, -9000, 9000)};
    if (a == b) continue;
    Line line = line_of(a, b);
    line.z_a = std::abs(random.real(4));
    line.z_b = i % 3 == 0 ? 1e-12 : std::abs(random.real(5));
    for_each_covered(line, {{-40, -40}, {40, 40}}, kCentre, [&](glm::ivec2 pixel) {
      const glm::ivec2 p = sample_position_fx8(pixel, kCentre);
      const glm::ivec2 d = b - a;
      mpq_class t((p.x - a.x) * long(d.x) + (p.y - a.y) * long(d.y), d.x * long(d.x) + d.y * long(d.y));
      t.canonicalize();
      if (t < 0) t = 0;
      if (t > 1) t = 1;
      const mpq_class exact = (1 - t) * mpq_class(line.z_a) + t * mpq_class(line.z_b);
      const float z = depth_at(line, p);
      const mpq_class error = abs(mpq_class(z) - exact);
      const double ulp = double(std::nextafter(z, 2.0f)) - double(z);
      worst = std::max(worst, error.get_d() / ulp);
      ASSERT_GE(z, float(std::min(line.z_a, line.z_b)));
      ASSERT_LE(z, float(std::max(line.z_a, line.z_b)));
    });
  }
  EXPECT_LE(worst, 0.501);
  EXPECT_GT(worst, 0.4);  // the test has seen roundings
}

TEST(LineWeights, AreThoseOfTheRationalPerspectiveAndAffineWhereWIsEqual) {
  Line line = line_of({0, 0}, {4096, 1024});
  line.w_a = 1.0;
  line.w_b = 4.0;
  // Half way on the screen: (½/1, ½/4) normalised.
  const VertexWeights half = weights_at(line, {2048, 512});
  EXPECT_EQ(half[0], 0.8);
  EXPECT_EQ(half[1], 0.2);
  EXPECT_EQ(half[2], 0.0);
  line.w_a = line.w_b = 3.0;
  EXPECT_EQ(weights_at(line, {2048, 512})[0], 0.5);
  EXPECT_EQ(weights_at(line, {1024, 256})[1], 0.25);
  // Before a and beyond b: held to the ends.
  EXPECT_EQ(weights_at(line, {-100, -20})[0], 1.0);
  EXPECT_EQ(weights_at(line, {5000, 1100})[1], 1.0);
}

TEST(LineWeights, OfAClippedLineAreOfItsOwnVertices) {
  Line line = line_of({0, 0}, {1024, 0});
  line.weights_a = {0.75, 0.25, 0.0};
  line.weights_b = {0.25, 0.75, 0.0};
  const VertexWeights half = weights_at(line, {512, 0});
  EXPECT_EQ(half[0], 0.5);
  EXPECT_EQ(half[1], 0.5);
}

TEST(LineFootprint, DerivativesAreThoseOfTheTextureCoordinate) {
  Line line = line_of({0, 0}, {64 * 256, 16 * 256});
  line.w_a = 1.0;
  line.w_b = 5.0;
  const VertexUvs uvs = std::array<glm::vec2, 3>{glm::vec2{0.0f, 1.0f}, glm::vec2{2.0f, -1.0f}, glm::vec2{}};
  const glm::ivec2 p{30 * 256, 8 * 256};
  const Footprint f = footprint_at(line, uvs, p);
  const VertexWeights b = weights_at(line, p);
  EXPECT_DOUBLE_EQ(f.uv.x, 2.0 * b[1]);
  EXPECT_DOUBLE_EQ(f.uv.y, b[0] - b[1]);
  const auto difference = [&](glm::ivec2 step) {
    return (footprint_at(line, uvs, p + step).uv - footprint_at(line, uvs, p - step).uv) * 128.0;
  };
  for (int c = 0; c < 2; ++c) {
    // Central differences over 2/256 px: their error is of the third derivative, here below 1e-7.
    EXPECT_NEAR(f.duv_dx[c], difference({1, 0})[c], 1e-7);
    EXPECT_NEAR(f.duv_dy[c], difference({0, 1})[c], 1e-7);
    EXPECT_GT(std::abs(f.duv_dx[c]), 1e-3);
  }
  EXPECT_EQ(footprint_at(line, {}, p).uv, glm::dvec2(0.0));
}

}  // namespace
}  // namespace lode::tests

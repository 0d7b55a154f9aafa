#include "raster/reference/disc.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/raster/counter_random.h"
#include "tests/raster/covered_pixels.h"

namespace lode::tests {
namespace {

using namespace raster;
using namespace raster::reference;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(PointCoverage, ASquareHasItsLeftAndTopSideButNotItsRightAndBottomOne) {
  // Centre (2, 2) px, side 3 px: from ½ to 3½ px, so samples 0, 1, 2 are in, sample 3 on the far side is not.
  EXPECT_EQ(picture_of(Square{{512, 512}, 768, 0.5}, {5, 5}), R"(
###..
###..
###..
.....
.....
)");
}

TEST(PointCoverage, TheTestOfASampleKnowsTheSidesByItself) {
  const Square s{{512, 512}, 768, 0.5};  // from 128 to 896
  EXPECT_TRUE(covers(s, {128, 128}));
  EXPECT_TRUE(covers(s, {895, 895}));
  for (const glm::ivec2 outside : {glm::ivec2{127, 500}, {500, 127}, {896, 500}, {500, 896}})
    EXPECT_FALSE(covers(s, outside));
}

TEST(PointCoverage, OneSubPixelMoreOrLessMovesASide) {
  EXPECT_EQ(picture_of(Square{{513, 512}, 768, 0.5}, {5, 4}), "\n.###.\n.###.\n.###.\n.....\n");
  EXPECT_EQ(picture_of(Square{{511, 511}, 768, 0.5}, {5, 4}), "\n###..\n###..\n###..\n.....\n");
  // An odd side, 769: half of it is 384½, so both sides now take in their samples.
  EXPECT_EQ(picture_of(Square{{512, 512}, 769, 0.5}, {5, 4}), "\n####.\n####.\n####.\n####.\n");
}

TEST(PointCoverage, APointOfOnePixelCoversOnePixelWhereverItIs) {
  for (std::uint64_t i = 0; i < 500; ++i) {
    const CounterRandom random{21, i};
    const Square s{{random.integer(0, -900, 900), random.integer(1, -900, 900)}, 256, 0.5};
    const glm::ivec2 sample{random.integer(2, 0, 255), random.integer(3, 0, 255)};
    ASSERT_EQ(covered(s, {{-8, -8}, {8, 8}}, sample).size(), 1u) << "case " << i;
  }
}

TEST(PointCoverage, SquaresSideBySideCoverEverySampleOnce) {
  for (const int size : {1, 2, 3, 77, 256, 300, 511}) {
    Pixels pixels;
    // Centres a side apart; odd sides have their edges on half sub-pixels.
    for (int y = -2000; y < 3000; y += size) {
      if (size < 77 && std::abs(y - 128) > 600) continue;
      for (int x = -2000; x < 3000; x += size) {
        if (size < 77 && std::abs(x - 128) > 600) continue;
        add_covered(pixels, Square{{x, y}, size, 0.5}, {{-1, -1}, {2, 2}});
      }
    }
    EXPECT_EQ(picture(pixels, {2, 2}), "\n##\n##\n") << size;
    EXPECT_EQ(pixels.size(), 9u) << size;
  }
}

TEST(PointCoverage, EqualsItsDefinition) {
  for (std::uint64_t i = 0; i < 2000; ++i) {
    const CounterRandom random{22, i};
    const Square s{{random.integer(0, -600, 600), random.integer(1, -600, 600)}, random.integer(2, 1, 900), 0.5};
    const glm::ivec2 sample{random.integer(3, 0, 255), random.integer(4, 0, 255)};
    Pixels expected;
    for (int y = -6; y < 6; ++y) {
      for (int x = -6; x < 6; ++x) {
        // In doubles, all of them exact.
        const double px = x + sample.x / 256.0, py = y + sample.y / 256.0;
        const double half = s.size_fx8 / 512.0, cx = s.centre_fx8.x / 256.0, cy = s.centre_fx8.y / 256.0;
        if (cx - half <= px && px < cx + half && cy - half <= py && py < cy + half) expected.emplace_back(y, x);
      }
    }
    ASSERT_EQ(covered(s, {{-6, -6}, {6, 6}}, sample), expected) << "case " << i;
  }
}

TEST(DiscCoverage, TheRimBelongsToTheDisc) {
  // Radius 1 px around a pixel centre: the four neighbours' samples lie on the rim.
  EXPECT_EQ(picture_of(Disc{{640, 640}, 256, 0.5}, {5, 5}), "\n.....\n..#..\n.###.\n..#..\n.....\n");
  EXPECT_EQ(picture_of(Disc{{640, 640}, 255, 0.5}, {5, 5}), "\n.....\n.....\n..#..\n.....\n.....\n");
}

TEST(DiscCoverage, ARadiusOfFiveHasThreeFourFiveOnItsRim) {
  EXPECT_EQ(picture_of(Disc{{6 * 256 + 128, 6 * 256 + 128}, 5 * 256, 0.5}, {13, 13}), R"(
.............
......#......
...#######...
..#########..
..#########..
..#########..
.###########.
..#########..
..#########..
..#########..
...#######...
......#......
.............
)");
}

TEST(DiscCoverage, EqualsItsDefinition) {
  for (std::uint64_t i = 0; i < 2000; ++i) {
    const CounterRandom random{23, i};
    const Disc d{{random.integer(0, -600, 600), random.integer(1, -600, 600)}, random.integer(2, 1, 900), 0.5};
    const glm::ivec2 sample{random.integer(3, 0, 255), random.integer(4, 0, 255)};
    Pixels expected;
    for (int y = -8; y < 8; ++y) {
      for (int x = -8; x < 8; ++x) {
        const double dx = 256 * x + sample.x - d.centre_fx8.x, dy = 256 * y + sample.y - d.centre_fx8.y;
        if (dx * dx + dy * dy <= double(d.radius_fx8) * d.radius_fx8) expected.emplace_back(y, x);
      }
    }
    ASSERT_EQ(covered(d, {{-8, -8}, {8, 8}}, sample), expected) << "case " << i;
  }
}

TEST(DiscCoverage, TheLargestDiscAndSquareCoverTheGuardBandFromItsCorner) {
  const glm::ivec2 corner{-kGuard_fx8, kGuard_fx8};
  const PixelBox far_corner{{32764, -32768}, {32768, -32764}};
  for (const double size_px : {1e6, 1e30, 1e300, kInfinity}) {
    EXPECT_EQ(covered(*make_disc(corner, size_px, 0.5), far_corner).size(), 16u) << size_px;
    EXPECT_EQ(covered(*make_square(corner, size_px, 0.5), far_corner).size(), 16u) << size_px;
  }
}

TEST(SnapSize, RoundsHalfToEvenAndRefusesWhatHasNoSize) {
  EXPECT_EQ(snap_size(1.0), 256);
  EXPECT_EQ(snap_size(1.5 / 256), 2);
  EXPECT_EQ(snap_size(2.5 / 256), 2);
  EXPECT_EQ(snap_size(0.5 / 256), std::nullopt);
  for (const double size_px : {0.0, -0.0, -1.0, 5e-324, -kInfinity, kNan}) {
    EXPECT_FALSE(snap_size(size_px).has_value()) << size_px;
    EXPECT_FALSE(make_disc({0, 0}, size_px, 0.5).has_value()) << size_px;
    EXPECT_FALSE(make_square({0, 0}, size_px, 0.5).has_value()) << size_px;
  }
}

TEST(DiscCoverage, DoesNotDependOnTheWindow) {
  const Disc d{{1003, 2007}, 3001, 0.5};
  Pixels tiles;
  for (int y = -14; y < 28; y += 7) {
    for (int x = -14; x < 28; x += 6) add_covered(tiles, d, {{x, y}, {x + 6, y + 7}});
  }
  EXPECT_EQ(tiles, covered(d, {{-14, -14}, {28, 28}}));
  EXPECT_EQ(tiles, covered(d, {{-2000000000, -2000000000}, {2000000000, 2000000000}}));
}

TEST(DiscFootprint, RunsFromZeroToOneAcrossTheSquare) {
  const Disc d{{640, 640}, 256, 0.25};
  const Footprint f = footprint_at(d, {}, {640 - 256, 640 + 128});
  EXPECT_EQ(f.uv, glm::dvec2(0.0, 0.75));
  EXPECT_EQ(f.duv_dx, glm::dvec2(0.5, 0.0));
  EXPECT_EQ(f.duv_dy, glm::dvec2(0.0, 0.5));
  const Footprint g = footprint_at(Square{{640, 640}, 1024, 0.25}, {}, {640 - 512, 640 + 256});
  EXPECT_EQ(g.uv, glm::dvec2(0.0, 0.75));
  EXPECT_EQ(g.duv_dx, glm::dvec2(0.25, 0.0));
  EXPECT_EQ(depth_at(d, {640, 640}), 0.25f);
  EXPECT_EQ(weights_at(d, {640, 640})[0], 1.0);
}

TEST(DiscFootprint, IsTheVertexsOwnCoordinateWhereItHasOne) {
  const VertexUvs uvs = std::array<glm::vec2, 3>{glm::vec2{0.25f, 7.0f}, glm::vec2{}, glm::vec2{}};
  const Footprint f = footprint_at(Disc{{0, 0}, 256, 0.5}, uvs, {100, 100});
  EXPECT_EQ(f.uv, glm::dvec2(0.25, 7.0));
  EXPECT_EQ(f.duv_dx, glm::dvec2(0.0));
  EXPECT_EQ(footprint_at(Square{{0, 0}, 256, 0.5}, uvs, {100, 100}).uv, glm::dvec2(0.25, 7.0));
}

}  // namespace
}  // namespace lode::tests

#include "raster/reference/surfel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/raster/covered_pixels.h"
#include "tests/raster/surfel_cases.h"
#include "tests/raster/surfel_oracle.h"

namespace lode::tests {
namespace {

using namespace raster;
using namespace raster::reference;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

std::optional<Surfel> surfel_of(const SurfelCase& s) {
  return make_surfel(s.centre, s.normal, s.radius, s.clip_from_object, s.viewport_origin_px, s.viewport_size_px);
}

/// A perspective camera at the origin that looks along −z: w = −z, window half = distance, depth 1/w.
const glm::dmat4 kPerspective{glm::dvec4{1, 0, 0, 0}, glm::dvec4{0, 1, 0, 0}, glm::dvec4{0, 0, 0, -1},
                              glm::dvec4{0, 0, 1, 0}};

/// Clip space is object space scaled so that one unit is one pixel of a 16 × 16 viewport, y up, centre (8, 8).
glm::dmat4 pixels_16() {
  glm::dmat4 m{1.0};
  m[0][0] = m[1][1] = 1.0 / 8.0;
  m[2][2] = 1.0 / 64.0;
  m[3][2] = 0.5;
  return m;
}

class SurfelOracleTest : public testing::TestWithParam<SurfelKind> {};

/// First mismatch of covers() with the oracle in a window, or an empty text.
std::string mismatch(const SurfelCase& s, const PixelBox& window, glm::ivec2 sample_fx8) {
  const SurfelOracle oracle(s);
  const std::optional<Surfel> surfel = surfel_of(s);
  const Pixels pixels = surfel ? covered(*surfel, window, sample_fx8) : Pixels{};
  Pixels expected;
  for (int y = window.begin_px.y; y < window.end_px.y; ++y) {
    for (int x = window.begin_px.x; x < window.end_px.x; ++x) {
      if (oracle.covers(sample_position_fx8({x, y}, sample_fx8))) expected.emplace_back(y, x);
    }
  }
  const glm::ivec2 size = window.end_px - window.begin_px;
  const auto moved = [&](Pixels all) {
    for (auto& [y, x] : all) y -= window.begin_px.y, x -= window.begin_px.x;
    return all;
  };
  return pixels == expected ? "" : "got" + picture(moved(pixels), size) + "expected" + picture(moved(expected), size);
}

TEST(SurfelCoverage, ADiscAcrossTheViewIsACircleWithItsRim) {
  // Centre at the sample (8½, 8½), radius 5: 3-4-5 and 5-0 samples lie on the rim.
  const SurfelCase s{{0.5f, -0.5f, 0.0f}, {0, 0, 1}, 5.0f, pixels_16(), {0, 0}, {16, 16}};
  EXPECT_EQ(picture_of(*surfel_of(s), {16, 16}), R"(
................
................
................
........#.......
.....#######....
....#########...
....#########...
....#########...
...###########..
....#########...
....#########...
....#########...
.....#######....
........#.......
................
................
)");
}

TEST(SurfelCoverage, ATiltedDiscIsAnEllipse) {
  // The normal (4, 0, 3)/5 makes it 3/5 as wide: (x/3)² + (y/5)² ≤ 1, with (±3, 0) and (0, ±5) on the rim. Its
  // normal's length does not matter.
  const SurfelCase s{{0.5f, -0.5f, 0.0f}, {4e10f, 0, 3e10f}, 5.0f, pixels_16(), {0, 0}, {16, 16}};
  EXPECT_EQ(picture_of(*surfel_of(s), {16, 16}), R"(
................
................
................
........#.......
.......###......
......#####.....
......#####.....
......#####.....
.....#######....
......#####.....
......#####.....
......#####.....
.......###......
........#.......
................
................
)");
}

TEST(SurfelCoverage, IsClippedAtEachSampleByNearAndFarPlane) {
  // Tilted by 45°, z = −x: depth ½ − x/8 is 1 at x = −4 and 0 at x = 4; the ellipse itself is 4.95 wide to either
  // side, 7 high.
  SurfelCase s{{0.0f, 0.0f, 0.0f}, {1, 0, 1}, 7.0f, pixels_16(), {0, 0}, {16, 16}};
  s.clip_from_object[2][2] = 1.0 / 8.0;
  EXPECT_EQ(picture_of(*surfel_of(s), {16, 16}), R"(
................
......####......
.....######.....
....########....
....########....
....########....
....########....
....########....
....########....
....########....
....########....
....########....
....########....
.....######.....
......####......
................
)");
}

TEST(SurfelCoverage, ADiscAroundTheEyeIsDrawnFromTheNearPlaneOn) {
  // A floor ½ below the eye, radius 2: a row y below the middle sees it at the distance d = 4/(y − 8). Row 10
  // (y = 10½) at 1.6, where it is 1.2 wide to either side: ¾ of half the window. Row 12 at 0.89, before w = 1.
  const SurfelCase s{{0.0f, -0.5f, 0.0f}, {0, 1, 0}, 2.0f, kPerspective, {0, 0}, {16, 16}};
  EXPECT_EQ(picture_of(*surfel_of(s), {16, 16}), R"(
................
................
................
................
................
................
................
................
................
................
..############..
################
................
................
................
................
)");
}

TEST(SurfelCoverage, EdgeOnAndBehindDrawNothing) {
  // Planes through the eye, exactly: (1, 0, 0) at x = 0, and one turned by 3-4-5.
  EXPECT_FALSE(surfel_of({{0, 0, -5}, {1, 0, 0}, 2.0f, kPerspective, {0, 0}, {16, 16}}).has_value());
  EXPECT_FALSE(surfel_of({{4, 0, -3}, {3, 0, 4}, 2.0f, kPerspective, {0, 0}, {16, 16}}).has_value());
  EXPECT_TRUE(surfel_of({{4, 0, -3}, {3, 0, 5}, 2.0f, kPerspective, {0, 0}, {16, 16}}).has_value());
  EXPECT_FALSE(surfel_of({{0, 0, 5}, {0, 0, 1}, 2.0f, kPerspective, {0, 0}, {16, 16}}).has_value());
  // Orthographic: any normal across the view.
  EXPECT_FALSE(surfel_of({{0, 0, 0}, {3, -4, 0}, 2.0f, pixels_16(), {0, 0}, {16, 16}}).has_value());
}

TEST(SurfelCoverage, ADiscInTheNearOrTheFarPlaneIsDrawn) {
  // z = w, and z = 0, for every sample.
  for (const float z : {1.0f, 0.0f}) {
    const SurfelCase s{{0.25f, 0.5f, z}, {0, 0, -3}, 0.3f, glm::dmat4(1.0), {0, 0}, {64, 64}};
    const Surfel surfel = *surfel_of(s);
    EXPECT_TRUE(surfel.inside_clip_volume);  // decided once, not at each sample
    const Pixels pixels = covered(surfel, {{0, 0}, {64, 64}});
    EXPECT_NEAR(double(pixels.size()), 3.14159 * 0.3 * 0.3 * 32 * 32, 10.0);  // its area; ± a tenth of its outline
    for (const auto& [y, x] : pixels) EXPECT_EQ(depth_at(surfel, sample_position_fx8({x, y}, kCentre)), z);
  }
  const SurfelCase beyond{
      {0.25f, 0.5f, std::nextafter(1.0f, 2.0f)}, {0, 0, 1}, 0.3f, glm::dmat4(1.0), {0, 0}, {64, 64}};
  EXPECT_FALSE(surfel_of(beyond).has_value());
}

TEST_P(SurfelOracleTest, CoverageEqualsTheRationals) {
  int hits = 0;
  for (std::uint64_t i = 0; i < 1200; ++i) {
    const CounterRandom random{31, i};
    const SurfelCase s = random_surfel(GetParam(), random);
    const glm::ivec2 begin = middle_of(s) - random.integer(500, 0, 7);
    const glm::ivec2 sample{random.integer(501, 0, 3) * 64, random.integer(502, 0, 255)};
    ASSERT_EQ(mismatch(s, {begin, begin + 7}, sample), "") << "case " << i;
    const std::optional<Surfel> surfel = surfel_of(s);
    hits += surfel && !covered(*surfel, {begin, begin + 7}, sample).empty();
  }
  EXPECT_GT(hits, 150);
}

TEST_P(SurfelOracleTest, DepthIsWithin0501UlpOfTheRational) {
  double worst = 0.0;
  int samples = 0;
  for (std::uint64_t i = 0; i < 1200; ++i) {
    const CounterRandom random{32, i};
    const SurfelCase s = random_surfel(GetParam(), random);
    const std::optional<Surfel> surfel = surfel_of(s);
    if (!surfel) continue;
    const SurfelOracle oracle(s);
    int left = 3;
    const glm::ivec2 begin = middle_of(s) - 4;
    const PixelBox window{begin, begin + 8};
    for_each_covered(*surfel, window, kCentre, [&](glm::ivec2 pixel) {
      if (left == 0 || random.integer(std::uint64_t(600 + pixel.x * 100 + pixel.y), 0, 5) != 0) return;
      --left;
      ++samples;
      const glm::ivec2 p = sample_position_fx8(pixel, kCentre);
      ASSERT_TRUE(oracle.covers(p)) << "case " << i;
      const float z = depth_at(*surfel, p);
      ASSERT_TRUE(z >= 0.0f && z <= 1.0f);
      const mpq_class error = abs(mpq_class(z) - oracle.depth(p));
      const double ulp = double(std::nextafter(z, 2.0f)) - double(z);
      worst = std::max(worst, mpq_class(error / mpq_class(ulp)).get_d());
    });
  }
  EXPECT_LE(worst, 0.501);
  EXPECT_GT(samples, 200);
}

TEST_P(SurfelOracleTest, TheExactTestAloneEqualsTheRationals) {
  for (std::uint64_t i = 0; i < 1500; ++i) {
    const CounterRandom random{36, i};
    SurfelCase s = random_surfel(GetParam(), random);
    if (i % 3 == 0) {
      for (int j = 0; j < 4; ++j) s.clip_from_object[j][2] = 0.0;  // depth 0 everywhere: no near plane hides small w
    }
    if (!(s.radius > 0.0f) || s.normal == glm::vec3(0.0f)) continue;
    const SurfelOracle oracle(s);
    const auto read = [](float x) { return std::clamp(double(x), -0x1p128, 0x1p128); };
    const SurfelInput input{{read(s.centre.x), read(s.centre.y), read(s.centre.z)},
                            {read(s.normal.x), read(s.normal.y), read(s.normal.z)},
                            read(s.radius),
                            s.clip_from_object,
                            s.viewport_origin_px,
                            s.viewport_size_px};
    for (int k = 0; k < 4; ++k) {
      const glm::ivec2 p = middle_of(s) * 256 + 64 * glm::ivec2{random.integer(std::uint64_t(800 + k), -20, 20),
                                                                random.integer(std::uint64_t(810 + k), -20, 20)};
      ASSERT_EQ(exact_covers(input, p), oracle.covers(p)) << "case " << i << " at " << p.x << ", " << p.y;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, SurfelOracleTest,
                         testing::Values(SurfelKind::scene, SurfelKind::structured, SurfelKind::hostile),
                         [](const auto& kind) {
                           return kind.param == SurfelKind::scene        ? "Scene"
                                  : kind.param == SurfelKind::structured ? "Structured"
                                                                         : "Hostile";
                         });

TEST(SurfelCoverage, NanZeroAndNegativeDrawNothing) {
  const SurfelCase good{{0, 0, 0}, {0, 0, 1}, 2.0f, pixels_16(), {0, 0}, {16, 16}};
  ASSERT_TRUE(surfel_of(good).has_value());
  for (const float radius : {0.0f, -0.0f, -1.0f, kNan, -kInfinity}) {
    SurfelCase s = good;
    s.radius = radius;
    EXPECT_FALSE(surfel_of(s).has_value()) << radius;
  }
  SurfelCase s = good;
  s.normal = {0.0f, -0.0f, 0.0f};
  EXPECT_FALSE(surfel_of(s).has_value());
  for (int i = 0; i < 3; ++i) {
    s = good;
    s.normal[i] = kNan;
    EXPECT_FALSE(surfel_of(s).has_value());
    EXPECT_TRUE(has_nan(s.centre, s.normal));
    s = good;
    s.centre[i] = kNan;
    EXPECT_FALSE(surfel_of(s).has_value());
    EXPECT_TRUE(has_nan(s.centre, s.normal));
  }
  EXPECT_FALSE(has_nan(good.centre, good.normal));
  s = good;
  s.clip_from_object[1][1] = double(kInfinity);
  EXPECT_FALSE(surfel_of(s).has_value());
  s.clip_from_object = glm::dmat4(0.0);
  EXPECT_FALSE(surfel_of(s).has_value());
  s = good;
  s.viewport_size_px = {16, 0};
  EXPECT_FALSE(surfel_of(s).has_value());
}

TEST(SurfelCoverage, AnInfiniteRadiusIsTheWholePlane) {
  for (const float radius : {1e30f, kInfinity}) {
    const SurfelCase s{{0, 0, -2}, {1, 2, 3}, radius, kPerspective, {0, 0}, {16, 16}};
    EXPECT_EQ(mismatch(s, {{0, 0}, {16, 16}}, kCentre), "");
    EXPECT_GT(covered(*surfel_of(s), {{0, 0}, {16, 16}}).size(), 50u);
  }
}

TEST(SurfelCoverage, ADenormalRadiusCoversASampleAtTheCentreOnly) {
  SurfelCase s{{0.5f, -0.5f, 0.0f}, {1, 1, 1}, std::numeric_limits<float>::denorm_min(), pixels_16(), {0, 0}, {16, 16}};
  EXPECT_EQ(covered(*surfel_of(s), {{0, 0}, {16, 16}}), (Pixels{{8, 8}}));
  s.centre.x = std::nextafter(0.5f, 1.0f);
  EXPECT_EQ(covered(*surfel_of(s), {{0, 0}, {16, 16}}), Pixels{});
}

TEST(SurfelCoverage, AWBelowTheLeastPositiveFloatDrawsNothing) {
  SurfelCase s{{0.0f, 0.0f, 0.0f}, {0, 0, 1}, 4.0f, pixels_16() * 0x1p-149, {0, 0}, {16, 16}};
  EXPECT_TRUE(surfel_of(s).has_value());
  EXPECT_EQ(mismatch(s, {{0, 0}, {16, 16}}, kCentre), "");
  EXPECT_FALSE(covered(*surfel_of(s), {{0, 0}, {16, 16}}).empty());
  s.clip_from_object *= 0.5;
  EXPECT_EQ(mismatch(s, {{0, 0}, {16, 16}}, kCentre), "");
  const std::optional<Surfel> below = surfel_of(s);
  EXPECT_TRUE(!below || covered(*below, {{0, 0}, {16, 16}}).empty());
}

TEST(SurfelCoverage, BoundsOfASmallDiscAreSmall) {
  // Radius 5 px around (8½, 8½): pixels 3 … 13, and at most one more on each side.
  const SurfelCase s{{0.5f, -0.5f, 0.0f}, {0, 0, 1}, 5.0f, pixels_16(), {0, 0}, {16, 16}};
  const PixelBox box = bounds_px(*surfel_of(s), kCentre);
  EXPECT_TRUE(box.begin_px.x >= 2 && box.begin_px.y >= 2 && box.begin_px.x <= 3 && box.begin_px.y <= 3);
  EXPECT_TRUE(box.end_px.x >= 14 && box.end_px.y >= 14 && box.end_px.x <= 15 && box.end_px.y <= 15);
}

TEST(SurfelCoverage, DoesNotDependOnTheWindow) {
  for (std::uint64_t i = 0; i < 100; ++i) {
    const CounterRandom random{33, i};
    const std::optional<Surfel> surfel = surfel_of(random_surfel(SurfelKind::structured, random));
    if (!surfel) continue;
    Pixels tiles;
    for (int y = -8; y < 72; y += 8) {
      for (int x = -9; x < 72; x += 9) add_covered(tiles, *surfel, {{x, y}, {x + 9, y + 8}});
    }
    ASSERT_EQ(tiles, covered(*surfel, {{-9, -8}, {72, 72}})) << "case " << i;
  }
}

TEST(SurfelFootprint, SpansTheDiscAndDerivativesAreThoseOfTheCoordinate) {
  const SurfelCase s{{0.3f, -0.2f, -4.0f}, {1, 2, 3}, 1.5f, kPerspective, {0, 0}, {64, 48}};
  const Surfel surfel = *surfel_of(s);
  double longest = 0.0;
  int n = 0;
  for_each_covered(surfel, {{0, 0}, {64, 48}}, kCentre, [&](glm::ivec2 pixel) {
    ++n;
    const glm::ivec2 p = sample_position_fx8(pixel, kCentre);
    const Footprint f = footprint_at(surfel, {}, p);
    const glm::dvec2 d = 2.0 * f.uv - 1.0;
    longest = std::max(longest, d.x * d.x + d.y * d.y);
    if (d.x * d.x + d.y * d.y > 0.9) return;  // its neighbours may be outside, where the coordinate is clamped
    const glm::dvec2 du =
        (footprint_at(surfel, {}, p + glm::ivec2{1, 0}).uv - footprint_at(surfel, {}, p - glm::ivec2{1, 0}).uv) * 128.0;
    const glm::dvec2 dv =
        (footprint_at(surfel, {}, p + glm::ivec2{0, 1}).uv - footprint_at(surfel, {}, p - glm::ivec2{0, 1}).uv) * 128.0;
    for (int c = 0; c < 2; ++c) {
      // Central differences over 2/256 px: their error is of the third derivative, here below 1e-7.
      EXPECT_NEAR(f.duv_dx[c], du[c], 1e-7);
      EXPECT_NEAR(f.duv_dy[c], dv[c], 1e-7);
    }
  });
  EXPECT_GT(n, 100);
  EXPECT_GT(longest, 0.9);
  EXPECT_LE(longest, 1.0 + 1e-12);
}

TEST(SurfelFootprint, OfADiscAcrossTheViewRunsRightAndUp) {
  // For the normal (0, 0, 1) the basis is (1, 0, 0), (0, 1, 0).
  const SurfelCase s{{0.0f, 0.0f, 0.0f}, {0, 0, 2}, 4.0f, pixels_16(), {0, 0}, {16, 16}};
  const Surfel surfel = *surfel_of(s);
  const Footprint f = footprint_at(surfel, {}, {10 * 256, 8 * 256});
  EXPECT_DOUBLE_EQ(f.uv.x, 0.75);
  EXPECT_DOUBLE_EQ(f.uv.y, 0.5);
  EXPECT_DOUBLE_EQ(f.duv_dx.x, 0.125);
  EXPECT_DOUBLE_EQ(f.duv_dy.y, -0.125);
  const VertexUvs uvs = std::array<glm::vec2, 3>{glm::vec2{0.25f, 7.0f}, glm::vec2{}, glm::vec2{}};
  EXPECT_EQ(footprint_at(surfel, uvs, {10 * 256, 8 * 256}).uv, glm::dvec2(0.25, 7.0));
  EXPECT_EQ(footprint_at(surfel, uvs, {10 * 256, 8 * 256}).duv_dx, glm::dvec2(0.0));
}

TEST(SurfelFootprint, HasAnOrthonormalBasisForEveryNormal) {
  // Seen across its normal, a disc's coordinate moves by 1/(2r) per pixel in a direction and its perpendicular.
  for (const glm::vec3 normal : {glm::vec3{0, 0, 1}, {0, 0, -1}, {0, -0.0f, -3}, {1e-30f, 0, -1}}) {
    const SurfelCase s{{0.0f, 0.0f, 0.0f}, normal, 4.0f, pixels_16(), {0, 0}, {16, 16}};
    const Footprint f = footprint_at(*surfel_of(s), {}, {8 * 256, 8 * 256});
    EXPECT_DOUBLE_EQ(f.uv.x, 0.5);
    EXPECT_NEAR(f.duv_dx.x * f.duv_dx.x + f.duv_dx.y * f.duv_dx.y, 1.0 / 64.0, 1e-14);  // a few roundings
    EXPECT_NEAR(f.duv_dy.x * f.duv_dy.x + f.duv_dy.y * f.duv_dy.y, 1.0 / 64.0, 1e-14);
    EXPECT_NEAR(f.duv_dx.x * f.duv_dy.x + f.duv_dx.y * f.duv_dy.y, 0.0, 1e-14);
  }
}

TEST(SurfelFootprint, IsFiniteForHostileSurfels) {
  for (std::uint64_t i = 0; i < 3000; ++i) {
    const CounterRandom random{35, i};
    const std::optional<Surfel> surfel = surfel_of(random_surfel(SurfelKind::hostile, random));
    if (!surfel) continue;
    for_each_covered(*surfel, {{0, 0}, {4, 4}}, kCentre, [&](glm::ivec2 pixel) {
      const Footprint f = footprint_at(*surfel, {}, sample_position_fx8(pixel, kCentre));
      for (int c = 0; c < 2; ++c) {
        ASSERT_TRUE(f.uv[c] >= 0.0 && f.uv[c] <= 1.0) << "case " << i;
        ASSERT_TRUE(std::isfinite(f.duv_dx[c]) && std::isfinite(f.duv_dy[c])) << "case " << i;
      }
    });
  }
}

}  // namespace
}  // namespace lode::tests

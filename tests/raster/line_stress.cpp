/// Lines against the oracle of line_oracle.h: notes/numerics.md, stress counts, rows "slivers" and "lines".

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <utility>

#include "raster/reference/line.h"
#include "tests/raster/counter_random.h"
#include "tests/raster/covered_pixels.h"
#include "tests/raster/line_oracle.h"

namespace lode::tests {
namespace {

using namespace raster;
using namespace raster::reference;

struct Ends {
  glm::ivec2 a, b;
};

/// Ends along x, then mirrored and transposed into any octant.
Ends in_any_octant(const CounterRandom& random, glm::ivec2 a, glm::ivec2 b) {
  const auto octant = random.integer(90, 0, 7);
  for (glm::ivec2* p : {&a, &b}) {
    if (octant & 1) p->x = -p->x;
    if (octant & 2) p->y = -p->y;
    if (octant & 4) std::swap(p->x, p->y);
  }
  return {a, b};
}

Ends random_ends(const CounterRandom& random) {
  const auto any = [&](std::uint64_t purpose, int limit) { return random.integer(purpose, -limit, limit); };
  switch (random.integer(0, 0, 4)) {
    case 0:  // a few pixels, anywhere
      return {{any(1, 1024), any(2, 1024)}, {any(3, 1024), any(4, 1024)}};
    case 1:  // on centres, diamond corners, boundaries
      return {{64 * any(1, 16), 64 * any(2, 16)}, {64 * any(3, 16), 64 * any(4, 16)}};
    case 2: {  // slivers: up to 65,536 px long, at most a few sub-pixels high
      const int y = any(2, 1000);
      return in_any_octant(random, {-random.integer(1, 0, kGuard_fx8), y},
                           {random.integer(3, 0, kGuard_fx8), y + any(4, 3)});
    }
    case 3: {  // within a few sub-pixels of 45°
      const int length = random.integer(3, 1, kGuard_fx8 - 2000), y = any(2, 1000);
      return in_any_octant(random, {any(1, 500), y}, {length, length + y + any(4, 2)});
    }
    default:  // across the guard band
      return {{any(1, kGuard_fx8), any(2, kGuard_fx8)}, {any(3, kGuard_fx8), any(4, kGuard_fx8)}};
  }
}

Line line_of(const Ends& ends) { return *make_line({ends.a, 0.5, 1.0}, {ends.b, 0.5, 1.0}); }

/// 7 × 7 pixels around a point of the segment: either end, or anywhere.
PixelBox window_on(const CounterRandom& random, const Ends& e) {
  const int where = random.integer(50, 0, 3);
  const double t = where == 0 ? 0.0 : where == 1 ? 1.0 : 0.5 + 0.5 * random.real(51);
  const glm::dvec2 p = glm::dvec2(e.a) + t * (glm::dvec2(e.b) - glm::dvec2(e.a));
  const glm::ivec2 pixel = glm::ivec2(p) >> 8;
  return {pixel - 3, pixel + 4};
}

TEST(LineStress, CoverageEqualsTheOracle) {
  const std::uint64_t count = stress_count(1'000'000);
  std::uint64_t fragments = 0, tests = 0;
  for (std::uint64_t i = 0; i < count; ++i) {
    const CounterRandom random{101, i};
    const Ends ends = random_ends(random);
    if (ends.a == ends.b) continue;
    const glm::ivec2 sample = i % 2 == 0 ? kCentre : glm::ivec2{random.integer(60, 0, 255), random.integer(61, 0, 255)};
    const PixelBox window = window_on(random, ends);
    const Pixels pixels = covered(line_of(ends), window, sample);
    Pixels expected;
    for (int y = window.begin_px.y; y < window.end_px.y; ++y) {
      for (int x = window.begin_px.x; x < window.end_px.x; ++x) {
        ++tests;
        if (oracle_exits_diamond(ends.a, ends.b, sample_position_fx8({x, y}, sample))) expected.emplace_back(y, x);
      }
    }
    fragments += pixels.size();
    ASSERT_EQ(pixels, expected) << "case " << i;
  }
  std::printf("lines: %llu, pixel tests: %llu, fragments: %llu\n", static_cast<unsigned long long>(count),
              static_cast<unsigned long long>(tests), static_cast<unsigned long long>(fragments));
  EXPECT_GT(fragments, count);
}

TEST(LineStress, LongLinesHaveOneFragmentAColumnInOrderAndAnyWindowHasItsShare) {
  const std::uint64_t count = stress_count(200);
  std::uint64_t fragments = 0;
  for (std::uint64_t i = 0; i < count; ++i) {
    const CounterRandom random{102, i};
    const Ends ends = random_ends(random);
    if (ends.a == ends.b) continue;
    Line line = line_of(ends);
    const PixelBox all{glm::ivec2(-40000), glm::ivec2(40000)};
    const LineColumns columns = columns_of(line, kCentre);
    int next = columns.begin;
    for_each_covered(line, all, kCentre, [&](glm::ivec2 p) { ASSERT_EQ(p[columns.major], next++) << "case " << i; });
    ASSERT_EQ(next, columns.end) << "case " << i;
    fragments += fragment_count(line, kCentre);
    // Stippled, in strips of random width across the major axis.
    line.stipple = LineStipple{{std::uint16_t(random.bits(70)), random.integer(71, 1, 256)}, random.bits(72) >> 32};
    Pixels strips;
    for (int at = -33000, k = 0; at < 33000; ++k) {
      PixelBox window = all;
      window.begin_px[columns.major] = at;
      at += random.integer(std::uint64_t(1000 + k), 1, 4000);
      window.end_px[columns.major] = at;
      for_each_covered(line, window, kCentre, [&](glm::ivec2 p) { strips.emplace_back(p.y, p.x); });
    }
    std::sort(strips.begin(), strips.end());
    ASSERT_EQ(strips, covered(line, all)) << "case " << i;
  }
  std::printf("lines: %llu, fragments: %llu\n", static_cast<unsigned long long>(count),
              static_cast<unsigned long long>(fragments));
}

TEST(LineStress, ASegmentCutInItsOwnPointsHasTheSameFragmentsOnceEach) {
  const std::uint64_t count = stress_count(50'000);
  for (std::uint64_t i = 0; i < count; ++i) {
    const CounterRandom random{103, i};
    const int unit = 1 << random.integer(0, 0, 7);
    const glm::ivec2 a{random.integer(1, -4000, 4000) & -unit, random.integer(2, -4000, 4000) & -unit};
    const glm::ivec2 step{unit * random.integer(3, -9, 9), unit * random.integer(4, -9, 9)};
    if (step == glm::ivec2(0)) continue;
    const int n = random.integer(5, 1, 12);
    const PixelBox window{glm::ivec2(-100), glm::ivec2(100)};
    Pixels pieces;
    std::uint64_t sum = 0;
    for (int k = 0; k < n; ++k) {
      const Line piece = line_of({a + k * step, a + (k + 1) * step});
      add_covered(pieces, piece, window);
      sum += fragment_count(piece, kCentre);
    }
    const Line whole = line_of({a, a + n * step});
    ASSERT_EQ(pieces, covered(whole, window)) << "case " << i;
    ASSERT_EQ(sum, fragment_count(whole, kCentre)) << "case " << i;
  }
  std::printf("cut segments: %llu\n", static_cast<unsigned long long>(count));
}

TEST(LineStress, ClosedConvexOutlinesHaveEachPixelOnceAndNoGap) {
  const std::uint64_t count = stress_count(20'000);
  for (std::uint64_t i = 0; i < count; ++i) {
    // An octagon of pixel centres: sides along axes and diagonals of random length, each turned by 45°, so that
    // two sides meet at 135° and share the corner's pixel only.
    const CounterRandom random{104, i};
    const int right = random.integer(0, 1, 30), diagonal = random.integer(1, 1, 30), down = random.integer(2, 1, 30);
    const glm::ivec2 sides[] = {{right, 0},  {diagonal, diagonal},   {0, down},  {-diagonal, diagonal},
                                {-right, 0}, {-diagonal, -diagonal}, {0, -down}, {diagonal, -diagonal}};
    const bool reversed = random.integer(3, 0, 1) == 1;
    glm::ivec2 at{random.integer(4, -50, 50), random.integer(5, -50, 50)};
    Pixels pixels;
    for (const glm::ivec2 side : sides) {
      const glm::ivec2 from = at * 256 + 128, to = (at + side) * 256 + 128;
      add_covered(pixels, reversed ? line_of({to, from}) : line_of({from, to}), {glm::ivec2(-300), glm::ivec2(300)});
      at += side;
    }
    // One pixel per step along each side, no two the same.
    ASSERT_EQ(pixels.size(), std::size_t(2 * right + 4 * diagonal + 2 * down)) << "case " << i;
    ASSERT_EQ(std::adjacent_find(pixels.begin(), pixels.end()), pixels.end()) << "case " << i;
  }
  std::printf("outlines: %llu\n", static_cast<unsigned long long>(count));
}

}  // namespace
}  // namespace lode::tests

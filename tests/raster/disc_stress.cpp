/// Squares and discs against GMP: notes/numerics.md, stress counts, row "lines, discs, surfels".

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "raster/reference/disc.h"
#include "tests/raster/counter_random.h"
#include "tests/raster/covered_pixels.h"

namespace lode::tests {
namespace {

using namespace raster;
using namespace raster::reference;

/// (p − c)² − r² ≤ 0 along both axes together, in units of 1/256 px.
bool oracle_disc(glm::ivec2 c, int r, glm::ivec2 p) {
  const mpz_class dx = mpz_class(p.x) - c.x, dy = mpz_class(p.y) - c.y, radius = r;
  return dx * dx + dy * dy <= radius * radius;
}
/// Twice the distance to the upper left corner, in [0, 2 · size).
bool oracle_square(glm::ivec2 c, int size, glm::ivec2 p) {
  for (int i = 0; i < 2; ++i) {
    const mpz_class from_corner = 2 * (mpz_class(p[i]) - c[i]) + size;
    if (from_corner < 0 || from_corner >= 2 * mpz_class(size)) return false;
  }
  return true;
}

template <class Primitive, class Oracle>
void compare(const char* name, std::uint64_t seed, Oracle oracle) {
  const std::uint64_t count = stress_count(1'000'000);
  std::uint64_t inside = 0, tests = 0;
  for (std::uint64_t i = 0; i < count; ++i) {
    const CounterRandom random{seed, i};
    const int size = random.integer(0, 0, 3) == 0   ? random.integer(1, 1, kMaxSize_fx8)
                     : random.integer(0, 0, 3) == 1 ? 128 * random.integer(1, 1, 40)
                                                    : random.integer(1, 1, 2000);
    const int limit = i % 4 == 0 ? kGuard_fx8 : 2000;
    const glm::ivec2 c{random.integer(2, -limit, limit), random.integer(3, -limit, limit)};
    const glm::ivec2 sample{random.integer(4, 0, 4) * 51, random.integer(5, 0, 255)};
    // 5 × 5 pixels around a point of the rim of a disc of this radius, or half of it, for a square's side.
    const double angle = 3.2 * random.real(6), reach = std::is_same_v<Primitive, Square> ? 0.5 * size : size;
    const double x = std::min(1.0, 1.5 * std::cos(angle)) * reach, y = std::sin(angle) * reach;
    const bool flat = std::is_same_v<Primitive, Square>;
    const glm::dvec2 rim{c.x + (flat ? x : std::cos(angle) * reach), c.y + y};
    const glm::ivec2 pixel = glm::ivec2(glm::clamp(rim, -double(kGuard_fx8), double(kGuard_fx8 - 1))) >> 8;
    const Primitive primitive{c, size, 0.5};
    const PixelBox window{pixel - 2, pixel + 3};
    Pixels expected;
    for (int py = window.begin_px.y; py < window.end_px.y; ++py) {
      for (int px = window.begin_px.x; px < window.end_px.x; ++px) {
        ++tests;
        if (oracle(c, size, sample_position_fx8({px, py}, sample))) expected.emplace_back(py, px);
      }
    }
    inside += expected.size();
    ASSERT_EQ(covered(primitive, window, sample), expected) << "case " << i;
  }
  std::printf("%s: %llu, pixel tests: %llu, inside: %llu\n", name, static_cast<unsigned long long>(count),
              static_cast<unsigned long long>(tests), static_cast<unsigned long long>(inside));
  EXPECT_GT(inside, tests / 5);
  EXPECT_LT(inside, tests - tests / 5);
}

TEST(DiscStress, DiscsEqualTheOracle) { compare<Disc>("discs", 111, oracle_disc); }
TEST(DiscStress, SquaresEqualTheOracle) { compare<Square>("squares", 112, oracle_square); }

}  // namespace
}  // namespace lode::tests

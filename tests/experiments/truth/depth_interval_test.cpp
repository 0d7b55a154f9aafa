/// Depth over all placements: against placements themselves, and the double evaluation against the exact one.

#include "experiments/truth/depth_interval.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/experiments/truth/placements.h"

namespace lode::experiments::truth {
namespace {

std::array<ExactVertex, 3> as_array(const ExactPolygon& t) { return {t[0], t[1], t[2]}; }

std::array<Vertex, 3> as_array(const Polygon& t) { return {t.v[0], t.v[1], t.v[2]}; }

/// The depth that a renderer gives this placement (C5): interpolated, clamped to the vertices'. Nothing without area.
std::optional<Rational> depth_at(const ExactPolygon& t, glm::dvec2 s) {
  const Rational e0 = cross(t[1], t[2], s), e1 = cross(t[2], t[0], s), e2 = cross(t[0], t[1], s), area = e0 + e1 + e2;
  if (area == 0) return std::nullopt;
  const Rational z = (e0 * t[0].z + e1 * t[1].z + e2 * t[2].z) / area;
  return std::clamp(z, std::min({t[0].z, t[1].z, t[2].z}), std::max({t[0].z, t[1].z, t[2].z}));
}

TEST(DepthInterval, NoPlacementLeavesIt) {
  for (std::uint64_t i = 0; i < 600; ++i) {
    Random random(11, 1, i);
    const ExactPolygon t = random_triangle(random);
    const glm::dvec2 s = random_sample(t, random);
    const DepthInterval interval = exact_depth_interval(as_array(t), s, kSnap_px, 0.0);
    for (int k = 0; k < 10; ++k) {
      const ExactPolygon moved = {placed(t[0], random), placed(t[1], random), placed(t[2], random)};
      const std::optional<Rational> z = depth_at(moved, s);
      if (!z) continue;
      ASSERT_LE(Rational(interval.low), *z) << "case " << i;
      ASSERT_GE(Rational(interval.high), *z) << "case " << i;
    }
  }
}

/// Where the area keeps its sign, some corner of the six squares gives each end, up to the rounding outwards.
TEST(DepthInterval, IsAttained) {
  for (std::uint64_t i = 0; i < 100; ++i) {
    Random random(12, 1, i);
    const ExactPolygon t = random_triangle(random);
    const glm::dvec2 s = random_sample(t, random);
    Rational low = 2, high = -1;
    int n_signs[3] = {0, 0, 0};
    for (int corner = 0; corner < 64; ++corner) {
      ExactPolygon moved = t;
      for (std::size_t v = 0; v < 3; ++v) {
        moved[v].x_px += Rational(corner >> (2 * v) & 1 ? kSnap_px : -kSnap_px);
        moved[v].y_px += Rational(corner >> (2 * v + 1) & 1 ? kSnap_px : -kSnap_px);
      }
      ++n_signs[1 + sgn(cross(moved[0], moved[1], {0, 0}) + cross(moved[1], moved[2], {0, 0}) +
                        cross(moved[2], moved[0], {0, 0}))];
      const std::optional<Rational> z = depth_at(moved, s);
      if (!z) continue;
      low = std::min(low, *z);
      high = std::max(high, *z);
    }
    if (n_signs[0] != 64 && n_signs[2] != 64) continue;
    const DepthInterval interval = exact_depth_interval(as_array(t), s, kSnap_px, 0.0);
    EXPECT_NEAR(interval.low, low.get_d(), 1e-14);
    EXPECT_NEAR(interval.high, high.get_d(), 1e-14);
  }
}

TEST(DepthInterval, IsTheVerticesRangeWhereTheAreaMayVanish) {
  const std::array<ExactVertex, 3> t = {ExactVertex{0, Rational(1, 2), Rational(1, 4)},
                                        ExactVertex{8, Rational(1, 2), Rational(1, 2)},
                                        ExactVertex{4, Rational(1, 2) + Rational(1, 1024), Rational(3, 4)}};
  const DepthInterval interval = exact_depth_interval(t, {3.5, 0.5}, kSnap_px, 0.0);
  EXPECT_NEAR(interval.low, 0.25, 1e-14);
  EXPECT_NEAR(interval.high, 0.75, 1e-14);
}

/// It holds the exact one and is wider by less than a sixteenth of a float's rounding.
TEST(DepthInterval, InDoubleHoldsTheExactOne) {
  int n_decided = 0;
  for (std::uint64_t i = 0; i < 1000; ++i) {
    Random random(13, 1, i);
    const ExactPolygon t = random_triangle(random);
    const Polygon in_double = rounded(t);
    const glm::dvec2 s = random_sample(t, random);
    const double error_z = 0x1p-52;  // of the vertices' depths, rounded to double
    const std::optional<DepthInterval> found =
        depth_interval(as_array(in_double), s, kSnap_px, in_double.error_px, error_z);
    if (!found) continue;
    ++n_decided;
    const DepthInterval exact = exact_depth_interval(as_array(t), s, kSnap_px, 0.0);
    EXPECT_LE(found->low, exact.low + 1e-15) << "case " << i;
    EXPECT_GE(found->high, exact.high - 1e-15) << "case " << i;
    EXPECT_NEAR(found->low, exact.low, 0x1p-27) << "case " << i;
    EXPECT_NEAR(found->high, exact.high, 0x1p-27) << "case " << i;
  }
  EXPECT_GT(n_decided, 800);
}

TEST(DepthInterval, HoldsAFloatIfItIsARoundedOneOfItsDepths) {
  const double middle = 0.5 + 0x1p-26;  // between two floats: 0.5 and the next, 0.5 + 2^-24, it rounds to 0.5
  const DepthInterval interval{middle, middle};
  EXPECT_TRUE(interval.contains(0.5f));
  EXPECT_FALSE(interval.contains(std::nextafter(0.5f, 1.0f)));
  EXPECT_FALSE(interval.contains(std::nextafter(0.5f, 0.0f)));
}

}  // namespace
}  // namespace lode::experiments::truth

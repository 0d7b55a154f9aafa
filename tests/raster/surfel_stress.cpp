/// Surfels against the oracle of surfel_oracle.h: notes/numerics.md, stress counts, row "lines, discs, surfels". Coverage at the
/// samples, all 1/256 px apart, on either side of the rim or of a clipping plane; depth at those inside.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "raster/reference/surfel.h"
#include "tests/raster/counter_random.h"
#include "tests/raster/surfel_cases.h"
#include "tests/raster/surfel_oracle.h"

namespace lode::tests {
namespace {

using namespace raster::reference;

/// Neighbouring positions on a line from p, one like p and one not, or p twice where all are like p.
std::array<glm::ivec2, 2> boundary_from(const Surfel& surfel, glm::ivec2 p, glm::ivec2 direction) {
  const bool inside = covers(surfel, p);
  int low = 0, high = 1;  // in steps of 1/256 px along the direction's longer axis
  const auto at = [&](int n) {
    const int longest = std::max(std::abs(direction.x), std::abs(direction.y));
    return p + glm::ivec2(std::int64_t(n) * direction.x / longest, std::int64_t(n) * direction.y / longest);
  };
  while (high < (1 << 22) && covers(surfel, at(high)) == inside) low = high, high *= 2;
  if (high >= (1 << 22)) return {p, p};
  while (high - low > 1) {
    const int middle = low + (high - low) / 2;
    (covers(surfel, at(middle)) == inside ? low : high) = middle;
  }
  return {at(low), at(high)};
}

void compare(const char* name, SurfelKind kind, std::uint64_t ci_count) {
  const std::uint64_t count = stress_count(ci_count);
  std::uint64_t drawn = 0, inside = 0, samples = 0;
  double worst_depth = 0.0;
  for (std::uint64_t i = 0; i < count; ++i) {
    const CounterRandom random{121, i};
    const SurfelCase s = random_surfel(kind, random);
    const std::optional<Surfel> surfel =
        make_surfel(s.centre, s.normal, s.radius, s.clip_from_object, s.viewport_origin_px, s.viewport_size_px);
    const SurfelOracle oracle(s);
    const glm::ivec2 middle = middle_of(s) * 256 + glm::ivec2{random.integer(700, 0, 255), random.integer(701, 0, 255)};
    std::array<glm::ivec2, 3> positions{middle, middle, middle};
    if (surfel) {
      ++drawn;
      const std::array<glm::ivec2, 2> pair =
          boundary_from(*surfel, middle, {random.integer(702, -100, 100), random.integer(703, 1, 100)});
      positions = {middle, pair[0], pair[1]};
    }
    for (const glm::ivec2 p : positions) {
      ++samples;
      const bool is_covered = surfel && covers(*surfel, p);
      ASSERT_EQ(is_covered, oracle.covers(p)) << name << " case " << i << " at " << p.x << ", " << p.y;
      if (!is_covered) continue;
      ++inside;
      const float z = depth_at(*surfel, p);
      ASSERT_TRUE(z >= 0.0f && z <= 1.0f) << name << " case " << i;
      const double ulp = double(std::nextafter(z, 2.0f)) - double(z);
      const double error = mpq_class(abs(mpq_class(z) - oracle.depth(p)) / mpq_class(ulp)).get_d();
      ASSERT_LE(error, 0.501) << name << " case " << i;
      worst_depth = std::max(worst_depth, error);
    }
  }
  std::printf("%s surfels: %llu, drawn: %llu, samples: %llu, inside: %llu, worst depth error: %.6f ULP\n", name,
              static_cast<unsigned long long>(count), static_cast<unsigned long long>(drawn),
              static_cast<unsigned long long>(samples), static_cast<unsigned long long>(inside), worst_depth);
  EXPECT_GT(inside, count / 5);
}

TEST(SurfelStress, SceneSurfelsEqualTheOracle) { compare("scene", SurfelKind::scene, 600'000); }
TEST(SurfelStress, StructuredSurfelsEqualTheOracle) { compare("structured", SurfelKind::structured, 300'000); }
TEST(SurfelStress, HostileSurfelsEqualTheOracle) { compare("hostile", SurfelKind::hostile, 100'000); }

}  // namespace
}  // namespace lode::tests

/// Conservative slabs against exact point-in-polygon tests at the stress count: 10^6 points in CI, 10^8 long.

#include <gtest/gtest.h>

#include "tests/geometry/slab_cases.h"
#include "tests/raster/stress_count.h"

namespace lode::geometry {
namespace {

TEST(SlabStress, ConservativeAnswersHoldAtEveryPoint) {
  const std::uint64_t n = raster::test::stress_count("points in covered occludees", 1'000'000, 100'000'000);
  test::SlabTally tally;
  for (std::uint64_t i = 0; tally.points < n; ++i) {
    const SlabParams params = {.y_bins = i % 3 == 0 ? 480 : 0, .margin_px = i % 2 == 0 ? 0.0 : 1.0 / 256.0};
    test::slab_case(i, params, 50, tally);
  }
  EXPECT_EQ(tally.false_answers, 0u);
}

}  // namespace
}  // namespace lode::geometry

// Any subset of occluders, against the union that is made of just these.
#include "geometry/slab_occluders.h"

#include <gtest/gtest.h>

#include "geometry/random.h"

namespace lode::geometry {
namespace {

constexpr int kSlabs = 8;

/// Some slabs, small whole numbers: intervals often touch, at times are empty or points.
SlabFootprint random_footprint(Random& random) {
  SlabFootprint footprint;
  footprint.first = int(random.below(kSlabs));
  const std::uint32_t n = 1 + random.below(std::uint32_t(kSlabs - footprint.first));
  for (std::uint32_t i = 0; i < n; ++i) {
    const double low = random.below(10);
    footprint.intervals.push_back({low, low + double(random.below(6)) - 1.0});
  }
  return footprint;
}

TEST(SlabOccluders, CoverWhatTheUnionOfTheSubsetCovers) {
  int n_covered = 0;
  for (std::uint64_t seed = 0; seed < 3000; ++seed) {
    Random random(seed, 1);
    SlabOccluders all(kSlabs);
    SlabUnion some(kSlabs);
    std::vector<std::uint8_t> counts;
    for (int k = 0; k < 12; ++k) {
      const SlabFootprint occluder = random_footprint(random);
      all.add(occluder);
      counts.push_back(random.below(4) != 0 ? 1 : 0);
      if (counts.back() != 0) some.add(occluder);
    }
    all.sort();
    for (int k = 0; k < 8; ++k) {
      const SlabFootprint occludee = random_footprint(random);
      const bool covered = some.covers(occludee);
      EXPECT_EQ(all.cover(occludee, counts), covered) << "seed " << seed;
      n_covered += covered ? 1 : 0;
    }
  }
  EXPECT_GT(n_covered, 2000);
}

TEST(SlabOccluders, AreGoneWhenCleared) {
  SlabOccluders all(kSlabs);
  all.add({0, {{0.0, 5.0}}});
  all.sort();
  const std::uint8_t counts[] = {1};
  EXPECT_TRUE(all.cover({0, {{1.0, 2.0}}}, counts));
  all.clear();
  EXPECT_EQ(all.size(), 0u);
  EXPECT_FALSE(all.cover({0, {{1.0, 2.0}}}, {}));
  EXPECT_TRUE(all.cover({}, {}));  // nothing is covered by nothing
}

}  // namespace
}  // namespace lode::geometry

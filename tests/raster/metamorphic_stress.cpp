// notes/numerics.md, stress counts: metamorphic relations at full counts, each relation that many cases.

#include <gtest/gtest.h>

#include <atomic>

#include "metamorphic_cases.h"
#include "raster/parallel.h"
#include "stress_count.h"

namespace lode::raster {
namespace {

using namespace test;

TEST(MetamorphicStress, NoRelationChangesABit) {
  const std::uint64_t n_cases = stress_count("cases of each relation", 100'000, 10'000'000);
  for (const Relation& relation : kRelations) {
    std::atomic<std::uint64_t> n_wrong = 0, first_wrong = ~0ull;
    parallel_for((n_cases + 99) / 100, worker_count(0), [&](std::size_t chunk, int) {
      for (std::uint64_t seed = 100 * chunk; seed < std::min<std::uint64_t>(100 * chunk + 100, n_cases); ++seed) {
        const int wrong = relation.wrong(seed + 1'000'000);
        if (wrong == 0) continue;
        n_wrong += std::uint64_t(wrong);
        for (std::uint64_t first = first_wrong; seed < first && !first_wrong.compare_exchange_weak(first, seed);) {
        }
      }
    });
    std::printf("[  COUNT   ] %s: %llu samples differ\n", relation.name, (unsigned long long)n_wrong);
    EXPECT_EQ(n_wrong, 0u) << relation.name << ": first with seed " << first_wrong + 1'000'000;
  }
}

}  // namespace
}  // namespace lode::raster

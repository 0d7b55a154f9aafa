/// Orientation signs at the stress count: 10^7 cases in CI, 10^9 long.

#include <gtest/gtest.h>

#include <algorithm>
#include <thread>
#include <vector>

#include "geometry/predicates.h"
#include "tests/geometry/predicates_cases.h"
#include "tests/raster/stress_count.h"

namespace lode::geometry {
namespace {

TEST(OrientationStress, SignsEqualTheRationals) {
  const std::uint64_t n = raster::test::stress_count("signs", 10'000'000, 1'000'000'000) / 2;  // two a case
  const unsigned n_threads = std::max(1u, std::thread::hardware_concurrency());
  std::vector<std::uint64_t> wrong(n_threads);
  std::vector<std::thread> threads;
  for (unsigned t = 0; t < n_threads; ++t) {
    threads.emplace_back(
        [&, t] { wrong[t] = test::wrong_signs(n * t / n_threads, n * (t + 1) / n_threads, orientation, orientation); });
  }
  for (auto& thread : threads) thread.join();
  for (const std::uint64_t w : wrong) EXPECT_EQ(w, 0u);
}

}  // namespace
}  // namespace lode::geometry

// The fast pipeline against the reference: random frames of mixed primitives and states at the best target and two
// threads, and some of them over every target, {1, 2, 3, 7, 16} threads and every choice of skips. A tenth of the long
// run's 10^5 and 10^3, so that all stress tests fit their time.
#include <atomic>

#include "fast_equality.h"
#include "raster/parallel.h"
#include "stress_count.h"

namespace lode::raster::test {
namespace {

constexpr int kMostFailures = 5;  // printed, each bisected

/// check(seed, memory) for seeds [0, n), on all processors, until there are enough failures.
template <class Check>
void for_seeds(std::uint64_t n, Check check) {
  std::atomic<int> n_failed = 0;
  const int workers = worker_count(0);
  std::vector<FrameMemory> memories{std::size_t(workers)};
  parallel_for((n + 15) / 16, workers, [&](std::size_t chunk, int worker) {
    for (std::uint64_t seed = 16 * chunk; seed < std::min<std::uint64_t>(16 * chunk + 16, n); ++seed) {
      if (n_failed < kMostFailures && !check(seed, memories[std::size_t(worker)])) ++n_failed;
    }
  });
}

TEST(FastEqualityStress, OfRandomFramesWithTheReference) {
  for_seeds(stress_count("random frames", 10'000, 100'000), [](std::uint64_t seed, FrameMemory& memory) {
    return expect_same_as_reference(seed, seed % 64 == 63 ? FrameSize::several_tiles : FrameSize::one_tile, memory);
  });
}

// Frames of several tiles one after the other: inside another parallel loop they would not get their threads.
TEST(FastEqualityStress, OnEveryTargetWithAnyThreadsAndSkips) {
  const std::uint64_t n = stress_count("random frames every way", 100, 1'000);
  for_seeds(n - n / 8, [](std::uint64_t seed, FrameMemory& memory) {
    return expect_same_every_way(seed, FrameSize::one_tile, memory);
  });
  FrameMemory memory;
  int n_failed = 0;
  for (std::uint64_t seed = 0; seed < n / 8 && n_failed < kMostFailures; ++seed) {
    n_failed += !expect_same_every_way(seed, FrameSize::several_tiles, memory);
  }
}

}  // namespace
}  // namespace lode::raster::test

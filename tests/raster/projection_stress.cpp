// notes/numerics.md, stress counts: exactly-once through projection, near and far clip and guard band, at full counts.

#include <gtest/gtest.h>

#include "raster/parallel.h"
#include "signed_coverage.h"
#include "stress_count.h"

namespace lode::raster {
namespace {

using namespace test;

struct Tally {
  std::uint64_t n_scenes = 0, n_samples = 0, n_tests = 0, n_clipped = 0, n_turned = 0, n_uncertain = 0, n_inside = 0,
                n_wrong = 0;
  std::string first_wrong;
};

void run(std::uint64_t wanted, Scene (*make)(HashedNumbers&, int)) {
  constexpr std::uint64_t kBatch = 200;
  Tally sum;
  for (std::uint64_t first = 0; sum.n_tests < wanted; first += kBatch) {
    std::vector<Tally> tallies(kBatch);
    parallel_for(kBatch, worker_count(0), [&](std::size_t i, int) {
      HashedNumbers random(first + i + 500);
      const Scene scene = make(random, 1 << (2 + random.below(10)));
      const SceneResult r = check_scene(scene);
      tallies[i] = {1,
                    r.coverage.sum.size(),
                    r.coverage.n_tests,
                    r.coverage.n_clipped,
                    r.coverage.n_turned,
                    r.n_uncertain,
                    r.n_inside,
                    r.n_wrong,
                    r.first_wrong};
    });
    for (std::uint64_t i = 0; i < kBatch; ++i) {
      const Tally& t = tallies[i];
      if (sum.n_wrong == 0 && t.n_wrong > 0)
        sum.first_wrong = "scene " + std::to_string(first + i) + ": " + t.first_wrong;
      sum.n_scenes += t.n_scenes;
      sum.n_samples += t.n_samples;
      sum.n_tests += t.n_tests;
      sum.n_clipped += t.n_clipped;
      sum.n_turned += t.n_turned;
      sum.n_uncertain += t.n_uncertain;
      sum.n_inside += t.n_inside;
      sum.n_wrong += t.n_wrong;
    }
  }
  const auto print = [](const char* what, std::uint64_t n) {
    std::printf("[  COUNT   ] done: %llu %s\n", (unsigned long long)n, what);
  };
  print("pixel tests", sum.n_tests);
  print("scenes", sum.n_scenes);
  print("pieces of cut triangles", sum.n_clipped);
  print("of them in polygons with a turned piece", sum.n_turned);
  print("samples", sum.n_samples);
  print("of them with a count that must not be 0", sum.n_inside);
  print("of them within 1/32 px of a border or cut, not judged", sum.n_uncertain);
  print("gaps and doubles", sum.n_wrong);
  EXPECT_EQ(sum.n_wrong, 0u) << sum.first_wrong;
  EXPECT_LT(sum.n_uncertain, sum.n_samples / 20);
  EXPECT_GT(sum.n_clipped, 0u);
}

TEST(ProjectionStress, SheetsAreCoveredExactlyOnce) {
  run(stress_count("pixel tests", 100'000'000, 10'000'000'000), random_sheet_scene);
}

TEST(ProjectionStress, ClosedMeshesAreCoveredAsOftenFromTheFrontAsFromTheBack) {
  run(stress_count("pixel tests", 100'000'000, 10'000'000'000), random_closed_scene);
}

}  // namespace
}  // namespace lode::raster

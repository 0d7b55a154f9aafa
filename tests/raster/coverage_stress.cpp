// notes/numerics.md, stress counts: shared edges exactly once, slivers, and the 128-bit oracle, at full counts.

#include <gtest/gtest.h>

#include "raster/parallel.h"
#include "stress_count.h"
#include "window_meshes.h"

namespace lode::raster {
namespace {

using namespace test;
using reference::PixelBox;

/// Sums of one worker; what fails first is told by its case's seed.
struct Tally {
  std::uint64_t n_tests = 0, n_covered = 0, n_wrong = 0, n_cases = 0;
  std::uint64_t first_wrong_case = ~0ull;
  void add(std::uint64_t seed, std::uint64_t wrong) {
    ++n_cases;
    n_wrong += wrong;
    if (wrong != 0) first_wrong_case = std::min(first_wrong_case, seed);
  }
};

/// Runs cases first, first + 1, … on all processors in batches until the tests counted reach `wanted`.
template <class Case>
Tally run_until(std::uint64_t wanted, std::uint64_t batch, const Case& run_case) {
  const int n_workers = worker_count(0);
  std::vector<Tally> tallies(std::size_t(n_workers) * 8);  // each in cache lines of its own
  Tally sum;
  for (std::uint64_t first = 0; sum.n_tests < wanted; first += batch) {
    parallel_for(batch, n_workers,
                 [&](std::size_t i, int worker) { run_case(first + i, tallies[std::size_t(worker) * 8]); });
    sum = {};
    for (const Tally& t : tallies) {
      sum.n_tests += t.n_tests;
      sum.n_covered += t.n_covered;
      sum.n_wrong += t.n_wrong;
      sum.n_cases += t.n_cases;
      sum.first_wrong_case = std::min(sum.first_wrong_case, t.first_wrong_case);
    }
  }
  return sum;
}

TEST(SharedEdgesStress, EachSampleOfAMeshIsCoveredExactlyOnce) {
  const std::uint64_t wanted = stress_count("pixel tests", 10'000'000'000, 1'000'000'000'000);
  constexpr int kSize_px = 256;
  const Tally sum = run_until(wanted, 1000, [](std::uint64_t seed, Tally& tally) {
    HashedNumbers random(seed + 1000);
    const WindowMesh mesh = random_mesh(random, kSize_px);
    tally.add(seed, std::uint64_t(wrong_samples(mesh, kSize_px, tally.n_tests)));
  });
  std::printf("[  COUNT   ] done: %llu pixel tests in %llu meshes, %llu gaps and doubles\n",
              (unsigned long long)sum.n_tests, (unsigned long long)sum.n_cases, (unsigned long long)sum.n_wrong);
  EXPECT_EQ(sum.n_wrong, 0u) << "first in mesh " << sum.first_wrong_case;
}

/// A sliver a–b–c with c one sub-pixel from b, pointing into one of eight octants; up to 65,536 px long.
Corners random_sliver(HashedNumbers& random) {
  constexpr std::int32_t g = reference::kGuard_fx8;
  const double length_px = std::exp2(16.0 * random.unit());
  const std::int32_t along = std::int32_t(256.0 * length_px);
  const std::int32_t across = random.below(2) == 0 ? random.between(0, 1) : random.between(0, along);
  glm::ivec2 d{along, across};
  glm::ivec2 step{0, 1};  // one sub-pixel high, seen along the longer axis
  const std::uint32_t octant = random.below(8);
  if (octant & 1) {
    std::swap(d.x, d.y);
    std::swap(step.x, step.y);
  }
  if (octant & 2) d.x = -d.x;
  if (octant & 4) d.y = -d.y;
  const auto start = [&](std::int32_t delta) {  // so that both ends lie in the guard band
    const std::int32_t low = std::max(-g, -g - delta), high = std::min(g, g - delta) - 1;
    const std::int32_t x = low >= high ? low : random.between(low, high);
    return random.below(2) == 0 ? std::clamp(256 * (x >> 8) + 128, std::min(low, high), high) : x;
  };
  const glm::ivec2 a{start(d.x), start(d.y)};
  const glm::ivec2 c = glm::clamp(a + d + (random.below(2) == 0 ? step : -step), -g, g);
  return {a, a + d, c};
}

/// Walks [begin, end) of one row against the crossing of the outline with it.
std::uint64_t wrong_in_row(const Corners& t, const reference::Triangle& triangle, int y, int begin, int end,
                           Tally& tally) {
  const std::int32_t y_fx8 = 256 * y + 128;
  int low = end - begin, high = 0;  // the row's samples inside: [begin + low, begin + high)
  const glm::ivec2 origin{256 * begin, 0};
  for (std::size_t k = 0; k < 3; ++k) {
    const glm::ivec2 a = t[k] - origin, b = t[(k + 1) % 3] - origin;
    if ((a.y > y_fx8) == (b.y > y_fx8)) continue;
    const int n = columns_left_of(a, b, y_fx8, end - begin);
    low = std::min(low, n);
    high = std::max(high, n);
  }
  const PixelBox window{{begin, y}, {end, y + 1}};
  int visited = 0, outside = 0;
  reference::for_each_covered(triangle, window, kCentre_fx8, [&](glm::ivec2 px) {
    ++visited;
    outside += px.x - begin < low || px.x - begin >= high;
  });
  tally.n_tests += pixels_in(reference::intersect(reference::bounds_px(triangle, kCentre_fx8), window));
  tally.n_covered += std::uint64_t(visited);
  return std::uint64_t(outside) + std::uint64_t(std::abs(visited - std::max(high - low, 0)));
}

TEST(SliverStress, SliversOneSubPixelHighEqualTheExactRows) {
  const std::uint64_t n_slivers = stress_count("slivers", 1'000'000, 100'000'000);
  const Tally sum = run_until(1, n_slivers, [](std::uint64_t seed, Tally& tally) {
    HashedNumbers random(seed + 77);
    const Corners t = random_sliver(random);
    const std::optional<reference::Triangle> triangle = triangle_of(t);
    std::uint64_t wrong = 0;
    if (triangle) {
      // Flat ones row by row over their whole length; of the others' many rows 24, and all columns near the sliver.
      const PixelBox box = reference::bounds_px(*triangle, kCentre_fx8);
      const int rows = box.end_px.y - box.begin_px.y;
      for (int k = 0; k < std::min(rows, 24); ++k) {
        const int y = rows <= 24 ? box.begin_px.y + k : random.between(box.begin_px.y, box.end_px.y - 1);
        int begin = box.begin_px.x - 1, end = box.end_px.x + 1;
        if (rows > 24) {
          const glm::dvec2 a = t[0], b = t[1];
          const double slope = b.y == a.y ? 0.0 : (b.x - a.x) / (b.y - a.y);
          const int x = int((a.x + slope * (256.0 * y + 128.0 - a.y)) / 256.0), reach = 8 + int(2.0 * std::abs(slope));
          begin = std::max(begin, x - reach);
          end = std::min(end, x + reach);
          if (begin >= end) continue;
        }
        wrong += wrong_in_row(t, *triangle, y, begin, end, tally);
      }
    }
    ++tally.n_tests;
    tally.add(seed, wrong);
  });
  std::printf("[  COUNT   ] done: %llu slivers, %llu pixel tests, %llu samples covered\n",
              (unsigned long long)sum.n_cases, (unsigned long long)sum.n_tests, (unsigned long long)sum.n_covered);
  EXPECT_EQ(sum.n_wrong, 0u) << "first in sliver " << sum.first_wrong_case;
}

TEST(OracleStress, CoverageEqualsThe128BitOracle) {
  const std::uint64_t n_triangles = stress_count("triangles", 1'000'000, 100'000'000);
  const Tally sum = run_until(1, n_triangles, [](std::uint64_t seed, Tally& tally) {
    HashedNumbers random(seed + 5);
    Corners t;
    PixelBox window{{-1, -1}, {0, 0}};
    if (random.below(4) != 0) {  // small: all of it
      const int limit_px = 1 << random.below(5);
      for (glm::ivec2& p : t) p = random_point_fx8(random, limit_px);
      window.end_px = glm::ivec2(limit_px + 1);
    } else {  // up to the guard band: 12 × 12 px at a place on an edge
      const int limit = 1 << (13 + random.below(11));
      for (glm::ivec2& p : t) p = {random.between(-limit, limit), random.between(-limit, limit)};
      const glm::dvec2 at =
          glm::mix(glm::dvec2(t[0]), glm::dvec2(t[1]), random.below(8) == 0 ? 0.0 : random.unit()) / 256.0;
      window = {glm::ivec2(at) - 6, glm::ivec2(at) + 6};
    }
    CoverageCount count(window);
    tally.n_tests += 1 + count.add(t);
    std::uint64_t wrong = 0;
    count.for_each([&](glm::ivec2 px, int n) { wrong += n != int(covers(t, centre_of(px))); });
    tally.add(seed, wrong);
  });
  std::printf("[  COUNT   ] done: %llu triangles\n", (unsigned long long)sum.n_cases);
  EXPECT_EQ(sum.n_wrong, 0u) << "first in triangle " << sum.first_wrong_case;
}

}  // namespace
}  // namespace lode::raster

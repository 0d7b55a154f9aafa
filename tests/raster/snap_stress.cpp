// notes/numerics.md, stress counts: snapping over float patterns, rational positions, and clipped edges from both sides, at full
// counts. The long run of the first goes through all 2^32 patterns.

#include <gtest/gtest.h>

#include <atomic>

#include "clip_cases.h"
#include "raster/parallel.h"
#include "stress_count.h"

namespace lode::raster {
namespace {

using namespace test;

/// Adds up wrong(chunk) over chunks of cases on all processors.
template <class Wrong>
std::uint64_t sum_over_chunks(std::uint64_t n_chunks, const Wrong& wrong) {
  std::atomic<std::uint64_t> sum = 0;
  parallel_for(n_chunks, worker_count(0), [&](std::size_t chunk, int) { sum += wrong(std::uint64_t(chunk)); });
  return sum;
}

TEST(SnapStress, EveryFloatPatternEqualsTheIntegerOracleOnItsBits) {
  const std::uint64_t n = stress_count("float patterns", 100'000'000, std::uint64_t(1) << 32);
  constexpr std::uint64_t kChunk = 1 << 16;
  std::atomic<std::uint64_t> n_nan = 0;
  const std::uint64_t n_wrong = sum_over_chunks((n + kChunk - 1) / kChunk, [&](std::uint64_t chunk) {
    std::uint64_t wrong = 0, nan = 0;
    for (std::uint64_t i = chunk * kChunk; i < std::min(n, (chunk + 1) * kChunk); ++i) {
      // An odd factor permutes the 2^32 patterns: a part of them is spread over all exponents.
      const auto bits = std::uint32_t(i * 0x9E37'79B1u);
      const float value = std::bit_cast<float>(bits);
      if (std::isnan(value)) {
        ++nan;
        continue;
      }
      const glm::ivec2 p = reference::window_vertex(glm::dvec3{double(value), -double(value), 0.0}).p_fx8;
      wrong += p != glm::ivec2(snapped_bits(bits), snapped_bits(bits ^ 0x8000'0000));
    }
    n_nan += nan;
    return wrong;
  });
  std::printf("[  COUNT   ] done: %llu, %llu of them NaN, which never get here\n", (unsigned long long)n,
              (unsigned long long)n_nan);
  EXPECT_EQ(n_wrong, 0u);
}

TEST(SnapStress, ClipVerticesAreWithinTheBoundOfTheirRationalPositions) {
  const std::uint64_t n = stress_count("clip vertices", 1'000'000, 100'000'000);
  const std::uint64_t n_wrong = sum_over_chunks(n / 1000, [](std::uint64_t chunk) {
    HashedNumbers random(chunk + 7'000'000);
    std::uint64_t wrong = 0;
    for (int i = 0; i < 1000; ++i) {
      const Rect viewport = random_viewport(random);
      const reference::Viewport v = reference::make_viewport(viewport);
      const glm::dvec4 p = random_inside(random, v);
      const ExactWindow exact = exact_window(viewport, mpq_class(p.x), mpq_class(p.y), mpq_class(p.w));
      wrong += !within_bound(exact, reference::window_vertex(v, p).p_fx8);
    }
    return wrong;
  });
  EXPECT_EQ(n_wrong, 0u);
}

TEST(ClipStress, NewVerticesHaveTheSameBitsFromBothSidesOfTheirEdge) {
  const std::uint64_t n = stress_count("edges", 1'000'000, 100'000'000);
  std::array<std::atomic<std::uint64_t>, reference::kClipPlanes> n_cut{};
  const std::uint64_t n_wrong = sum_over_chunks(n / 1000, [&](std::uint64_t chunk) {
    HashedNumbers random(chunk + 9'000'000);
    std::uint64_t wrong = 0;
    for (int i = 0; i < 1000; ++i) {
      const reference::Viewport v = reference::make_viewport(random_viewport(random));
      const int spread = i % 2 == 0 ? 3 : 20;
      const glm::dvec4 a = random_clip_point(random, spread), b = random_clip_point(random, spread);
      const glm::dvec4 c = random_clip_point(random, spread), d = random_clip_point(random, spread);
      wrong += !same_from_both_sides(random, v, a, b, c, d);
      const std::uint32_t crossed = reference::outside_planes(v, a) ^ reference::outside_planes(v, b);
      for (std::size_t k = 0; k < n_cut.size(); ++k) n_cut[k] += (crossed >> k) & 1u;
    }
    return wrong;
  });
  for (std::size_t k = 0; k < n_cut.size(); ++k) {
    std::printf("[  COUNT   ] crossing plane %zu: %llu\n", k, (unsigned long long)n_cut[k]);
    EXPECT_GE(n_cut[k], n / 10);
  }
  EXPECT_EQ(n_wrong, 0u);
}

}  // namespace
}  // namespace lode::raster

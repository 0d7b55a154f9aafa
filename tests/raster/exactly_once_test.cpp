// Triangles that share edges and vertices: each sample inside belongs to exactly one (C3). coverage_stress.cpp has
// the large counts.

#include <gtest/gtest.h>

#include "window_meshes.h"

namespace lode::raster {
namespace {

using namespace test;

TEST(CoverageOracle, ThreeFormulationsAgree) {
  HashedNumbers random(20);
  for (int i = 0; i < 500; ++i) {
    const Corners t = {random_point_fx8(random, 8), random_point_fx8(random, 8), random_point_fx8(random, 8)};
    const std::vector<std::int8_t> windings = winding_numbers(t, {8, 8});
    for (int k = 0; k < 64; ++k) {
      const glm::ivec2 p = centre_of({k % 8, k / 8});
      ASSERT_EQ(signed_cover(t, p), winding_number(t, p)) << to_string(t);
      ASSERT_EQ(int(windings[std::size_t(k)]), winding_number(t, p)) << to_string(t);
    }
  }
}

void expect_exactly_once(std::uint64_t seed, WindowMesh (*make)(HashedNumbers&)) {
  HashedNumbers random(seed);
  std::uint64_t n_tests = 0;
  for (int i = 0; i < 60; ++i) {
    const WindowMesh mesh = make(random);
    for (const Corners& t : mesh.triangles) ASSERT_GE(doubled_area(t), 0);
    ASSERT_EQ(wrong_samples(mesh, 32, n_tests), 0) << "mesh " << i;
  }
  EXPECT_GT(n_tests, 60u * 32u * 32u / 4u);
}

TEST(SharedEdges, GridsCoverEachSampleExactlyOnce) {
  expect_exactly_once(21, [](HashedNumbers& r) {
    const glm::ivec2 cells{r.between(1, 12), r.between(1, 12)};
    return grid_mesh(r, {32 * 256, 32 * 256}, cells.x, cells.y);
  });
}
TEST(SharedEdges, StripsCoverEachSampleExactlyOnce) {
  expect_exactly_once(22, [](HashedNumbers& r) { return strip_mesh(r, {32 * 256, 32 * 256}, r.between(1, 200)); });
}
TEST(SharedEdges, FansCoverEachSampleExactlyOnce) {
  expect_exactly_once(23, [](HashedNumbers& r) { return fan_mesh(r, 32, r.between(0, 100)); });
}
TEST(SharedEdges, SplitTrianglesCoverEachSampleExactlyOnce) {
  expect_exactly_once(24, [](HashedNumbers& r) { return split_mesh(r, 32, r.between(1, 40)); });
}
TEST(SharedEdges, DelaunayTriangulationsCoverEachSampleExactlyOnce) {
  expect_exactly_once(25, [](HashedNumbers& r) { return delaunay_mesh(r, 32, r.between(1, 80)); });
}

// From corner to corner of the guard band, the shared edges through a window of 32 × 32 px anywhere on them.
TEST(SharedEdges, TrianglesAsLargeAsTheGuardBandMeetWithoutGapOrDouble) {
  HashedNumbers random(26);
  constexpr std::int32_t g = reference::kGuard_fx8;
  for (int i = 0; i < 200; ++i) {
    const glm::ivec2 p{random.between(-g, g), random.between(-g, g)};
    const glm::ivec2 ring[] = {{-g, -g}, {g, -g}, {g, g}, {-g, g}};
    const glm::dvec2 on_edge = glm::mix(glm::dvec2(p), glm::dvec2(ring[i % 4]), random.unit()) / 256.0;
    const glm::ivec2 begin = glm::clamp(glm::ivec2(on_edge), -32768 + 17, 32767 - 17) - 16;
    CoverageCount count({begin, begin + 32});
    for (std::size_t k = 0; k < 4; ++k) count.add(Corners{p, ring[k], ring[(k + 1) % 4]});
    int wrong = 0;
    count.for_each([&](glm::ivec2, int n) { wrong += n != 1; });
    ASSERT_EQ(wrong, 0) << count.picture();
  }
}

}  // namespace
}  // namespace lode::raster

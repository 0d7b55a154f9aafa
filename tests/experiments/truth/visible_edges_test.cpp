#include "experiments/truth/visible_edges.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lode::experiments::truth {
namespace {

constexpr double kPi = 3.14159265358979;

VisibleEdges measure(glm::ivec2 size_px, const IdsAt& ids_at, double enough_px) {
  std::vector<raster::Ids> ids;
  for (int y = 0; y < size_px.y; ++y) {
    for (int x = 0; x < size_px.x; ++x) ids.push_back(ids_at({x + 0.5, y + 0.5}));
  }
  const glm::ivec2 also[] = {{10, 10}};
  return visible_edges(size_px, ids, also, enough_px, ids_at, 2);
}

IdsAt disc(double x, double y, double radius) {
  return [=](glm::dvec2 p) { return raster::Ids{std::hypot(p.x - x, p.y - y) < radius ? 1u : 0u, 0u}; };
}

/// Crofton's formula counts a circle of radius r as π/4 · 8r exactly: 2r columns and 2r rows, each crossed twice.
TEST(VisibleEdges, MeasureACircle) {
  const VisibleEdges edges = measure({128, 128}, disc(64.2, 63.9, 50.0), 0.0);
  EXPECT_NEAR(edges.length_px, 2.0 * kPi * 50.0, 2.0 * kPi);
  EXPECT_EQ(edges.grid, 1);
}

TEST(VisibleEdges, AreRefinedUntilTheLengthIsReached) {
  // Within one pixel, between its sample and its border: on the pixels' own grid there is no edge at all.
  const IdsAt speck = disc(10.8, 10.8, 0.1);
  EXPECT_EQ(measure({32, 32}, speck, -1.0).length_px, 0.0);
  const VisibleEdges edges = measure({32, 32}, speck, 0.4);
  EXPECT_GT(edges.grid, 1);
  EXPECT_GT(edges.length_px, 0.4);
  EXPECT_LT(edges.length_px, 0.9);  // 0.2π is 0.63
}

TEST(VisibleEdges, RefinementEnds) {
  const VisibleEdges edges = measure({32, 32}, disc(10.8, 10.8, 0.1), 1e9);
  EXPECT_LE(std::uint64_t(edges.grid) * edges.grid, kMaxEdgeRays);
  EXPECT_NEAR(edges.length_px, 0.2 * kPi, 0.02);
}

TEST(VisibleEdges, NothingHasNone) {
  const IdsAt nothing = [](glm::dvec2) { return raster::Ids{raster::kNoId, raster::kNoId}; };
  EXPECT_EQ(visible_edges({0, 0}, {}, {}, 1.0, nothing, 1).length_px, 0.0);
}

}  // namespace
}  // namespace lode::experiments::truth

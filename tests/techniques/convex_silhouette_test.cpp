/// Silhouette areas on lines, the orthographic error (eq. 2), and the error in both senses.

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "techniques/convex_culling/coverage_error.h"
#include "techniques/convex_culling/coverage_grid.h"
#include "techniques/convex_culling/line_union.h"
#include "techniques/convex_culling/silhouette_area.h"
#include "techniques/convex_culling/welded_mesh.h"
#include "tests/techniques/convex_models.h"

namespace lode::techniques::convex_culling {
namespace {

std::vector<std::uint32_t> every(std::size_t n) {
  std::vector<std::uint32_t> all(n);
  std::iota(all.begin(), all.end(), 0u);
  return all;
}

double area(const test::Soup& soup, int n_lines) {
  const WeldedMesh mesh = weld(soup.positions, soup.indices, 1e-6);
  return SilhouetteArea(n_lines).of_triangles(mesh.vertices, mesh.triangles, every(mesh.vertices.size()));
}

TEST(LineUnion, OverlapsCountOnce) {
  LineUnion lines;
  lines.clear({0.0, 4.0, 8});
  const glm::dvec2 square[] = {{0, 0}, {2, 0}, {2, 2}, {0, 2}}, other[] = {{1, 1}, {3, 1}, {3, 3}, {1, 3}};
  lines.add_hull(square);
  lines.add_hull(square);
  lines.add_hull(other);
  EXPECT_EQ(lines.area(), 7.0);  // 4 + 4 − 1
}

TEST(LineUnion, TheDifferenceLeavesWhatTheOtherHasNot) {
  LineUnion a, b;
  a.clear({0.0, 4.0, 8});
  b.clear({0.0, 4.0, 8});
  const glm::dvec2 tall[] = {{0, 0}, {4, 0}, {4, 9}, {0, 9}}, low[] = {{0, 1}, {4, 1}, {4, 2}, {0, 2}},
                   high[] = {{0, 4}, {2, 4}, {2, 5}, {0, 5}};
  a.add_hull(tall);
  b.add_hull(low);
  b.add_hull(high);
  EXPECT_EQ(a.area_without(b), 36.0 - 4.0 - 2.0);
  EXPECT_EQ(b.area_without(a), 0.0);
}

TEST(SilhouetteArea, OfABoxIsTheSumOfThreeFaces) {
  // Union, not sum: the front and the back of the box lie upon each other. 2·3 + 3·5 + 5·2 = 31.
  EXPECT_NEAR(area(test::box_soup({1, 1, 1}, {3, 4, 6}), 64), 31.0, 1e-12);
}

TEST(SilhouetteArea, TheTableHasItsLegsAndTheAirBetweenThem) {
  // From above 8·4; from the front 8·1 + 2·1·3; from the side 4·1 + 2·1·3: 32 + 14 + 10. Lines fall on whole legs.
  EXPECT_NEAR(area(test::table_soup(), 64), 56.0, 1e-12);
}

TEST(SilhouetteArea, ConvergesWithTheNumberOfLines) {
  // A ball of radius 1 with 4096 triangles inside it has nearly 3π: a circle with n corners on it lacks 2π²/3n² of its
  // area, 0.2 % for 64 or 66. Against 2048 lines the error falls as lines grow.
  test::Soup ball;
  ball.add(geometry::sphere({0, 0, 0}, 1.0, 64, 33));
  const double fine = area(ball, 2048);
  EXPECT_NEAR(fine, 3.0 * 3.14159265, 0.002 * 3.0 * 3.14159265 + 0.003);
  EXPECT_LT(std::fabs(area(ball, 256) - fine), 0.001 * fine);
  EXPECT_LT(std::fabs(area(ball, 32) - fine), 0.02 * fine);
}

TEST(CoverageGrid, WhatIsAddedAndRemovedLeavesNothing) {
  const test::Soup soup = test::table_soup();
  const WeldedMesh mesh = weld(soup.positions, soup.indices, 1e-6);
  CoverageGrid grid(mesh.bounds, 32);
  const GridFootprint all = grid.footprint(mesh.vertices, every(mesh.vertices.size()));
  grid.add(all);
  EXPECT_NEAR(grid.area(), 8.0 * 4.0 + 8.0 * 4.0 + 4.0 * 4.0, 1e-12);  // the box around it
  for (const Triangle& t : mesh.triangles) grid.add(grid.footprint(mesh.vertices, t));
  EXPECT_NEAR(grid.area(), 80.0, 1e-12);
  grid.remove(all);
  EXPECT_NEAR(grid.area(), 56.0, 1e-12);
  for (const Triangle& t : mesh.triangles) grid.remove(grid.footprint(mesh.vertices, t));
  EXPECT_EQ(grid.area(), 0.0);
}

TEST(CoverageError, TellsOverFromUnder) {
  // The table's hull from the front is 8 × 4: 18 over. A hull of the top's half alone: 4 under there, and the legs.
  const test::Soup soup = test::table_soup();
  const std::vector<std::vector<glm::vec3>> around = {soup.positions};
  const CoverageError e = coverage_error(soup.positions, soup.indices, around, {0, 0, 1}, 64);
  EXPECT_NEAR(e.model_area, 14.0, 1e-12);
  EXPECT_NEAR(e.over, 18.0, 1e-12);
  EXPECT_EQ(e.under, 0.0);
  const std::vector<std::vector<glm::vec3>> half = {test::box_soup({0, 3, 0}, {4, 4, 4}).positions};
  const CoverageError h = coverage_error(soup.positions, soup.indices, half, {0, 0, -2}, 64);
  EXPECT_EQ(h.over, 0.0);
  EXPECT_NEAR(h.under, 10.0, 1e-12);
}

TEST(CoverageError, TheTwoSidesDifferByTheAreas) {
  const test::Soup soup = test::random_soup(3, 60);
  std::vector<std::vector<glm::vec3>> hulls;
  for (std::size_t i = 0; i < 60; i += 6) {
    hulls.emplace_back(soup.positions.begin() + std::ptrdiff_t(3 * i),
                       soup.positions.begin() + std::ptrdiff_t(3 * i + 12));
  }
  for (const glm::dvec3& direction : measured_directions(10)) {
    const CoverageError e = coverage_error(soup.positions, soup.indices, hulls, direction, 128);
    EXPECT_NEAR(e.over - e.under, e.hull_area - e.model_area, 1e-9 * e.model_area);
    EXPECT_GT(e.over, 0.0);
    EXPECT_GT(e.under, 0.0);
  }
}

TEST(CoverageError, NothingHasNoError) {
  const CoverageError e = coverage_error({}, {}, {}, {0, 0, 1});
  EXPECT_EQ(e.over, 0.0);
  EXPECT_EQ(e.under, 0.0);
  EXPECT_THROW((void)coverage_error({}, {}, {}, {0, 0, 0}), std::logic_error);
}

}  // namespace
}  // namespace lode::techniques::convex_culling

/// The approximation as a whole: partitions (alg. 1, step 2), levels, and whatever models come.

#include "techniques/convex_culling/convex_approximation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "geometry/error.h"
#include "techniques/convex_culling/clustering_round.h"
#include "techniques/convex_culling/partition.h"
#include "techniques/convex_culling/reference.h"
#include "tests/techniques/convex_models.h"

namespace lode::techniques::convex_culling {
namespace {

using test::Soup;
using testing::HasSubstr;

ConvexApproximation approximate(const Soup& soup, std::vector<std::size_t> limits,
                                VertexCount count = VertexCount::distinct,
                                SupportRule rule = SupportRule::nearest_to_sphere) {
  ApproximationParams params;
  params.rule = rule;
  params.limits = std::move(limits);
  params.count = count;
  return convex_culling::approximate(soup.positions, soup.indices, params);
}

TEST(ConvexApproximation, ABoxIsItsOwnHull) {
  const ConvexApproximation a = approximate(test::box_soup({0, 0, 0}, {1, 2, 3}), {8});
  EXPECT_NEAR(a.area, 2.0 + 6.0 + 3.0, 1e-12);
  EXPECT_EQ(a.n_vertices, 8u);
  // With M = |V| the level is the single polygons; below it, the one hull of eight vertices is the best there is.
  EXPECT_EQ(a.levels[0].hulls.size(), 12u);
  EXPECT_EQ(a.levels[0].error, 0.0);
  const ConvexApproximation sum = approximate(test::box_soup({0, 0, 0}, {1, 2, 3}), {8, 35}, VertexCount::sum);
  EXPECT_EQ(sum.levels[0].hulls.size(), 1u);
  EXPECT_NEAR(sum.levels[0].error, 0.0, 1e-12);
  EXPECT_EQ(sum.levels[1].hulls.size(), 1u);
}

TEST(ConvexApproximation, TheTableIsItsFivePartsWhenTheLimitAllowsIt) {
  // One hull: 8 vertices, A = 8·4 + 8·4 + 4·4 = 80 against 8·4 + (8·1 + 2·2.875) + (4·1 + 2·2.875) = 55.5. The five
  // parts: 40 vertices, no error. (Support points are corners of the box around it; the paper's rule misses one.)
  const ConvexApproximation a =
      approximate(test::parted_table_soup(), {12, 40}, VertexCount::sum, SupportRule::farthest);
  EXPECT_NEAR(a.area, 55.5, 1e-9);
  EXPECT_EQ(a.levels[0].hulls.size(), 1u);
  EXPECT_NEAR(a.levels[0].error, 24.5, 1e-9);
  EXPECT_EQ(a.levels[1].hulls.size(), 5u);
  EXPECT_EQ(a.levels[1].n_sum, 40u);
  EXPECT_NEAR(a.levels[1].error, 0.0, 1e-9);
}

TEST(ConvexApproximation, LimitsHoldAndBothCountsAreTold) {
  Soup soup;
  soup.add(geometry::torus({0, 0, 0}, 2, 0.5, 14, 8));
  for (const VertexCount count : {VertexCount::distinct, VertexCount::sum}) {
    const ConvexApproximation a = approximate(soup, {30, 60, 120, 200}, count);
    for (const ApproximationLevel& level : a.levels) {
      EXPECT_LE(count == VertexCount::sum ? level.n_sum : level.n_distinct, level.limit);
      EXPECT_LE(level.n_distinct, level.n_sum);
      std::size_t n = 0;
      for (const auto& hull : level.hulls) n += hull.size();
      EXPECT_EQ(n, level.n_sum);
    }
  }
}

TEST(ConvexApproximation, ALimitOfAllVerticesIsThePolygonsThemselves) {
  Soup soup;
  soup.add(geometry::torus({0, 0, 0}, 2, 0.5, 12, 8));
  const ConvexApproximation a = approximate(soup, {96, 1'000'000});
  for (const ApproximationLevel& level : a.levels) {
    EXPECT_EQ(level.hulls.size(), 192u);
    EXPECT_EQ(level.n_distinct, 96u);
    EXPECT_EQ(level.n_sum, 3u * 192u);
    EXPECT_EQ(level.error, 0.0);
  }
}

TEST(ConvexApproximation, LimitZeroHasNoHulls) {
  const ConvexApproximation a = approximate(test::table_soup(), {0});
  EXPECT_TRUE(a.levels[0].hulls.empty());
  EXPECT_EQ(a.levels[0].error, a.area);
}

TEST(ConvexApproximation, AnythingIsAModel) {
  EXPECT_TRUE(approximate(Soup{}, {0, 9}).levels[1].hulls.empty());
  Soup one;
  one.add_triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  const ConvexApproximation triangle = approximate(one, {3}, VertexCount::sum);
  EXPECT_EQ(triangle.levels[0].hulls.size(), 1u);
  EXPECT_EQ(triangle.levels[0].error, 0.0);
  EXPECT_NEAR(triangle.area, 0.5, 1e-12);
  Soup nothing;  // triangles without area, all in one point
  for (int i = 0; i < 5; ++i) nothing.add_triangle({1, 1, 1}, {1, 1, 1}, {1, 1, 1});
  EXPECT_EQ(approximate(nothing, {9}).n_triangles, 0u);
  Soup line;
  for (int i = 0; i < 5; ++i) line.add_triangle({0, 0, 0}, {float(i) + 1, 0, 0}, {9, 0, 0});
  EXPECT_EQ(approximate(line, {5}, VertexCount::sum).levels[0].error, 0.0);
  Soup flat;
  flat.add(geometry::terrain(4.0, 6, 0.0, 1));
  EXPECT_NEAR(approximate(flat, {12}).levels[0].error, 0.0, 1e-9);
  Soup heap;  // a hundred times the same triangle
  for (int i = 0; i < 100; ++i) heap.add_triangle({0, 0, 0}, {1, 0, 1}, {0, 1, 0});
  EXPECT_NEAR(approximate(heap, {3}, VertexCount::sum).levels[0].error, 0.0, 1e-12);
  const float big = std::numeric_limits<float>::max();
  Soup huge;
  huge.add_triangle({-big, 0, 0}, {big, 0, 0}, {0, big, -big});
  EXPECT_EQ(approximate(huge, {3}, VertexCount::sum).levels[0].hulls.size(), 1u);
}

TEST(ConvexApproximation, NamesAParameterThatIsWrong) {
  const auto refusal = [](const ApproximationParams& params) -> std::string {
    try {
      (void)convex_culling::approximate({}, {}, params);
    } catch (const geometry::Error& error) {
      return error.what();
    }
    return "";
  };
  ApproximationParams limits, step, lines, grid;
  limits.limits = {3, 1};
  step.direction_step_deg = 50.0;
  lines.n_lines = 0;
  grid.n_grid = 5000;
  EXPECT_THAT(refusal(limits), HasSubstr("limits: expected them ascending"));
  EXPECT_THAT(refusal(step), HasSubstr("direction_step_deg"));
  EXPECT_THAT(refusal(lines), HasSubstr("n_lines: expected 1 to 4096, found 0"));
  EXPECT_THAT(refusal(grid), HasSubstr("n_grid"));
  EXPECT_EQ(refusal({}), "");
}

TEST(Partition, EqualsThePlainOneOnSmallModels) {
  Soup torus;
  torus.add(geometry::torus({0, 0, 0}, 2, 0.5, 10, 6));
  for (const Soup& soup : {test::table_soup(), torus, test::random_soup(4, 60)}) {
    for (const VertexCount count : {VertexCount::distinct, VertexCount::sum}) {
      ApproximationParams params;
      params.count = count;
      params.order = count == VertexCount::sum ? SplitOrder::own_error : SplitOrder::least_error;
      params.n_grid = 24;
      const WeldedMesh mesh = weld(soup.positions, soup.indices, 1e-6);
      const ClusterTree tree = cluster_tree(mesh, params);
      const double area = sampled_area(mesh, params);
      ExtremeVertices extreme(mesh, tree, params);
      for (const std::size_t limit : {0u, 10u, 40u, 100u}) {
        const Partition fast = partition(mesh, tree, limit, params, area, extreme);
        const Partition plain = reference_partition(mesh, tree, limit, params, area, extreme);
        EXPECT_EQ(fast.nodes, plain.nodes) << limit;
        EXPECT_EQ(fast.n_vertices, plain.n_vertices) << limit;
        EXPECT_EQ(fast.error, plain.error) << limit;
      }
    }
  }
}

}  // namespace
}  // namespace lode::techniques::convex_culling

/// The convex approximation at the stress count: the fast way down the tree against the plain one, 200 models in CI,
/// 20,000 long; and a soup of 20,000 triangles that share nothing.

#include <gtest/gtest.h>

#include "techniques/convex_culling/clustering_round.h"
#include "techniques/convex_culling/convex_approximation.h"
#include "techniques/convex_culling/reference.h"
#include "tests/raster/stress_count.h"
#include "tests/techniques/convex_models.h"

namespace lode::techniques::convex_culling {
namespace {

/// Case i: balls, rings, boxes and loose triangles, some of them upon each other.
test::Soup random_model(std::uint64_t i) {
  geometry::Random random(9, 92, i);
  test::Soup soup = test::random_soup(i, int(random.below(20)));
  for (std::uint32_t n = random.below(4); n > 0; --n) {
    const glm::dvec3 at(random.below(8), random.below(8), random.below(8));
    const glm::dvec3 size(1 + random.below(4), 1 + random.below(4), 1 + random.below(4));
    soup.add(geometry::box(at, at + size));
  }
  if (random.below(2))
    soup.add(geometry::torus({4, 4, 4}, 3.0, 1.0, 3 + int(random.below(8)), 3 + int(random.below(5))));
  if (random.below(2)) soup.add(geometry::sphere({1, 4, 7}, 2.0, 3 + int(random.below(8)), 2 + int(random.below(5))));
  return soup;
}

TEST(ConvexStress, ThePartitionEqualsThePlainOne) {
  const std::uint64_t n = raster::test::stress_count("models", 200, 20'000);
  for (std::uint64_t i = 0; i < n; ++i) {
    const test::Soup soup = random_model(i);
    ApproximationParams params;
    params.count = i % 2 == 0 ? VertexCount::distinct : VertexCount::sum;
    params.order = i % 3 == 0 ? SplitOrder::own_error : SplitOrder::least_error;
    params.rule = i % 5 == 0 ? SupportRule::farthest : SupportRule::nearest_to_sphere;
    params.n_grid = 20;
    const WeldedMesh mesh = weld(soup.positions, soup.indices, 1e-6);
    const ClusterTree tree = cluster_tree(mesh, params);
    const double area = sampled_area(mesh, params);
    ExtremeVertices extreme(mesh, tree, params);
    const std::size_t limit = 8 + i % 80;
    const Partition fast = partition(mesh, tree, limit, params, area, extreme);
    const Partition plain = reference_partition(mesh, tree, limit, params, area, extreme);
    ASSERT_EQ(fast.nodes, plain.nodes) << i;
    ASSERT_EQ(fast.n_vertices, plain.n_vertices) << i;
    ASSERT_EQ(fast.error, plain.error) << i;
  }
}

TEST(ConvexStress, ASoupOfManyTrianglesHasItsLevels) {
  const test::Soup soup = test::random_soup(3, 20'000);
  ApproximationParams params;
  params.limits = {100, 2000};
  const ConvexApproximation a = approximate(soup.positions, soup.indices, params);
  EXPECT_LE(a.levels[0].n_distinct, 100u);
  EXPECT_LE(a.levels[1].n_distinct, 2000u);
  EXPECT_LE(a.levels[1].error, a.levels[0].error);
}

}  // namespace
}  // namespace lode::techniques::convex_culling

/// The convex approximation at the stress count: the fast way down the tree against the plain one, 200 models in CI,
/// 20,000 long; a soup of 20,000 triangles that share nothing; and a scene of 100,000 models.

#include <gtest/gtest.h>

#include "geometry/procedural.h"
#include "techniques/convex_culling/clustering_round.h"
#include "techniques/convex_culling/convex_approximation.h"
#include "techniques/convex_culling/convex_culling.h"
#include "techniques/convex_culling/reference.h"
#include "techniques/objects_in_view.h"
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

// 100,000 boxes of one shape, a wall of 1000 and 99 more behind it. The wall is the nearest, and so the thousand best
// occluders; nothing else can be seen. The conservative mode tells so only where a single box covers, as columns that
// two boxes share count for neither.
TEST(ConvexStress, AHundredThousandModelsAreCulled) {
  constexpr int kAcross = 40, kUp = 25, kDeep = 100;
  geometry::Scene scene = geometry::scene_of(geometry::box(glm::dvec3(-0.5), glm::dvec3(0.5)));
  const geometry::Instance one = scene.instances.front();
  scene.instances.clear();
  for (int i = 0; i < kAcross * kUp * kDeep; ++i) {
    geometry::Instance& instance = scene.instances.emplace_back(one);
    instance.world_from_object[3] = {i % kAcross - 0.5 * kAcross, i / kAcross % kUp - 0.5 * kUp,
                                     -2.0 * (i / (kAcross * kUp)), 1.0};
    scene.objects.push_back({.name = "box", .first_instance = std::uint32_t(i), .n_instances = 1});
  }
  const World world(scene, {}, false, 1);
  ASSERT_EQ(world.objects().size(), scene.instances.size());
  View view{.camera = {}, .size_px = {640, 480}};
  geometry::look_at(view.camera, {0.0, 0.0, 15.0}, glm::dvec3(0.0));
  for (const auto mode : {ConvexCulling::Mode::literal, ConvexCulling::Mode::safe, ConvexCulling::Mode::conservative}) {
    ConvexCulling::Params params = ConvexCulling::params_for(mode);
    params.least_area_quantile = 0.0;
    params.slabs.occluders.most = kAcross * kUp;
    params.slabs.angle_limit_deg = 180.0;
    ConvexCulling technique(params);
    Stage stage(world, {.threads = 1});
    technique.prepare(stage);
    stage.begin(view);
    const Counters counters = technique.draw(view, stage);
    const std::uint64_t n_inside = counters[0].value, n_culled = counters[3].value;
    EXPECT_STREQ(counters[3].name, "culled");
    EXPECT_GT(n_inside, std::uint64_t{50'000});
    EXPECT_GT(n_culled, mode == ConvexCulling::Mode::conservative ? 0 : n_inside * 9 / 10);
    for (const ObjectId id : objects_in_view(world, view)) {
      if (id >= kAcross * kUp) break;  // the wall comes first
      EXPECT_TRUE(stage.drawn(id)) << id;
    }
  }
}

}  // namespace
}  // namespace lode::techniques::convex_culling

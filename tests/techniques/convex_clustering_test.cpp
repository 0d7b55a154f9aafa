/// Welding, the vertex subset U(v), and the clustering of polygons (alg. 1, step 1, and alg. 2).

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <tuple>

#include "geometry/error.h"
#include "geometry/hull.h"
#include "techniques/convex_culling/clustering_round.h"
#include "tests/techniques/convex_models.h"

namespace lode::techniques::convex_culling {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(Weld, JoinsWhatIsNearAndDropsWhatThenHasNoArea) {
  // The diagonal is about 100: 1e-6 of it is 1e-4. Vertex 3 is near 0, the second triangle's corners 4 and 5 are equal.
  const glm::vec3 p[] = {{0, 0, 0}, {100, 0, 0}, {0, 1, 0}, {0, 1e-5f, 0}, {5, 5, 0}, {5, 5, 0}, {0, 0.5f, 0}};
  const std::uint32_t indices[] = {0, 1, 2, 4, 5, 1, 3, 1, 6};
  const WeldedMesh mesh = weld(p, indices, 1e-6);
  EXPECT_EQ(mesh.n_dropped, 1u);
  ASSERT_EQ(mesh.triangles.size(), 2u);
  EXPECT_EQ(mesh.vertices.size(), 4u);
  EXPECT_EQ(mesh.triangles[0][0], mesh.triangles[1][0]);
  EXPECT_EQ(weld(p, indices, 0.0).vertices.size(), 5u);
}

TEST(Weld, AHeapOfVerticesInOneCellTakesNoTimeOfItsOwn) {
  // One vertex far out: all others are within the tolerance of each other.
  test::Soup soup = test::random_soup(1, 20000);
  soup.add_triangle({1e30f, 0, 0}, {0, 1e30f, 0}, {0, 0, 1e30f});
  EXPECT_EQ(weld(soup.positions, soup.indices, 1e-6).triangles.size(), 1u);
}

std::string refusal(const std::vector<glm::vec3>& positions, const std::vector<std::uint32_t>& indices) {
  try {
    (void)weld(positions, indices, 1e-6);
  } catch (const geometry::Error& error) {
    return error.what();
  }
  return "";
}

TEST(Weld, NamesWhatIsWrong) {
  EXPECT_THAT(refusal({{0, 0, 0}}, {0, 0}), HasSubstr("expected a multiple of 3 indices, found 2"));
  EXPECT_THAT(refusal({{0, 0, 0}}, {0, 0, 7}), HasSubstr("index 2: expected less than 1, found 7"));
  EXPECT_THAT(refusal({{0, 0, 0}, {0, NAN, 0}}, {0, 1, 1}), HasSubstr("position 1: expected finite numbers, found 0"));
}

TEST(SupportVertices, FortyFiveDegreesAreTwentySixDirections) {
  const std::vector<glm::dvec3> directions = sphere_directions(45.0);
  EXPECT_EQ(directions.size(), 26u);  // two poles and three circles of eight
  EXPECT_EQ(sphere_directions(60.0).size(), 14u);
  EXPECT_EQ(sphere_directions(30.0).size(), 62u);
  for (const glm::dvec3& d : directions) EXPECT_NEAR(d.x * d.x + d.y * d.y + d.z * d.z, 1.0, 1e-15);
  EXPECT_THROW((void)sphere_directions(50.0), std::logic_error);
}

TEST(SupportVertices, BothRulesFindTheCornersOfABoxAndNothingInside) {
  std::vector<glm::vec3> points;
  for (int i = 0; i < 27; ++i) points.emplace_back(i % 3, 4 * (i / 3 % 3), 2 * (i / 9));
  std::vector<std::uint32_t> all(points.size());
  for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = i;
  for (const SupportRule rule : {SupportRule::nearest_to_sphere, SupportRule::farthest}) {
    const auto chosen = support_vertices(points, all, sphere_directions(45.0), rule);
    for (const std::uint32_t corner : {0u, 2u, 6u, 8u, 18u, 20u, 24u, 26u}) {
      EXPECT_TRUE(std::ranges::binary_search(chosen, corner)) << corner;
    }
    EXPECT_FALSE(std::ranges::binary_search(chosen, 13u));  // the middle
  }
}

TEST(SupportVertices, TheNearestToTheSphereNeedNotBeExtreme) {
  // A needle's middle is the nearest to the pole (0, √104, 0) of its sphere: √104 − 1 = 9.2 from (0, 1, 0), more than
  // that, √(100 + 8.2²) = 12.9, from the end (10, 2, 0), which is the farthest up.
  const glm::vec3 p[] = {{-10, -2, 0}, {10, 2, 0}, {0, 1, 0}};
  const std::uint32_t all[] = {0, 1, 2};
  const std::vector<glm::dvec3> up = {{0, 1, 0}};
  EXPECT_THAT(support_vertices(p, all, up, SupportRule::nearest_to_sphere), ElementsAre(2));
  EXPECT_THAT(support_vertices(p, all, up, SupportRule::farthest), ElementsAre(1));
}

std::vector<Cluster> one_triangle_each(const WeldedMesh& mesh) {
  std::vector<Cluster> clusters;
  for (const Triangle& t : mesh.triangles) {
    Cluster c{.node = std::uint32_t(clusters.size()), .triangles = {t}, .vertices = {t.begin(), t.end()}};
    std::ranges::sort(c.vertices);
    clusters.push_back(c);
  }
  return clusters;
}

TEST(Neighbourhoods, AreThoseThatShareAVertexByBruteForce) {
  test::Soup soup;
  soup.add(geometry::torus({0, 0, 0}, 2, 1, 7, 5));
  soup.add(geometry::box({9, 9, 9}, {10, 10, 10}));
  const WeldedMesh mesh = weld(soup.positions, soup.indices, 1e-6);
  const std::vector<Cluster> clusters = one_triangle_each(mesh);
  const auto found = neighbourhoods(clusters, mesh.vertices.size());
  for (std::uint32_t i = 0; i < clusters.size(); ++i) {
    std::vector<std::uint32_t> expected;
    for (std::uint32_t k = 0; k < clusters.size(); ++k) {
      if (std::ranges::find_first_of(clusters[i].vertices, clusters[k].vertices) != clusters[i].vertices.end()) {
        expected.push_back(k);
      }
    }
    EXPECT_EQ(found[i], expected);
  }
}

TEST(Neighbourhoods, OfAFanOfManyStayFew) {
  test::Soup fan;
  for (int i = 0; i < 2000; ++i) fan.add_triangle({0, 0, 9}, {float(i), 1, 0}, {float(i) + 0.5f, 1, 0});
  const WeldedMesh mesh = weld(fan.positions, fan.indices, 1e-9);
  std::size_t n = 0;
  for (const auto& members : neighbourhoods(one_triangle_each(mesh), mesh.vertices.size())) n += members.size();
  EXPECT_LE(n, 2000u * 10u);
}

/// Every node but the root is a child once, the leaves are the polygons, and children come first.
void expect_tree(const ClusterTree& tree, std::size_t n_leaves) {
  std::vector<int> n_parents(tree.size());
  for (std::uint32_t i = 0; i < tree.size(); ++i) {
    EXPECT_EQ(tree[i].children.empty(), i < n_leaves);
    EXPECT_NE(tree[i].children.size(), 1u);
    EXPECT_FALSE(tree[i].support.empty());
    for (const std::uint32_t child : tree[i].children) {
      ASSERT_LT(child, i);
      ++n_parents[child];
    }
  }
  for (std::size_t i = 0; i < tree.size(); ++i) EXPECT_EQ(n_parents[i], i + 1 < tree.size() ? 1 : 0);
}

TEST(ClusterTree, HasOneRootOverAnyPolygons) {
  test::Soup torus;
  torus.add(geometry::torus({0, 0, 0}, 2, 1, 10, 6));
  test::Soup flat;
  flat.add(geometry::terrain(4.0, 8, 0.0, 1));
  test::Soup doubled = test::table_soup();
  doubled.indices.insert(doubled.indices.end(), doubled.indices.begin(), doubled.indices.begin() + 60);
  for (const test::Soup& soup : {test::table_soup(), test::random_soup(2, 300), torus, flat, doubled}) {
    const WeldedMesh mesh = weld(soup.positions, soup.indices, 1e-6);
    expect_tree(cluster_tree(mesh, {}), mesh.triangles.size());
  }
  EXPECT_TRUE(cluster_tree({}, {}).empty());
}

TEST(ClusterTree, DoesNotDependOnThreads) {
  const test::Soup soup = test::random_soup(5, 100);
  const WeldedMesh mesh = weld(soup.positions, soup.indices, 1e-6);
  ApproximationParams one, three;
  one.threads = 1;
  three.threads = 3;
  const ClusterTree a = cluster_tree(mesh, one), b = cluster_tree(mesh, three);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].children, b[i].children);
    EXPECT_EQ(a[i].support, b[i].support);
    EXPECT_EQ(a[i].error, b[i].error);
  }
}

TEST(NeighbourRound, TakesTheLeastErrorFirstAndNothingTwice) {
  // Alg. 2 against its words: candidates by brute force, taken in ascending order of E (in steps), hull area, index.
  test::Soup soup;
  soup.add(geometry::torus({0, 0, 0}, 2, 1, 8, 5));
  const WeldedMesh mesh = weld(soup.positions, soup.indices, 1e-6);
  const ApproximationParams params;
  std::vector<Cluster> clusters = one_triangle_each(mesh);
  std::vector<std::tuple<double, double, std::vector<std::uint32_t>>> all;
  for (const Candidate& c : measure(mesh, params, clusters, neighbourhoods(clusters, mesh.vertices.size()))) {
    all.emplace_back(in_steps(c.error, mesh), in_steps(c.hull_area, mesh), c.members);
  }
  std::ranges::stable_sort(all, {}, [](const auto& c) { return std::pair(std::get<0>(c), std::get<1>(c)); });
  std::set<std::uint32_t> taken;
  std::set<std::vector<std::uint32_t>> expected;
  for (const auto& [error, hull_area, members] : all) {
    if (std::ranges::any_of(members, [&](std::uint32_t m) { return taken.contains(m); })) continue;
    taken.insert(members.begin(), members.end());
    expected.insert(members);
  }
  ClusterTree tree(mesh.triangles.size());
  neighbour_round(mesh, params, clusters, tree);
  std::set<std::vector<std::uint32_t>> found;
  for (std::size_t i = mesh.triangles.size(); i < tree.size(); ++i) found.insert(tree[i].children);
  EXPECT_EQ(found, expected);
}

/// Case i: random points on an ellipsoid, and those below a plane z apart from those above it: how many vertices the
/// hulls of both parts have, added up, and the hull of all; of all points, or of U by the rule given.
struct Counts {
  std::size_t parts, whole;
};
Counts counts(std::uint64_t i, std::optional<SupportRule> rule) {
  geometry::Random random(8, 91, i);
  const double height = random.uniform(0.05, 1.0), depth = random.uniform(0.05, 1.0);
  std::vector<glm::vec3> points;
  for (std::uint32_t n = 12 + random.below(60); n > 0;) {
    const double x = random.uniform(-1, 1), y = random.uniform(-1, 1), z = random.uniform(-1, 1);
    const double square = x * x + y * y + z * z;
    if (square > 1.0 || square < 1e-3) continue;
    points.emplace_back(glm::dvec3(x, y * height, z * depth) / std::sqrt(square));
    --n;
  }
  std::ranges::sort(points, {}, &glm::vec3::z);
  const std::vector<glm::dvec3> directions = sphere_directions(45.0);
  const auto count = [&](std::uint32_t first, std::uint32_t last) {
    std::vector<std::uint32_t> subset;
    for (std::uint32_t k = first; k < last; ++k) subset.push_back(k);
    if (rule) subset = support_vertices(points, subset, directions, *rule);
    std::vector<glm::dvec3> corners;
    for (const std::uint32_t k : subset) corners.emplace_back(points[k]);
    return geometry::convex_hull(corners).vertices.size();
  };
  const std::uint32_t n = std::uint32_t(points.size()), cut = i % 2 == 0 ? n / 2 : n / 4;
  return {count(0, cut) + count(cut, n), count(0, n)};
}

int times_that_splitting_lowers(std::optional<SupportRule> rule, std::uint64_t n) {
  int n_lower = 0;
  for (std::uint64_t i = 0; i < n; ++i) {
    const Counts c = counts(i, rule);
    n_lower += c.parts < c.whole;
  }
  return n_lower;
}

TEST(Proposition1, SplittingNeverLowersTheVerticesOfExactHulls) {
  // A vertex of the whole's hull is one of its part's hull.
  EXPECT_EQ(times_that_splitting_lowers(std::nullopt, 60), 0);
}

TEST(Proposition1, DoesNotHoldForSampledHulls) {
  // A part chooses its own vertices, and one vertex for several directions: some parts have fewer than the whole chose.
  EXPECT_GT(times_that_splitting_lowers(SupportRule::nearest_to_sphere, 200), 0);
}

}  // namespace
}  // namespace lode::techniques::convex_culling

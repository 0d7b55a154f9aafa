// make_clusters: nothing is lost, boxes and cones hold what is in them, limits hold, the same for any threads.
#include "raster/clusters.h"

#include <gtest/gtest.h>

#include <cstring>
#include <set>

#include "random_meshes.h"

namespace lode::raster::test {
namespace {

struct Mesh {
  std::string name;
  std::vector<glm::vec3> positions;
  std::optional<std::vector<std::uint32_t>> indices;

  [[nodiscard]] std::size_t n_triangles() const { return (indices ? indices->size() : positions.size()) / 3; }
  [[nodiscard]] std::uint32_t vertex(std::size_t corner) const {
    return indices ? (*indices)[corner] : std::uint32_t(corner);
  }
  [[nodiscard]] Clusters cut(int threads = 1) const { return make_clusters(positions, indices, threads); }
};

Mesh mesh_of(const std::string& name, OwnedDraw draw) {
  Mesh mesh{name, std::move(draw.object), std::nullopt};
  if (draw.indexed) mesh.indices = std::move(draw.indices);
  return mesh;
}

/// Balls, grids, soups, layers; the last ones with NaN and infinities; one with 70000 triangles, of several tasks.
std::vector<Mesh> mesh_zoo() {
  HashedNumbers random(9);
  std::vector<Mesh> zoo;
  OwnedDraw ball, grid, large, soup, layers, fan;
  add_ball(40, 20, ball);
  add_grid(random, 33, 21, grid);
  add_grid(random, 250, 140, large);
  add_soup(random, {64, 64}, 400, soup.object);
  add_layers_of_quads(random, {64, 64}, 50, layers.object);
  for (std::uint32_t t = 0; t < 300; ++t) {  // all in one place
    for (const std::uint32_t v : {0u, 1u, 2u}) fan.indices.push_back(v);
  }
  fan.object = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, fan.indexed = true;
  zoo.push_back(mesh_of("ball", std::move(ball)));
  zoo.push_back(mesh_of("grid", std::move(grid)));
  zoo.push_back(mesh_of("large", std::move(large)));
  zoo.push_back(mesh_of("soup", std::move(soup)));
  zoo.push_back(mesh_of("layers", std::move(layers)));
  zoo.push_back(mesh_of("coincident", std::move(fan)));
  zoo.push_back({"none", {}, std::nullopt});
  for (const std::size_t k : {0u, 3u}) {
    Mesh broken = zoo[k];
    broken.name += ", broken";
    break_some(random, broken.positions);
    zoo.push_back(std::move(broken));
  }
  return zoo;
}

TEST(Clusters, HoldEachTriangleOnceWithItsCornersInTurn) {
  for (const Mesh& mesh : mesh_zoo()) {
    const Clusters all = mesh.cut();
    EXPECT_EQ(all.n_positions, mesh.positions.size()) << mesh.name;
    EXPECT_EQ(all.n_primitives, mesh.n_triangles()) << mesh.name;
    std::vector<int> count(mesh.n_triangles());
    for (const Cluster& cluster : all.clusters) {
      for (std::uint32_t t = cluster.first_triangle; t < cluster.first_triangle + cluster.n_triangles; ++t) {
        const std::uint32_t primitive = all.primitives[t];
        ++count[primitive];
        for (std::size_t k = 0; k < 3; ++k) {
          ASSERT_LT(all.corners[3 * t + k], cluster.n_vertices) << mesh.name;
          const std::size_t at = cluster.first_vertex + all.corners[3 * t + k];
          ASSERT_EQ(all.vertices[at], mesh.vertex(3 * primitive + k)) << mesh.name;
        }
      }
    }
    EXPECT_EQ(count, std::vector<int>(mesh.n_triangles(), 1)) << mesh.name;
  }
}

TEST(Clusters, KeepTheBitsOfTheirPositionsAndPadThem) {
  for (const Mesh& mesh : mesh_zoo()) {
    const Clusters all = mesh.cut();
    for (const Cluster& cluster : all.clusters) {
      ASSERT_EQ(cluster.first_vertex % kClusterPadding, 0u);
      const std::uint32_t padded = (cluster.n_vertices + kClusterPadding - 1u) / kClusterPadding * kClusterPadding;
      for (std::uint32_t i = cluster.first_vertex; i < cluster.first_vertex + padded; ++i) {
        const glm::vec3 p{all.x[i], all.y[i], all.z[i]};
        ASSERT_EQ(std::memcmp(&p, &mesh.positions[all.vertices[i]], sizeof p), 0) << mesh.name;
      }
    }
  }
}

TEST(Clusters, HaveAtMost128TrianglesAndVerticesAndAtLeastOneTriangle) {
  for (const Mesh& mesh : mesh_zoo()) {
    for (const Cluster& cluster : mesh.cut().clusters) {
      EXPECT_LE(cluster.n_triangles, kMaxClusterTriangles) << mesh.name;
      EXPECT_LE(cluster.n_vertices, kMaxClusterVertices) << mesh.name;
      EXPECT_GT(cluster.n_triangles, 0) << mesh.name;
    }
  }
}

/// What is below entry i of a group: its triangles' vertices must be in its box, their normals in its cone.
class TreeCheck {
 public:
  TreeCheck(const Mesh& mesh, const Clusters& all) : mesh_(mesh), all_(all) {}

  void run() {
    if (all_.groups.empty()) return;
    check_group(0);
    EXPECT_EQ(clusters_.size(), all_.clusters.size()) << mesh_.name;
    EXPECT_EQ(groups_.size(), all_.groups.size()) << mesh_.name;
  }

 private:
  using Triangles = std::vector<std::uint32_t>;  // places in primitives and corners, with the cluster's first vertex

  Triangles check_group(std::uint32_t g) {
    EXPECT_TRUE(groups_.insert(g).second) << mesh_.name << ": group " << g << " is in the tree twice";
    const ClusterGroup& group = all_.groups[g];
    EXPECT_TRUE(group.n >= 1 && group.n <= ClusterGroup::kMost);
    Triangles below;
    for (std::size_t i = 0; i < std::size_t(group.n); ++i) {
      const bool leaf = (group.child[i] & ClusterGroup::kIsCluster) != 0;
      const std::uint32_t child = group.child[i] & ~ClusterGroup::kIsCluster;
      const Triangles here = leaf ? triangles_of(child) : check_group(child);
      for (const std::uint32_t primitive : here) check(group, i, primitive);
      below.insert(below.end(), here.begin(), here.end());
    }
    return below;
  }

  Triangles triangles_of(std::uint32_t c) {
    EXPECT_TRUE(clusters_.insert(c).second) << mesh_.name << ": cluster " << c << " is in the tree twice";
    const Cluster& cluster = all_.clusters[c];
    const auto first = all_.primitives.begin() + std::ptrdiff_t(cluster.first_triangle);
    return {first, first + cluster.n_triangles};
  }

  void check(const ClusterGroup& group, std::size_t i, std::uint32_t primitive) const {
    std::array<glm::dvec3, 3> p;
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::vec3& q = mesh_.positions[mesh_.vertex(3 * std::size_t(primitive) + k)];
      p[k] = glm::dvec3(q);
      for (int axis = 0; axis < 3; ++axis) {
        if (std::isnan(q[axis])) continue;  // in no box; the box must reach everywhere, as its other corners tell
        ASSERT_GE(q[axis], group.low[axis][i]) << mesh_.name;
        ASSERT_LE(q[axis], group.high[axis][i]) << mesh_.name;
      }
      if (!(std::isfinite(q.x) && std::isfinite(q.y) && std::isfinite(q.z))) {
        ASSERT_EQ(group.low[0][i], -std::numeric_limits<float>::infinity()) << mesh_.name;
        ASSERT_EQ(group.high[2][i], std::numeric_limits<float>::infinity()) << mesh_.name;
      }
    }
    if (group.cone_cos[i] <= 0.0f || p[0] == p[1] || p[1] == p[2] || p[2] == p[0]) return;
    const glm::dvec3 normal = glm::cross(p[1] - p[0], p[2] - p[0]);
    const double length = glm::length(normal);
    const glm::dvec3 axis{group.cone_axis[0][i], group.cone_axis[1][i], group.cone_axis[2][i]};
    ASSERT_NEAR(glm::length(axis), 1.0, 1e-6) << mesh_.name;  // floats
    ASSERT_GE(glm::dot(normal, axis), double(group.cone_cos[i]) * length) << mesh_.name;
    ASSERT_GE(length, double(group.least_normal[i])) << mesh_.name;
  }

  const Mesh& mesh_;
  const Clusters& all_;
  std::set<std::uint32_t> clusters_, groups_;
};

TEST(Clusters, AreOnceInATreeWhoseBoxesAndConesHoldThem) {
  for (const Mesh& mesh : mesh_zoo()) {
    const Clusters all = mesh.cut();
    EXPECT_EQ(all.groups.empty(), mesh.n_triangles() == 0) << mesh.name;
    TreeCheck(mesh, all).run();
  }
}

template <class T>
bool same(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

TEST(Clusters, AreTheSameForAnyNumberOfThreads) {
  for (const Mesh& mesh : mesh_zoo()) {
    const Clusters one = mesh.cut(1);
    for (const int threads : {2, 7}) {
      const Clusters many = mesh.cut(threads);
      EXPECT_TRUE(same(one.clusters, many.clusters) && same(one.groups, many.groups)) << mesh.name;
      EXPECT_TRUE(same(one.x, many.x) && same(one.y, many.y) && same(one.z, many.z)) << mesh.name;
      EXPECT_TRUE(same(one.vertices, many.vertices) && same(one.corners, many.corners)) << mesh.name;
      EXPECT_TRUE(same(one.primitives, many.primitives)) << mesh.name;
    }
  }
}

// Eight rectangles over one another, two triangles each. Half the surface of the common box is 9·9 + 2·9·3.5 = 144, of
// each triangle's box 81: more than 0.4 of it, so all are split apart.
TEST(Clusters, OfLargeTrianglesOverOneAnotherAreOneEach) {
  std::vector<glm::vec3> p;
  for (int k = 0; k < 8; ++k) {
    const float z = 0.5f * float(k);
    for (const glm::vec2 q : {glm::vec2{0, 0}, {9, 0}, {9, 9}, {0, 0}, {9, 9}, {0, 9}}) p.push_back({q, z});
  }
  const Clusters all = make_clusters(p, std::nullopt);
  EXPECT_EQ(all.clusters.size(), 16u);
}

// 128 small triangles side by side have a box much larger than their own: one cluster. With one more there are two.
TEST(Clusters, OfSmallTrianglesAreFull) {
  OwnedDraw grid;
  HashedNumbers random(1);
  add_grid(random, 8, 8, grid);
  EXPECT_EQ(make_clusters(grid.object, grid.indices).clusters.size(), 1u);
  for (const std::uint32_t v : {0u, 1u, 9u}) grid.indices.push_back(v);
  EXPECT_EQ(make_clusters(grid.object, grid.indices).clusters.size(), 2u);
}

TEST(Clusters, WithATriangleOfCornersOnALineHaveNoCone) {
  const std::vector<glm::vec3> p = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 5, 0}, {6, 6, 0}, {7, 7, 0}};
  const Clusters all = make_clusters(p, std::nullopt);
  ASSERT_EQ(all.clusters.size(), 1u);
  EXPECT_LE(all.groups[0].cone_cos[0], 0.0f);
}

// A triangle with two equal corners never has a sample, whatever its facing: it does not spoil the cone.
TEST(Clusters, WithATriangleOfTwoEqualCornersKeepTheirCone) {
  const std::vector<glm::vec3> p = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 5, 0}, {5, 5, 0}, {7, 7, 0}};
  const Clusters all = make_clusters(p, std::nullopt);
  ASSERT_EQ(all.clusters.size(), 1u);
  EXPECT_GT(all.groups[0].cone_cos[0], 0.99f);
  EXPECT_EQ(all.groups[0].cone_axis[2][0], 1.0f);
}

TEST(Clusters, OfOppositeFacingsHaveNoCone) {
  const std::vector<glm::vec3> p = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {50, 50, 0}, {50, 51, 0}, {51, 50, 0}};
  const Clusters all = make_clusters(p, std::nullopt);
  ASSERT_EQ(all.clusters.size(), 1u);
  EXPECT_LE(all.groups[0].cone_cos[0], 0.0f);
}

}  // namespace
}  // namespace lode::raster::test

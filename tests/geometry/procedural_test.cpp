/// Procedural models are what they say: closed, facing outwards, of the right size. And normals of meshes.

#include "geometry/procedural.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <utility>

#include "geometry/trigonometry.h"

namespace lode::geometry {
namespace {

using Place = std::array<float, 3>;

Place place(const Mesh& mesh, std::size_t corner) {
  const glm::vec3 p = mesh.positions[mesh.indices[corner]] + 0.0f;
  return {p.x, p.y, p.z};
}

/// Every edge, by positions, is used as often in one direction as in the other.
bool closed(const Mesh& mesh) {
  std::map<std::pair<Place, Place>, int> balance;
  for (std::size_t t = 0; t < mesh.n_primitives(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Place a = place(mesh, 3 * t + k), b = place(mesh, 3 * t + (k + 1) % 3);
      if (a < b) ++balance[{a, b}];
      if (b < a) --balance[{b, a}];
    }
  }
  for (const auto& [edge, n] : balance) {
    if (n != 0) return false;
  }
  return true;
}

/// Positive if triangles face outwards.
double volume(const Mesh& mesh) {
  double sum = 0.0;
  for (std::size_t t = 0; t < mesh.n_primitives(); ++t) {
    const auto p = [&](std::size_t k) { return glm::dvec3(mesh.positions[mesh.indices[3 * t + k]]); };
    sum += glm::dot(p(0), glm::cross(p(1), p(2))) / 6.0;
  }
  return sum;
}

TEST(Procedural, SolidsAreClosedFaceOutwardsAndHaveTheirVolume) {
  // n-gon prisms' limits: 4/3·π·r³ and 2π²·R·r², a little less for the facets.
  const Mesh ball = sphere({0, 0, 0}, 2.0, 64, 32);
  EXPECT_EQ(ball.n_primitives(), 2u * 64u * 31u);
  EXPECT_TRUE(closed(ball));
  EXPECT_NEAR(volume(ball), 33.51, 0.3);
  const Mesh ring = torus({0, 0, 0}, 1.0, 0.25, 64, 32);
  EXPECT_EQ(ring.n_primitives(), 2u * 64u * 32u);
  EXPECT_TRUE(closed(ring));
  EXPECT_NEAR(volume(ring), 1.2337, 0.02);
  const Mesh cube = box({-1, -2, -3}, {1, 2, 3});
  EXPECT_TRUE(closed(cube));
  EXPECT_EQ(volume(cube), 48.0);
}

TEST(Procedural, FarFromTheOriginTheSphereIsStillClosed) {
  EXPECT_TRUE(closed(sphere({148376, 1234, -223423}, 2.0, 200, 100)));
}

TEST(Procedural, StoredNormalsPointAsTheTrianglesFace) {
  for (const Mesh& mesh : {sphere({0, 0, 0}, 2.0, 16, 8), torus({0, 0, 0}, 1.0, 0.25, 16, 8), box({0, 0, 0}, {1, 2, 3}),
                           terrain(10, 16, 2, 1)}) {
    const Mesh flat = with_flat_normals(mesh);
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
      EXPECT_GT(glm::dot(mesh.normals[mesh.indices[i]], flat.normals[i]), 0.3f) << i;
    }
  }
}

TEST(Procedural, TerrainIsAFunctionOfItsSeed) {
  EXPECT_EQ(terrain(10, 8, 2, 1).positions, terrain(10, 8, 2, 1).positions);
  EXPECT_NE(terrain(10, 8, 2, 1).positions, terrain(10, 8, 2, 2).positions);
}

TEST(SmoothNormals, AreWeightedByAreaAndSharedByEqualPositions) {
  // Two triangles with doubled corners on their common edge, 45° apart: area normals (0, 0, 1) and (−2, 0, 2): the
  // shared corners have the direction (−2, 0, 3).
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {-0.0f, 1, 0}, {-2, 0, -2}};
  mesh.indices = {0, 1, 2, 3, 4, 5};
  const Mesh smooth = with_smooth_normals(mesh);
  const glm::vec3 shared = glm::vec3(glm::normalize(glm::dvec3(-2, 0, 3)));
  const auto normal = [&](std::size_t corner) { return smooth.normals[smooth.indices[corner]]; };
  for (const std::size_t corner : {0u, 2u, 3u, 4u}) EXPECT_EQ(normal(corner), shared) << corner;
  EXPECT_EQ(normal(1), glm::vec3(0, 0, 1));
  EXPECT_EQ(normal(5), glm::vec3(glm::normalize(glm::dvec3(-1, 0, 1))));
  EXPECT_EQ(smooth.positions.size(), 6u);  // nothing was split
}

TEST(SmoothNormals, LeaveCreasesSharpByMakingAVertexSeveral) {
  // Two triangles at a right angle on a common edge: its two vertices become four.
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, 0, 2}};
  mesh.uvs = {{0, 0}, {0, 1}, {1, 0}, {1, 1}};
  mesh.indices = {0, 1, 2, 1, 0, 3};
  const Mesh smooth = with_smooth_normals(mesh);
  ASSERT_EQ(smooth.positions.size(), 6u);
  for (std::size_t c = 0; c < 6; ++c) {
    EXPECT_EQ(smooth.normals[smooth.indices[c]], c < 3 ? glm::vec3(0, 0, 1) : glm::vec3(-1, 0, 0)) << c;
    EXPECT_EQ(smooth.positions[smooth.indices[c]], mesh.positions[mesh.indices[c]]) << c;
    EXPECT_EQ(smooth.uvs[smooth.indices[c]], mesh.uvs[mesh.indices[c]]) << c;
  }
}

TEST(SmoothNormals, OfAFaceThatIsThereFromBothSidesDoNotCancel) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.indices = {0, 1, 2, 2, 1, 0};
  const Mesh smooth = with_smooth_normals(mesh);
  for (std::size_t c = 0; c < 6; ++c) {
    EXPECT_EQ(smooth.normals[smooth.indices[c]], glm::vec3(0, 0, c < 3 ? 1 : -1)) << c;
  }
}

TEST(SmoothNormals, KeepWhatAMeshHas) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.normals = {{5, 0, 0}, {0, 0, 0}, {0, 0, 0}};
  mesh.indices = {0, 1, 2};
  const Mesh smooth = with_smooth_normals(mesh);
  EXPECT_EQ(smooth.normals[smooth.indices[0]], glm::vec3(5, 0, 0));
  EXPECT_EQ(smooth.normals[smooth.indices[1]], glm::vec3(0, 0, 1));
}

TEST(SmoothNormals, OfAVertexOfVeryManyTrianglesCostNoSquare) {
  // A fan of 100,000 triangles in a plane around one vertex: each corner there is flat.
  Mesh mesh;
  mesh.positions.emplace_back(0.0f);
  const int n = 100000;
  for (int i = 0; i < n; ++i) {
    const SinCos t = sin_cos(2.0 * kPi * i / n);
    mesh.positions.emplace_back(t.cos, t.sin, 0.0);
    const auto a = std::uint32_t(i + 1), b = std::uint32_t((i + 1) % n + 1);
    mesh.indices.insert(mesh.indices.end(), {0u, a, b});
  }
  for (const glm::vec3& normal : with_smooth_normals(mesh).normals) ASSERT_EQ(normal, glm::vec3(0, 0, 1));
}

TEST(SmoothNormals, AreZeroWhereThereIsNoArea) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {9, 9, 9}};
  mesh.indices = {0, 1, 2};
  for (const glm::vec3& n : with_smooth_normals(mesh).normals) EXPECT_EQ(n, glm::vec3(0, 0, 0));
  for (const glm::vec3& n : with_flat_normals(mesh).normals) EXPECT_EQ(n, glm::vec3(0, 0, 0));
}

TEST(Scene, BoundsAreOfTheIndexedVerticesInTheWorld) {
  Scene scene;
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {100, 100, 100}};  // the last one is not used
  mesh.indices = {0, 1, 2};
  glm::dmat4 moved(1.0);
  moved[3] = {10, 20, 30, 1};
  (void)add_instance(scene, mesh, {}, moved);
  EXPECT_EQ(scene.bounds().low, glm::dvec3(10, 20, 30));
  EXPECT_EQ(scene.bounds().high, glm::dvec3(11, 21, 30));
  EXPECT_TRUE(Scene{}.bounds().empty());
}

TEST(Scene, OnlyAnOddNumberOfNegativeScalesMirrors) {
  const auto scaled = [](double x, double y, double z) {
    glm::dmat4 m(1.0);
    m[0][0] = x, m[1][1] = y, m[2][2] = z;
    return m;
  };
  EXPECT_FALSE(mirrors(scaled(1, 2, 3)));
  EXPECT_TRUE(mirrors(scaled(-1, 2, 3)));
  EXPECT_FALSE(mirrors(scaled(-1, -2, 3)));
  EXPECT_TRUE(mirrors(scaled(-1, -2, -3)));
}

}  // namespace
}  // namespace lode::geometry

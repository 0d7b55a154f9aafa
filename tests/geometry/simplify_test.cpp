// Simplified meshes: how many triangles are left, whose vertices they have, how far the surface has moved.
#include "geometry/simplify.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <set>
#include <tuple>

#include "geometry/procedural.h"
#include "geometry/trigonometry.h"

namespace lode::geometry {
namespace {

using Vertex = std::tuple<float, float, float, float, float, float, float, float, float, float, float, float>;

/// Of a mesh that has every attribute.
std::set<Vertex> vertices_of(const Mesh& mesh) {
  std::set<Vertex> result;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const glm::vec3& p = mesh.positions[i];
    const glm::vec3& n = mesh.normals[i];
    const glm::vec4& c = mesh.colors[i];
    result.emplace(p.x, p.y, p.z, n.x, n.y, n.z, mesh.uvs[i].x, mesh.uvs[i].y, c.r, c.g, c.b, c.a);
  }
  return result;
}

Mesh colored(Mesh mesh) {
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) mesh.colors.emplace_back(float(i), 0.5f, 0.25f, 1.0f);
  return mesh;
}

bool same(const Mesh& a, const Mesh& b) {
  return a.kind == b.kind && a.positions == b.positions && a.indices == b.indices && a.normals == b.normals &&
         a.uvs == b.uvs && a.colors == b.colors && a.material == b.material;
}

/// The six sides of a cube of side 1, each of n² squares with four vertices and flat normals of its own.
Mesh cube_of_squares(int n) {
  Mesh mesh;
  for (int side = 0; side < 6; ++side) {
    const int axis = side / 2;
    const float outwards = side % 2 == 0 ? 1.0f : -1.0f;
    const auto point = [&](int u, int v) {
      glm::vec3 p;
      p[axis] = 0.5f * outwards;
      p[(axis + 1) % 3] = float(u) / float(n) - 0.5f;
      p[(axis + 2) % 3] = outwards * (float(v) / float(n) - 0.5f);
      return p;
    };
    for (int u = 0; u < n; ++u) {
      for (int v = 0; v < n; ++v) {
        const auto i = std::uint32_t(mesh.positions.size());
        for (const glm::vec3& p : {point(u, v), point(u + 1, v), point(u + 1, v + 1), point(u, v + 1)}) {
          mesh.positions.push_back(p);
          mesh.normals.emplace_back(0.0f);
          mesh.normals.back()[axis] = outwards;
        }
        for (const std::uint32_t k : {0u, 1u, 2u, 0u, 2u, 3u}) mesh.indices.push_back(i + k);
      }
    }
  }
  return mesh;
}

glm::dvec3 area_normal(const Mesh& mesh, std::size_t triangle) {
  const auto p = [&](std::size_t c) { return glm::dvec3(mesh.positions[mesh.indices[3 * triangle + c]]); };
  return glm::cross(p(1) - p(0), p(2) - p(0));
}

TEST(Simplify, KeepsAboutTheShareOfABallAndOfARing) {
  for (const Mesh& mesh : {sphere({1.0, 2.0, 3.0}, 2.0, 64, 32), torus({0.0, 0.0, 0.0}, 1.0, 0.4, 64, 32)}) {
    for (const double share : {0.5, 0.2, 0.05}) {
      const double wanted = share * double(mesh.n_primitives());
      const auto found = double(simplify(mesh, share).mesh.n_primitives());
      // A collapse takes two triangles, and the last pass may not stop between two that go together.
      EXPECT_LE(found, wanted + 2.0) << share;
      EXPECT_GE(found, 0.98 * wanted - 2.0) << share;
    }
  }
}

/// Vertices stay where they were, so what has moved most is the middle of a triangle.
TEST(Simplify, TheErrorGrowsAsTrianglesGoAndIsThatOfTheBall) {
  const double radius = 3.0;
  const Mesh ball = sphere({100.0, 0.0, 0.0}, radius, 96, 48);
  double error_before = 0.0;
  for (const double share : {0.5, 0.2, 0.05}) {
    const SimplifiedMesh simplified = simplify(ball, share);
    EXPECT_GT(simplified.error, error_before) << share;
    error_before = simplified.error;
    double farthest = 0.0;
    for (std::size_t t = 0; t < simplified.mesh.n_primitives(); ++t) {
      glm::dvec3 middle(0.0);
      for (std::size_t c = 0; c < 3; ++c) {
        middle += glm::dvec3(simplified.mesh.positions[simplified.mesh.indices[3 * t + c]]) / 3.0;
      }
      farthest = std::max(farthest, radius - glm::distance(middle, glm::dvec3(100.0, 0.0, 0.0)));
    }
    // The library's is a mean over planes, not a bound: within a factor of four here.
    EXPECT_LT(simplified.error, 4.0 * farthest) << share;
    EXPECT_GT(simplified.error, 0.25 * farthest) << share;
  }
}

TEST(Simplify, TheErrorIsInTheMeshsUnits) {
  const double small = simplify(sphere(glm::dvec3(0.0), 1.0, 48, 24), 0.2).error;
  const double large = simplify(sphere(glm::dvec3(0.0), 1024.0, 48, 24), 0.2).error;
  EXPECT_NEAR(large / small, 1024.0, 1024.0 * 1e-3);  // the ball's floats differ in their last bits
}

TEST(Simplify, EveryVertexIsOneOfTheInputsWithItsAttributesAndIsUsed) {
  Mesh mesh = colored(torus(glm::dvec3(0.0), 1.0, 0.4, 48, 24));
  mesh.material = 7;
  const Mesh simple = simplify(mesh, 0.2).mesh;
  EXPECT_EQ(simple.material, 7u);
  const std::set<Vertex> before = vertices_of(mesh), after = vertices_of(simple);
  EXPECT_TRUE(std::includes(before.begin(), before.end(), after.begin(), after.end()));
  const std::set<std::uint32_t> used(simple.indices.begin(), simple.indices.end());
  EXPECT_EQ(used.size(), simple.positions.size());
  EXPECT_EQ(*used.rbegin() + 1, simple.positions.size());
}

/// 6 · 8² · 2 = 768 triangles, all with vertices of their own; in the plane nothing moves, so that twelve are enough.
TEST(Simplify, CreasesNeitherStopItNorBecomeRound) {
  const Mesh cube = cube_of_squares(8);
  const SimplifiedMesh simplified = simplify(cube, 12.0 / 768.0);
  EXPECT_EQ(simplified.mesh.n_primitives(), 12u);
  EXPECT_LT(simplified.error, 1e-3);
  for (std::size_t c = 0; c < simplified.mesh.indices.size(); ++c) {
    const glm::dvec3 normal = glm::normalize(area_normal(simplified.mesh, c / 3));
    EXPECT_GT(glm::dot(normal, glm::dvec3(simplified.mesh.normals[simplified.mesh.indices[c]])), 0.999) << c;
  }
}

/// A tube whose texture goes around once: its first and its last column are at the same positions, with the same
/// normals. On either side of that seam no triangle may span the whole picture.
TEST(Simplify, TriangleBesideATextureSeamHasCoordinatesOfOneSide) {
  const int n_around = 32, n_high = 32;
  Mesh tube;
  for (int y = 0; y <= n_high; ++y) {
    for (int k = 0; k <= n_around; ++k) {
      const SinCos turn = sin_cos(2.0 * kPi * (k % n_around) / n_around);
      const glm::vec3 normal(float(turn.cos), 0.0f, float(-turn.sin));
      tube.positions.emplace_back(normal.x, 0.1f * float(y), normal.z);
      tube.normals.push_back(normal);
      tube.uvs.emplace_back(float(k) / float(n_around), float(y) / float(n_high));
    }
  }
  const auto at = [&](int k, int y) { return std::uint32_t(y * (n_around + 1) + k); };
  for (int y = 0; y < n_high; ++y) {
    for (int k = 0; k < n_around; ++k) {
      const std::uint32_t a = at(k, y), b = at(k + 1, y), c = at(k + 1, y + 1), d = at(k, y + 1);
      tube.indices.insert(tube.indices.end(), {a, b, c, a, c, d});
    }
  }
  const Mesh simple = simplify(tube, 0.2).mesh;
  EXPECT_LT(double(simple.n_primitives()), 0.25 * double(tube.n_primitives()));
  bool at_start = false, at_end = false;
  for (std::size_t t = 0; t < simple.n_primitives(); ++t) {
    float low = 1.0f, high = 0.0f;
    for (std::size_t c = 0; c < 3; ++c) {
      const float u = simple.uvs[simple.indices[3 * t + c]].x;
      low = std::min(low, u), high = std::max(high, u);
    }
    EXPECT_LE(high - low, 0.5f) << t;
    at_start = at_start || low == 0.0f, at_end = at_end || high == 1.0f;
  }
  EXPECT_TRUE(at_start && at_end);  // the seam is still there
}

TEST(Simplify, DoesTheSameTwice) {
  const Mesh mesh = colored(torus(glm::dvec3(0.0), 1.0, 0.4, 40, 20));
  const SimplifiedMesh a = simplify(mesh, 0.1), b = simplify(mesh, 0.1);
  EXPECT_TRUE(same(a.mesh, b.mesh));
  EXPECT_EQ(a.error, b.error);
}

TEST(Simplify, WhatCannotBeSimplerComesBackAsItIs) {
  const Mesh ball = sphere(glm::dvec3(0.0), 1.0, 12, 6);
  const auto expect_unchanged = [](const char* what, const Mesh& mesh, double share) {
    const SimplifiedMesh simplified = simplify(mesh, share);
    EXPECT_TRUE(same(simplified.mesh, mesh)) << what;
    EXPECT_EQ(simplified.error, 0.0) << what;
  };
  expect_unchanged("all of it", ball, 1.0);
  expect_unchanged("more than all", ball, 7.0);
  expect_unchanged("no number", ball, std::numeric_limits<double>::quiet_NaN());
  expect_unchanged("empty", Mesh{}, 0.5);
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.indices = {0, 1, 2};
  expect_unchanged("one triangle", mesh, 0.0);
  mesh.indices = {0, 0, 1, 2, 2, 2};
  expect_unchanged("degenerate triangles only", mesh, 0.5);
  for (const MeshKind kind : {MeshKind::lines, MeshKind::points}) {
    mesh.kind = kind;
    expect_unchanged("no triangles", mesh, 0.5);
  }
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    mesh = ball;
    mesh.positions[mesh.indices[10]].y = bad;
    // A NaN is not equal to itself.
    EXPECT_EQ(simplify(mesh, 0.5).mesh.indices, mesh.indices);
  }
  mesh = ball;
  mesh.indices[10] = std::uint32_t(mesh.positions.size());
  expect_unchanged("an index beyond", mesh, 0.5);
  mesh = ball;
  mesh.normals.pop_back();
  expect_unchanged("a normal missing", mesh, 0.5);
  mesh = ball;
  mesh.indices.pop_back();
  expect_unchanged("a corner missing", mesh, 0.5);
}

TEST(Simplify, PositionsThatNobodyUsesAndDegenerateTrianglesDoNotMatter) {
  const Mesh ball = sphere(glm::dvec3(0.0), 1.0, 32, 16);
  const SimplifiedMesh clean = simplify(ball, 0.25);
  Mesh mesh = ball;
  mesh.positions.emplace_back(std::numeric_limits<float>::quiet_NaN());
  mesh.normals.emplace_back(0.0f);
  mesh.uvs.emplace_back(0.0f);
  EXPECT_TRUE(same(simplify(mesh, 0.25).mesh, clean.mesh));
  // As many degenerate triangles as there are others: half the share leaves as many triangles.
  mesh = ball;
  mesh.indices.insert(mesh.indices.end(), ball.indices.size(), ball.indices[0]);
  EXPECT_TRUE(same(simplify(mesh, 0.125).mesh, clean.mesh));
}

TEST(Simplify, TinyHugeAndFarMeshesAreSimplifiedAsOthersAre) {
  const Mesh ball = sphere(glm::dvec3(0.0), 1.0, 32, 16);
  const SimplifiedMesh plain = simplify(ball, 0.25);
  for (const float scale : {0x1p-120f, 0x1p120f}) {
    Mesh mesh = ball;
    for (glm::vec3& p : mesh.positions) p *= scale;
    const SimplifiedMesh scaled = simplify(mesh, 0.25);
    EXPECT_EQ(scaled.mesh.indices, plain.mesh.indices) << scale;
    EXPECT_DOUBLE_EQ(scaled.error, plain.error * double(scale)) << scale;
  }
}

/// Triangles at random over few points: edges of many triangles, triangles there twice and turned.
TEST(Simplify, TrianglesThatAreNoSurfaceLeaveTrianglesOfTheirVertices) {
  std::uint32_t state = 1;
  const auto below = [&](std::uint32_t n) {
    state = state * 1664525u + 1013904223u;
    return (state >> 8) % n;
  };
  for (int k = 0; k < 50; ++k) {
    Mesh mesh;
    for (int i = 0; i < 30; ++i) {
      const auto x = float(below(4)), y = float(below(4));
      mesh.positions.emplace_back(x, y, float(below(4)));
    }
    for (int i = 0; i < 300; ++i) mesh.indices.push_back(below(30));
    const SimplifiedMesh simplified = simplify(mesh, 0.1);
    EXPECT_GT(simplified.mesh.n_primitives(), 0u);
    EXPECT_LE(simplified.mesh.n_primitives(), mesh.n_primitives());
    EXPECT_TRUE(std::isfinite(simplified.error));
    for (const std::uint32_t i : simplified.mesh.indices) ASSERT_LT(i, simplified.mesh.positions.size());
  }
}

}  // namespace
}  // namespace lode::geometry

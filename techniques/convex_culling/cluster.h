#pragma once
/// Clusters of polygons, and the tree that they grow into. Onozawa & Kitazawa, sec. 2.3.

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "geometry/bounds.h"
#include "techniques/convex_culling/approximation_params.h"
#include "techniques/convex_culling/silhouette_area.h"
#include "techniques/convex_culling/welded_mesh.h"

namespace lode::techniques::convex_culling {

/// A node v_i of alg. 1: a leaf is a polygon.
struct ClusterNode {
  std::vector<std::uint32_t> children;  ///< D(v_i), ascending; empty for a leaf
  std::vector<std::uint32_t> support;   ///< U_i, ascending; a leaf's are its corners
  geometry::Bounds bounds;              ///< of all vertices of its polygons
  double error = 0.0;                   ///< E of its polygons against the hull of U_i; 0 for a leaf
};

/// Nodes 0…triangles − 1 are the leaves; children come before parents; the last is the root. Empty for an empty mesh.
using ClusterTree = std::vector<ClusterNode>;

/// A cluster of the present round.
struct Cluster {
  std::uint32_t node = 0;
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> vertices;  ///< ascending
};

/// What a union of clusters would be: the measures that order candidates.
struct Candidate {
  std::vector<std::uint32_t> members;  ///< indices of clusters, ascending
  std::vector<std::uint32_t> support;
  double error = 0.0;       ///< E(S_i, C(U_i)), eq. 2
  double model_area = 0.0;  ///< A(S_i)
  double hull_area = 0.0;   ///< A(C(U_i)); by Cauchy's formula about ¾ of its surface
};

/// Measures each of some unions of clusters, given by their members. By as many threads as the params say.
[[nodiscard]] std::vector<Candidate> measure(const WeldedMesh& mesh, const ApproximationParams& params,
                                             std::span<const Cluster> clusters,
                                             std::vector<std::vector<std::uint32_t>> unions);

/// An error in whole steps of a billionth of the square of the mesh's diagonal: what differs by rounding is equal, so
/// that the ties of flat sets (all of E = 0) are decided by what comes next in the order.
[[nodiscard]] double in_steps(double area, const WeldedMesh& mesh);

/// Joins the members of each candidate, which have none in common, to one cluster with a node of its own; the others
/// stay as they are (gap). In order of their first members.
void merge(std::span<const Candidate> accepted, std::vector<Cluster>& clusters, ClusterTree& tree);

}  // namespace lode::techniques::convex_culling

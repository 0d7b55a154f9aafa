#pragma once
/// A mesh cut into clusters of at most 128 triangles under a tree of boxes, made once per mesh, so that a frame costs
/// what is visible in it: whole branches, then clusters, are skipped before a vertex of theirs is read. A cluster is a
/// leaf of the tree, split by the surface area heuristic (MacDonald & Booth 1990; binned as in Wald 2007), so that it
/// is compact, and large triangles do not share a cluster with others far away.

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

namespace lode::raster {

inline constexpr int kMaxClusterTriangles = 128;
inline constexpr int kMaxClusterVertices = 128;
inline constexpr int kClusterPadding = 16;  ///< positions of a cluster start at, and are padded to, multiples of this

struct Cluster {
  std::uint32_t first_vertex = 0;    ///< in x, y, z, vertices
  std::uint32_t first_triangle = 0;  ///< in corners, primitives
  std::uint16_t n_vertices = 0;
  std::uint16_t n_triangles = 0;
  glm::vec3 cone_axis{0.0f};  ///< unit; every triangle's normal n has n·axis ≥ cone_cos
  float cone_cos = -2.0f;     ///< ≤ 0: no use for culling
};

/// Boxes of the vertices below; children are nodes `first` and `first + 1`, or `first` is a cluster.
struct ClusterNode {
  glm::vec3 low{0.0f}, high{0.0f};
  std::uint32_t first = 0;
  bool leaf = false;
};

struct Clusters {
  std::vector<Cluster> clusters;
  std::vector<ClusterNode> nodes;         ///< node 0 is the root; empty without triangles
  std::vector<float> x, y, z;             ///< positions, cluster by cluster; padding repeats the last vertex
  std::vector<std::uint32_t> vertices;    ///< the mesh's vertex at each of them
  std::vector<std::uint8_t> corners;      ///< [3 · triangles + 1] vertices within the cluster
  std::vector<std::uint32_t> primitives;  ///< [triangles] the mesh's triangle
  std::size_t n_positions = 0;            ///< of the mesh that they were made of
  std::size_t n_primitives = 0;
};

/// Cuts a mesh. Every triangle is in exactly one cluster. Deterministic; the same for any number of threads.
///   positions   [n] object space
///   indices     [3·t], each < n; absent: positions three by three
[[nodiscard]] Clusters make_clusters(std::span<const glm::vec3> positions,
                                     std::optional<std::span<const std::uint32_t>> indices, int threads = 0);

}  // namespace lode::raster

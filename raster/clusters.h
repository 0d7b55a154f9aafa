#pragma once
/// A mesh cut into clusters of at most 128 triangles under a tree of boxes, made once per mesh, so that a frame costs
/// what is visible in it: whole branches, then clusters, are skipped before a vertex of theirs is read. A cluster is a
/// leaf of a binary tree split by the surface area heuristic (MacDonald & Booth 1990; binned as in Wald 2007), so that
/// it is compact; large triangles that lie over one another are split until each is on its own, so that they can be
/// drawn front to back. The binary tree is then folded into groups of sixteen boxes, which a frame looks at together.

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
  std::uint32_t first_triangle = 0;  ///< in primitives; times three in corners
  std::uint16_t n_vertices = 0;
  std::uint16_t n_triangles = 0;
};

/// Up to sixteen parts of the tree side by side; what is behind the last one is empty.
struct ClusterGroup {
  static constexpr int kMost = 16;
  static constexpr std::uint32_t kIsCluster = 0x80000000u;

  alignas(64) float low[3][kMost];  ///< [axis] boxes of the vertices below
  alignas(64) float high[3][kMost];
  alignas(64) float cone_axis[3][kMost];  ///< unit; every triangle's normal n below has n·axis ≥ cone_cos
  alignas(64) float cone_cos[kMost];      ///< ≤ 0: no use for culling
  alignas(64) float least_normal[kMost];  ///< least length of (b − a) × (c − a), of triangles whose corners all differ
  std::uint32_t child[kMost];             ///< a group, or kIsCluster | a cluster
  int n = 0;
};

struct Clusters {
  std::vector<Cluster> clusters;
  std::vector<ClusterGroup> groups;       ///< group 0 is the root; none without triangles
  glm::vec3 low{0.0f}, high{0.0f};        ///< box of everything
  std::vector<float> x, y, z;             ///< positions, cluster by cluster; padding repeats the last vertex
  std::vector<std::uint32_t> vertices;    ///< the mesh's vertex at each of them
  std::vector<std::uint8_t> corners;      ///< [3 · triangles + 1] vertices within the cluster
  std::vector<std::uint32_t> primitives;  ///< [triangles] the mesh's triangle
  std::size_t n_positions = 0;            ///< of the mesh that they were made of
  std::size_t n_primitives = 0;
};

/// Cuts a mesh. Every triangle is in exactly one cluster. Deterministic; the same for any number of threads.
///   positions   [n] object space; not finite ones are in boxes that reach everywhere
///   indices     [3·t], each < n; absent: positions three by three
///   cost        O(t log t)
[[nodiscard]] Clusters make_clusters(std::span<const glm::vec3> positions,
                                     std::optional<std::span<const std::uint32_t>> indices, int threads = 0);

}  // namespace lode::raster

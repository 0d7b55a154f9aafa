#pragma once
/// Which nodes of the tree stand for the model: the partition with the least error among those that a limit on hull
/// vertices allows and that a greedy way down from the root meets. Onozawa & Kitazawa, alg. 1, step 2.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "techniques/convex_culling/cluster.h"

namespace lode::techniques::convex_culling {

struct Partition {
  std::vector<std::uint32_t> nodes;  ///< ascending
  std::size_t n_vertices = 0;        ///< m(Q): extreme vertices, counted as the params say
};

/// The extreme points X(C(U)) of a node's hull, as vertices of the mesh, ascending. Found when first asked for.
class ExtremeVertices {
 public:
  ExtremeVertices(const WeldedMesh& mesh, const ClusterTree& tree, const ApproximationParams& params)
      : mesh_(mesh), tree_(tree), params_(params), known_(tree.size()) {}
  [[nodiscard]] const std::vector<std::uint32_t>& of(std::uint32_t node);

 private:
  const WeldedMesh& mesh_;
  const ClusterTree& tree_;
  const ApproximationParams& params_;
  std::vector<std::vector<std::uint32_t>> known_;
};

/// Q begins as {root}. Of all Q with one node replaced by its children that keep m ≤ limit, the one with the least E
/// goes on (ties: the lowest node; leaves stay, gap), E(Q) growing or not; the best on the way is returned. Nothing if
/// the root alone has more than `limit` vertices.
///
///   model_area  A(S), on the grid's samples
///   cost        a step looks at what it changed, and at one number for each node of Q
[[nodiscard]] Partition partition(const WeldedMesh& mesh, const ClusterTree& tree, std::size_t limit,
                                  const ApproximationParams& params, double model_area, ExtremeVertices& extreme);

/// The same, plainly: E and m of every Q' from the start. O(|Q|²) hulls; the tests' oracle.
[[nodiscard]] Partition reference_partition(const WeldedMesh& mesh, const ClusterTree& tree, std::size_t limit,
                                            const ApproximationParams& params, double model_area,
                                            ExtremeVertices& extreme);

/// A(S) on the samples of the grid that partition() uses.
[[nodiscard]] double sampled_area(const WeldedMesh& mesh, const ApproximationParams& params);

}  // namespace lode::techniques::convex_culling

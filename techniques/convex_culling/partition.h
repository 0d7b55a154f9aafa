#pragma once
/// Which nodes of the tree stand for the model: the partition with the least error among those that a limit on hull
/// vertices allows and that a greedy way down from the root meets. Onozawa & Kitazawa, alg. 1, step 2.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "techniques/convex_culling/cluster.h"
#include "techniques/convex_culling/extreme_vertices.h"

namespace lode::techniques::convex_culling {

struct Partition {
  std::vector<std::uint32_t> nodes;  ///< ascending
  std::size_t n_vertices = 0;        ///< m(Q): extreme vertices, counted as the params say
  double error = 0.0;                ///< E(Q) on the grid's samples
};

/// Q begins as {root}. Of all Q with one node replaced by its children that keep m ≤ limit, the one with the least E
/// goes on, E(Q) growing or not; the best on the way is returned. Leaves stay (gap). Of equal E (gap: nothing seems to
/// change where others hide it) the one whose hulls have the least silhouettes each for itself, then the lowest node.
/// Nothing if the root alone has more than `limit` vertices.
///
///   model_area  A(S), on the grid's samples
///   cost        a step looks at what it changed, and at one number for each node of Q
[[nodiscard]] Partition partition(const WeldedMesh& mesh, const ClusterTree& tree, std::size_t limit,
                                  const ApproximationParams& params, double model_area, ExtremeVertices& extreme);

/// A(S) on the samples of the grid that partition() uses.
[[nodiscard]] double sampled_area(const WeldedMesh& mesh, const ApproximationParams& params);

}  // namespace lode::techniques::convex_culling

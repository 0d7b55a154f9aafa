#pragma once
/// The plain way down the tree: what partition() must equal.

#include "techniques/convex_culling/partition.h"

namespace lode::techniques::convex_culling {

/// As partition() with order least_error or own_error, with E and m of every Q' from the start: O(|Q|²) hulls a step.
[[nodiscard]] Partition reference_partition(const WeldedMesh& mesh, const ClusterTree& tree, std::size_t limit,
                                            const ApproximationParams& params, double model_area,
                                            ExtremeVertices& extreme);

}  // namespace lode::techniques::convex_culling

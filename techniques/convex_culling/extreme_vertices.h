#pragma once
/// The vertices that a node's hull needs, which limits M count.

#include <cstdint>
#include <vector>

#include "techniques/convex_culling/cluster.h"

namespace lode::techniques::convex_culling {

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

}  // namespace lode::techniques::convex_culling

#pragma once
/// The nodes Q of a partition while it is looked for, with what is asked of them again and again kept up: the area of
/// their hulls' silhouettes and the number of their vertices. Onozawa & Kitazawa, alg. 1, step 2.

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "techniques/convex_culling/cluster.h"
#include "techniques/convex_culling/coverage_grid.h"
#include "techniques/convex_culling/extreme_vertices.h"

namespace lode::techniques::convex_culling {

class Selection {
 public:
  /// Empty; borrows all.
  Selection(const WeldedMesh& mesh, const ClusterTree& tree, const ApproximationParams& params,
            ExtremeVertices& extreme);

  void add(std::uint32_t node);
  void remove(std::uint32_t node);  ///< one that was added
  void split(std::uint32_t node);   ///< in its place its children

  /// What splitting the node would change.
  struct Change {
    std::array<std::int64_t, 3> covered{};  ///< in samples of the union, on each plane
    std::int64_t m = 0;                     ///< in vertices
    std::int64_t own = 0;                   ///< in samples of each hull for itself
  };
  [[nodiscard]] Change change(std::uint32_t node);

  [[nodiscard]] std::int64_t m() const { return m_; }
  /// A(Q) after a change; as it is after none.
  [[nodiscard]] double area_after(const Change& change) const;

 private:
  const GridFootprint& footprint(std::uint32_t node);

  const WeldedMesh& mesh_;
  const ClusterTree& tree_;
  const ApproximationParams& params_;
  ExtremeVertices& extreme_;
  CoverageGrid grid_;
  std::map<std::uint32_t, GridFootprint> footprints_;  ///< of nodes asked for
  std::vector<std::uint32_t> n_uses_;                  ///< [vertices] by how many hulls
  std::int64_t m_ = 0;
};

}  // namespace lode::techniques::convex_culling

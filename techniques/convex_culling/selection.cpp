#include "techniques/convex_culling/selection.h"

#include <utility>

namespace lode::techniques::convex_culling {

Selection::Selection(const WeldedMesh& mesh, const ClusterTree& tree, const ApproximationParams& params,
                     ExtremeVertices& extreme)
    : mesh_(mesh),
      tree_(tree),
      params_(params),
      extreme_(extreme),
      grid_(mesh.bounds, params.n_grid),
      n_uses_(mesh.vertices.size()) {}

void Selection::add(std::uint32_t node) {
  grid_.add(footprint(node));
  for (const std::uint32_t v : extreme_.of(node)) m_ += n_uses_[v]++ == 0 || params_.count == VertexCount::sum;
}

void Selection::remove(std::uint32_t node) {
  grid_.remove(footprint(node));
  for (const std::uint32_t v : extreme_.of(node)) m_ -= --n_uses_[v] == 0 || params_.count == VertexCount::sum;
}

void Selection::split(std::uint32_t node) {
  remove(node);
  for (const std::uint32_t child : tree_[node].children) add(child);
}

Selection::Change Selection::change(std::uint32_t node) {
  const std::array<std::int64_t, 3> before = grid_.covered();
  const std::int64_t m_before = m_;
  split(node);
  Change result{grid_.covered(), m_ - m_before, -footprint(node).n_samples()};
  for (std::size_t axis = 0; axis < 3; ++axis) result.covered[axis] -= before[axis];
  for (const std::uint32_t child : tree_[node].children) {
    remove(child);
    result.own += footprint(child).n_samples();
  }
  add(node);
  return result;
}

double Selection::area_after(const Change& change) const {
  std::array<std::int64_t, 3> covered = grid_.covered();
  for (std::size_t axis = 0; axis < 3; ++axis) covered[axis] += change.covered[axis];
  return grid_.area_of(covered);
}

const GridFootprint& Selection::footprint(std::uint32_t node) {
  const auto [at, is_new] = footprints_.try_emplace(node);
  if (is_new) at->second = grid_.footprint(mesh_.vertices, tree_[node].support);
  return at->second;
}

}  // namespace lode::techniques::convex_culling

#include "techniques/convex_culling/partition.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "geometry/hull.h"
#include "techniques/convex_culling/coverage_grid.h"

namespace lode::techniques::convex_culling {
namespace {

bool overlap(const geometry::Bounds& a, const geometry::Bounds& b) {
  // In some plane: on at least two axes.
  int n = 0;
  for (int axis = 0; axis < 3; ++axis) n += a.low[axis] <= b.high[axis] && b.low[axis] <= a.high[axis];
  return n >= 2;
}

/// Q, with its silhouettes and its count of vertices.
class Selection {
 public:
  Selection(const WeldedMesh& mesh, const ClusterTree& tree, const ApproximationParams& params,
            ExtremeVertices& extreme)
      : mesh_(mesh),
        tree_(tree),
        params_(params),
        extreme_(extreme),
        grid_(mesh.bounds, params.n_grid),
        n_uses_(mesh.vertices.size()) {}

  void add(std::uint32_t node) {
    grid_.add(footprint(node));
    for (const std::uint32_t v : extreme_.of(node)) m_ += n_uses_[v]++ == 0 || params_.count == VertexCount::sum;
  }
  void remove(std::uint32_t node) {
    grid_.remove(footprint(node));
    for (const std::uint32_t v : extreme_.of(node)) m_ -= --n_uses_[v] == 0 || params_.count == VertexCount::sum;
  }
  void split(std::uint32_t node) {
    remove(node);
    for (const std::uint32_t child : tree_[node].children) add(child);
  }

  /// What splitting the node would change.
  struct Change {
    std::array<std::int64_t, 3> covered{};
    std::int64_t m = 0;
  };
  [[nodiscard]] Change change(std::uint32_t node) {
    const std::array<std::int64_t, 3> before = grid_.covered();
    const std::int64_t m_before = m_;
    split(node);
    Change result{grid_.covered(), m_ - m_before};
    for (std::size_t axis = 0; axis < 3; ++axis) result.covered[axis] -= before[axis];
    for (const std::uint32_t child : tree_[node].children) remove(child);
    add(node);
    return result;
  }

  [[nodiscard]] std::int64_t m() const { return m_; }
  [[nodiscard]] double area_after(const Change& change) const {
    std::array<std::int64_t, 3> covered = grid_.covered();
    for (std::size_t axis = 0; axis < 3; ++axis) covered[axis] += change.covered[axis];
    return grid_.area_of(covered);
  }

 private:
  const GridFootprint& footprint(std::uint32_t node) {
    const auto [at, is_new] = footprints_.try_emplace(node);
    if (is_new) at->second = grid_.footprint(mesh_.vertices, tree_[node].support);
    return at->second;
  }

  const WeldedMesh& mesh_;
  const ClusterTree& tree_;
  const ApproximationParams& params_;
  ExtremeVertices& extreme_;
  CoverageGrid grid_;
  std::map<std::uint32_t, GridFootprint> footprints_;  ///< of nodes asked for
  std::vector<std::uint32_t> n_uses_;                  ///< [vertices] by how many hulls
  std::int64_t m_ = 0;
};

/// A node of Q that can be split, and what that would change, as long as nothing near it has changed.
struct Splittable {
  std::uint32_t node;
  std::optional<Selection::Change> change;
};

}  // namespace

const std::vector<std::uint32_t>& ExtremeVertices::of(std::uint32_t node) {
  std::vector<std::uint32_t>& known = known_[node];
  const std::vector<std::uint32_t>& support = tree_[node].support;
  if (!known.empty() || support.empty()) return known;
  if (params_.on_stage) params_.on_stage(ApproximationStage::hulls);
  std::vector<glm::dvec3> points;
  for (const std::uint32_t v : support) points.emplace_back(mesh_.vertices[v]);
  for (const std::uint32_t i : geometry::convex_hull(points).vertices) known.push_back(support[i]);
  std::ranges::sort(known);
  if (params_.on_stage) params_.on_stage(ApproximationStage::partition);
  return known;
}

Partition partition(const WeldedMesh& mesh, const ClusterTree& tree, std::size_t limit,
                    const ApproximationParams& params, double model_area, ExtremeVertices& extreme) {
  if (tree.empty()) return {};
  const std::uint32_t root = std::uint32_t(tree.size() - 1);
  Selection selection(mesh, tree, params, extreme);
  selection.add(root);
  if (std::size_t(selection.m()) > limit) return {};
  std::vector<std::uint32_t> splits;  // in order
  std::size_t n_best = 0, m_best = std::size_t(selection.m());
  double least = std::fabs(model_area - selection.area_after({}));
  std::vector<Splittable> queue = {{root, {}}};
  std::erase_if(queue, [&](const Splittable& s) { return tree[s.node].children.empty(); });
  for (;;) {
    const Splittable* best = nullptr;
    double best_error = 0.0;
    for (Splittable& s : queue) {  // ascending by node
      if (!s.change) s.change = selection.change(s.node);
      if (selection.m() + s.change->m > std::int64_t(limit)) continue;
      const double error = std::fabs(model_area - selection.area_after(*s.change));
      if (best == nullptr || error < best_error) best = &s, best_error = error;
    }
    if (best == nullptr) break;
    const std::uint32_t node = best->node;
    selection.split(node);
    splits.push_back(node);
    std::erase_if(queue, [&](const Splittable& s) { return s.node == node; });
    for (Splittable& s : queue) {
      if (overlap(tree[s.node].bounds, tree[node].bounds)) s.change.reset();
    }
    for (const std::uint32_t child : tree[node].children) {
      if (!tree[child].children.empty()) queue.push_back({child, {}});
    }
    std::ranges::sort(queue, {}, &Splittable::node);
    if (best_error < least) least = best_error, n_best = splits.size(), m_best = std::size_t(selection.m());
  }
  // Q_min: the root with the first n_best splits made.
  Partition result{{root}, m_best};
  for (std::size_t i = 0; i < n_best; ++i) {
    std::erase(result.nodes, splits[i]);
    const std::vector<std::uint32_t>& children = tree[splits[i]].children;
    result.nodes.insert(result.nodes.end(), children.begin(), children.end());
  }
  std::ranges::sort(result.nodes);
  return result;
}

double sampled_area(const WeldedMesh& mesh, const ApproximationParams& params) {
  CoverageGrid grid(mesh.bounds, params.n_grid);
  for (const Triangle& t : mesh.triangles) grid.add(grid.footprint(mesh.vertices, t));
  return grid.area();
}

Partition reference_partition(const WeldedMesh& mesh, const ClusterTree& tree, std::size_t limit,
                              const ApproximationParams& params, double model_area, ExtremeVertices& extreme) {
  if (tree.empty()) return {};
  const auto m = [&](const std::vector<std::uint32_t>& nodes) {
    std::vector<std::uint32_t> all;
    for (const std::uint32_t node : nodes) all.insert(all.end(), extreme.of(node).begin(), extreme.of(node).end());
    if (params.count == VertexCount::sum) return all.size();
    std::ranges::sort(all);
    return std::size_t(std::ranges::unique(all).begin() - all.begin());
  };
  const auto error = [&](const std::vector<std::uint32_t>& nodes) {
    CoverageGrid grid(mesh.bounds, params.n_grid);
    for (const std::uint32_t node : nodes) grid.add(grid.footprint(mesh.vertices, tree[node].support));
    return std::fabs(model_area - grid.area());
  };
  std::vector<std::uint32_t> q = {std::uint32_t(tree.size() - 1)};
  if (m(q) > limit) return {};
  Partition least{q, m(q)};
  double least_error = error(q);
  for (;;) {
    std::optional<std::pair<double, std::vector<std::uint32_t>>> best;
    for (const std::uint32_t node : q) {
      if (tree[node].children.empty()) continue;
      std::vector<std::uint32_t> next = q;
      std::erase(next, node);
      next.insert(next.end(), tree[node].children.begin(), tree[node].children.end());
      std::ranges::sort(next);
      if (m(next) > limit) continue;
      const double e = error(next);
      if (!best || e < best->first) best = {e, std::move(next)};
    }
    if (!best) return least;
    q = std::move(best->second);
    if (best->first < least_error) least_error = best->first, least = {q, m(q)};
  }
}

}  // namespace lode::techniques::convex_culling

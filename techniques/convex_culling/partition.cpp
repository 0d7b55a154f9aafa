#include "techniques/convex_culling/partition.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include "techniques/convex_culling/coverage_grid.h"
#include "techniques/convex_culling/selection.h"

namespace lode::techniques::convex_culling {
namespace {

/// Whether two boxes overlap in the picture on some plane, that is on two axes at least.
bool overlap_on_a_plane(const geometry::Bounds& a, const geometry::Bounds& b) {
  int n = 0;
  for (int axis = 0; axis < 3; ++axis) n += a.low[axis] <= b.high[axis] && b.low[axis] <= a.high[axis];
  return n >= 2;
}

/// Alg. 1, step 2, from the root down.
class Descent {
 public:
  Descent(const WeldedMesh& mesh, const ClusterTree& tree, std::size_t limit, const ApproximationParams& params,
          SplitOrder order, double model_area, ExtremeVertices& extreme)
      : tree_(tree),
        limit_(std::int64_t(limit)),
        order_(order),
        model_area_(model_area),
        selection_(mesh, tree, params, extreme),
        root_(std::uint32_t(tree.size() - 1)) {
    selection_.add(root_);
    if (!tree[root_].children.empty()) queue_.push_back({root_, {}});
  }

  [[nodiscard]] Partition best() {
    if (selection_.m() > limit_) return {};
    Partition least{{}, std::size_t(selection_.m()), error_after({})};
    std::size_t n_least = 0;
    while (const std::optional<std::uint32_t> node = next()) {
      split(*node);
      if (const double error = error_after({}); error < least.error) {
        least = {{}, std::size_t(selection_.m()), error};
        n_least = splits_.size();
      }
    }
    least.nodes = nodes_after(n_least);
    return least;
  }

 private:
  /// A node of Q that has children, and what splitting it would change, as long as nothing near it has changed.
  struct Splittable {
    std::uint32_t node;
    std::optional<Selection::Change> change;
  };

  [[nodiscard]] double error_after(const Selection::Change& change) const {
    return std::fabs(model_area_ - selection_.area_after(change));
  }

  [[nodiscard]] std::optional<std::uint32_t> next() {
    std::optional<std::uint32_t> best;
    std::tuple<double, std::int64_t, std::uint32_t> least_key;
    for (Splittable& s : queue_) {
      if (!s.change) s.change = selection_.change(s.node);
      if (selection_.m() + s.change->m > limit_) continue;
      const std::tuple key = order_ == SplitOrder::own_error
                                 ? std::tuple(-tree_[s.node].error, std::int64_t{0}, s.node)
                                 : std::tuple(error_after(*s.change), s.change->own, s.node);
      if (!best || key < least_key) best = s.node, least_key = key;
    }
    return best;
  }

  void split(std::uint32_t node) {
    selection_.split(node);
    splits_.push_back(node);
    std::erase_if(queue_, [&](const Splittable& s) { return s.node == node; });
    for (Splittable& s : queue_) {
      if (overlap_on_a_plane(tree_[s.node].bounds, tree_[node].bounds)) s.change.reset();
    }
    for (const std::uint32_t child : tree_[node].children) {
      if (!tree_[child].children.empty()) queue_.push_back({child, {}});
    }
  }

  /// Q after the first n splits.
  [[nodiscard]] std::vector<std::uint32_t> nodes_after(std::size_t n) const {
    std::vector<std::uint32_t> split(splits_.begin(), splits_.begin() + std::ptrdiff_t(n)), nodes;
    std::ranges::sort(split);
    const auto add = [&](std::uint32_t node) {
      if (!std::ranges::binary_search(split, node)) nodes.push_back(node);
    };
    add(root_);
    for (const std::uint32_t node : split) std::ranges::for_each(tree_[node].children, add);
    std::ranges::sort(nodes);
    return nodes;
  }

  const ClusterTree& tree_;
  std::int64_t limit_;
  SplitOrder order_;
  double model_area_;
  Selection selection_;
  std::uint32_t root_;
  std::vector<Splittable> queue_;      ///< in any order
  std::vector<std::uint32_t> splits_;  ///< in their order
};

}  // namespace

Partition partition(const WeldedMesh& mesh, const ClusterTree& tree, std::size_t limit,
                    const ApproximationParams& params, double model_area, ExtremeVertices& extreme) {
  if (tree.empty()) return {};
  const auto by = [&](SplitOrder order) {
    return Descent(mesh, tree, std::min(limit, std::size_t{1} << 62), params, order, model_area, extreme).best();
  };
  if (params.order != SplitOrder::better) return by(params.order);
  Partition printed = by(SplitOrder::least_error), own = by(SplitOrder::own_error);
  return own.error < printed.error ? own : printed;
}

double sampled_area(const WeldedMesh& mesh, const ApproximationParams& params) {
  CoverageGrid grid(mesh.bounds, params.n_grid);
  for (const Triangle& t : mesh.triangles) grid.add(grid.footprint(mesh.vertices, t));
  return grid.area();
}

}  // namespace lode::techniques::convex_culling

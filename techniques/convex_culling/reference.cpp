#include "techniques/convex_culling/reference.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

#include "techniques/convex_culling/coverage_grid.h"

namespace lode::techniques::convex_culling {

Partition reference_partition(const WeldedMesh& mesh, const ClusterTree& tree, std::size_t limit,
                              const ApproximationParams& params, double model_area, ExtremeVertices& extreme) {
  if (tree.empty()) return {};
  const auto m = [&](const std::vector<std::uint32_t>& nodes) {
    std::vector<std::uint32_t> all;
    for (const std::uint32_t node : nodes) all.insert(all.end(), extreme.of(node).begin(), extreme.of(node).end());
    if (params.count == VertexCount::sum) return all.size();
    std::ranges::sort(all);
    return std::size_t(std::unique(all.begin(), all.end()) - all.begin());
  };
  const auto error = [&](const std::vector<std::uint32_t>& nodes, std::int64_t& own) {
    CoverageGrid grid(mesh.bounds, params.n_grid);
    own = 0;
    for (const std::uint32_t node : nodes) {
      const GridFootprint footprint = grid.footprint(mesh.vertices, tree[node].support);
      grid.add(footprint);
      own += footprint.n_samples();
    }
    return std::fabs(model_area - grid.area());
  };
  std::int64_t own = 0;
  std::vector<std::uint32_t> q = {std::uint32_t(tree.size() - 1)};
  if (m(q) > limit) return {};
  Partition least{q, m(q), error(q, own)};
  using Key = std::pair<double, std::int64_t>;
  for (;;) {
    std::optional<std::tuple<Key, double, std::vector<std::uint32_t>>> best;
    for (const std::uint32_t node : q) {
      if (tree[node].children.empty()) continue;
      std::vector<std::uint32_t> next = q;
      std::erase(next, node);
      next.insert(next.end(), tree[node].children.begin(), tree[node].children.end());
      std::ranges::sort(next);
      if (m(next) > limit) continue;
      const double e = error(next, own);
      const Key key = params.order == SplitOrder::own_error ? Key{-tree[node].error, 0} : Key{e, own};
      if (!best || key < std::get<0>(*best)) best = {key, e, std::move(next)};
    }
    if (!best) return least;
    q = std::move(std::get<2>(*best));
    if (std::get<1>(*best) < least.error) least = {q, m(q), std::get<1>(*best)};
  }
}

}  // namespace lode::techniques::convex_culling

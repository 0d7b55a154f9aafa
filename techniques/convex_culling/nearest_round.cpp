#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <tuple>
#include <utility>

#include "techniques/convex_culling/clustering_round.h"

namespace lode::techniques::convex_culling {
namespace {

struct Sphere {
  glm::dvec3 centre;
  double radius;
};

std::vector<Sphere> bounding_spheres(std::span<const Cluster> clusters, const ClusterTree& tree) {
  std::vector<Sphere> spheres;
  for (const Cluster& cluster : clusters) {
    const geometry::Bounds& box = tree[cluster.node].bounds;
    spheres.push_back({box.centre(), 0.5 * box.diagonal()});
  }
  return spheres;
}

/// Negative where they overlap.
double distance(const Sphere& a, const Sphere& b) { return glm::length(a.centre - b.centre) - a.radius - b.radius; }

/// The bits of a 21-bit number, three apart.
std::uint64_t spread(std::uint64_t x) {
  std::uint64_t result = 0;
  for (int i = 0; i < 21; ++i) result |= (x >> i & 1) << (3 * i);
  return result;
}

std::vector<std::uint32_t> along_morton_curve(std::span<const Sphere> spheres, const geometry::Bounds& bounds) {
  std::vector<std::pair<std::uint64_t, std::uint32_t>> codes;
  for (std::uint32_t i = 0; i < spheres.size(); ++i) {
    std::uint64_t code = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double size = bounds.high[axis] - bounds.low[axis];
      const double t = size > 0.0 ? (spheres[i].centre[axis] - bounds.low[axis]) / size : 0.0;
      code |= spread(std::uint64_t(std::clamp(t, 0.0, 1.0) * double((1 << 21) - 1))) << axis;
    }
    codes.emplace_back(code, i);
  }
  std::ranges::sort(codes);
  std::vector<std::uint32_t> order;
  for (const auto& [code, i] : codes) order.push_back(i);
  return order;
}

/// So many clusters, or fewer, are looked at with care: all pairs, and few of them joined in a round.
constexpr std::size_t kAllPairs = 256;

using Pair = std::array<std::uint32_t, 2>;  ///< ascending

/// Pairs by distance, as long as either of the two has been in fewer than eight; and all neighbours along the curve.
std::vector<Pair> near_pairs(std::span<const Sphere> spheres, const geometry::Bounds& bounds) {
  constexpr std::uint32_t kWindow = 3, kMostPairs = 8;
  const std::uint32_t n = std::uint32_t(spheres.size());
  const std::vector<std::uint32_t> order = along_morton_curve(spheres, bounds);
  const std::uint32_t reach = n <= kAllPairs ? n : kWindow;
  std::vector<std::tuple<double, Pair, bool>> all;
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t k = i + 1; k < n && k - i <= reach; ++k) {
      const Pair pair = {std::min(order[i], order[k]), std::max(order[i], order[k])};
      all.emplace_back(distance(spheres[pair[0]], spheres[pair[1]]), pair, k == i + 1);
    }
  }
  std::ranges::sort(all);
  std::vector<std::uint32_t> n_pairs(n);
  std::vector<Pair> pairs;
  for (const auto& [far, pair, next_on_curve] : all) {
    const bool full = n_pairs[pair[0]] >= kMostPairs || n_pairs[pair[1]] >= kMostPairs;
    if (full && !next_on_curve) continue;
    ++n_pairs[pair[0]];
    ++n_pairs[pair[1]];
    pairs.push_back(pair);
  }
  return pairs;
}

}  // namespace

void nearest_round(const WeldedMesh& mesh, const ApproximationParams& params, std::vector<Cluster>& clusters,
                   ClusterTree& tree) {
  const std::vector<Sphere> spheres = bounding_spheres(clusters, tree);
  std::vector<std::vector<std::uint32_t>> unions;
  for (const auto& [a, b] : near_pairs(spheres, mesh.bounds)) unions.push_back({a, b});
  std::vector<Candidate> candidates = measure(mesh, params, clusters, std::move(unions));
  std::vector<std::tuple<double, double, Pair, std::uint32_t>> keys;
  for (std::uint32_t i = 0; i < candidates.size(); ++i) {
    const std::uint32_t a = candidates[i].members[0], b = candidates[i].members[1];
    const double increase = candidates[i].error - tree[clusters[a].node].error - tree[clusters[b].node].error;
    keys.emplace_back(in_steps(increase, mesh), distance(spheres[a], spheres[b]), Pair{a, b}, i);
  }
  std::ranges::sort(keys);
  const std::size_t n_most =
      clusters.size() > kAllPairs ? clusters.size() : std::max<std::size_t>(clusters.size() / 4, 1);
  std::vector<Candidate> accepted;
  std::vector<bool> taken(clusters.size());
  for (const auto& [increase, far, pair, i] : keys) {
    if (accepted.size() >= n_most) break;
    if (taken[pair[0]] || taken[pair[1]]) continue;
    taken[pair[0]] = taken[pair[1]] = true;
    accepted.push_back(std::move(candidates[i]));
  }
  merge(accepted, clusters, tree);
}

}  // namespace lode::techniques::convex_culling

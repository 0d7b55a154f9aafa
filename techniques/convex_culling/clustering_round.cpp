#include "techniques/convex_culling/clustering_round.h"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

namespace lode::techniques::convex_culling {
namespace {

/// Accepts, in the order given, what shares no cluster with what was accepted before.
std::vector<Candidate> without_overlap(std::vector<Candidate>& candidates, std::span<const std::uint32_t> order,
                                       std::size_t n_clusters) {
  std::vector<bool> taken(n_clusters);
  std::vector<Candidate> accepted;
  for (const std::uint32_t i : order) {
    const std::vector<std::uint32_t>& members = candidates[i].members;
    if (std::ranges::any_of(members, [&](std::uint32_t m) { return taken[m]; })) continue;
    for (const std::uint32_t m : members) taken[m] = true;
    accepted.push_back(std::move(candidates[i]));
  }
  return accepted;
}

std::size_t n_triangles(std::span<const Cluster> clusters, std::span<const std::uint32_t> members) {
  std::size_t n = 0;
  for (const std::uint32_t m : members) n += clusters[m].triangles.size();
  return n;
}

ClusterTree leaves(const WeldedMesh& mesh, std::vector<Cluster>& clusters) {
  ClusterTree tree;
  for (const Triangle& triangle : mesh.triangles) {
    Cluster cluster{.node = std::uint32_t(tree.size()), .triangles = {triangle}, .vertices = {}};
    cluster.vertices.assign(triangle.begin(), triangle.end());
    std::ranges::sort(cluster.vertices);
    ClusterNode leaf{.children = {}, .support = cluster.vertices, .bounds = {}, .error = 0.0};
    for (const std::uint32_t v : triangle) leaf.bounds.add(glm::dvec3(mesh.vertices[v]));
    tree.push_back(std::move(leaf));
    clusters.push_back(std::move(cluster));
  }
  return tree;
}

}  // namespace

std::vector<std::vector<std::uint32_t>> neighbourhoods(std::span<const Cluster> clusters, std::size_t n_vertices) {
  std::vector<std::vector<std::uint32_t>> at_vertex(n_vertices);  // clusters, ascending
  for (std::uint32_t i = 0; i < clusters.size(); ++i) {
    for (const std::uint32_t v : clusters[i].vertices) at_vertex[v].push_back(i);
  }
  std::vector<std::vector<std::uint32_t>> result(clusters.size());
  for (std::uint32_t i = 0; i < clusters.size(); ++i) {
    std::vector<std::uint32_t>& members = result[i];
    members.push_back(i);
    for (const std::uint32_t v : clusters[i].vertices) {
      const std::vector<std::uint32_t>& all = at_vertex[v];
      auto begin = all.begin(), end = all.end();
      if (all.size() > kMaxSharing) {
        const auto own = std::ranges::lower_bound(all, i) - all.begin();
        constexpr std::ptrdiff_t kEach = kMaxSharing / 16;
        begin += std::max<std::ptrdiff_t>(own - kEach, 0);
        end = all.begin() + std::min<std::ptrdiff_t>(own + kEach + 1, std::ssize(all));
      }
      if (end - begin > 1) members.insert(members.end(), begin, end);
    }
    std::ranges::sort(members);
    members.erase(std::unique(members.begin(), members.end()), members.end());
  }
  return result;
}

void neighbour_round(const WeldedMesh& mesh, const ApproximationParams& params, std::vector<Cluster>& clusters,
                     ClusterTree& tree) {
  std::vector<std::vector<std::uint32_t>> unions;
  std::vector<std::vector<std::uint32_t>> neighbours = neighbourhoods(clusters, mesh.vertices.size());
  for (std::size_t i = 0; i < clusters.size(); ++i) {
    std::vector<std::uint32_t>& members = neighbours[i];
    const std::size_t own = clusters[i].triangles.size();
    if (members.size() > 1 && n_triangles(clusters, members) <= 256 + 64 * own) unions.push_back(std::move(members));
  }
  std::vector<Candidate> candidates = measure(mesh, params, clusters, std::move(unions));  // step 1
  std::vector<std::tuple<double, double, std::uint32_t>> keys;
  for (std::uint32_t i = 0; i < candidates.size(); ++i) {
    const Candidate& c = candidates[i];
    const bool relative = params.relative_error && c.model_area > 0.0;
    keys.emplace_back(relative ? c.error / c.model_area : in_steps(c.error, mesh), in_steps(c.hull_area, mesh), i);
  }
  std::ranges::sort(keys);  // step 2
  std::vector<std::uint32_t> order;
  for (const auto& [error, hull_area, i] : keys) order.push_back(i);
  merge(without_overlap(candidates, order, clusters.size()), clusters, tree);  // step 3
}

ClusterTree cluster_tree(const WeldedMesh& mesh, const ApproximationParams& params) {
  std::vector<Cluster> clusters;
  ClusterTree tree = leaves(mesh, clusters);
  while (clusters.size() > 1) {
    const std::size_t n_before = clusters.size();
    neighbour_round(mesh, params, clusters, tree);
    // Rounds that end are too few if each takes only a little: at least a tenth goes in each, and so O(log n) do.
    if (10 * clusters.size() > 9 * n_before && clusters.size() > 1) nearest_round(mesh, params, clusters, tree);
  }
  return tree;
}

}  // namespace lode::techniques::convex_culling

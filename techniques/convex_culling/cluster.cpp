#include "techniques/convex_culling/cluster.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lode::techniques::convex_culling {
namespace {

/// As many as the triangles stand side by side, four times over: a few triangles need no fine measure.
int lines_for(std::size_t n_triangles, int n_most) {
  return std::min(n_most, std::max(16, int(4.0 * std::sqrt(double(n_triangles)))));
}

}  // namespace

double in_steps(double area, const WeldedMesh& mesh) {
  const double step = 1e-9 * mesh.bounds.diagonal() * mesh.bounds.diagonal();
  return step > 0.0 ? std::floor(area / step + 0.5) : 0.0;
}

Candidate ClusterMeasure::of(std::span<const Cluster> clusters, std::vector<std::uint32_t> members) {
  triangles_.clear();
  vertices_.clear();
  for (const std::uint32_t m : members) {
    const Cluster& cluster = clusters[m];
    triangles_.insert(triangles_.end(), cluster.triangles.begin(), cluster.triangles.end());
    vertices_.insert(vertices_.end(), cluster.vertices.begin(), cluster.vertices.end());
  }
  std::ranges::sort(vertices_);
  vertices_.erase(std::ranges::unique(vertices_).begin(), vertices_.end());
  Candidate candidate;
  candidate.members = std::move(members);
  candidate.support = support_vertices(mesh_.vertices, vertices_, directions_, params_.rule);
  hull_[0] = candidate.support;
  area_.set_lines(lines_for(triangles_.size(), params_.n_cluster_lines));
  const SilhouetteArea::Areas areas = area_.of_both(mesh_.vertices, triangles_, vertices_, hull_);
  candidate.error = areas.error();
  candidate.model_area = areas.model;
  candidate.hull_area = areas.hulls;
  return candidate;
}

void merge(std::span<const Candidate> accepted, std::vector<Cluster>& clusters, ClusterTree& tree) {
  std::vector<const Candidate*> first_of(clusters.size(), nullptr);
  std::vector<bool> gone(clusters.size());
  for (const Candidate& candidate : accepted) {
    first_of[candidate.members.front()] = &candidate;
    for (const std::uint32_t m : candidate.members) gone[m] = true;
  }
  std::vector<Cluster> next;
  for (std::uint32_t i = 0; i < clusters.size(); ++i) {
    if (!gone[i]) next.push_back(std::move(clusters[i]));
    if (first_of[i] == nullptr) continue;
    const Candidate& candidate = *first_of[i];
    Cluster joined{.node = std::uint32_t(tree.size()), .triangles = {}, .vertices = {}};
    ClusterNode node{.children = {}, .support = candidate.support, .bounds = {}, .error = candidate.error};
    for (const std::uint32_t m : candidate.members) {
      Cluster& member = clusters[m];
      node.children.push_back(member.node);
      node.bounds.add(tree[member.node].bounds.low);
      node.bounds.add(tree[member.node].bounds.high);
      joined.triangles.insert(joined.triangles.end(), member.triangles.begin(), member.triangles.end());
      joined.vertices.insert(joined.vertices.end(), member.vertices.begin(), member.vertices.end());
      member.triangles = {};
      member.vertices = {};
    }
    std::ranges::sort(node.children);
    std::ranges::sort(joined.vertices);
    joined.vertices.erase(std::ranges::unique(joined.vertices).begin(), joined.vertices.end());
    tree.push_back(std::move(node));
    next.push_back(std::move(joined));
  }
  clusters = std::move(next);
}

}  // namespace lode::techniques::convex_culling

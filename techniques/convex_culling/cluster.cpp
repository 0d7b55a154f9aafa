#include "techniques/convex_culling/cluster.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "raster/parallel.h"

namespace lode::techniques::convex_culling {
namespace {

/// As many as the triangles stand side by side, four times over: a few triangles need no fine measure.
int lines_for(std::size_t n_triangles, int n_most) {
  return std::min(n_most, std::max(16, int(4.0 * std::sqrt(double(n_triangles)))));
}

/// Measures unions one after another with the same memory.
class ClusterMeasure {
 public:
  ClusterMeasure(const WeldedMesh& mesh, const ApproximationParams& params, std::span<const glm::dvec3> directions)
      : mesh_(mesh), params_(params), directions_(directions), area_(params.n_cluster_lines) {}

  [[nodiscard]] Candidate of(std::span<const Cluster> clusters, std::vector<std::uint32_t> members) {
    triangles_.clear();
    vertices_.clear();
    for (const std::uint32_t m : members) {
      const Cluster& cluster = clusters[m];
      triangles_.insert(triangles_.end(), cluster.triangles.begin(), cluster.triangles.end());
      vertices_.insert(vertices_.end(), cluster.vertices.begin(), cluster.vertices.end());
    }
    std::ranges::sort(vertices_);
    vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
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

 private:
  const WeldedMesh& mesh_;
  const ApproximationParams& params_;
  std::span<const glm::dvec3> directions_;
  SilhouetteArea area_;
  std::vector<Triangle> triangles_;
  std::vector<std::uint32_t> vertices_;
  std::vector<std::vector<std::uint32_t>> hull_{1};
};

}  // namespace

double in_steps(double area, const WeldedMesh& mesh) {
  const double step = 1e-9 * mesh.bounds.diagonal() * mesh.bounds.diagonal();
  return step > 0.0 ? std::floor(area / step + 0.5) : 0.0;
}

std::vector<Candidate> measure(const WeldedMesh& mesh, const ApproximationParams& params,
                               std::span<const Cluster> clusters, std::vector<std::vector<std::uint32_t>> unions) {
  constexpr std::size_t kAtOnce = 32;
  const std::size_t n_chunks = (unions.size() + kAtOnce - 1) / kAtOnce;
  const int n_workers = n_chunks > 1 ? raster::worker_count(params.threads) : 1;
  const std::vector<glm::dvec3> directions = sphere_directions(params.direction_step_deg);
  std::vector<ClusterMeasure> measures(std::size_t(n_workers), ClusterMeasure(mesh, params, directions));
  std::vector<Candidate> candidates(unions.size());
  raster::parallel_for(n_chunks, n_workers, [&](std::size_t chunk, int worker) {
    const std::size_t end = std::min((chunk + 1) * kAtOnce, unions.size());
    for (std::size_t i = chunk * kAtOnce; i < end; ++i) {
      candidates[i] = measures[std::size_t(worker)].of(clusters, std::move(unions[i]));
    }
  });
  return candidates;
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
    joined.vertices.erase(std::unique(joined.vertices.begin(), joined.vertices.end()), joined.vertices.end());
    tree.push_back(std::move(node));
    next.push_back(std::move(joined));
  }
  clusters = std::move(next);
}

}  // namespace lode::techniques::convex_culling

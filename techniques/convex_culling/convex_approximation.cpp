#include "techniques/convex_culling/convex_approximation.h"

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>

#include "geometry/error.h"
#include "techniques/convex_culling/clustering_round.h"
#include "techniques/convex_culling/partition.h"

namespace lode::techniques::convex_culling {
namespace {

void expect(bool holds, const std::string& what) {
  if (!holds) throw geometry::Error(geometry::ErrorKind::bad_input, "convex approximation: " + what);
}

void enter(const ApproximationParams& params, ApproximationStage stage) {
  if (params.on_stage) params.on_stage(stage);
}

/// Every polygon for itself.
std::vector<std::uint32_t> single_polygons(const WeldedMesh& mesh) {
  std::vector<std::uint32_t> nodes(mesh.triangles.size());
  std::iota(nodes.begin(), nodes.end(), 0u);
  return nodes;
}

std::vector<std::uint32_t> all_vertices(const WeldedMesh& mesh) {
  std::vector<std::uint32_t> vertices(mesh.vertices.size());
  std::iota(vertices.begin(), vertices.end(), 0u);
  return vertices;
}

ApproximationLevel level_of(const WeldedMesh& mesh, const std::vector<std::vector<std::uint32_t>>& hulls,
                            std::size_t limit, const ApproximationParams& params) {
  ApproximationLevel level{.limit = limit, .hulls = {}};
  std::vector<bool> used(mesh.vertices.size());
  for (const std::vector<std::uint32_t>& hull : hulls) {
    std::vector<glm::vec3>& points = level.hulls.emplace_back();
    for (const std::uint32_t v : hull) {
      points.push_back(mesh.vertices[v]);
      level.n_distinct += !used[v];
      used[v] = true;
    }
    level.n_sum += hull.size();
  }
  enter(params, ApproximationStage::area);
  const auto areas = SilhouetteArea(params.n_lines).of_both(mesh.vertices, {}, all_vertices(mesh), hulls);
  level.hull_area = areas.hulls;
  return level;
}

}  // namespace

void check(const ApproximationParams& params) {
  expect(std::ranges::is_sorted(params.limits), "limits: expected them ascending");
  const double steps = 180.0 / params.direction_step_deg;
  expect(params.direction_step_deg >= 5.0 && params.direction_step_deg <= 90.0 && steps == double(int(steps)),
         "direction_step_deg: expected 5 to 90 and a whole part of 180, found " +
             std::to_string(params.direction_step_deg));
  const auto in_range = [](int n, int most, const char* name) {
    expect(n >= 1 && n <= most,
           std::string(name) + ": expected 1 to " + std::to_string(most) + ", found " + std::to_string(n));
  };
  in_range(params.n_lines, 4096, "n_lines");
  in_range(params.n_cluster_lines, 4096, "n_cluster_lines");
  in_range(params.n_grid, 1024, "n_grid");
}

ConvexApproximation approximate(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices,
                                const ApproximationParams& params) {
  check(params);
  enter(params, ApproximationStage::weld);
  const WeldedMesh mesh = weld(positions, indices, params.weld_tolerance);
  enter(params, ApproximationStage::area);
  ConvexApproximation result;
  result.n_vertices = mesh.vertices.size();
  result.n_triangles = mesh.triangles.size();
  result.area = SilhouetteArea(params.n_lines).of_triangles(mesh.vertices, mesh.triangles, all_vertices(mesh));
  const double sampled = sampled_area(mesh, params);

  std::vector<std::size_t> limits = params.limits;
  if (limits.empty()) limits = {mesh.vertices.size() * 6 / 100, mesh.vertices.size() * 13 / 100};
  enter(params, ApproximationStage::cluster);
  const ClusterTree tree = cluster_tree(mesh, params);
  ExtremeVertices extreme(mesh, tree, params);
  for (const std::size_t limit : limits) {
    enter(params, ApproximationStage::partition);
    const bool exact = params.count == VertexCount::distinct && limit >= mesh.vertices.size();
    const std::vector<std::uint32_t> nodes =
        exact ? single_polygons(mesh) : partition(mesh, tree, limit, params, sampled, extreme).nodes;
    std::vector<std::vector<std::uint32_t>> hulls;
    for (const std::uint32_t node : nodes) hulls.push_back(exact ? tree[node].support : extreme.of(node));
    ApproximationLevel level = level_of(mesh, hulls, limit, params);
    if (exact) level.hull_area = result.area;  // the same triangles: their union is the same
    level.error = level.hull_area > result.area ? level.hull_area - result.area : result.area - level.hull_area;
    // A greater limit allows what a smaller one does: where the way down misses it, the level before is as good.
    if (!result.levels.empty() && result.levels.back().error < level.error) {
      level = result.levels.back();
      level.limit = limit;
    }
    result.levels.push_back(std::move(level));
  }
  enter(params, ApproximationStage::done);
  return result;
}

}  // namespace lode::techniques::convex_culling

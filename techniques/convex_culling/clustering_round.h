#pragma once
/// One round of clustering. Onozawa & Kitazawa, alg. 2; and what joins parts that share no vertex.

#include "techniques/convex_culling/cluster.h"

namespace lode::techniques::convex_culling {

/// The clusters of NE(L_i) for each i: those that share a vertex with L_i, and L_i itself, ascending. In contrast to
/// the paper, where more than kMaxSharing clusters meet at a vertex each of them neighbours only the nearest of these
/// in ascending order: a fan of n triangles would have n² neighbours.
inline constexpr std::size_t kMaxSharing = 64;
[[nodiscard]] std::vector<std::vector<std::uint32_t>> neighbourhoods(std::span<const Cluster> clusters,
                                                                     std::size_t n_vertices);

/// Alg. 2: E of all NE(L_i); in ascending order, each that has no cluster in common with those before becomes a
/// cluster. Ties go to the smaller hull, then to the lower i (gap). NE(L_i) with more than 256 + 64 times the polygons
/// of L_i are left out, so that a round costs no more than the mesh has polygons times a constant.
void neighbour_round(const WeldedMesh& mesh, const ApproximationParams& params, std::vector<Cluster>& clusters,
                     ClusterTree& tree);

/// Joins pairs of clusters that are near to each other, by smallest increase of E, then distance between bounding
/// spheres, then index; at least one; of up to 256 clusters a quarter as many at most (gap: the paper's rounds never
/// end where parts share no vertex). Near: among the eight nearest of up to 256 clusters, or next to each other along a
/// Morton curve.
void nearest_round(const WeldedMesh& mesh, const ApproximationParams& params, std::vector<Cluster>& clusters,
                   ClusterTree& tree);

/// Alg. 1, step 1: rounds until one cluster is left; rounds of nearest pairs where rounds of neighbours do too little.
/// Deterministic. O(n log² n) for n triangles.
[[nodiscard]] ClusterTree cluster_tree(const WeldedMesh& mesh, const ApproximationParams& params);

}  // namespace lode::techniques::convex_culling

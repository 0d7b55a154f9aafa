#pragma once
/// What the convex approximation leaves open or lets choose. "Gap" in comments: the paper does not say.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "techniques/convex_culling/support_vertices.h"

namespace lode::techniques::convex_culling {

/// What a limit M counts. distinct: vertices of all hulls, each once (Problem 1); sum: vertices of each hull (m(Q) in
/// alg. 1).
enum class VertexCount : std::uint8_t { distinct, sum };

/// Which node of Q alg. 1 splits next. least_error: the one that leaves the least E(Q), as printed; it stays on
/// plateaus where a split shows only after another one (of two hulls that hide each other's hollows). own_error: the
/// one whose hull differs most from its own polygons, alone. better: both ways, and of their best Q the better.
enum class SplitOrder : std::uint8_t { least_error, own_error, better };

/// The parts of the work, for who wants to time them.
enum class ApproximationStage : std::uint8_t { weld, area, cluster, partition, hulls, done };

struct ApproximationParams {
  /// The limits M, ascending: one level each. The paper's for its Table are 210 and 282. Empty: 6 % and 13 % of the
  /// welded vertices.
  std::vector<std::size_t> limits;
  VertexCount count = VertexCount::distinct;
  SplitOrder order = SplitOrder::better;  ///< the paper: least_error
  double weld_tolerance = 1e-6;           ///< times the diagonal, 0…0.1; gap
  double direction_step_deg = 45.0;       ///< of latitude and longitude, 5…90; gap
  SupportRule rule = SupportRule::nearest_to_sphere;
  bool relative_error = false;  ///< clusters in order of E/A, which favours compact ones, instead of E; gap
  int n_lines = 256;            ///< a plane, of reported areas, 1…4096; gap
  int n_cluster_lines = 64;     ///< a plane, of the areas that order clusters, 1…4096; gap
  int n_grid = 128;             ///< lines a plane, and samples a line, that choose among partitions, 1…1024; gap

  int threads = 0;  ///< that measure clusters; 0: one a processor. The result does not depend on it

  /// Called when a part of the work begins, many times, on the calling thread. A caller with a clock splits the time by
  /// it.
  std::function<void(ApproximationStage)> on_stage;
};

/// Throws geometry::Error (bad_input) naming the first field that is out of range.
void check(const ApproximationParams& params);

}  // namespace lode::techniques::convex_culling

#pragma once
/// A walk's rows summed up.

#include <vector>

#include "experiments/harness/culling_case.h"

namespace lode::experiments {

/// What a row of a summary is of.
inline constexpr const char *kOfMethod = "method", *kOfFit = "cost model", *kOfCrossover = "crossover",
                             *kOfEqualError = "equal error";

/// Appends a row a method: kind, scene, path, each (triangles of a house; 0: real models), method, frames,
///   frame_ms_mean, frame_ms_median, frame_ms_p99, frame_ms_max, seconds (of 2000 such frames)
///   speedup              against drawing everything with the same skips
///   reused_percent       of objects that could have been, far enough away
///   captures_per_frame, captured_px_per_frame, picture_mib (the most that were kept)
///   triangles_per_frame, flip, psnr_db, ssim (means), displacement_px (mean), displacement_max_px,
///   pop (mean), pop_max, pop_p99 (mean)
/// and, for each choice of skips, a row of the cost model (cost_model.h): kind, scene, path, each, skips (0 or 1),
///   t0_ms, k_ms_deg, residual_percent, break_even_deg (if there is one)
/// and, for each threshold, the renderer's skips off, a row of time at equal error: kind, scene, path, each, flip (of the
///   threshold), method and frame_ms_mean (the fastest threshold whose FLIP is not above), rival and rival_ms (the
///   fastest of the other techniques whose FLIP is not above), ratio (of the times). None without such a rival.
void add_summary(const CaseResult& walk, double each, std::vector<Row>& summary);

/// Appends, over all that was summed up, a row a walk and threshold: kind, scene (without its parameters), path, method,
/// triangles: of a house, from which on reuse pays; none where it does not at any size measured.
void add_crossovers(std::vector<Row>& summary);

}  // namespace lode::experiments

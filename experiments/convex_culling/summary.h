#pragma once
/// A case's rows in one row a method: what it saves, what it loses.

#include "experiments/harness/culling_case.h"

namespace lode::experiments {

/// For each method: frames; frame_ms median, mean, p99; technique_ms mean; speedup against frustum_culling without the
/// renderer's skips (of sums over the walk); own_percent_of_saved, of the time that it saves the renderer, if it saves
/// any, that it takes itself; culled_percent of what could be culled; frames, objects and samples falsely culled;
/// false_percent of the samples that show anything; pictures that differ from the whole scene's; of the views that were
/// held against the truth, if any: their number true_views, and means of the columns of add_true_errors.
void add_summary(const CaseResult& result, std::vector<Row>& summary);

}  // namespace lode::experiments

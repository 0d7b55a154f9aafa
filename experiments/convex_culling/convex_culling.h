#pragma once
/// The experiment on occlusion culling with hierarchical convex approximation and its rivals: README.md.

#include "experiments/experiment.h"

namespace lode::experiments {

[[nodiscard]] Experiment convex_culling_experiment();

}  // namespace lode::experiments

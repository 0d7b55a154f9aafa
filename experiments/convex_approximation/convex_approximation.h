#pragma once
/// The experiment that makes Table 1 of Onozawa and Kitazawa again: README.md.

#include "experiments/experiment.h"

namespace lode::experiments {

[[nodiscard]] Experiment convex_approximation_experiment();

}  // namespace lode::experiments

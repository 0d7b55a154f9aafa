#pragma once
/// What reuse of pictures saves and what it costs, on walks to and past houses: README.md.

#include "experiments/experiment.h"

namespace lode::experiments {

[[nodiscard]] Experiment image_reuse_experiment();

}  // namespace lode::experiments

#include "experiments/convex_approximation/convex_approximation.h"
#include "experiments/convex_culling/convex_culling.h"
#include "experiments/experiment.h"
#include "experiments/image_reuse/image_reuse.h"

namespace lode::experiments {

std::span<const Experiment> experiment_list() {
  static const std::vector<Experiment> list = {convex_approximation_experiment(), convex_culling_experiment(),
                                               image_reuse_experiment()};
  return list;
}

}  // namespace lode::experiments

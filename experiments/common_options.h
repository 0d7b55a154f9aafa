#pragma once
/// Options that every command takes, before or after its name.

#include "experiments/target.h"

namespace lode::experiments {

enum class Pipeline { fast, reference };

struct CommonOptions {
  bool quiet = false;
  int threads = 0;  ///< 0: all cores
  Target target = Target::scalar;
  Pipeline pipeline = Pipeline::fast;
};

}  // namespace lode::experiments

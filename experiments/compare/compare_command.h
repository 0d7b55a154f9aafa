#pragma once
/// `lodestone compare` on the command line.

#include "experiments/command.h"

namespace lode::experiments {

[[nodiscard]] Command compare_command();

}  // namespace lode::experiments

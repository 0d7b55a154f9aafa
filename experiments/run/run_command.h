#pragma once
/// `lodestone run`: experiments, and the files that they leave.

#include "experiments/command.h"

namespace lode::experiments {

[[nodiscard]] Command run_command();

}  // namespace lode::experiments

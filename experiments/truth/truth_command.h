#pragma once
/// `lodestone truth` on the command line.

#include "experiments/command.h"

namespace lode::experiments {

[[nodiscard]] Command truth_command();

}  // namespace lode::experiments

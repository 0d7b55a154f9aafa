#pragma once
/// `lodestone explain` on the command line.

#include "experiments/command.h"

namespace lode::experiments {

[[nodiscard]] Command explain_command();

}  // namespace lode::experiments

#pragma once
/// `lodestone list`: the scenes, techniques and experiments there are, with their parameters.

#include "experiments/command.h"

namespace lode::experiments {

[[nodiscard]] Command list_command();

}  // namespace lode::experiments

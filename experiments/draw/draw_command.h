#pragma once
/// `lodestone draw` on the command line.

#include "experiments/command.h"

namespace lode::experiments {

[[nodiscard]] Command draw_command();

}  // namespace lode::experiments

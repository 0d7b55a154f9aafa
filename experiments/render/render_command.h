#pragma once
/// `lodestone render` on the command line.

#include "experiments/command.h"

namespace lode::experiments {

[[nodiscard]] Command render_command();

}  // namespace lode::experiments

#pragma once
/// `lodestone report`: what `lodestone run` found, as a page.

#include "experiments/command.h"

namespace lode::experiments {

[[nodiscard]] Command report_command();

}  // namespace lode::experiments

#pragma once
/// `lodestone render` on the command line.

#include "experiments/command.h"
#include "experiments/render/render.h"

namespace lode::experiments {

/// All that render takes, for commands that take the same.
void add_render_options(CLI::App& app, RenderOptions& options);

[[nodiscard]] Command render_command();

}  // namespace lode::experiments

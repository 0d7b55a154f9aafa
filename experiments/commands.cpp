#include "experiments/command.h"
#include "experiments/compare/compare_command.h"
#include "experiments/draw/draw_command.h"
#include "experiments/list/list_command.h"
#include "experiments/render/render_command.h"
#include "experiments/truth/truth_command.h"

namespace lode::experiments {

std::vector<Command> all_commands() {
  return {draw_command(), render_command(), truth_command(), compare_command(), list_command()};
}

}  // namespace lode::experiments

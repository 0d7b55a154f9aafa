#include "experiments/command.h"
#include "experiments/compare/compare_command.h"
#include "experiments/draw/draw_command.h"
#include "experiments/explain/explain_command.h"
#include "experiments/list/list_command.h"
#include "experiments/render/render_command.h"
#include "experiments/report/report_command.h"
#include "experiments/run/run_command.h"
#include "experiments/truth/truth_command.h"

namespace lode::experiments {

std::vector<Command> all_commands() {
  return {list_command(),    render_command(),  draw_command(), truth_command(),
          explain_command(), compare_command(), run_command(),  report_command()};
}

}  // namespace lode::experiments

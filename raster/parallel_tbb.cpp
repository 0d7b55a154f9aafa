// raster/parallel on TBB, in an arena of this call's own. TBB by itself starts one thread a processor: the global
// limit makes room for as many as were asked for (where the application has set a lower limit, the lower one holds).
#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>

#include "raster/fp_environment.h"
#include "raster/parallel.h"

namespace lode::raster {

void detail::run_on_threads(std::size_t n, int n_workers, Task task, const void* function) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(n_workers));
  tbb::task_arena arena(n_workers);
  arena.execute([&] {
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, n, 1),
        [&](const tbb::blocked_range<std::size_t>& range) {
          const FpEnvironment environment;
          const int worker = tbb::this_task_arena::current_thread_index();
          for (std::size_t index = range.begin(); index != range.end(); ++index) task(function, index, worker);
        },
        tbb::simple_partitioner{});
  });
}

}  // namespace lode::raster

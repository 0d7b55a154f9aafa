#include "raster/parallel.h"

#include <algorithm>
#include <thread>

#include "raster/fp_environment.h"

namespace lode::raster {

int worker_count(int threads) {
  const int wanted = threads > 0 ? threads : static_cast<int>(std::thread::hardware_concurrency());
  return std::clamp(wanted, 1, kMaxThreads);  // hardware_concurrency() is 0 where it is not known
}

void detail::parallel_for(std::size_t n, int n_workers, Task task, const void* function) {
  const std::size_t n_useful = std::min(n, static_cast<std::size_t>(std::clamp(n_workers, 1, kMaxThreads)));
  if (n_useful >= 2) {
    run_on_threads(n, static_cast<int>(n_useful), task, function);
    return;
  }
  const FpEnvironment environment;
  for (std::size_t index = 0; index < n; ++index) task(function, index, 0);
}

}  // namespace lode::raster

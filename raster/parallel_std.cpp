// raster/parallel on std::thread: threads of this call alone that take the next index until there is none. Where
// a thread cannot be started (a limit, no memory, no threads at all) the work goes on with those there are.
#include <array>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>

#include "raster/fp_environment.h"
#include "raster/parallel.h"

namespace lode::raster {

namespace {

struct Work {
  const std::size_t n;
  const detail::Task task;
  const void* const function;
  std::atomic<std::size_t> next{0};
  std::mutex mutex;              // guards first_error
  std::exception_ptr first_error;

  void run(int worker) noexcept {
    const FpEnvironment environment;
    try {
      for (std::size_t index; (index = next.fetch_add(1, std::memory_order_relaxed)) < n;) task(function, index, worker);
    } catch (...) {
      const std::scoped_lock lock(mutex);
      if (!first_error) first_error = std::current_exception();
      next.store(n, std::memory_order_relaxed);  // nothing more is begun
    }
  }
};

}  // namespace

void detail::run_on_threads(std::size_t n, int n_workers, Task task, const void* function) {
  Work work{.n = n, .task = task, .function = function, .mutex = {}, .first_error = {}};
  std::array<std::thread, kMaxThreads> threads;  // not a vector: starting threads asks for as little memory as can be
  int n_started = 1;                             // worker 0 is this thread
  try {
    for (; n_started < n_workers; ++n_started) {
      threads[static_cast<std::size_t>(n_started)] = std::thread(&Work::run, &work, n_started);
    }
  } catch (const std::exception&) {  // std::system_error or std::bad_alloc
  }
  work.run(0);
  for (int i = 1; i < n_started; ++i) threads[static_cast<std::size_t>(i)].join();
  if (work.first_error) std::rethrow_exception(work.first_error);
}

}  // namespace lode::raster

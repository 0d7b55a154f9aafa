// raster/parallel on std::thread: threads of this call alone that take the next index until there is none. Where
// a thread cannot be started (a limit, no memory, no threads at all) the work goes on with those there are.
#include <array>
#include <atomic>
#include <cstdint>
#include <exception>
#include <mutex>
#include <thread>

#include "raster/fp_environment.h"
#include "raster/parallel.h"

namespace lode::raster {

namespace {

#ifdef LODESTONE_YIELD_AT_RANDOM  // in the tsan preset: tasks begin late at random, so that ever other orders are tried
constexpr bool kYieldAtRandom = true;
#else
constexpr bool kYieldAtRandom = false;
#endif

/// Gives way up to fifteen times, half of the time not at all; a relaxed counter orders nothing between threads.
void yield_at_random() {
  static std::atomic<std::uint64_t> n_calls{0};
  std::uint64_t z = (n_calls.fetch_add(1, std::memory_order_relaxed) + 1) * 0x9E37'79B9'7F4A'7C15ull;
  z = (z ^ (z >> 30)) * 0xBF58'476D'1CE4'E5B9ull;
  z ^= z >> 27;
  if (z >> 63) return;
  for (std::uint64_t i = z >> 40 & 15; i > 0; --i) std::this_thread::yield();
}

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
      for (std::size_t index; (index = next.fetch_add(1, std::memory_order_relaxed)) < n;) {
        if (kYieldAtRandom) yield_at_random();
        task(function, index, worker);
      }
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

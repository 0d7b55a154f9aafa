#pragma once
/// The one door to threads. Two implementations of the same function: TBB, and std::thread (chosen by the
/// CMake option LODESTONE_THREADS, for ThreadSanitizer, cross builds and WebAssembly).

#include <cstddef>
#include <memory>
#include <type_traits>

namespace lode::raster {

inline constexpr int kMaxThreads = 256;

/// The number of workers that `threads` asks for: 0 is one per processor; never more than kMaxThreads.
[[nodiscard]] int worker_count(int threads);

namespace detail {
using Task = void (*)(const void* function, std::size_t index, int worker);
void parallel_for(std::size_t n, int n_workers, Task task, const void* function);
void run_on_threads(std::size_t n, int n_workers, Task task, const void* function);  ///< the back end; n, n_workers ≥ 2
}  // namespace detail

/// Calls function(index, worker) once for each index in [0, n), worker in [0, n_workers), no two calls with
/// the same worker at a time. The order is not defined: write results by index. With one worker everything
/// runs on the calling thread, in order. The first exception thrown is rethrown when all calls have ended.
/// Each worker computes in IEEE round-to-nearest with denormals, whatever the caller had set (see fp_environment.h).
template <class Function>
void parallel_for(std::size_t n, int n_workers, const Function& function) {
  detail::parallel_for(
      n, n_workers,
      [](const void* f, std::size_t index, int worker) { (*static_cast<const Function*>(f))(index, worker); },
      std::addressof(function));
}

}  // namespace lode::raster

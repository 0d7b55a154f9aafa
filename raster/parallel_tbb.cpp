// raster/parallel on TBB, in an arena that no other call uses at the time. TBB by itself starts one thread a processor:
// the global limit makes room for as many as were asked for (where the application has set a lower limit, the lower one
// holds).
#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>

#include <memory>
#include <mutex>
#include <vector>

#include "raster/fp_environment.h"
#include "raster/parallel.h"

namespace lode::raster {
namespace {

/// Arenas, kept for the next call: TBB 2021.8 seldom frees one that is destroyed soon after its work, some 7 KiB each,
/// and looks at all of them whenever work is handed out. A thousand calls with arenas of their own made each slower.
class Arenas {
 public:
  /// One of so many threads that is not in use. Throws std::bad_alloc.
  tbb::task_arena& take(int n_workers) {
    const std::lock_guard lock(mutex_);
    for (Kept& kept : arenas_) {
      if (!kept.busy && kept.n_workers == n_workers) {
        kept.busy = true;
        return *kept.arena;
      }
    }
    arenas_.push_back({std::make_unique<tbb::task_arena>(n_workers), n_workers, true});
    return *arenas_.back().arena;
  }
  void give_back(const tbb::task_arena& arena) {
    const std::lock_guard lock(mutex_);
    for (Kept& kept : arenas_) {
      if (kept.arena.get() == &arena) kept.busy = false;
    }
  }

 private:
  struct Kept {
    std::unique_ptr<tbb::task_arena> arena;
    int n_workers;
    bool busy;
  };
  std::mutex mutex_;
  std::vector<Kept> arenas_;
};

/// Never destroyed, so that it outlives whoever renders as the program ends.
Arenas& arenas() {
  static Arenas& all = *new Arenas;
  return all;
}

class Taken {
 public:
  explicit Taken(int n_workers) : arena(arenas().take(n_workers)) {}
  ~Taken() { arenas().give_back(arena); }
  Taken(const Taken&) = delete;
  Taken& operator=(const Taken&) = delete;

  tbb::task_arena& arena;
};

}  // namespace

void detail::run_on_threads(std::size_t n, int n_workers, Task task, const void* function) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(n_workers));
  const Taken taken(n_workers);
  taken.arena.execute([&] {
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

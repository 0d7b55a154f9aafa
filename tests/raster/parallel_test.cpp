#include "raster/parallel.h"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cfenv>
#include <chrono>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>
#if defined(__x86_64__)
#include <xmmintrin.h>
#endif

namespace lode::raster {
namespace {

constexpr int kWorkers[] = {1, 2, 3, 5, 8, 16, 64};

TEST(WorkerCount, ZeroAsksForOnePerProcessorAndNothingForMoreThanTheMaximum) {
  EXPECT_GE(worker_count(0), 1);
  EXPECT_EQ(worker_count(-1), worker_count(0));
  EXPECT_EQ(worker_count(1), 1);
  EXPECT_EQ(worker_count(64), 64);
  EXPECT_EQ(worker_count(1000), kMaxThreads);
  EXPECT_EQ(worker_count(std::numeric_limits<int>::max()), kMaxThreads);
}

TEST(ParallelFor, CallsEachIndexExactlyOnce) {
  for (const int n_workers : kWorkers) {
    for (const std::size_t n : {0u, 1u, 2u, 7u, 64u, 1000u}) {
      std::vector<std::atomic<int>> calls(n);
      parallel_for(n, n_workers, [&](std::size_t index, int) { calls[index].fetch_add(1); });
      for (std::size_t i = 0; i < n; ++i) ASSERT_EQ(calls[i].load(), 1) << "index " << i << ", workers " << n_workers;
    }
  }
}

TEST(ParallelFor, NoTwoCallsHaveTheSameWorkerAtATime) {
  for (const int n_workers : kWorkers) {
    std::vector<std::atomic<int>> inside(static_cast<std::size_t>(n_workers));
    std::atomic<int> n_shared = 0;
    std::atomic<int> n_outside_range = 0;
    parallel_for(2000, n_workers, [&](std::size_t, int worker) {
      if (worker < 0 || worker >= n_workers) {
        ++n_outside_range;
        return;
      }
      std::atomic<int>& here = inside[static_cast<std::size_t>(worker)];
      if (here.fetch_add(1) != 0) ++n_shared;
      std::this_thread::yield();
      here.fetch_sub(1);
    });
    EXPECT_EQ(n_outside_range.load(), 0) << n_workers << " workers";
    EXPECT_EQ(n_shared.load(), 0) << n_workers << " workers";
  }
}

TEST(ParallelFor, OneWorkerRunsInOrderOnTheCallingThread) {
  std::vector<std::size_t> order;
  const std::thread::id caller = std::this_thread::get_id();
  parallel_for(5, 1, [&](std::size_t index, int worker) {
    EXPECT_EQ(std::this_thread::get_id(), caller);
    EXPECT_EQ(worker, 0);
    order.push_back(index);
  });
  EXPECT_EQ(order, (std::vector<std::size_t>{0, 1, 2, 3, 4}));
}

// The determinism product counts on this: with 64 workers on 2 processors, 64 threads really share the work.
TEST(ParallelFor, SixtyFourWorkersAreInsideAtTheSameTimeOnAnyMachine) {
  std::atomic<int> n_inside = 0;
  std::atomic<int> n_gave_up = 0;
  parallel_for(64, 64, [&](std::size_t, int) {
    ++n_inside;
    const auto start = std::chrono::steady_clock::now();
    while (n_inside.load() < 64 && n_gave_up.load() == 0) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      if (std::chrono::steady_clock::now() - start > std::chrono::seconds(30)) ++n_gave_up;
    }
  });
  EXPECT_EQ(n_gave_up.load(), 0);
}

TEST(ParallelFor, RethrowsTheFirstExceptionWhenAllCallsHaveEnded) {
  for (const int n_workers : kWorkers) {
    std::atomic<int> n_inside = 0;
    const auto work = [&](std::size_t index, int) {
      ++n_inside;
      std::this_thread::yield();
      --n_inside;
      if (index == 3) throw std::runtime_error("index 3");
    };
    try {
      parallel_for(100, n_workers, work);
      FAIL() << "nothing thrown, workers " << n_workers;
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "index 3");
    }
    EXPECT_EQ(n_inside.load(), 0);
  }
}

TEST(ParallelFor, RunsAgainAfterAnException) {
  const auto fail = [](std::size_t, int) { throw std::runtime_error("always"); };
  EXPECT_THROW(parallel_for(10, 4, fail), std::runtime_error);
  std::atomic<int> n_calls = 0;
  parallel_for(10, 4, [&](std::size_t, int) { ++n_calls; });
  EXPECT_EQ(n_calls.load(), 10);
}

#if defined(__SANITIZE_THREAD__)
constexpr bool kRemembersThreads = true;  ///< ThreadSanitizer, which keeps a record of each that ended
#elif defined(__has_feature)
constexpr bool kRemembersThreads = __has_feature(thread_sanitizer);
#else
constexpr bool kRemembersThreads = false;
#endif

// With an arena for every call, TBB kept some 7 KiB of each: 20,000 calls took 140 MB.
TEST(ParallelFor, KeepsNoMemoryOfItsCalls) {
  const auto resident_kib = [] {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);) {
      if (line.starts_with("VmRSS:")) return std::stol(line.substr(6));
    }
    return 0l;
  };
  if (resident_kib() == 0) GTEST_SKIP() << "no /proc/self/status here";
  if (kRemembersThreads) GTEST_SKIP() << "ThreadSanitizer remembers threads that have ended";
  std::atomic<int> n_calls = 0;
  const auto call_often = [&](int n) {
    for (int i = 0; i < n; ++i) parallel_for(4, 2 + i % 2, [&](std::size_t, int) { ++n_calls; });
  };
  call_often(1000);
  const long before = resident_kib();
  call_often(20'000);
  EXPECT_LT(resident_kib() - before, 32'000);
  EXPECT_EQ(n_calls, 4 * 21'000);
}

#if defined(__x86_64__)
/// What a worker computes, seen from outside: 1 + 2⁻²⁴ is a tie, which goes to even (1) in the default mode and to
/// 1 + 2⁻²³ when rounding up; half the smallest normal number is a denormal, lost under FTZ and DAZ.
bool computes_by_default() {
  volatile float tiny = 0x1p-24f;
  volatile float smallest = std::numeric_limits<float>::min();
  volatile float sum = 1.0f + tiny;
  volatile float denormal = smallest * 0.5f;
  volatile float restored = denormal * 2.0f;
  return sum == 1.0f && restored == smallest;
}

TEST(ParallelFor, WorkersComputeInTheDefaultEnvironmentAndTheCallerKeepsItsOwn) {
  constexpr unsigned kFlushDenormals = 0x8040;  // MXCSR: FTZ | DAZ
  constexpr unsigned kRoundUp = 0x4000;
  const unsigned original = _mm_getcsr();
  for (const int n_workers : kWorkers) {
    const unsigned callers = 0x1F80 | kFlushDenormals | kRoundUp;
    _mm_setcsr(callers);
    const bool changed = !computes_by_default();
    std::atomic<int> n_wrong = 0;
    parallel_for(200, n_workers, [&](std::size_t, int) {
      if (!computes_by_default()) ++n_wrong;
    });
    const unsigned after = _mm_getcsr();
    _mm_setcsr(original);
    EXPECT_TRUE(changed);
    EXPECT_EQ(n_wrong.load(), 0) << n_workers << " workers";
    EXPECT_EQ(after & ~0x3Fu, callers) << n_workers << " workers";  // the low six bits record what has happened
  }
}
#endif

}  // namespace
}  // namespace lode::raster

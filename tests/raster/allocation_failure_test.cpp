/// Every k-th allocation fails once (C15): this file replaces the test program's operator new.

#include <gtest/gtest.h>

#include <cstdlib>
#include <new>
#include <string>
#include <vector>

#include "raster/error.h"
#include "raster/texture.h"

namespace {

/// Allocations of this thread that still succeed; negative: all do.
thread_local int allocations_left = -1;

}  // namespace

// Not inlined: GCC takes an inlined free of what an operator new returned for a mistake.
[[gnu::noinline]] void* operator new(std::size_t size) {
  if (allocations_left == 0) throw std::bad_alloc();
  if (allocations_left > 0) --allocations_left;
  if (void* memory = std::malloc(size > 0 ? size : 1)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace lode::raster {
namespace {

/// Runs `make` with its first, second, … allocation failing until it succeeds; every failure must be an Error
/// out_of_memory of one line. Returns the number of failures.
template <class Make>
int failures_until_success(Make make) {
  for (int k = 0;; ++k) {
    bool failed = false, as_expected = true;
    allocations_left = k;
    try {
      (void)make();
    } catch (const Error& error) {
      failed = true;
      as_expected = error.kind() == ErrorKind::out_of_memory;
    } catch (...) {
      failed = true;
      as_expected = false;
    }
    allocations_left = -1;
    EXPECT_TRUE(as_expected) << "allocation " << k;
    if (!failed) return k;
  }
}

TEST(AllocationFailure, MakingATextureSaysOutOfMemoryWhicheverAllocationFails) {
  const std::vector<glm::u8vec4> bytes(5 * 4);
  const std::vector<glm::vec4> floats(5 * 4);
  // At least the list of levels and three planes: 5×4, 2×2, 1×1.
  EXPECT_GE(failures_until_success([&] { return make_raw_texture({5, 4}, bytes, Mips::all); }), 4);
  EXPECT_GE(failures_until_success([&] { return make_srgb_texture({5, 4}, bytes, Mips::all); }), 4);
  EXPECT_GE(failures_until_success([&] { return make_linear_texture({5, 4}, floats, Mips::all); }), 4);
}

}  // namespace
}  // namespace lode::raster

#pragma once
/// How many cases a stress test runs (notes/numerics.md, stress counts): LODESTONE_STRESS=ci, the default, or long.

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace lode::raster::test {

[[nodiscard]] inline bool long_run() {
  const char* setting = std::getenv("LODESTONE_STRESS");
  return setting != nullptr && std::string_view(setting) == "long";
}

/// The count of this run, printed under the test's name.
[[nodiscard]] inline std::uint64_t stress_count(const char* what, std::uint64_t ci, std::uint64_t in_long_run) {
  const std::uint64_t n = long_run() ? in_long_run : ci;
  std::printf("[  COUNT   ] %s: %llu\n", what, static_cast<unsigned long long>(n));
  return n;
}

}  // namespace lode::raster::test

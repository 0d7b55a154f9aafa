#pragma once
/// Random numbers for tests: a hash of (seed, case, purpose), so that a failing case can be made again by itself.

#include <cstdint>
#include <cstdlib>
#include <string_view>

namespace lode::tests {

/// The numbers of one case. Two calls with the same purpose give the same number.
struct CounterRandom {
  std::uint64_t seed = 0;
  std::uint64_t index = 0;

  [[nodiscard]] std::uint64_t bits(std::uint64_t purpose) const {
    // splitmix64's finalizer (Steele et al. 2014), once per input.
    std::uint64_t x = 0;
    for (const std::uint64_t input : {seed, index, purpose}) {
      x = (x ^ input) + 0x9E3779B97F4A7C15u;
      x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9u;
      x = (x ^ (x >> 27)) * 0x94D049BB133111EBu;
      x ^= x >> 31;
    }
    return x;
  }
  /// low … high, both included.
  [[nodiscard]] int integer(std::uint64_t purpose, int low, int high) const {
    const std::uint64_t range = std::uint64_t(std::int64_t(high) - low) + 1;
    return int(low + std::int64_t(bits(purpose) % range));
  }
  /// [−1, 1), 53 bits.
  [[nodiscard]] double real(std::uint64_t purpose) const { return double(std::int64_t(bits(purpose)) >> 10) * 0x1p-53; }
};

/// Count of a stress test's cases: as given in CI, a hundredfold with LODESTONE_STRESS=long.
[[nodiscard]] inline std::uint64_t stress_count(std::uint64_t ci_count) {
  const char* mode = std::getenv("LODESTONE_STRESS");
  return mode != nullptr && std::string_view(mode) == "long" ? 100 * ci_count : ci_count;
}

}  // namespace lode::tests

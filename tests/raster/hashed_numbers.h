#pragma once
/// Random test input as a hash of (seed, counter): the same on every machine, and case i can be made again alone.

#include <cmath>
#include <cstdint>

namespace lode::raster::test {

/// SplitMix64 (Steele et al., 2014).
class HashedNumbers {
 public:
  /// Another factor than the step of bits(), or seed 2 would be seed 1 from its second number on.
  explicit HashedNumbers(std::uint64_t seed) : state_(seed * 0xD1B5'4A32'D192'ED03ull) {}

  std::uint64_t bits() {
    std::uint64_t z = state_ += 0x9E37'79B9'7F4A'7C15ull;
    z = (z ^ (z >> 30)) * 0xBF58'476D'1CE4'E5B9ull;
    z = (z ^ (z >> 27)) * 0x94D0'49BB'1331'11EBull;
    return z ^ (z >> 31);
  }
  /// 0…n − 1, n < 2^32.
  std::uint32_t below(std::uint32_t n) { return static_cast<std::uint32_t>(((bits() >> 32) * n) >> 32); }
  /// low…high, both included.
  std::int32_t between(std::int32_t low, std::int32_t high) {
    return low + static_cast<std::int32_t>(below(static_cast<std::uint32_t>(high - low) + 1));
  }
  /// A multiple of 2^-53 in [0, 1).
  double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
  /// A number of [1, 2) times a power of two, 2^low to 2^high.
  double of_magnitude(int low, int high) {
    const double mantissa = 1.0 + unit();
    return std::ldexp(mantissa, between(low, high));
  }

 private:
  std::uint64_t state_;
};

}  // namespace lode::raster::test

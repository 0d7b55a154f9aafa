#pragma once
/// Random numbers as a pure function of what they are for: a counter-based generator, so that neither threads nor the
/// order of calls can change them. Philox4x32-10 (Salmon, Moraes, Dror, Shaw: "Parallel random numbers: as easy as
/// 1, 2, 3", SC 2011, sec. 3.2).

#include <array>
#include <cstdint>

namespace lode::geometry {

using RandomBlock = std::array<std::uint32_t, 4>;

/// Four random words for a counter and a key.
[[nodiscard]] RandomBlock philox(RandomBlock counter, std::array<std::uint32_t, 2> key);

/// A stream of random numbers for one purpose: element i of purpose p under a seed. Streams of different
/// (seed, purpose, element) are independent; drawing from one moves no other.
class Random {
 public:
  Random(std::uint64_t seed, std::uint32_t purpose, std::uint64_t element = 0);

  [[nodiscard]] std::uint32_t word();  ///< uniform over all 32-bit words
  [[nodiscard]] double uniform();      ///< uniform in [0, 1), a multiple of 2^-53
  [[nodiscard]] double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// Uniform in [0, n), n ≥ 1, by Lemire's multiplication with rejection: no bias.
  [[nodiscard]] std::uint32_t below(std::uint32_t n);

 private:
  RandomBlock counter_;
  std::array<std::uint32_t, 2> key_;
  RandomBlock block_{};
  int used_ = 4;  ///< words of block_ already given
};

}  // namespace lode::geometry

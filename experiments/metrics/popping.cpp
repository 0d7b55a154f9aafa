#include "experiments/metrics/popping.h"

#include <array>
#include <cstdint>
#include <cstdlib>

#include "experiments/metrics/expect_size.h"

namespace lode::experiments {
namespace {

/// Pixels by the sum of their three channels' values.
using Histogram = std::array<std::uint64_t, 3 * 510 + 1>;

int change_beyond_the_truth(const FramePairs& f, std::size_t i) {
  int sum = 0;
  for (int c = 0; c < 3; ++c) {
    const int change = int(f.picture[i][c]) - int(f.picture_before[i][c]);
    const int true_change = int(f.reference[i][c]) - int(f.reference_before[i][c]);
    sum += std::abs(change - true_change);
  }
  return sum;
}

}  // namespace

Popping popping(const FramePairs& frames) {
  const std::size_t n = frames.picture.size();
  expect_size("picture before", n, frames.picture_before.size());
  expect_size("reference", n, frames.reference.size());
  expect_size("reference before", n, frames.reference_before.size());
  if (n == 0) return {};
  Histogram histogram{};
  std::uint64_t total = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const int sum = change_beyond_the_truth(frames, i);
    histogram[std::size_t(sum)] += 1;
    total += std::uint64_t(sum);
  }
  const std::uint64_t rank = n - n / 100;  // ⌈0.99·n⌉
  std::size_t at = 0;
  for (std::uint64_t below = histogram[0]; below < rank; below += histogram[at]) ++at;
  return {double(total) / (3.0 * double(n)), double(at) / 3.0};
}

}  // namespace lode::experiments

#include "experiments/metrics/largest_region.h"

#include <algorithm>
#include <vector>

#include "experiments/metrics/expect_size.h"

namespace lode::experiments {
namespace {

/// Regions are taken off a copy of the mask one by one, each pixel once.
class Regions {
 public:
  Regions(glm::ivec2 size_px, std::span<const std::uint8_t> mask)
      : width_(std::size_t(size_px.x)), left_(mask.begin(), mask.end()) {}

  /// Takes the region of the pixel, and tells its size; 0 if it is in none, or in one that was taken.
  std::uint64_t take(std::size_t pixel) {
    std::uint64_t n = 0;
    push(pixel);
    while (!open_.empty()) {
      const std::size_t i = open_.back(), x = i % width_;
      open_.pop_back();
      n += 1;
      if (x > 0) push(i - 1);
      if (x + 1 < width_) push(i + 1);
      if (i >= width_) push(i - width_);
      if (i + width_ < left_.size()) push(i + width_);
    }
    return n;
  }

 private:
  void push(std::size_t i) {
    if (left_[i] == 0) return;
    left_[i] = 0;
    open_.push_back(i);
  }

  std::size_t width_;
  std::vector<std::uint8_t> left_;
  std::vector<std::size_t> open_;  ///< taken, neighbours not looked at yet
};

}  // namespace

std::uint64_t largest_region(glm::ivec2 size_px, std::span<const std::uint8_t> mask) {
  expect_size("mask", pixel_count(size_px), mask.size());
  Regions regions(size_px, mask);
  std::uint64_t largest = 0;
  for (std::size_t i = 0; i < mask.size(); ++i) largest = std::max(largest, regions.take(i));
  return largest;
}

}  // namespace lode::experiments

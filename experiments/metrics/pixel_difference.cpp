#include "experiments/metrics/pixel_difference.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "geometry/exponential.h"

namespace lode::experiments {

PixelDifference pixel_difference(const PicturePair& pair) {
  PixelDifference d;
  d.n_values = 3 * std::uint64_t(pair.a.size());
  for (std::size_t i = 0; i < pair.a.size(); ++i) {
    int largest = 0;
    for (int c = 0; c < 3; ++c) {
      const int difference = std::abs(int(pair.a[i][c]) - int(pair.b[i][c]));
      largest = std::max(largest, difference);
      d.sum_squared += std::uint64_t(difference * difference);
    }
    d.max = std::max(d.max, largest);
    d.differing += largest > 0;
  }
  return d;
}

double rmse(const PixelDifference& d) {
  return d.n_values == 0 ? 0.0 : std::sqrt(double(d.sum_squared) / double(d.n_values));
}

std::optional<double> psnr(const PixelDifference& d) {
  if (d.sum_squared == 0) return std::nullopt;
  constexpr double kLog10Of2 = 0.30102999566398120;
  return 10.0 * kLog10Of2 * geometry::log2_of(255.0 * 255.0 * double(d.n_values) / double(d.sum_squared));
}

}  // namespace lode::experiments

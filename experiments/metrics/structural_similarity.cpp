#include "experiments/metrics/structural_similarity.h"

#include <algorithm>
#include <array>
#include <vector>

#include "geometry/exponential.h"

namespace lode::experiments {
namespace {

constexpr int kWindow = 11;
/// exp(−(k − 5)²/(2·1.5²)), normalized.
constexpr std::array<double, kWindow> kGaussian = {0.00102838008447911,  0.007598758135239185, 0.03600077212843083,
                                                   0.10936068950970002,  0.2130055377112537,   0.26601172486179436,
                                                   0.2130055377112537,   0.10936068950970002,  0.03600077212843083,
                                                   0.007598758135239185, 0.00102838008447911};
constexpr double kC1 = (0.01 * 255.0) * (0.01 * 255.0);
constexpr double kC2 = (0.03 * 255.0) * (0.03 * 255.0);

/// One channel of both pictures.
struct Planes {
  int width = 0, height = 0;
  std::vector<double> a, b;  ///< [width*height]
};

Planes channel_of(const PicturePair& pair, int channel) {
  Planes planes{pair.size_px.x, pair.size_px.y, {}, {}};
  planes.a.reserve(pair.a.size());
  planes.b.reserve(pair.b.size());
  for (const glm::u8vec4& texel : pair.a) planes.a.push_back(texel[channel]);
  for (const glm::u8vec4& texel : pair.b) planes.b.push_back(texel[channel]);
  return planes;
}

/// a, b, a², b², ab, weighted.
using Moments = std::array<double, 5>;

/// Moments of the windows of one row, along the row only: [width − 10].
void filter_row(const Planes& planes, int y, std::vector<Moments>& out) {
  const double* const a = &planes.a[std::size_t(y) * std::size_t(planes.width)];
  const double* const b = &planes.b[std::size_t(y) * std::size_t(planes.width)];
  for (std::size_t x = 0; x < out.size(); ++x) {
    Moments sum{};
    for (std::size_t k = 0; k < kWindow; ++k) {
      const double w = kGaussian[k], p = a[x + k], q = b[x + k];
      sum[0] += w * p;
      sum[1] += w * q;
      sum[2] += w * (p * p);
      sum[3] += w * (q * q);
      sum[4] += w * (p * q);
    }
    out[x] = sum;
  }
}

/// Means over all windows.
struct Similarity {
  double ssim = 0.0;
  double contrast_structure = 0.0;
};

void add_window(const Moments& m, Similarity& sum) {
  const double mean_aa = m[0] * m[0], mean_bb = m[1] * m[1], mean_ab = m[0] * m[1];
  const double variances = (m[2] - mean_aa) + (m[3] - mean_bb), covariance = m[4] - mean_ab;
  const double contrast_structure = (2.0 * covariance + kC2) / (variances + kC2);
  sum.contrast_structure += contrast_structure;
  sum.ssim += contrast_structure * ((2.0 * mean_ab + kC1) / (mean_aa + mean_bb + kC1));
}

Similarity similarity(const Planes& planes) {
  const auto n_x = std::size_t(planes.width - kWindow + 1), n_y = std::size_t(planes.height - kWindow + 1);
  std::array<std::vector<Moments>, kWindow> rows;  // the last eleven, by y mod 11
  rows.fill(std::vector<Moments>(n_x));
  Similarity sum;
  for (int y = 0; y < planes.height; ++y) {
    filter_row(planes, y, rows[std::size_t(y % kWindow)]);
    if (y < kWindow - 1) continue;
    for (std::size_t x = 0; x < n_x; ++x) {
      Moments window{};
      for (int k = 0; k < kWindow; ++k) {
        const Moments& row = rows[std::size_t((y + 1 + k) % kWindow)][x];  // from y − 10 to y
        for (std::size_t i = 0; i < window.size(); ++i) window[i] += kGaussian[std::size_t(k)] * row[i];
      }
      add_window(window, sum);
    }
  }
  const double n = double(n_x) * double(n_y);
  return {sum.ssim / n, sum.contrast_structure / n};
}

std::vector<double> halved(const std::vector<double>& plane, int width, int height) {
  std::vector<double> half;
  half.reserve(std::size_t(width / 2) * std::size_t(height / 2));
  for (int y = 0; y + 1 < height; y += 2) {
    for (int x = 0; x + 1 < width; x += 2) {
      const std::size_t i = std::size_t(y) * std::size_t(width) + std::size_t(x), below = i + std::size_t(width);
      half.push_back(0.25 * ((plane[i] + plane[i + 1]) + (plane[below] + plane[below + 1])));
    }
  }
  return half;
}

double ms_ssim_of(Planes planes) {
  constexpr double kWeights[] = {0.0448, 0.2856, 0.3001, 0.2363, 0.1333};
  double product = 1.0;
  for (int scale = 0; scale < 5; ++scale) {
    const Similarity s = similarity(planes);
    product *= geometry::power(std::max(scale < 4 ? s.contrast_structure : s.ssim, 0.0), kWeights[scale]);
    planes.a = halved(planes.a, planes.width, planes.height);
    planes.b = halved(planes.b, planes.width, planes.height);
    planes.width /= 2;
    planes.height /= 2;
  }
  return product;
}

}  // namespace

std::optional<double> ssim(const PicturePair& pair) {
  if (std::min(pair.size_px.x, pair.size_px.y) < kMinSsimSize_px) return std::nullopt;
  double sum = 0.0;
  for (int c = 0; c < 3; ++c) sum += similarity(channel_of(pair, c)).ssim;
  return sum / 3.0;
}

std::optional<double> ms_ssim(const PicturePair& pair) {
  if (std::min(pair.size_px.x, pair.size_px.y) < kMinMsSsimSize_px) return std::nullopt;
  double sum = 0.0;
  for (int c = 0; c < 3; ++c) sum += ms_ssim_of(channel_of(pair, c));
  return sum / 3.0;
}

}  // namespace lode::experiments

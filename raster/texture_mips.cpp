#include "raster/texture_mips.h"

#include <algorithm>

#include "raster/blend.h"

namespace lode::raster {
namespace {

glm::u8vec4 mean_raw(const std::uint64_t (&sum)[4], std::uint64_t total) {
  glm::u8vec4 mean;
  // Half up; doubled, because the total may be odd.
  for (int c = 0; c < 4; ++c) mean[c] = static_cast<std::uint8_t>((2 * sum[c] + total) / (2 * total));
  return mean;
}

glm::vec4 mean_linear(const double (&sum)[4], std::uint64_t total) {
  const auto divisor = static_cast<double>(total);
  glm::vec4 mean;
  for (int c = 0; c < 4; ++c) mean[c] = static_cast<float>(sum[c] / divisor);
  return store_rgba32f(mean);
}

/// Sum is std::uint64_t for bytes and double for floats: both hold total · texel exactly, as total ≤ 2^28.
template <class Sum, class Texel, class Mean>
void shrink(glm::ivec2 from_px, const std::vector<Texel>& from, glm::ivec2 to_px, std::vector<Texel>& to, Mean mean) {
  to.resize(std::size_t(to_px.x) * std::size_t(to_px.y));
  const std::uint64_t total = std::uint64_t(from_px.x) * std::uint64_t(from_px.y);
  auto* out = to.data();
  for (int y = 0; y < to_px.y; ++y) {
    const BoxSpan rows = box_span(y, from_px.y, to_px.y);
    for (int x = 0; x < to_px.x; ++x) {
      const BoxSpan columns = box_span(x, from_px.x, to_px.x);
      Sum sum[4]{};
      for (int j = 0; j < rows.n; ++j) {
        const Texel* row = &from[std::size_t(rows.first + j) * std::size_t(from_px.x) + std::size_t(columns.first)];
        for (int i = 0; i < columns.n; ++i) {
          const auto weight = static_cast<Sum>(rows.weight[j] * columns.weight[i]);
          for (int c = 0; c < 4; ++c) sum[c] += weight * static_cast<Sum>(row[i][c]);
        }
      }
      *out++ = mean(sum, total);
    }
  }
}

}  // namespace

BoxSpan box_span(int i, int s, int d) {
  const int begin = i * s;
  const int end = begin + s;
  BoxSpan span{.first = begin / d, .n = 0, .weight = {}};
  for (int j = span.first; j * d < end; ++j) {
    span.weight[span.n++] = std::min(end, (j + 1) * d) - std::max(begin, j * d);
  }
  return span;
}

TextureLevel next_level(const TextureLevel& larger, TextureFormat format) {
  const glm::ivec2 from_px = larger.size_px;
  TextureLevel level;
  level.size_px = {std::max(1, from_px.x / 2), std::max(1, from_px.y / 2)};
  if (format == TextureFormat::raw) {
    shrink<std::uint64_t>(from_px, larger.raw, level.size_px, level.raw, mean_raw);
  } else {
    shrink<double>(from_px, larger.linear, level.size_px, level.linear, mean_linear);
  }
  return level;
}

}  // namespace lode::raster

#include "raster/level_of_detail.h"

#include <algorithm>
#include <cmath>

namespace lode::raster {
namespace {

constexpr int kMaxAnisotropy = 16;

}  // namespace

double squared_length_px(const glm::dvec2& duv, const glm::ivec2& size_px) {
  const double x_px = duv.x * size_px.x;
  const double y_px = duv.y * size_px.y;
  const double squared = x_px * x_px + y_px * y_px;
  return std::isnan(squared) ? 0.0 : squared;
}

Probes isotropic_probe(const Footprint& footprint, const glm::ivec2& size_px) {
  const double x_squared = squared_length_px(footprint.duv_dx, size_px);
  const double y_squared = squared_length_px(footprint.duv_dy, size_px);
  return {.n = 1, .major_duv = {0.0, 0.0}, .lambda_fx8 = lambda_fx8(std::max(x_squared, y_squared))};
}

Probes anisotropic_probes(const Footprint& footprint, const glm::ivec2& size_px, int max_anisotropy) {
  const double x_squared = squared_length_px(footprint.duv_dx, size_px);
  const double y_squared = squared_length_px(footprint.duv_dy, size_px);
  const bool x_is_major = x_squared >= y_squared;
  const double max_squared = x_is_major ? x_squared : y_squared;
  const double min_squared = x_is_major ? y_squared : x_squared;

  const int most = std::clamp(max_anisotropy, 1, kMaxAnisotropy);
  int n = 1;
  while (n < most && n * n * min_squared < max_squared) ++n;
  return {.n = n,
          .major_duv = x_is_major ? footprint.duv_dx : footprint.duv_dy,
          .lambda_fx8 = lambda_fx8(max_squared / (n * n))};
}

}  // namespace lode::raster

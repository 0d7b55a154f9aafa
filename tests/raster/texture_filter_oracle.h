#pragma once
/// Texture filters as C10 defines them, in exact arithmetic: levels of detail by MPFR's logarithm, sums over the tents
/// of texture_oracle.h.

#include <gmpxx.h>
#include <mpfr.h>

#include <cmath>
#include <cstdint>

#include "raster/texture.h"
#include "texture_oracle.h"

namespace lode::raster::test {

/// 128 · log2(rho²), rounded to nearest (no rational is a tie, but powers of two, which are whole numbers).
[[nodiscard]] inline std::int64_t exact_lambda_fx8(const mpq_class& rho_squared) {
  mpfr_t x;
  mpfr_init2(x, 256);
  mpfr_set_q(x, rho_squared.get_mpq_t(), MPFR_RNDN);
  mpfr_log2(x, x, MPFR_RNDN);
  mpfr_mul_ui(x, x, 128, MPFR_RNDN);
  const long rounded = mpfr_get_si(x, MPFR_RNDN);
  mpfr_clear(x);
  return rounded;
}

/// What a filter reads: n probes along `major`, level and the next one's weight in 1/256.
struct Plan {
  int n = 1;
  glm::dvec2 major{0.0, 0.0};
  int level = 0;
  int f = 0;
};

[[nodiscard]] inline Plan plan_with(int n, const glm::dvec2& major, std::int64_t lambda_fx8, std::size_t n_levels) {
  const auto most = static_cast<std::int64_t>(n_levels - 1) * 256;
  const std::int64_t lambda = lambda_fx8 < 0 ? 0 : lambda_fx8 > most ? most : lambda_fx8;
  return {n, major, static_cast<int>(lambda / 256), static_cast<int>(lambda % 256)};
}

/// For finite derivatives, from rationals alone.
[[nodiscard]] inline Plan exact_plan(const Texture& texture, const Sampler& sampler, const Footprint& footprint) {
  if (sampler.filter != Filter::trilinear && sampler.filter != Filter::anisotropic) return {};
  const glm::ivec2 size_px = texture.levels[0].size_px;
  const auto squared = [&](const glm::dvec2& duv) -> mpq_class {
    const mpq_class x = mpq_class(duv.x) * size_px.x, y = mpq_class(duv.y) * size_px.y;
    return x * x + y * y;
  };
  const mpq_class xx = squared(footprint.duv_dx), yy = squared(footprint.duv_dy);
  const mpq_class longer = xx >= yy ? xx : yy, shorter = xx >= yy ? yy : xx;
  int n = 1;
  while (sampler.filter == Filter::anisotropic && n < sampler.max_anisotropy && shorter * (n * n) < longer) ++n;
  if (longer == 0) return {};
  return plan_with(n, xx >= yy ? footprint.duv_dx : footprint.duv_dy, exact_lambda_fx8(longer / (n * n)),
                   texture.levels.size());
}

/// The same in double wherever no decision is close, else exact_plan.
[[nodiscard]] inline Plan fast_plan(const Texture& texture, const Sampler& sampler, const Footprint& footprint) {
  if (sampler.filter != Filter::trilinear && sampler.filter != Filter::anisotropic) return {};
  const glm::dvec2 size_px = texture.levels[0].size_px;
  const double x = std::hypot(footprint.duv_dx.x * size_px.x, footprint.duv_dx.y * size_px.y);
  const double y = std::hypot(footprint.duv_dy.x * size_px.x, footprint.duv_dy.y * size_px.y);
  const double longer = std::fmax(x, y), ratio = longer / std::fmin(x, y);
  const double most = sampler.filter == Filter::anisotropic ? sampler.max_anisotropy : 1;
  const double n = std::fmin(std::ceil(ratio), most);
  const double lambda = 256.0 * std::log2(longer / n);
  const bool close = !(ratio > 1.0 + 1e-9) || std::abs(ratio - std::round(ratio)) < 1e-9 * ratio ||
                     !(std::abs(lambda - std::floor(lambda) - 0.5) > 1e-6);
  if (close || !std::isfinite(ratio)) return exact_plan(texture, sampler, footprint);
  return plan_with(static_cast<int>(n), x > y ? footprint.duv_dx : footprint.duv_dy, std::lround(lambda),
                   texture.levels.size());
}

/// visit(level index, texel x, texel y (−1: border), weight) for all texels with a weight above 0 of plan.n · 2^24:
/// probe by probe, level by level, row by row. Probe i is at uv + (2i − (n+1)) / (2(n+1)) · major, in double: that
/// is its definition.
template <class Integer, class Visit>
void for_each_texel(const Texture& texture, const Sampler& sampler, const glm::dvec2& uv, const Plan& plan,
                    Visit visit) {
  for (int i = 1; i <= plan.n; ++i) {
    const double along = (2.0 * i - (plan.n + 1.0)) / (2.0 * (plan.n + 1.0));
    const glm::dvec2 at = plan.n == 1 ? uv : glm::dvec2(uv.x + along * plan.major.x, uv.y + along * plan.major.y);
    for (int step = 0; step < (plan.f > 0 ? 2 : 1); ++step) {
      const auto level = static_cast<std::size_t>(plan.level + step);
      const glm::ivec2 size_px = texture.levels[level].size_px;
      const auto columns = tent<Integer>(at.x, size_px.x, sampler.wrap_u);
      for (const WeightedTexel& y : tent<Integer>(at.y, size_px.y, sampler.wrap_v)) {
        for (const WeightedTexel& x : columns) {
          visit(level, x.texel, y.texel, (step == 0 ? 256 - plan.f : plan.f) * y.weight * x.weight);
        }
      }
    }
  }
}

/// The exact mean of a raw texture under any linear filter, rounded half up.
template <class Integer>
[[nodiscard]] glm::u8vec4 filtered_raw(const Texture& texture, const Sampler& sampler, const glm::dvec2& uv,
                                       const Plan& plan) {
  std::int64_t sum[4]{};
  for_each_texel<Integer>(texture, sampler, uv, plan, [&](std::size_t level, int x, int y, std::int64_t weight) {
    const TextureLevel& from = texture.levels[level];
    for (int c = 0; c < 4; ++c) {
      const bool border = x < 0 || y < 0;
      sum[c] += weight * (border ? static_cast<int>(sampler.border[c])
                                 : int{from.raw[std::size_t(y) * std::size_t(from.size_px.x) + std::size_t(x)][c]});
    }
  });
  const std::int64_t total = std::int64_t{plan.n} * 65536 * 256;
  glm::u8vec4 rounded;
  for (int c = 0; c < 4; ++c) rounded[c] = static_cast<std::uint8_t>((2 * sum[c] + total) / (2 * total));
  return rounded;
}

/// A linear texture's filter as it is written down: a sum in double, in the order of for_each_texel, one division,
/// one rounding to float.
[[nodiscard]] inline glm::vec4 filtered_linear(const Texture& texture, const Sampler& sampler, const glm::dvec2& uv,
                                               const Plan& plan) {
  double sum[4]{};
  for_each_texel<Int128>(texture, sampler, uv, plan, [&](std::size_t level, int x, int y, std::int64_t weight) {
    const TextureLevel& from = texture.levels[level];
    const bool border = x < 0 || y < 0;
    const glm::vec4 texel =
        border ? sampler.border : from.linear[std::size_t(y) * std::size_t(from.size_px.x) + std::size_t(x)];
    for (int c = 0; c < 4; ++c) sum[c] += static_cast<double>(weight) * double{texel[c]};
  });
  glm::vec4 rounded;
  for (int c = 0; c < 4; ++c) rounded[c] = static_cast<float>(sum[c] / (plan.n * 16777216.0));
  return rounded;
}

/// The texel that contains the coordinate.
template <class Integer>
[[nodiscard]] glm::u8vec4 nearest_raw(const Texture& texture, const Sampler& sampler, const glm::dvec2& uv) {
  const TextureLevel& from = texture.levels[0];
  const int x = texel_in_row(texel_index<Integer>(uv.x, from.size_px.x, sampler.wrap_u), from.size_px.x,
                             sampler.wrap_u == Wrap::mirror ? Wrap::clamp : sampler.wrap_u);
  const int y = texel_in_row(texel_index<Integer>(uv.y, from.size_px.y, sampler.wrap_v), from.size_px.y,
                             sampler.wrap_v == Wrap::mirror ? Wrap::clamp : sampler.wrap_v);
  if (x < 0 || y < 0) return glm::u8vec4(sampler.border);
  return from.raw[std::size_t(y) * std::size_t(from.size_px.x) + std::size_t(x)];
}

}  // namespace lode::raster::test

#pragma once
/// Texture filters as C10 defines them, in exact arithmetic, written without a look at raster/texture*: wrapping in
/// rationals, the linear filter as a tent over an endless row of texels, levels of detail by MPFR's logarithm.
///
/// Integer is mpz_class (any finite u) or Int128 (fast, |u| ≤ 2^20).

#include <gmpxx.h>
#include <mpfr.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "raster/texture.h"

namespace lode::raster::test {

__extension__ typedef __int128 Int128;

/// numerator / denominator, denominator > 0.
template <class Integer>
struct Ratio {
  Integer numerator, denominator;
};

template <class Integer>
[[nodiscard]] Integer floor_quotient(const Integer& a, const Integer& b) {
  return Integer(a / b) - (Integer(a % b) < 0 ? 1 : 0);
}

[[nodiscard]] inline Ratio<mpz_class> exact_ratio(double u, mpz_class) {
  const mpq_class q(u);
  return {q.get_num(), q.get_den()};
}

/// Below 2^-47 only the sign matters: times 2^22 it is far from any tie and any other texel.
[[nodiscard]] inline Ratio<Int128> exact_ratio(double u, Int128) {
  int exponent = 0;
  const auto numerator = static_cast<std::int64_t>(std::ldexp(std::frexp(u, &exponent), 53));
  const int shift = 53 - exponent;
  if (shift > 100) return {Int128(numerator > 0) - Int128(numerator < 0), Int128(1) << 100};
  return {numerator, Int128(1) << shift};
}

/// u after wrapping: repeat [0, 1), mirror and clamp [0, 1], border as it is. Not finite is 0.
template <class Integer>
[[nodiscard]] Ratio<Integer> wrapped(double u, Wrap wrap) {
  auto [n, d] = exact_ratio(std::isfinite(u) ? u : 0.0, Integer());
  if (wrap == Wrap::repeat) n -= floor_quotient(n, d) * d;
  if (wrap == Wrap::mirror) {
    const Integer period = d * 2;
    n -= floor_quotient(n, period) * period;
    if (n > d) n = period - n;
  }
  if (wrap == Wrap::clamp) n = n < 0 ? Integer(0) : n > d ? d : n;
  return {n, d};
}

[[nodiscard]] inline std::int64_t small(const mpz_class& a) { return a.fits_slong_p() ? a.get_si() : 1L << 62; }
[[nodiscard]] inline std::int64_t small(Int128 a) { return static_cast<std::int64_t>(a); }

/// 256 · size · u, rounded half to even.
template <class Integer>
[[nodiscard]] std::int64_t coordinate_fx8(double u, int size_px, Wrap wrap) {
  const auto [n, d] = wrapped<Integer>(u, wrap);
  const Integer product = n * (256 * size_px);
  const Integer below = floor_quotient(product, d);
  const Integer twice_rest = (product - below * d) * 2;
  const bool odd = Integer(below % 2) != 0;
  return small(Integer(below + (twice_rest > d || (twice_rest == d && odd) ? 1 : 0)));
}

/// ⌊size · u⌋.
template <class Integer>
[[nodiscard]] std::int64_t texel_index(double u, int size_px, Wrap wrap) {
  const auto [n, d] = wrapped<Integer>(u, wrap);
  return small(floor_quotient(Integer(n * size_px), d));
}

/// The endless row of texels: which one stands at index j; −1 is the border.
[[nodiscard]] inline int texel_in_row(std::int64_t j, int size_px, Wrap wrap) {
  if (wrap == Wrap::border) return j < 0 || j >= size_px ? -1 : static_cast<int>(j);
  if (wrap == Wrap::clamp) return static_cast<int>(j < 0 ? 0 : j >= size_px ? size_px - 1 : j);
  const std::int64_t period = wrap == Wrap::repeat ? size_px : 2 * size_px;
  const std::int64_t phase = ((j % period) + period) % period;
  return static_cast<int>(phase < size_px ? phase : period - 1 - phase);
}

struct WeightedTexel {
  int texel;
  int weight;  ///< of 256, above 0
};

/// A tent of one texel's width on either side of the coordinate, over the centres 256·j + 128 of the texels.
template <class Integer>
[[nodiscard]] std::vector<WeightedTexel> tent(double u, int size_px, Wrap wrap) {
  const std::int64_t x_fx8 = coordinate_fx8<Integer>(u, size_px, wrap);
  const std::int64_t middle = floor_quotient<std::int64_t>(x_fx8, 256);
  std::vector<WeightedTexel> texels;
  for (std::int64_t j = middle - 1; j <= middle + 1; ++j) {
    const std::int64_t weight = 256 - std::abs(x_fx8 - (256 * j + 128));
    if (weight > 0) texels.push_back({texel_in_row(j, size_px, wrap), static_cast<int>(weight)});
  }
  return texels;
}

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

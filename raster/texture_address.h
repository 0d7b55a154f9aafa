#pragma once
/// From a texture coordinate to the texels that a filter reads along one axis (C10). The coordinate is wrapped
/// first, in double and without any rounding; only then is it multiplied by the level's width and rounded, once,
/// to texels. What comes out equals the rational result for every finite double: huge, tiny negative, or
/// within an ulp of a tie.

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "raster/texture.h"

namespace lode::raster {

/// A texel beyond the picture: the border colour.
inline constexpr std::int32_t kBorderTexel = -1;

/// What a linear filter reads along one axis: texel indices (or kBorderTexel), and the second one's weight in 1/256.
struct TexelPair {
  std::int32_t first = 0;
  std::int32_t second = 0;
  std::int32_t second_weight_fx8 = 0;  ///< 0…255; the first one's is 256 minus this
};

/// Exactly a·n − product, where product is a·n rounded to double and a multiple of ½, 1 ≤ n ≤ 2^22. (Veltkamp's
/// splitting: both halves times n are exact, and the error of a rounded product is a double.)
[[nodiscard]] inline double product_error(double a, std::int32_t n, double product) {
  const double high = static_cast<double>(static_cast<float>(a));
  const double low = a - high;
  return (high * n - product) + low * n;
}

/// a·n rounded half to even, exactly, for |a| ≤ 2, 1 ≤ n ≤ 2^22. Rounding the product to double first cannot carry
/// it past a tie, as ties are doubles, but it can land on one; then the error of the product decides.
[[nodiscard]] inline std::int32_t rounded_product(double a, std::int32_t n) {
  const double product = a * n;
  double rounded = std::rint(product);
  if (std::abs(product - rounded) == 0.5) {
    const double error = product_error(a, n, product);
    if (error != 0.0) rounded = error > 0.0 ? std::floor(product) + 1.0 : std::floor(product);
  }
  return static_cast<std::int32_t>(rounded);
}

/// ⌊a·n⌋, exactly, for |a| ≤ 2, 1 ≤ n ≤ 2^22: a product that was rounded up to a whole number is one less.
[[nodiscard]] inline std::int32_t floored_product(double a, std::int32_t n) {
  const double product = a * n;
  double floored = std::floor(product);
  if (floored == product && product_error(a, n, product) < 0.0) floored -= 1.0;
  return static_cast<std::int32_t>(floored);
}

/// The coordinate brought near the picture; each mode without rounding. Not finite reads as 0.
///   repeat   u − trunc(u), in (−1, 1): what is below 0 is moved up by a whole width in texels, where that is
///            exact (u − ⌊u⌋ is not: −1e-20 would become 1)
///   mirror   in [0, 1], period 2, even
///   clamp    in [0, 1]
///   border   in [−1, 2]: beyond, even a picture of one texel is all border
[[nodiscard]] inline double wrapped_coordinate(double u, Wrap wrap) {
  if (!std::isfinite(u)) return 0.0;
  switch (wrap) {
    case Wrap::repeat:
      return u - std::trunc(u);
    case Wrap::mirror:
      return std::abs(u - 2.0 * std::rint(u * 0.5));  // the distance from the nearest even number
    case Wrap::clamp:
      return std::clamp(u, 0.0, 1.0);
    case Wrap::border:
      break;
  }
  return std::clamp(u, -1.0, 2.0);
}

/// Index −1…size of a texel next to the picture, as the mode has it.
[[nodiscard]] inline std::int32_t wrapped_texel(std::int32_t index, std::int32_t size_px, Wrap wrap) {
  if (index >= 0 && index < size_px) return index;
  if (wrap == Wrap::repeat) return index < 0 ? index + size_px : index - size_px;
  if (wrap == Wrap::border) return kBorderTexel;
  return index < 0 ? 0 : size_px - 1;  // mirror and clamp: the texel at the edge is its own neighbour
}

/// The texel that contains the coordinate: ⌊u·size⌋, rounded down so that no sample slips into the next texel.
///   size_px   1…16384
[[nodiscard]] inline std::int32_t nearest_texel(double u, std::int32_t size_px, Wrap wrap) {
  return wrapped_texel(floored_product(wrapped_coordinate(u, wrap), size_px), size_px, wrap);
}

/// The two texels whose centres enclose the coordinate. u·size is rounded to 1/256 texel half to even, so that a
/// mirrored coordinate gives the mirrored weights.
///   size_px   1…16384
[[nodiscard]] inline TexelPair linear_texels(double u, std::int32_t size_px, Wrap wrap) {
  const std::int32_t size_fx8 = size_px * 256;
  std::int32_t x_fx8 = rounded_product(wrapped_coordinate(u, wrap), size_fx8);
  if (x_fx8 < 0 && wrap == Wrap::repeat) x_fx8 += size_fx8;  // into [0, size]; both ends have the same neighbours
  const std::int32_t from_centre_fx8 = x_fx8 - 128;
  const std::int32_t first = from_centre_fx8 >> 8;  // arithmetic shift: floor
  return {wrapped_texel(first, size_px, wrap), wrapped_texel(first + 1, size_px, wrap), from_centre_fx8 & 255};
}

}  // namespace lode::raster

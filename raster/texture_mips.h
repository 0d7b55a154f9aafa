#pragma once
/// Mip levels by an area box filter (C10): each texel of the smaller level is the mean of the area it covers in
/// the larger one, with exact integer overlaps, so that odd sizes lose nothing at their edges.

#include "raster/texture.h"

namespace lode::raster {

/// The texels under one texel of the smaller level, along one axis, and the integer lengths of their overlaps. In
/// units where texel j of the larger level spans [j·d, (j+1)·d], texel i of the smaller one spans [i·s, (i+1)·s].
struct BoxSpan {
  int first = 0;
  int n = 0;        ///< 1 (s = 1), 2 (even s) or 3
  int weight[3]{};  ///< their sum is s
};

/// Span of texel i of d = max(1, ⌊s/2⌋) over s texels, s in 1…16384.
[[nodiscard]] BoxSpan box_span(int i, int s, int d);

/// The next smaller level of `larger`, from its stored texels. Bytes: one rounding, half up. Floats: the sum of
/// integer weight × texel in double, row by row, left to right, divided by the weights' total, then made float;
/// NaN is 0x7FC00000 and −0 is +0. A constant level stays constant, and no texel leaves the range of those it
/// covers (see texture_sample.cpp for why).
[[nodiscard]] TextureLevel next_level(const TextureLevel& larger, TextureFormat format);

}  // namespace lode::raster

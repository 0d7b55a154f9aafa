#pragma once
/// Where the ray through a sample meets a surfel's plane, as linear functions of the sample's position. Written
/// once, for any number type: doubles with error bounds (bounded.h) and big integers (exact_surfel.cpp).
///
/// In 1/256 px, with h the viewport's half size and k its centre minus the sample, the sample's ray is where two
/// planes meet, given by the rows x, y, w of clip_from_object:
///     A = k_x·w + h_x·x,   B = k_y·w − h_y·y,   A·P = B·P = 0.
/// With n the disc's normal, c its centre, q = P − c, α = A·(c,1), β = B·(c,1), and A', B' the first three parts:
///     q·det = −α (B'×n) − β (n×A'),   det = n·(A'×B').
/// Both sides are linear in k: the terms with k_x·k_y cancel. So are z·det, for the clip coordinate z at P, and
/// so on; w·det does not depend on k at all, and where it is 0 the eye lies in the plane.

#include <array>

namespace lode::raster::reference {

template <class N>
using Triple = std::array<N, 3>;

/// What a surfel is made of, each group of numbers in a unit of its own (a power of two).
template <class N>
struct SurfelTerms {
  std::array<std::array<N, 4>, 4> rows;  ///< x, y, z, w of clip_from_object
  N half_width, half_height;             ///< viewport, 1/256 px
  Triple<N> centre;
  N radius, one;  ///< in the unit of the centre
  Triple<N> normal;
  N w_factor, w_min;  ///< w ≥ kMinW is w_factor·w ≥ w_min in the units of the rows and the centre
};

/// f(k) = f[0]·k_x + f[1]·k_y + f[2].
template <class N>
using Linear = std::array<N, 3>;

/// Everything is times det, and its sign is such that w > 0: in front of the eye det > 0.
template <class N>
struct HitMap {
  Triple<Linear<N>> q;  ///< from the centre to the hit
  Linear<N> reach;      ///< radius
  Linear<N> det;
  Linear<N> z;         ///< clip-space z at the hit
  Linear<N> gap;       ///< w − z
  Linear<N> w_margin;  ///< w_factor·w − w_min
  N w;                 ///< clip-space w at the hit
};

template <class N>
N dot(const Triple<N>& a, const Triple<N>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class N>
Triple<N> cross(const Triple<N>& a, const Triple<N>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

template <class N>
N at(const Linear<N>& f, const Triple<N>& k) {
  return f[0] * k[0] + f[1] * k[1] + f[2] * k[2];
}

/// `w` keeps its sign: see turn_to_positive_w.
template <class N>
HitMap<N> make_hit_map(const SurfelTerms<N>& s) {
  const auto part = [](const std::array<N, 4>& row, const N& scale) {
    return Triple<N>{row[0] * scale, row[1] * scale, row[2] * scale};
  };
  const auto value_at_centre = [&](const std::array<N, 4>& row) {
    return row[0] * s.centre[0] + row[1] * s.centre[1] + row[2] * s.centre[2] + row[3] * s.one;
  };
  const auto& [row_x, row_y, row_z, row_w] = s.rows;
  const Triple<N> z{row_z[0], row_z[1], row_z[2]}, w{row_w[0], row_w[1], row_w[2]};
  const N minus_half_height = -s.half_height;
  const Triple<N> x = part(row_x, s.half_width), y = part(row_y, minus_half_height);
  const N x_c = value_at_centre(row_x) * s.half_width, y_c = value_at_centre(row_y) * minus_half_height;
  const N z_c = value_at_centre(row_z), w_c = value_at_centre(row_w);
  const Triple<N> x_n = cross(x, s.normal), y_n = cross(y, s.normal), w_n = cross(w, s.normal);

  HitMap<N> map;
  for (std::size_t i = 0; i < 3; ++i) {
    map.q[i] = {y_c * w_n[i] - w_c * y_n[i], w_c * x_n[i] - x_c * w_n[i], y_c * x_n[i] - x_c * y_n[i]};
  }
  map.det = {dot(w, y_n), dot(x, w_n), dot(x, y_n)};
  const auto q_along = [&](const Triple<N>& a, std::size_t j) {
    return a[0] * map.q[0][j] + a[1] * map.q[1][j] + a[2] * map.q[2][j];
  };
  map.w = w_c * map.det[2] + q_along(w, 2);
  for (std::size_t j = 0; j < 3; ++j) {
    map.reach[j] = s.radius * map.det[j];
    map.z[j] = z_c * map.det[j] + q_along(z, j);
    map.gap[j] = -map.z[j];
    map.w_margin[j] = -(s.w_min * map.det[j]);
  }
  map.gap[2] = map.gap[2] + map.w;
  map.w_margin[2] = map.w_margin[2] + s.w_factor * map.w;
  return map;
}

/// Negates everything.
template <class N>
void turn(HitMap<N>& map) {
  for (Linear<N>* f : {&map.q[0], &map.q[1], &map.q[2], &map.reach, &map.det, &map.z, &map.gap, &map.w_margin}) {
    for (N& coefficient : *f) coefficient = -coefficient;
  }
  map.w = -map.w;
}

}  // namespace lode::raster::reference

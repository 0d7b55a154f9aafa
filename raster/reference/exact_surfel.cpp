#include "raster/reference/exact_surfel.h"

// Boost's Karatsuba multiplication takes memory from the heap, also for numbers of fixed size: never use it.
#define BOOST_MP_KARATSUBA_CUTOFF 100000
#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>

namespace lode::raster::reference {
namespace {

namespace mp = boost::multiprecision;

/// A signed integer of fixed size without heap memory.
template <unsigned kBits>
using Integer = mp::number<mp::cpp_int_backend<kBits, kBits, mp::signed_magnitude, mp::unchecked, void>, mp::et_off>;

/// Powers of two that numbers of a group reach from and to: each is a multiple of 2^low, below 2^high.
struct Span {
  int low = std::numeric_limits<int>::max();
  int high = std::numeric_limits<int>::min();

  void add(double x) {
    if (x == 0.0) return;
    int exponent = 0;
    const auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &exponent), 53));
    int zeros = 0;
    while (((mantissa >> zeros) & 1) == 0) ++zeros;
    low = std::min(low, exponent - 53 + zeros);
    high = std::max(high, exponent);
  }
  [[nodiscard]] int unit() const { return low <= high ? low : 0; }
  [[nodiscard]] int bits() const { return low <= high ? high - low : 0; }
};

struct Spans {
  Span rows, centre, normal;

  explicit Spans(const SurfelInput& s) {
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j) rows.add(s.clip_from_object[i][j]);
    }
    for (int i = 0; i < 3; ++i) {
      centre.add(s.centre[i]);
      normal.add(s.normal[i]);
    }
    centre.add(s.radius);
    centre.add(1.0);
  }
  /// w ≥ 2^-149 reads w·2^shift ≥ det in integers.
  [[nodiscard]] int w_shift() const { return rows.unit() + centre.unit() + 149; }
  /// Bits of the largest number below: |q|² has the degree 4 in the rows, 2 in centre and normal, and four
  /// factors (h and k, below 2^41); w_margin has the degree 3 in the rows and the shift.
  [[nodiscard]] int bits_needed() const {
    const int r = rows.bits(), c = centre.bits(), n = normal.bits();
    return std::max(4 * r + 2 * c + 2 * n, 3 * r + c + n + std::abs(w_shift())) + 4 * 41 + 20;
  }
};

/// Any finite input: rows 2^-1074 … 2^1024, the others 2^-149 … 2^129: 4·2098 + 2·278 + 2·278 + 184 = 9688.
constexpr unsigned kWideBits = 9728;
static_assert(kWideBits / 64 < mp::backends::karatsuba_cutoff);
/// Enough for what scenes contain, and five times smaller on the stack.
constexpr unsigned kNarrowBits = 2048;

/// x / 2^unit, for an x that is a multiple of it.
template <class N>
N lift(double x, int unit) {
  if (x == 0.0) return N(0);
  int exponent = 0;
  const auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &exponent), 53));
  const int shift = exponent - 53 - unit;
  return shift >= 0 ? N(mantissa) << shift : N(mantissa / (std::int64_t(1) << -shift));
}

template <class N>
HitMap<N> integer_hit_map(const SurfelInput& s, const Spans& spans) {
  SurfelTerms<N> terms;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      terms.rows[std::size_t(i)][std::size_t(j)] = lift<N>(s.clip_from_object[j][i], spans.rows.unit());
    }
  }
  for (int i = 0; i < 3; ++i) {
    terms.centre[std::size_t(i)] = lift<N>(s.centre[i], spans.centre.unit());
    terms.normal[std::size_t(i)] = lift<N>(s.normal[i], spans.normal.unit());
  }
  terms.radius = lift<N>(s.radius, spans.centre.unit());
  terms.one = lift<N>(1.0, spans.centre.unit());
  terms.half_width = N(std::int64_t(128) * s.viewport_size_px.x);
  terms.half_height = N(std::int64_t(128) * s.viewport_size_px.y);
  terms.w_factor = N(1) << std::max(spans.w_shift(), 0);
  terms.w_min = N(1) << std::max(-spans.w_shift(), 0);
  HitMap<N> map = make_hit_map(terms);
  if (map.w < 0) turn(map);
  return map;
}

template <class N>
Triple<N> integer_from_centre(const SurfelInput& s, glm::ivec2 p_fx8) {
  const Triple<double> k = from_centre(s, p_fx8);
  return {N(static_cast<std::int64_t>(k[0])), N(static_cast<std::int64_t>(k[1])), N(1)};
}

template <class N>
bool covers_in(const SurfelInput& s, const Spans& spans, glm::ivec2 p_fx8) {
  const HitMap<N> map = integer_hit_map<N>(s, spans);
  const Triple<N> k = integer_from_centre<N>(s, p_fx8);
  if (map.w == 0 || at(map.det, k) <= 0) return false;  // the ray lies in the plane, misses it, or hits behind the eye
  if (at(map.w_margin, k) < 0 || at(map.z, k) < 0 || at(map.gap, k) < 0) return false;
  const N reach = at(map.reach, k);
  const Triple<N> q{at(map.q[0], k), at(map.q[1], k), at(map.q[2], k)};
  return dot(q, q) <= reach * reach;
}

/// |x| = top · 2^exponent with 2^63 ≤ top < 2^64, cut off; x ≠ 0.
struct Top {
  double top;
  int exponent;
};
template <class N>
Top top_of(const N& x) {
  const N magnitude = abs(x);
  const int shift = int(msb(magnitude)) - 63;
  const N top = shift >= 0 ? N(magnitude >> shift) : N(magnitude << -shift);
  return {double(static_cast<std::uint64_t>(top)), shift};
}

template <class N>
double depth_in(const SurfelInput& s, const Spans& spans, glm::ivec2 p_fx8) {
  const HitMap<N> map = integer_hit_map<N>(s, spans);
  const N z = at(map.z, integer_from_centre<N>(s, p_fx8));
  if (z == 0) return 0.0;
  const Top z_top = top_of(z), w_top = top_of(map.w);
  return std::ldexp(z_top.top / w_top.top, z_top.exponent - w_top.exponent);
}

/// x / 2^unit, rounded.
template <class N>
Bounded rounded(const N& x, int unit) {
  if (x == 0) return {};
  const Top top = top_of(x);
  const double value = std::ldexp(top.top, top.exponent - unit);
  return {x < 0 ? -value : value, kRounding * value + kUnderflow};
}

/// Rounds functions of one group, in the unit of their largest coefficient.
template <class N, std::size_t n>
void round_group(const std::array<const Linear<N>*, n>& exact, const std::array<Linear<Bounded>*, n>& result,
                 int unit) {
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < 3; ++j) (*result[i])[j] = rounded((*exact[i])[j], unit);
  }
}
template <class N, std::size_t n>
int largest_exponent(const std::array<const Linear<N>*, n>& group) {
  int largest = 0;
  for (const Linear<N>* f : group) {
    for (const N& x : *f) {
      if (x != 0) largest = std::max(largest, int(msb(abs(x))));
    }
  }
  return largest;
}

template <class N>
std::optional<HitMap<Bounded>> rounded_map_in(const SurfelInput& s, const Spans& spans) {
  const HitMap<N> exact = integer_hit_map<N>(s, spans);
  if (exact.w == 0) return std::nullopt;
  using From = const Linear<N>*;
  using To = Linear<Bounded>*;
  HitMap<Bounded> map;
  const std::array<From, 4> across{&exact.q[0], &exact.q[1], &exact.q[2], &exact.reach};
  round_group<N>(across, std::array<To, 4>{&map.q[0], &map.q[1], &map.q[2], &map.reach}, largest_exponent<N>(across));
  const std::array<From, 1> det{&exact.det}, w_margin{&exact.w_margin};
  round_group<N>(det, std::array<To, 1>{&map.det}, largest_exponent<N>(det));
  round_group<N>(w_margin, std::array<To, 1>{&map.w_margin}, largest_exponent<N>(w_margin));
  const std::array<From, 2> depth{&exact.z, &exact.gap};
  const int depth_unit = std::max(largest_exponent<N>(depth), int(msb(exact.w)));
  round_group<N>(depth, std::array<To, 2>{&map.z, &map.gap}, depth_unit);
  map.w = rounded(exact.w, depth_unit);
  return map;
}

}  // namespace

bool exact_covers(const SurfelInput& s, glm::ivec2 p_fx8) {
  const Spans spans(s);
  return spans.bits_needed() <= int(kNarrowBits) ? covers_in<Integer<kNarrowBits>>(s, spans, p_fx8)
                                                 : covers_in<Integer<kWideBits>>(s, spans, p_fx8);
}

double exact_depth(const SurfelInput& s, glm::ivec2 p_fx8) {
  const Spans spans(s);
  return spans.bits_needed() <= int(kNarrowBits) ? depth_in<Integer<kNarrowBits>>(s, spans, p_fx8)
                                                 : depth_in<Integer<kWideBits>>(s, spans, p_fx8);
}

std::optional<HitMap<Bounded>> exact_hit_map(const SurfelInput& s) {
  const Spans spans(s);
  return spans.bits_needed() <= int(kNarrowBits) ? rounded_map_in<Integer<kNarrowBits>>(s, spans)
                                                 : rounded_map_in<Integer<kWideBits>>(s, spans);
}

}  // namespace lode::raster::reference

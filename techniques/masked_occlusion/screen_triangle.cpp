#include "techniques/masked_occlusion/screen_triangle.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lode::techniques {
namespace {

constexpr int kRows = kSubtileHeight_px;

/// floor(n / d) for d > 0, |n| < 2^53: the quotient in double is off by one at most.
struct Quotient {
  std::int64_t floor, rest;  ///< 0 ≤ rest < d
};
Quotient divide(std::int64_t n, std::int64_t d) {
  Quotient q;
  q.floor = static_cast<std::int64_t>(double(n) / double(d));
  q.rest = n - q.floor * d;
  while (q.rest < 0) --q.floor, q.rest += d;
  while (q.rest >= d) ++q.floor, q.rest -= d;
  return q;
}

/// Where one edge a→b of a clockwise triangle cuts rows of samples, row after row, exactly. The edge function of
/// raster/reference/triangle.h, E(p) = dx·p.y − dy·p.x + c, is inside at E ≥ bias (0 on top and left edges, else 1).
/// In a row, with p.x = 256·i + 128, that is i ≥ n/d on edges that go up and i ≤ n/d on those that go down.
class EdgeWalk {
 public:
  EdgeWalk(glm::ivec2 a, glm::ivec2 b, int first_row) {
    const std::int64_t dx = b.x - a.x, dy = b.y - a.y, y_fx8 = 256 * std::int64_t(first_row) + 128;
    const std::int64_t bias = dy < 0 || (dy == 0 && dx > 0) ? 0 : 1;
    const std::int64_t row = dx * (y_fx8 - a.y) + dy * a.x;  // E + dy·p.x
    if (dy == 0) {
      kind_ = Kind::level;
      at_ = {row - bias, 0};
      step_ = {256 * dx, 0};
      return;
    }
    kind_ = dy < 0 ? Kind::left : Kind::right;
    d_ = 256 * std::abs(dy);
    // left: i ≥ (bias − row + 128·dy) / d, rounded up; right: i ≤ (row − bias − 128·dy) / d, rounded down.
    at_ = dy < 0 ? divide(bias - row + 128 * dy + (d_ - 1), d_) : divide(row - bias - 128 * dy, d_);
    step_ = divide(dy < 0 ? -256 * dx : 256 * dx, d_);
  }

  /// Narrows the row's samples [first, last] to what is inside.
  void narrow(std::int64_t& first, std::int64_t& last) const {
    if (kind_ == Kind::left) first = std::max(first, at_.floor);
    if (kind_ == Kind::right) last = std::min(last, at_.floor);
    if (kind_ == Kind::level && at_.floor < 0) last = first - 1;
  }
  void next_row() {
    at_.floor += step_.floor;
    at_.rest += step_.rest;
    if (at_.rest < d_) return;
    at_.rest -= d_;
    ++at_.floor;
  }

 private:
  enum class Kind : std::uint8_t { left, right, level };
  Kind kind_;
  std::int64_t d_ = 1;
  Quotient at_{0, 0}, step_{0, 0};  ///< of a level edge: E − bias itself
};

/// A depth that the triangle's fragments do not fall below.
///
/// The plane is z₀ + a·(x − x₀) + b·(y − y₀). Where its gradient is a quotient of sums, each sum loses at most 2^-51 of
/// its terms; over the triangle's box that is at most `lost_`. The renderer's depth is within 2^-50 of the plane's, and
/// both are rounded to float alike.
class DepthPlane {
 public:
  DepthPlane(const ScreenTriangle& t, double area) : z0_(t.z[0]), p0_(t.p_fx8[0]) {
    const glm::dvec2 u(t.p_fx8[1] - t.p_fx8[0]), v(t.p_fx8[2] - t.p_fx8[0]);
    const double du = t.z[1] - t.z[0], dv = t.z[2] - t.z[0];
    a_ = (du * v.y - dv * u.y) / area;
    b_ = (dv * u.x - du * v.x) / area;
    const glm::dvec2 size = glm::max(glm::abs(u), glm::abs(v)) + glm::abs(u - v);
    farthest_ = std::min({t.z[0], t.z[1], t.z[2]});
    const double nearest = std::max({t.z[0], t.z[1], t.z[2]});
    lost_ = 0x1p-48 * (4.0 * (nearest - farthest_) * (size.x * size.y / std::abs(area)) + nearest);
  }

  /// Over the samples [first, last].
  [[nodiscard]] float farthest_in(glm::ivec2 first, glm::ivec2 last) const {
    const double x = 256.0 * (a_ > 0.0 ? first.x : last.x) + 128.0 - p0_.x;
    const double y = 256.0 * (b_ > 0.0 ? first.y : last.y) + 128.0 - p0_.y;
    return float(std::max((z0_ + (a_ * x + b_ * y)) - lost_, farthest_));
  }

 private:
  double z0_, a_, b_, farthest_, lost_;
  glm::dvec2 p0_;
};

/// Samples [first, last] of four rows.
struct Band {
  std::int64_t first[kRows], last[kRows];
};

/// Samples that are in all four rows.
struct Whole {
  std::int64_t first, last;
};
Whole whole_part(const Band& band) {
  return {std::max({band.first[0], band.first[1], band.first[2], band.first[3]}),
          std::min({band.last[0], band.last[1], band.last[2], band.last[3]})};
}

/// The band's samples in the subtile that begins at x.
std::uint32_t coverage_at(const Band& band, int x) {
  std::uint32_t coverage = 0;
  for (int k = 0; k < kRows; ++k) {
    const std::int64_t first = std::max<std::int64_t>(band.first[k] - x, 0);
    const std::int64_t last = std::min<std::int64_t>(band.last[k] - x, 7);
    if (first > last) continue;
    coverage |= ((0xFFu >> (7 - last)) & (0xFFu << first)) << (8 * k);
  }
  return coverage;
}

}  // namespace

SampleBox sample_box(const ScreenTriangle& t, glm::ivec2 n_subtiles) {
  const glm::ivec2 low = glm::min(glm::min(t.p_fx8[0], t.p_fx8[1]), t.p_fx8[2]);
  const glm::ivec2 high = glm::max(glm::max(t.p_fx8[0], t.p_fx8[1]), t.p_fx8[2]);
  const auto first = [](int fx8) { return std::max((fx8 + 127) >> 8, 0); };  // an arithmetic shift: rounds down
  const auto last = [](int fx8, int n) { return std::min((fx8 - 128) >> 8, n - 1); };
  return {{first(low.x), first(low.y)},
          {last(high.x, n_subtiles.x * kSubtileWidth_px), last(high.y, n_subtiles.y * kSubtileHeight_px)}};
}

std::uint64_t draw_triangle(const ScreenTriangle& t, MaskedDepth& buffer) {
  const SampleBox box = sample_box(t, buffer.n_subtiles());
  const std::int64_t area = doubled_area(t);
  if (box.empty() || area == 0) return 0;
  const glm::ivec2 p0 = t.p_fx8[0], p1 = t.p_fx8[area > 0 ? 1 : 2], p2 = t.p_fx8[area > 0 ? 2 : 1];
  EdgeWalk edges[3] = {{p0, p1, box.first.y}, {p1, p2, box.first.y}, {p2, p0, box.first.y}};
  const DepthPlane plane(t, double(area));

  std::uint64_t n_subtiles = 0;
  for (int y = box.first.y; y <= box.last.y;) {
    // The rows of one line of subtiles.
    const int subtile_y = y / kRows, first_row = y, end_row = std::min((subtile_y + 1) * kRows, box.last.y + 1);
    Band band;
    std::fill(std::begin(band.first), std::end(band.first), 0);
    std::fill(std::begin(band.last), std::end(band.last), -1);
    std::int64_t first = box.last.x + 1, last = box.first.x - 1;
    for (; y < end_row; ++y) {
      std::int64_t row_first = box.first.x, row_last = box.last.x;
      for (EdgeWalk& edge : edges) {
        edge.narrow(row_first, row_last);
        edge.next_row();
      }
      if (row_first > row_last) continue;
      band.first[y % kRows] = row_first;
      band.last[y % kRows] = row_last;
      first = std::min(first, row_first);
      last = std::max(last, row_last);
    }
    // Its subtiles, each with the bits that lie in it.
    const Whole whole = whole_part(band);
    for (int x = int(first) & ~7; x <= last; x += kSubtileWidth_px) {
      const bool all = whole.first <= x && x + kSubtileWidth_px - 1 <= whole.last;
      const std::uint32_t coverage = all ? ~0u : coverage_at(band, x);
      if (coverage == 0) continue;
      const float farthest = plane.farthest_in({std::max(x, int(first)), first_row},
                                               {std::min(x + kSubtileWidth_px - 1, int(last)), end_row - 1});
      buffer.add({x / kSubtileWidth_px, subtile_y}, coverage, farthest);
      ++n_subtiles;
    }
  }
  return n_subtiles;
}

}  // namespace lode::techniques

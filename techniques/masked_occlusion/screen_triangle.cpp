#include "techniques/masked_occlusion/screen_triangle.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "techniques/masked_occlusion/subtile_line.h"

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
    LineSpans spans;
    spans.first.fill(0);
    spans.last.fill(-1);
    const int first_row = y, end_row = std::min((y / kRows + 1) * kRows, box.last.y + 1);
    for (; y < end_row; ++y) {
      std::int64_t first = box.first.x, last = box.last.x;
      for (EdgeWalk& edge : edges) {
        edge.narrow(first, last);
        edge.next_row();
      }
      if (first > last) continue;
      spans.first[std::size_t(y % kRows)] = int(first);
      spans.last[std::size_t(y % kRows)] = int(last);
    }
    n_subtiles += add_line(spans, {first_row, end_row - 1}, plane, buffer);
  }
  return n_subtiles;
}

}  // namespace lode::techniques

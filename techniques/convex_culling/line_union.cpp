#include "techniques/convex_culling/line_union.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lode::techniques::convex_culling {
namespace {

double between(const glm::dvec2& a, const glm::dvec2& b, double x) {
  return b.x > a.x ? a.y + (x - a.x) / (b.x - a.x) * (b.y - a.y) : a.y;
}

/// The edge's rise over x; 0 for an upright one, which meets no line but with its first point.
double slope(const glm::dvec2& a, const glm::dvec2& b) {
  const double rise = (b.y - a.y) / (b.x - a.x);
  return std::isfinite(rise) ? rise : 0.0;
}

/// Sorts a few intervals by insertion, many by the library.
void sort_by_low(std::vector<LineUnion::Interval>& line) {
  if (line.size() > 24) {
    std::ranges::sort(line, {}, &LineUnion::Interval::low);
    return;
  }
  for (std::size_t i = 1; i < line.size(); ++i) {
    const LineUnion::Interval y = line[i];
    std::size_t k = i;
    for (; k > 0 && line[k - 1].low > y.low; --k) line[k] = line[k - 1];
    line[k] = y;
  }
}

double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// One chain over points sorted by x: with sign +1 the lower, with −1 the upper one.
std::vector<glm::dvec2> chain_over(const std::vector<glm::dvec2>& sorted, double sign) {
  std::vector<glm::dvec2> chain;
  for (const glm::dvec2& p : sorted) {
    if (!chain.empty() && chain.back().x == p.x) {
      if (sign * (p.y - chain.back().y) >= 0.0) continue;
      chain.pop_back();
    }
    while (chain.size() >= 2 && sign * turn(chain[chain.size() - 2], chain.back(), p) <= 0.0) chain.pop_back();
    chain.push_back(p);
  }
  return chain;
}

}  // namespace

int Lines::first_from(double at) const {
  const double step = spacing();
  if (!(step > 0.0)) return n;
  return int(std::clamp(std::ceil((at - left) / step - 0.5), 0.0, double(n)));
}

RoundedChains rounded_chains(std::span<const glm::dvec2> points) {
  std::vector<glm::dvec2> sorted(points.begin(), points.end());
  std::ranges::sort(sorted,
                    [](const glm::dvec2& a, const glm::dvec2& b) { return std::pair(a.x, a.y) < std::pair(b.x, b.y); });
  return {chain_over(sorted, 1.0), chain_over(sorted, -1.0)};
}

double height(std::span<const glm::dvec2> chain, double x, std::size_t& from) {
  while (from + 2 < chain.size() && chain[from + 1].x <= x) ++from;
  return from + 1 < chain.size() ? between(chain[from], chain[from + 1], x) : chain[from].y;
}

void LineUnion::clear(const Lines& lines) {
  lines_ = lines;
  united_ = false;
  if (on_line_.size() < std::size_t(lines.n)) on_line_.resize(std::size_t(lines.n));
  for (int i = 0; i < lines.n; ++i) on_line_[std::size_t(i)].clear();
}

void LineUnion::add(int line, double y0, double y1) {
  on_line_[std::size_t(line)].push_back({std::min(y0, y1), std::max(y0, y1)});
}

void LineUnion::add_triangle(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  const glm::dvec2 *l = &a, *m = &b, *r = &c;
  if (m->x < l->x) std::swap(l, m);
  if (r->x < m->x) std::swap(m, r);
  if (m->x < l->x) std::swap(l, m);
  const double step = lines_.spacing(), whole = slope(*l, *r), first = slope(*l, *m), second = slope(*m, *r);
  for (int i = lines_.first_from(l->x); i < lines_.n; ++i) {
    const double x = lines_.left + (double(i) + 0.5) * step;
    if (x > r->x) break;
    add(i, l->y + (x - l->x) * whole, x < m->x ? l->y + (x - l->x) * first : m->y + (x - m->x) * second);
  }
}

void LineUnion::add_hull(std::span<const glm::dvec2> points) {
  if (points.empty()) return;
  const auto [lower, upper] = rounded_chains(points);
  std::size_t at_lower = 0, at_upper = 0;
  for (int i = lines_.first_from(lower.front().x); i < lines_.n; ++i) {
    const double x = lines_.x(i);
    if (x > lower.back().x) break;
    add(i, height(lower, x, at_lower), height(upper, x, at_upper));
  }
}

void LineUnion::unite() {
  if (std::exchange(united_, true)) return;
  for (int i = 0; i < lines_.n; ++i) {
    std::vector<Interval>& line = on_line_[std::size_t(i)];
    if (line.size() < 2) continue;
    sort_by_low(line);
    std::size_t n = 0;
    for (const Interval& y : line) {
      if (n > 0 && y.low <= line[n - 1].high) {
        line[n - 1].high = std::max(line[n - 1].high, y.high);
      } else {
        line[n++] = y;
      }
    }
    line.resize(n);
  }
}

double LineUnion::area() {
  unite();
  double length = 0.0;
  for (int i = 0; i < lines_.n; ++i) {
    for (const Interval& y : on_line_[std::size_t(i)]) length += y.high - y.low;
  }
  return length * lines_.spacing();
}

double LineUnion::area_without(LineUnion& other) {
  unite();
  other.unite();
  double length = 0.0;
  for (int i = 0; i < lines_.n; ++i) {
    const std::vector<Interval>& theirs = other.on_line_[std::size_t(i)];
    std::size_t k = 0;
    for (const Interval& y : on_line_[std::size_t(i)]) {
      while (k < theirs.size() && theirs[k].high < y.low) ++k;
      double at = y.low;
      for (std::size_t j = k; j < theirs.size() && theirs[j].low < y.high; ++j) {
        length += std::max(theirs[j].low - at, 0.0);
        at = std::max(at, theirs[j].high);
      }
      length += std::max(y.high - at, 0.0);
    }
  }
  return length * lines_.spacing();
}

}  // namespace lode::techniques::convex_culling

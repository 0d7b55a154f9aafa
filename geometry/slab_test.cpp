#include "geometry/slab_test.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace lode::geometry {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kPaperBins = 512;

void check(const SlabParams& params) {
  const bool sized = params.size_px.x >= 1.0 && params.size_px.x <= kLargestSlabCoordinate && params.size_px.y >= 1.0 &&
                     params.size_px.y <= kLargestSlabCoordinate;
  if (!sized || params.n_slabs < 1 || params.n_slabs > 65536 || params.y_bins < 0 || params.y_bins > (1 << 20) ||
      !(params.margin_px >= 0.0 && params.margin_px <= kLargestSlabCoordinate)) {
    throw std::logic_error(
        "SlabParams: expected size_px >= 1, n_slabs in 1...65536, y_bins in 0...2^20, margin_px >= 0");
  }
}

/// As std::floor, which is a call; for |x| up to the largest coordinate times 2^16.
double rounded_down(double x) {
  const auto whole = static_cast<std::int64_t>(x);
  return double(whole) - (double(whole) > x ? 1.0 : 0.0);
}

/// Where the screen's columns end, and where its lines are. Any ascending numbers would do, as long as occluders and
/// occludees see the same.
class Slabs {
 public:
  explicit Slabs(const SlabParams& params) : n_(params.n_slabs), width_(params.size_px.x) {}

  [[nodiscard]] int count() const { return n_; }
  [[nodiscard]] double line(double i) const { return (i + 0.5) * width_ / double(n_); }
  [[nodiscard]] double boundary(int i) const { return i == n_ ? width_ : double(i) * width_ / double(n_); }

  /// The line nearest to x; of two the right one. Off the screen, lines go on.
  [[nodiscard]] double nearest_line(double x) const { return rounded_down(x / width_ * double(n_)); }
  /// The first line on the screen at x or right of it, n if there is none.
  [[nodiscard]] int first_line_from(double x) const {
    int i = int(std::clamp(nearest_line(x), 0.0, double(n_)));
    while (i > 0 && line(i - 1) >= x) --i;
    while (i < n_ && line(i) < x) ++i;
    return i;
  }
  /// The first column on the screen that ends at x or right of it, n if there is none.
  [[nodiscard]] int first_column_until(double x) const {
    int i = int(std::clamp(nearest_line(x), 0.0, double(n_)));
    while (i > 0 && boundary(i) >= x) --i;
    while (i < n_ && boundary(i + 1) < x) ++i;
    return i;
  }

 private:
  int n_;
  double width_;
};

double to_bins(double y, const SlabParams& params, int n_bins) { return y * double(n_bins) / params.size_px.y; }

/// Shrinks the interval to the bins that it surely fills.
SlabInterval filled_bins(const SlabInterval& y, const SlabParams& params) {
  if (params.y_bins == 0 || y.low > y.high) return y;
  const double low = to_bins(y.low, params, params.y_bins), high = to_bins(y.high, params, params.y_bins);
  return {std::ceil(low + 0x1p-50 * std::fabs(low)), std::floor(high - 0x1p-50 * std::fabs(high))};
}

/// Grows the interval to all bins that it may touch.
SlabInterval touched_bins(const SlabInterval& y, const SlabParams& params) {
  if (params.y_bins == 0) return y;
  const double low = to_bins(y.low, params, params.y_bins), high = to_bins(y.high, params, params.y_bins);
  return {std::floor(low - 0x1p-50 * std::fabs(low)), std::ceil(high + 0x1p-50 * std::fabs(high))};
}

/// Lines: what is off the screen is cut, then every bin that is touched counts as whole.
SlabInterval on_line(const SlabInterval& y, const SlabParams& params) {
  const int n_bins = params.y_bins == 0 && params.mode == SlabMode::paper ? kPaperBins : params.y_bins;
  const SlabInterval cut = {std::max(y.low, 0.0), std::min(y.high, params.size_px.y)};
  if (n_bins == 0 || cut.low > cut.high) return cut;
  // Both ends are on the screen and not negative: a cast rounds them down.
  const auto bin = [&](double v) { return double(std::min(int(to_bins(v, params, n_bins)), n_bins - 1)); };
  return {bin(cut.low), bin(cut.high) + 1.0};
}

/// A footprint begins and ends where there is something.
void trim(SlabFootprint& footprint) {
  std::vector<SlabInterval>& intervals = footprint.intervals;
  const auto something = [](const SlabInterval& y) { return y.low <= y.high; };
  const auto end = std::find_if(intervals.rbegin(), intervals.rend(), something).base();
  intervals.erase(end, intervals.end());
  const auto begin = std::find_if(intervals.begin(), intervals.end(), something);
  footprint.first += int(begin - intervals.begin());
  intervals.erase(intervals.begin(), begin);
}

/// From the least to the greatest y of any points.
SlabInterval y_range(std::span<const glm::dvec2> points) {
  SlabInterval y = {kInfinity, -kInfinity};
  for (const glm::dvec2& p : points) y = {std::min(y.low, p.y), std::max(y.high, p.y)};
  return y;
}

/// Inner bounds: over a column the lower chain is highest, and the upper chain lowest, at one of the column's ends. So
/// the rectangle from end to end lies in the polygon; shrunk by the margin it is what the column gets.
void inner_columns(const ConvexChains& chains, const SlabParams& params, SlabFootprint& out) {
  const Slabs slabs(params);
  const double margin = params.margin_px;
  out.first = slabs.first_column_until(chains.left() + margin);
  ChainWalk low_left(chains.lower), high_left(chains.upper), low_right(chains.lower), high_right(chains.upper);
  for (int i = out.first; i < slabs.count(); ++i) {
    const double left = slabs.boundary(i) - margin, right = slabs.boundary(i + 1) + margin;
    if (right > chains.right()) break;
    SlabInterval y;
    if (left >= chains.left()) {
      const auto [l0, l0_error] = low_left.at(left);
      const auto [l1, l1_error] = low_right.at(right);
      const auto [h0, h0_error] = high_left.at(left);
      const auto [h1, h1_error] = high_right.at(right);
      y = {std::max(l0 + l0_error, l1 + l1_error) + margin, std::min(h0 - h0_error, h1 - h1_error) - margin};
    }
    out.intervals.push_back(filled_bins(y, params));
  }
  trim(out);
}

/// The corners of a chain from x = left to x = right, both growing from call to call.
class CornersBetween {
 public:
  explicit CornersBetween(const std::vector<glm::dvec2>& chain) : chain_(chain) {}

  [[nodiscard]] std::span<const glm::dvec2> operator()(double left, double right) {
    while (first_ < chain_.size() && chain_[first_].x < left) ++first_;
    std::size_t end = first_;
    while (end < chain_.size() && chain_[end].x <= right) ++end;
    return std::span(chain_).subspan(first_, end - first_);
  }

 private:
  const std::vector<glm::dvec2>& chain_;
  std::size_t first_ = 0;
};

/// Outer bounds: all that the polygon, grown by the margin, has of each column, cut to the screen. Its extremes in y
/// are at the column's ends or at corners between them.
void outer_columns(const ConvexChains& chains, const SlabParams& params, SlabFootprint& out) {
  const Slabs slabs(params);
  const double margin = params.margin_px;
  out.first = slabs.first_column_until(chains.left() - margin);
  ChainWalk low_left(chains.lower), high_left(chains.upper), low_right(chains.lower), high_right(chains.upper);
  CornersBetween low_corners(chains.lower), high_corners(chains.upper);
  for (int i = out.first; i < slabs.count() && slabs.boundary(i) - margin <= chains.right(); ++i) {
    const double left = std::max(slabs.boundary(i) - margin, chains.left());
    const double right = std::min(slabs.boundary(i + 1) + margin, chains.right());
    const ChainHeight l0 = low_left.at(left), l1 = low_right.at(right);
    const ChainHeight h0 = high_left.at(left), h1 = high_right.at(right);
    SlabInterval y = {std::min(l0.y - l0.error, l1.y - l1.error), std::max(h0.y + h0.error, h1.y + h1.error)};
    y.low = std::min(y.low, y_range(low_corners(left, right)).low);
    y.high = std::max(y.high, y_range(high_corners(left, right)).high);
    y = {std::max(y.low - margin, 0.0), std::min(y.high + margin, params.size_px.y)};
    out.intervals.push_back(y.low <= y.high ? touched_bins(y, params) : SlabInterval{});
  }
  trim(out);
}

bool usable(std::span<const glm::dvec2> points) {
  return std::ranges::all_of(points, [](const glm::dvec2& p) {
    return std::fabs(p.x) <= kLargestSlabCoordinate && std::fabs(p.y) <= kLargestSlabCoordinate;
  });
}

}  // namespace

SlabFootprints::SlabFootprints(const SlabParams& params) : params_(params) { check(params); }

void SlabFootprints::of_occluder(std::span<const glm::dvec2> points_px, SlabFootprint& out) {
  out.first = 0;
  out.intervals.clear();
  if (points_px.empty() || !usable(points_px)) return;
  if (params_.mode != SlabMode::conservative) return on_lines(points_px, out);
  convex_chains(points_px, chains_);
  inner_columns(chains_, params_, out);
}

void SlabFootprints::of_occludee(std::span<const glm::dvec2> points_px, SlabFootprint& out) {
  out.first = 0;
  out.intervals.clear();
  if (points_px.empty()) return;
  if (!usable(points_px)) {
    out.intervals.push_back({-kInfinity, kInfinity});
  } else if (params_.mode != SlabMode::conservative) {
    on_lines(points_px, out);
  } else {
    convex_chains(points_px, chains_);
    outer_columns(chains_, params_, out);
  }
}

/// Sec. 3.2: the edge loop's crossings with each line. In contrast to the paper, with `exact_x` a polygon may lie
/// between two lines: it meets the one nearest to its middle, with all of its y.
void SlabFootprints::on_lines(std::span<const glm::dvec2> points, SlabFootprint& out) {
  const SlabInterval all = y_range(points);
  if (all.low > params_.size_px.y || all.high < 0.0) return;
  const Slabs slabs(params_);
  if (params_.mode == SlabMode::paper) {
    moved_.assign(points.begin(), points.end());
    for (glm::dvec2& p : moved_) p.x = slabs.line(slabs.nearest_line(p.x));
    points = moved_;
  }
  const auto [left, right] = std::minmax_element(points.begin(), points.end(),
                                                 [](const glm::dvec2& a, const glm::dvec2& b) { return a.x < b.x; });
  if (right->x < 0.0 || left->x > params_.size_px.x) return;
  convex_chains(points, chains_);
  ChainWalk lower(chains_.lower), upper(chains_.upper);
  out.first = slabs.first_line_from(chains_.left());
  for (int i = out.first; i < slabs.count() && slabs.line(i) <= chains_.right(); ++i) {
    const double x = slabs.line(i);
    out.intervals.push_back(on_line({lower.at(x).y, upper.at(x).y}, params_));
  }
  if (out.intervals.empty()) {
    const double middle = 0.5 * (chains_.left() + chains_.right());
    out.first = int(std::clamp(slabs.nearest_line(middle), 0.0, double(slabs.count() - 1)));
    out.intervals.push_back(on_line(all, params_));
  }
  trim(out);
}

SlabFootprint occluder_footprint(std::span<const glm::dvec2> points_px, const SlabParams& params) {
  SlabFootprint footprint;
  SlabFootprints(params).of_occluder(points_px, footprint);
  return footprint;
}

SlabFootprint occludee_footprint(std::span<const glm::dvec2> points_px, const SlabParams& params) {
  SlabFootprint footprint;
  SlabFootprints(params).of_occludee(points_px, footprint);
  return footprint;
}

}  // namespace lode::geometry

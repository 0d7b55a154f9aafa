#include "experiments/metrics/flip/flip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "experiments/metrics/expect_size.h"
#include "experiments/metrics/flip/color_difference.h"
#include "experiments/metrics/flip/filters.h"
#include "geometry/exponential.h"
#include "raster/parallel.h"
#include "raster/srgb.h"

namespace lode::experiments {
namespace {

using flip::Filters;

/// A strip of a picture's rows is worked on at a time: small enough for a processor's cache.
constexpr int kStripRows = 32;

/// One channel.
template <class T>
struct Plane {
  int width = 0, height = 0;
  std::vector<T> values;  ///< [width*height]

  Plane(int width_px, int height_px)
      : width(width_px), height(height_px), values(std::size_t(width_px) * std::size_t(height_px)) {}
  [[nodiscard]] T* row(int y) { return &values[std::size_t(y) * std::size_t(width)]; }
  [[nodiscard]] const T* row(int y) const { return &values[std::size_t(y) * std::size_t(width)]; }
};

/// out[x] = Σ w[k]·in[k·stride + x], k in order.
template <class T>
void convolve(const T* in, std::size_t stride, const std::vector<T>& weights, T* out, int width) {
  std::fill_n(out, width, T(0));
  for (std::size_t k = 0; k < weights.size(); ++k) {
    const T w = weights[k];
    const T* const shifted = in + k * stride;
    for (int x = 0; x < width; ++x) out[x] += w * shifted[x];
  }
}

/// Only where the whole row of weights is inside: narrower by its length − 1.
template <class T>
Plane<T> along_x(const Plane<T>& in, const std::vector<T>& weights) {
  Plane<T> out(in.width - int(weights.size()) + 1, in.height);
  for (int y = 0; y < out.height; ++y) convolve(in.row(y), 1, weights, out.row(y), out.width);
  return out;
}

template <class T>
Plane<T> along_y(const Plane<T>& in, const std::vector<T>& weights) {
  Plane<T> out(in.width, in.height - int(weights.size()) + 1);
  for (int y = 0; y < out.height; ++y) {
    convolve(in.row(y), std::size_t(in.width), weights, out.row(y), out.width);
  }
  return out;
}

/// A strip of a picture in YCxCz, its borders as wide as the filters' radius.
using Strip = std::array<Plane<double>, 3>;

Strip load_strip(glm::ivec2 size_px, const LinearColors& color, int first_y, int n_rows, int border) {
  const Plane<double> empty(size_px.x + 2 * border, n_rows + 2 * border);
  Strip strip = {empty, empty, empty};
  for (int y = 0; y < empty.height; ++y) {
    const int y_inside = std::clamp(first_y + y - border, 0, size_px.y - 1);
    for (int x = 0; x < size_px.x; ++x) {
      const std::size_t pixel = std::size_t(y_inside) * std::size_t(size_px.x) + std::size_t(x);
      const glm::dvec3 c = flip::ycxcz_from_linear(color(pixel));
      for (int i = 0; i < 3; ++i) strip[std::size_t(i)].row(y)[x + border] = c[i];
    }
    for (Plane<double>& plane : strip) {  // the picture's edges are repeated outwards
      double* const row = plane.row(y);
      std::fill_n(row, border, row[border]);
      std::fill_n(row + border + size_px.x, border, row[border + size_px.x - 1]);
    }
  }
  return strip;
}

/// As an eye sees it from where it is: YCxCz, [w*n_rows].
Strip seen(const Strip& strip, const Filters& filters) {
  const auto filtered = [](const Plane<double>& plane, const std::vector<double>& w) {
    return along_y(along_x(plane, w), w);
  };
  Strip result = {filtered(strip[0], filters.achromatic), filtered(strip[1], filters.red_green),
                  filtered(strip[2], filters.blue_yellow_1)};
  const Plane<double> second = filtered(strip[2], filters.blue_yellow_2);
  for (std::size_t i = 0; i < second.values.size(); ++i) result[2].values[i] += second.values[i];
  return result;
}

/// How much of an edge and of a point there is: [w*n_rows].
struct Features {
  Plane<float> edge, point;
};

/// √(x² + y²), element by element.
Plane<float> lengths(Plane<float> x, const Plane<float>& y) {
  for (std::size_t i = 0; i < x.values.size(); ++i) {
    x.values[i] = std::sqrt(x.values[i] * x.values[i] + y.values[i] * y.values[i]);
  }
  return x;
}

Features features_of(const Strip& strip, const Filters& filters) {
  Plane<float> luminance(strip[0].width, strip[0].height);
  std::transform(strip[0].values.begin(), strip[0].values.end(), luminance.values.begin(),
                 [](double y) { return float(flip::luminance_of(y)); });
  const Plane<float> smooth_x = along_x(luminance, filters.gaussian);
  return {lengths(along_y(along_x(luminance, filters.edge), filters.gaussian), along_y(smooth_x, filters.edge)),
          lengths(along_y(along_x(luminance, filters.point), filters.gaussian), along_y(smooth_x, filters.point))};
}

/// ΔE_f in [0, 1], q_f = ½ (sec. 4.2).
double feature_difference(const Features& reference, const Features& test, std::size_t i) {
  const float edge = std::fabs(reference.edge.values[i] - test.edge.values[i]);
  const float point = std::fabs(reference.point.values[i] - test.point.values[i]);
  return std::sqrt(double{std::max(edge, point)} / std::sqrt(2.0));
}

/// ΔE = ΔE_c^(1 − ΔE_f) (sec. 4.3).
void compare_strips(const Strip& reference, const Strip& test, const Filters& filters, std::span<float> errors) {
  const Strip p = seen(reference, filters), q = seen(test, filters);
  const Features p_features = features_of(reference, filters), q_features = features_of(test, filters);
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const auto color = [i](const Strip& s) { return glm::dvec3(s[0].values[i], s[1].values[i], s[2].values[i]); };
    const double difference = flip::color_difference(color(p), color(q));
    const double exponent = 1.0 - feature_difference(p_features, q_features, i);
    errors[i] = float(geometry::power(difference, exponent));
  }
}

}  // namespace

ErrorMap flip_map(glm::ivec2 size_px, const LinearColors& reference, const LinearColors& test,
                  const FlipParams& params) {
  const Filters filters = flip::make_filters(params.pixels_per_degree);
  ErrorMap map{size_px, std::vector<float>(pixel_count(size_px))};
  if (map.errors.empty()) return map;
  const int n_strips = (size_px.y + kStripRows - 1) / kStripRows;
  raster::parallel_for(std::size_t(n_strips), raster::worker_count(params.threads), [&](std::size_t strip, int) {
    const int y = int(strip) * kStripRows, n_rows = std::min(kStripRows, size_px.y - y);
    const std::size_t width(size_px.x);
    compare_strips(load_strip(size_px, reference, y, n_rows, filters.radius),
                   load_strip(size_px, test, y, n_rows, filters.radius), filters,
                   std::span(map.errors).subspan(std::size_t(y) * width, std::size_t(n_rows) * width));
  });
  return map;
}

ErrorMap flip_map(const PicturePair& pair, const FlipParams& params) {
  expect_size("FLIP's reference", pixel_count(pair.size_px), pair.a.size());
  expect_size("FLIP's test", pixel_count(pair.size_px), pair.b.size());
  const auto linear = [](std::span<const glm::u8vec4> texels) {
    return [texels](std::size_t i) {
      return glm::dvec3(raster::srgb_decode(texels[i].r), raster::srgb_decode(texels[i].g),
                        raster::srgb_decode(texels[i].b));
    };
  };
  return flip_map(pair.size_px, linear(pair.a), linear(pair.b), params);
}

}  // namespace lode::experiments

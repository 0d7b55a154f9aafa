#include "experiments/compare/picture_metrics.h"

#include <cmath>

#include "experiments/error.h"
#include "experiments/metrics/flip/hdr_flip.h"
#include "experiments/metrics/pixel_difference.h"
#include "experiments/metrics/structural_similarity.h"

namespace lode::experiments {

PictureMetrics::PictureMetrics(const StoredPicture& a, const StoredPicture& b, int threads) : a_(a), b_(b) {
  if (std::holds_alternative<ColorPlane>(a.plane)) {
    add_color_metrics(threads);
  } else if (std::holds_alternative<DepthPlane>(a.plane)) {
    add_depth_metrics();
  } else {
    add_id_metrics();
  }
}

void PictureMetrics::add_color_metrics(int threads) {
  const PicturePair pair{a_.size_px, std::get<ColorPlane>(a_.plane), std::get<ColorPlane>(b_.plane)};
  const PixelDifference d = pixel_difference(pair);
  metrics_ = {{"max", [d] { return double(d.max); }},  {"differing", [d] { return double(d.differing); }},
              {"rmse", [d] { return rmse(d); }},       {"psnr", [d] { return psnr(d); }},
              {"ssim", [pair] { return ssim(pair); }}, {"ms-ssim", [pair] { return ms_ssim(pair); }}};
  add_map("flip", [pair, threads] { return flip_map(pair, {.threads = threads}); });
  if (a_.is_linear && b_.is_linear) {
    const LinearPair linear{a_.size_px, a_.linear, b_.linear};
    add_map("hdr-flip", [linear, threads] { return hdr_flip_map(linear, {.threads = threads}); });
  }
}

void PictureMetrics::add_depth_metrics() {
  const auto &a = std::get<DepthPlane>(a_.plane), &b = std::get<DepthPlane>(b_.plane);
  double max = 0.0, differing = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i] == b[i] || (std::isnan(a[i]) && std::isnan(b[i]))) continue;
    differing += 1.0;
    const double difference = std::abs(double{a[i]} - double{b[i]});
    max = std::isnan(difference) ? difference : std::fmax(max, difference);
  }
  metrics_ = {{"max", [max] { return std::optional(max); }},
              {"differing", [differing] { return std::optional(differing); }}};
}

void PictureMetrics::add_id_metrics() {
  const auto &a = std::get<IdPlane>(a_.plane), &b = std::get<IdPlane>(b_.plane);
  double differing = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) differing += a[i] != b[i] ? 1.0 : 0.0;
  metrics_ = {{"differing", [differing] { return std::optional(differing); }}};
}

void PictureMetrics::add_map(const std::string& name, const Map& make) {
  make_map_[name] = make;
  metrics_[name] = [this, name]() -> std::optional<double> {
    const std::optional<ErrorMap>& map = map_if_any(name);
    return map ? std::optional(mean_error(map->errors)) : std::nullopt;
  };
}

const std::optional<ErrorMap>& PictureMetrics::map_if_any(const std::string& name) {
  if (!maps_.contains(name)) maps_[name] = make_map_.at(name)();
  return maps_[name];
}

std::optional<double> PictureMetrics::value(const std::string& name) {
  const auto metric = metrics_.find(name);
  if (metric == metrics_.end()) {
    const bool only_b = a_.is_linear && !b_.is_linear;
    const StoredPicture& picture = only_b ? b_ : a_;
    const bool is_color = std::holds_alternative<ColorPlane>(picture.plane);
    throw Error(Status::bad_input,
                picture.path + ": " + (is_color ? "colour of 8 bits" : kind_of(picture)) + " has no " + name);
  }
  const auto known = values_.find(name);
  if (known != values_.end()) return known->second;
  return values_[name] = metric->second();
}

const ErrorMap& PictureMetrics::map(const std::string& name) {
  (void)value(name);
  const std::optional<ErrorMap>& map = map_if_any(name);
  if (!map) throw Error(Status::bad_input, a_.path + ", " + b_.path + ": expected finite colours for " + name);
  return *map;
}

}  // namespace lode::experiments

#include "experiments/compare/compare.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <ostream>
#include <set>

#include "experiments/compare/stored_picture.h"
#include "experiments/metrics/pixel_difference.h"
#include "experiments/metrics/structural_similarity.h"
#include "experiments/option_values.h"
#include "experiments/output_files.h"
#include "experiments/whole_file.h"
#include "geometry/image_file.h"

namespace lode::experiments {
namespace {

/// In the order in which they are printed.
constexpr std::string_view kMetrics[] = {"max", "differing", "rmse", "psnr", "ssim", "ms-ssim"};

/// "METRIC<VALUE" or "METRIC>VALUE".
struct Condition {
  std::string metric;
  bool below = false;
  double value = 0.0;
};

/// The options, understood.
struct Request {
  std::vector<std::string> metrics;  ///< to be printed, in order
  bool all = false;
  std::vector<Condition> conditions;
};

Condition read_condition(const std::string& text) {
  const std::size_t at = text.find_first_of("<>");
  const std::optional<double> value = at == std::string::npos ? std::nullopt : number_in(text.substr(at + 1));
  if (!value) fail_value("--fail-if", "METRIC<VALUE or METRIC>VALUE", text);
  return {std::string(kMetrics[read_choice("--fail-if", text.substr(0, at), kMetrics)]), text[at] == '<', *value};
}

Request read_options(const CompareOptions& options) {
  Request request;
  std::set<std::string_view> wanted;
  request.all = options.metrics == "all";
  if (!request.all) {
    for (const std::string_view name : split(options.metrics, ',')) {
      wanted.insert(kMetrics[read_choice("--metrics", name, kMetrics)]);
    }
  }
  for (const std::string_view name : kMetrics) {
    if (request.all || wanted.contains(name)) request.metrics.emplace_back(name);
  }
  for (const std::string& text : options.fail_if) request.conditions.push_back(read_condition(text));
  if (options.map && geometry::image_format(*options.map) != geometry::ImageFormat::png) {
    throw Error(Status::wrong_usage, "--map " + *options.map + ": expected a file ending in .png");
  }
  for (const std::string& input : {options.a, options.b}) check_output_paths({.out = options.map}, input);
  return request;
}

/// Metrics of two planes by name, each computed when it is first asked for; nothing where it is not defined.
using Metrics = std::map<std::string, std::function<std::optional<double>()>, std::less<>>;

Metrics color_metrics(const PicturePair& pair) {
  const PixelDifference d = pixel_difference(pair);
  return {{"max", [d] { return double(d.max); }},  {"differing", [d] { return double(d.differing); }},
          {"rmse", [d] { return rmse(d); }},       {"psnr", [d] { return psnr(d); }},
          {"ssim", [pair] { return ssim(pair); }}, {"ms-ssim", [pair] { return ms_ssim(pair); }}};
}

Metrics depth_metrics(const DepthPlane& a, const DepthPlane& b) {
  double max = 0.0, differing = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i] == b[i] || (std::isnan(a[i]) && std::isnan(b[i]))) continue;
    differing += 1.0;
    const double difference = std::abs(double{a[i]} - double{b[i]});
    max = std::isnan(difference) ? difference : std::fmax(max, difference);
  }
  return {{"max", [max] { return std::optional(max); }},
          {"differing", [differing] { return std::optional(differing); }}};
}

Metrics id_metrics(const IdPlane& a, const IdPlane& b) {
  double differing = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) differing += a[i] != b[i] ? 1.0 : 0.0;
  return {{"differing", [differing] { return std::optional(differing); }}};
}

Metrics metrics_of(const StoredPicture& a, const StoredPicture& b) {
  if (const auto* color = std::get_if<ColorPlane>(&a.plane)) {
    return color_metrics({a.size_px, *color, std::get<ColorPlane>(b.plane)});
  }
  if (const auto* depth = std::get_if<DepthPlane>(&a.plane)) {
    return depth_metrics(*depth, std::get<DepthPlane>(b.plane));
  }
  return id_metrics(std::get<IdPlane>(a.plane), std::get<IdPlane>(b.plane));
}

void check_same_shape(const StoredPicture& a, const StoredPicture& b) {
  if (a.plane.index() != b.plane.index()) {
    throw Error(Status::bad_input,
                b.path + ": has " + kind_of(b) + ": expected " + kind_of(a) + " as " + a.path + " has");
  }
  if (a.size_px != b.size_px) {
    const auto size = [](const StoredPicture& p) {
      return std::to_string(p.size_px.x) + " x " + std::to_string(p.size_px.y);
    };
    throw Error(Status::bad_input, b.path + ": " + size(b) + " px: expected " + size(a) + " px as " + a.path + " has");
  }
}

std::optional<double> value_of(const Metrics& metrics, const std::string& name, const StoredPicture& picture) {
  const auto found = metrics.find(name);
  if (found == metrics.end()) {
    throw Error(Status::bad_input, picture.path + ": " + kind_of(picture) + " has no " + name);
  }
  return found->second();
}

/// Equal pictures have no psnr: it is above every limit.
bool holds(const Condition& condition, const std::optional<double>& value, const StoredPicture& picture) {
  if (!value && condition.metric == "psnr") return !condition.below;
  if (!value) {
    throw Error(Status::bad_input, "--fail-if " + condition.metric + ": pictures of " +
                                       std::to_string(picture.size_px.x) + " x " + std::to_string(picture.size_px.y) +
                                       " px are too small to have one");
  }
  return condition.below ? *value < condition.value : *value > condition.value;
}

/// Whole numbers without a point.
nlohmann::ordered_json shown(const std::optional<double>& value, bool whole) {
  if (!value || !std::isfinite(*value)) return nullptr;
  return whole ? nlohmann::ordered_json(std::uint64_t(*value)) : nlohmann::ordered_json(*value);
}

/// How a difference of 0…255 is shown: black where equal, others from 64 up, so that 1 is seen.
glm::u8 shown_difference(int difference) { return difference == 0 ? 0 : glm::u8(64 + difference * 191 / 255); }

/// Differences by channel; of depth and ids, white where they differ.
ColorPlane difference_map(const StoredPicture& a, const StoredPicture& b) {
  ColorPlane map(std::size_t(a.size_px.x) * std::size_t(a.size_px.y), {0, 0, 0, 255});
  for (std::size_t i = 0; i < map.size(); ++i) {
    if (const auto* color = std::get_if<ColorPlane>(&a.plane)) {
      const glm::u8vec4 p = (*color)[i], q = std::get<ColorPlane>(b.plane)[i];
      for (int c = 0; c < 3; ++c) map[i][c] = shown_difference(std::abs(int(p[c]) - int(q[c])));
    } else if (const auto* depth = std::get_if<DepthPlane>(&a.plane)) {
      if ((*depth)[i] != std::get<DepthPlane>(b.plane)[i]) map[i] = glm::u8vec4(255);
    } else if (std::get<IdPlane>(a.plane)[i] != std::get<IdPlane>(b.plane)[i]) {
      map[i] = glm::u8vec4(255);
    }
  }
  return map;
}

}  // namespace

Status compare(const CompareOptions& options, const Streams& streams) {
  const Request request = read_options(options);
  std::optional<WholeFile> map;
  if (options.map) map.emplace(*options.map);
  const StoredPicture a = read_stored_picture(options.a), b = read_stored_picture(options.b);
  check_same_shape(a, b);
  const Metrics metrics = metrics_of(a, b);

  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (const std::string& name : request.metrics) {
    if (request.all && !metrics.contains(name)) continue;
    const bool whole = name == "differing" || (name == "max" && std::holds_alternative<ColorPlane>(a.plane));
    json[name] = shown(value_of(metrics, name, a), whole);
  }
  Status status = Status::done;
  for (const Condition& condition : request.conditions) {
    if (holds(condition, value_of(metrics, condition.metric, a), a)) status = Status::check_failed;
  }
  if (map) geometry::write_color(map->file(), geometry::ImageFormat::png, a.size_px, difference_map(a, b));
  streams.out << json.dump() << std::endl;
  if (!streams.out) throw Error(Status::machine_failed, "standard output: cannot be written");
  publish({map ? &*map : nullptr});
  return status;
}

}  // namespace lode::experiments

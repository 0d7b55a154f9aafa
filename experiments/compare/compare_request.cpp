#include "experiments/compare/compare_request.h"

#include <set>
#include <string_view>

#include "experiments/option_values.h"
#include "experiments/output_files.h"
#include "geometry/image_file.h"

namespace lode::experiments {
namespace {

/// In the order in which they are printed. The last one takes the time of many and is not one of `all`.
constexpr std::string_view kMetrics[] = {"max", "differing", "rmse", "psnr", "ssim", "ms-ssim", "flip", "hdr-flip"};

Condition read_condition(const std::string& text) {
  const std::size_t at = text.find_first_of("<>");
  const std::optional<double> value = at == std::string::npos ? std::nullopt : number_in(text.substr(at + 1));
  if (!value) fail_value("--fail-if", "METRIC<VALUE or METRIC>VALUE", text);
  return {std::string(kMetrics[read_choice("--fail-if", text.substr(0, at), kMetrics)]), text[at] == '<', *value};
}

}  // namespace

CompareRequest read_compare_request(const CompareOptions& options) {
  CompareRequest request;
  std::set<std::string_view> wanted;
  request.all = options.metrics == "all";
  if (!request.all) {
    for (const std::string_view name : split(options.metrics, ',')) {
      wanted.insert(kMetrics[read_choice("--metrics", name, kMetrics)]);
    }
  }
  for (const std::string_view name : kMetrics) {
    if (wanted.contains(name) || (request.all && name != "hdr-flip")) request.metrics.emplace_back(name);
  }
  if (wanted.size() == 1 && (wanted.contains("flip") || wanted.contains("hdr-flip"))) {
    request.shown_map = request.metrics.front();
  }
  for (const std::string& text : options.fail_if) request.conditions.push_back(read_condition(text));
  if (options.map && geometry::image_format(*options.map) != geometry::ImageFormat::png) {
    throw Error(Status::wrong_usage, "--map " + *options.map + ": expected a file ending in .png");
  }
  for (const std::string& input : {options.a, options.b}) check_output_paths({.out = options.map}, input);
  return request;
}

}  // namespace lode::experiments

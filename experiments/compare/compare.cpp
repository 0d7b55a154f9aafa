#include "experiments/compare/compare.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <ostream>

#include "experiments/compare/compare_request.h"
#include "experiments/compare/difference_map.h"
#include "experiments/compare/picture_metrics.h"
#include "experiments/compare/stored_picture.h"
#include "experiments/metrics/magma.h"
#include "experiments/whole_file.h"
#include "geometry/image_file.h"

namespace lode::experiments {
namespace {

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

/// Equal pictures have no psnr: it is above every limit.
bool holds(const Condition& condition, const std::optional<double>& value, const StoredPicture& picture) {
  if (!value && condition.metric == "psnr") return !condition.below;
  if (!value) {
    const std::string why =
        condition.metric == "hdr-flip" ? "with colours that are not finite have none" : "are too small to have one";
    throw Error(Status::bad_input, "--fail-if " + condition.metric + ": pictures of " +
                                       std::to_string(picture.size_px.x) + " x " + std::to_string(picture.size_px.y) +
                                       " px " + why);
  }
  return condition.below ? *value < condition.value : *value > condition.value;
}

/// Whole numbers without a point.
nlohmann::ordered_json shown(const std::optional<double>& value, bool whole) {
  if (!value || !std::isfinite(*value)) return nullptr;
  return whole ? nlohmann::ordered_json(std::uint64_t(*value)) : nlohmann::ordered_json(*value);
}

}  // namespace

Status compare(const CompareOptions& options, int threads, const Streams& streams) {
  const CompareRequest request = read_compare_request(options);
  std::optional<WholeFile> map;
  if (options.map) map.emplace(*options.map);
  const StoredPicture a = read_stored_picture(options.a), b = read_stored_picture(options.b);
  check_same_shape(a, b);
  PictureMetrics metrics(a, b, threads);

  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (const std::string& name : request.metrics) {
    if (request.all && !metrics.has(name)) continue;
    const bool whole = name == "differing" || (name == "max" && std::holds_alternative<ColorPlane>(a.plane));
    json[name] = shown(metrics.value(name), whole);
  }
  Status status = Status::done;
  for (const Condition& condition : request.conditions) {
    if (holds(condition, metrics.value(condition.metric), a)) status = Status::check_failed;
  }
  if (map) {
    const ColorPlane picture =
        request.shown_map ? magma_picture(metrics.map(*request.shown_map).errors) : difference_map(a, b);
    geometry::write_color(map->file(), geometry::ImageFormat::png, a.size_px, picture);
  }
  streams.out << json.dump() << std::endl;
  if (!streams.out) throw Error(Status::machine_failed, "standard output: cannot be written");
  publish({map ? &*map : nullptr});
  return status;
}

}  // namespace lode::experiments

#include "experiments/metrics/culling_errors.h"

#include <stdexcept>
#include <string>

#include "experiments/metrics/expect_size.h"
#include "experiments/metrics/largest_region.h"

namespace lode::experiments {
namespace {

std::size_t object_of(std::uint32_t draw, std::span<const std::uint32_t> object_of_draw, std::size_t n_objects) {
  if (draw >= object_of_draw.size()) {
    throw std::logic_error("reference ids: expected draws below " + std::to_string(object_of_draw.size()) + ", found " +
                           std::to_string(draw));
  }
  const std::size_t object = object_of_draw[draw];
  if (object >= n_objects) {
    throw std::logic_error("objects of draws: expected objects below " + std::to_string(n_objects) + ", found " +
                           std::to_string(object));
  }
  return object;
}

}  // namespace

double CullingErrors::falsely_culled_share() const {
  return owned_pixels == 0 ? 0.0 : double(falsely_culled_pixels) / double(owned_pixels);
}

std::optional<double> CullingErrors::culled_share() const {
  if (could_be_culled() == 0) return std::nullopt;
  return double(culled - falsely_culled_objects) / double(could_be_culled());
}

std::vector<std::uint64_t> owned_pixels(std::span<const raster::Ids> reference,
                                        std::span<const std::uint32_t> object_of_draw, std::size_t n_objects) {
  std::vector<std::uint64_t> owned(n_objects);
  for (const raster::Ids& ids : reference) {
    if (ids.draw != raster::kNoId) owned[object_of(ids.draw, object_of_draw, n_objects)] += 1;
  }
  return owned;
}

CullingErrors culling_errors(const CulledFrame& frame) {
  expect_size("reference ids", pixel_count(frame.size_px), frame.reference.size());
  const std::vector<std::uint64_t> owned = owned_pixels(frame.reference, frame.object_of_draw, frame.drawn.size());
  CullingErrors errors{.n_objects = frame.drawn.size()};
  for (std::size_t object = 0; object < owned.size(); ++object) {
    const bool visible = owned[object] > 0, drawn = frame.drawn[object] != 0;
    errors.owned_pixels += owned[object];
    errors.visible += visible;
    errors.culled += !drawn;
    errors.missed_culls += drawn && !visible;
    if (drawn || !visible) continue;
    errors.falsely_culled_objects += 1;
    errors.falsely_culled_pixels += owned[object];
  }
  if (errors.falsely_culled_pixels == 0) return errors;
  std::vector<std::uint8_t> missing;
  missing.reserve(frame.reference.size());
  for (const raster::Ids& ids : frame.reference) {
    missing.push_back(ids.draw != raster::kNoId && frame.drawn[frame.object_of_draw[ids.draw]] == 0 ? 1 : 0);
  }
  errors.largest_missing_region = largest_region(frame.size_px, missing);
  return errors;
}

}  // namespace lode::experiments

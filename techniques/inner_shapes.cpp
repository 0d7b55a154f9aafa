#include "techniques/inner_shapes.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include "raster/parallel.h"

namespace lode::techniques {
namespace {

/// Not finite if one coordinate is not.
double largest_coordinate(std::span<const glm::vec3> positions) {
  double largest = 0.0;
  for (const glm::vec3& p : positions) {
    for (int axis = 0; axis < 3; ++axis) {
      const double c = std::fabs(double(p[axis]));
      if (!(c <= largest)) largest = c;
      if (!std::isfinite(largest)) return largest;
    }
  }
  return largest;
}

std::vector<geometry::Bounds> boxes_in(const Shape& shape, const geometry::InnerBoxesParams& params) {
  const double largest = largest_coordinate(shape.positions);
  if (!shape.hides || !std::isfinite(largest)) return {};
  std::vector<geometry::Bounds> boxes = geometry::inner_boxes({shape.positions, shape.indices}, params);
  for (geometry::Bounds& box : boxes) {
    box.low += 0x1p-22 * largest;
    box.high -= 0x1p-22 * largest;
  }
  std::erase_if(boxes, [](const geometry::Bounds& box) { return box.empty(); });
  return boxes;
}

ShapeBoxes boxes_of_shapes(const World& world, std::span<const double> areas, const geometry::InnerBoxesParams& params,
                           int threads) {
  std::vector<std::uint8_t> wanted(world.n_shapes(), 0);
  for (ObjectId id = 0; id < areas.size(); ++id) {
    if (areas[id] > 0.0) wanted[world.objects()[id].shape] = 1;
  }
  ShapeBoxes boxes(world.n_shapes());
  raster::parallel_for(boxes.size(), raster::worker_count(threads), [&](std::size_t i, int) {
    if (wanted[i] != 0) boxes[i] = boxes_in(world.shape(std::uint32_t(i)), params);
  });
  return boxes;
}

}  // namespace

std::shared_ptr<const ShapeBoxes> inner_boxes_of_shapes(const World& world, std::span<const double> areas,
                                                        const geometry::InnerBoxesParams& params, int threads) {
  const std::string key = "inner boxes; " + std::to_string(params.resolution) + "; " + std::to_string(params.n_most) +
                          "; " + std::to_string(params.least_share);
  return world.once<ShapeBoxes>(key, [&] { return boxes_of_shapes(world, areas, params, threads); });
}

}  // namespace lode::techniques

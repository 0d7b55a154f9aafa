#pragma once
/// What stands for occluders without ever hiding more than they do: boxes in the solid parts of each shape
/// (geometry/inner_boxes.h), for every technique that draws or projects such.

#include <memory>
#include <span>
#include <vector>

#include "geometry/inner_boxes.h"
#include "techniques/world.h"

namespace lode::techniques {

/// For each shape its inner boxes, in its space, smaller on every side by 2^-22 of its largest coordinate: a shape's
/// positions are rounded to floats where it is made of several instances. None for a shape that does not hide what is
/// behind it (Shape::hides), that no object of positive area has, or that is not finite.
///
///   areas     [objects] of all that may occlude (occluder_areas)
///   threads   0: one per processor
///   returns   [World::n_shapes()]; deterministic; kept with the world for whoever asks next
///   checks    params (std::logic_error)
using ShapeBoxes = std::vector<std::vector<geometry::Bounds>>;
[[nodiscard]] std::shared_ptr<const ShapeBoxes> inner_boxes_of_shapes(const World& world, std::span<const double> areas,
                                                                      const geometry::InnerBoxesParams& params,
                                                                      int threads);

}  // namespace lode::techniques

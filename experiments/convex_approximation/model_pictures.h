#pragma once
/// Pictures of models and of what stands for them: hulls at each level, inner boxes. One colour a hull or box.

#include <string>

#include "raster/render.h"
#include "techniques/convex_culling/convex_approximation.h"
#include "techniques/world.h"

namespace lode::experiments {

/// What follows a model's name in the names of its pictures.
inline constexpr const char *kHullsPicture = ".hulls.png", *kBoxesPicture = ".boxes.png";

/// FILE: the model, then the hulls of each level, side by side, as seen from one side and above; no file for a model
/// without positions. Throws Error as WholeFile does.
void write_hulls_picture(const std::string& file, const techniques::Shape& model,
                         const techniques::convex_culling::ConvexApproximation& approximation,
                         const raster::RenderOptions& options);

/// FILE: the model and its inner boxes (geometry/inner_boxes.h), side by side.
void write_boxes_picture(const std::string& file, const techniques::Shape& model, const raster::RenderOptions& options);

}  // namespace lode::experiments

#pragma once
/// The picture that a view's pictures are held against: the whole scene, supersampled, in linear colours. Kept from run
/// to run.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/harness/kept_results.h"
#include "raster/render.h"
#include "techniques/technique.h"
#include "techniques/world.h"

namespace lode::experiments {

/// A regular grid of 8 × 8 samples in every pixel, averaged.
inline constexpr int kTrueSamplesPerAxis = 8;

/// [w·h] linear premultiplied colours over a background of transparent black.
using TruePicture = std::vector<glm::vec4>;

/// Draws it, or takes it from `kept`. Deterministic.
///   look     hash of everything that the scene's colours depend on (look_hash_of)
/// Throws std::logic_error for a world of raw colours; what raster::render and KeptResults throw.
[[nodiscard]] TruePicture true_picture(const techniques::World& world, std::string_view look,
                                       const techniques::View& view, const raster::RenderOptions& options,
                                       const KeptResults& kept);

}  // namespace lode::experiments

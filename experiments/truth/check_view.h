#pragma once
/// One view of a scene by raster and by rays, compared pixel by pixel.

#include <cmath>
#include <cstdint>
#include <functional>

#include "experiments/truth/check_picture.h"
#include "experiments/truth/solid_draws.h"
#include "experiments/truth/visible_edges.h"
#include "geometry/camera.h"
#include "geometry/scene.h"
#include "raster/render.h"
#include "techniques/scene_draws.h"

namespace lode::experiments::truth {

struct ViewCheck {
  PictureCheck picture;
  LeftOut left_out;
  VisibleEdges edges;  ///< as far as it took to show the bound, see visible_edges.h

  /// At most this many samples are expected to be explained by edge: 2δ × visible edge length. It holds for the whole
  /// number that it is rounded up to.
  [[nodiscard]] double edge_bound() const { return kEdgeBand_px * edges.length_px; }
  [[nodiscard]] bool edge_bound_holds() const { return double(picture.of(Verdict::edge)) <= std::ceil(edge_bound()); }
};

/// Renders, as the options say, traces with as many threads, and compares. `on_pixels`, if given, is called from any
/// thread with numbers that sum up to w·h, as parts of the work are done. Throws raster::Error, geometry::Error
/// (machine).
[[nodiscard]] ViewCheck check_view(const techniques::SceneDraws& draws, const geometry::Camera& camera,
                                   const geometry::Bounds& bounds, glm::ivec2 size_px,
                                   const raster::RenderOptions& options,
                                   const std::function<void(std::uint64_t)>& on_pixels = {});

}  // namespace lode::experiments::truth

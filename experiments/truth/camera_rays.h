#pragma once
/// The rays of a camera against the triangles of draws: whose surface is nearest at any point of the picture.
///
/// Rays live in camera space moved along the view to where the scene begins, so that floats resolve the scene as finely
/// from a thousand diagonals away, or far from the world's origin, as from nearby.

#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <vector>

#include "geometry/bounds.h"
#include "geometry/camera.h"
#include "geometry/ray_query.h"
#include "raster/frame.h"
#include "raster/image.h"

namespace lode::experiments::truth {

/// A draw of triangles (ObjectVertices, with a draw_id) and where it stands. It is culled as the draw says.
struct TracedDraw {
  const raster::Draw* draw = nullptr;
  glm::dmat4 world_from_object{1.0};
  std::uint32_t mask = 1;
};

class CameraRays {
 public:
  /// Builds the tree. `bounds` are the scene's, in the world. Throws geometry::Error (machine).
  CameraRays(std::span<const TracedDraw> draws, const geometry::Camera& camera, glm::ivec2 size_px,
             const geometry::Bounds& bounds, const std::function<void(double)>& progress = {});

  /// The ray through a point of the target (pixel centres are at ½), between near and far.
  [[nodiscard]] geometry::Ray ray(glm::dvec2 p_px, std::uint32_t mask = ~0u) const;

  [[nodiscard]] const geometry::RayScene& scene() const { return *scene_; }
  [[nodiscard]] raster::Ids ids(const geometry::RayHit& hit) const { return {draw_ids_[hit.instance], hit.primitive}; }
  /// Of the nearest hit, or kNoId twice.
  [[nodiscard]] raster::Ids nearest(glm::dvec2 p_px) const;

 private:
  geometry::Camera camera_;
  glm::ivec2 size_px_;
  double start_ = 0.0;  ///< view distance at which t = 0
  double scale_ = 1.0;  ///< query space is camera space times this
  std::vector<std::uint32_t> draw_ids_;
  std::optional<geometry::RayScene> scene_;
};

/// The nearest at every pixel's centre, [w·h]. `on_row`, if given, is called for each row done, from any thread.
[[nodiscard]] std::vector<raster::Ids> trace_ids(const CameraRays& rays, glm::ivec2 size_px, int threads,
                                                 const std::function<void()>& on_row = {});

}  // namespace lode::experiments::truth

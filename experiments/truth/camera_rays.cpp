#include "experiments/truth/camera_rays.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "raster/parallel.h"

namespace lode::experiments::truth {
namespace {

/// A view distance just before the box's nearest corner, not behind the eye of a perspective view.
double start_of(const geometry::Camera& camera, const geometry::Bounds& bounds) {
  if (bounds.empty()) return 0.0;
  const glm::dmat4 m = geometry::camera_from_world(camera);
  double nearest = HUGE_VAL;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 p(corner & 1 ? bounds.high.x : bounds.low.x, corner & 2 ? bounds.high.y : bounds.low.y,
                       corner & 4 ? bounds.high.z : bounds.low.z);
    nearest = std::min(nearest, -(m * glm::dvec4(p, 1.0)).z);
  }
  nearest -= bounds.diagonal() / 1024.0;  // room for the rounding to floats: nothing lies before t = 0
  return camera.projection == geometry::Projection::perspective ? std::max(nearest, 0.0) : nearest;
}

geometry::RayCull ray_cull(raster::Cull cull) {
  switch (cull) {
    case raster::Cull::back:
      return geometry::RayCull::back;
    case raster::Cull::front:
      return geometry::RayCull::front;
    default:
      return geometry::RayCull::none;
  }
}

/// A power of two that brings the farthest corner of the box to about 1: the ray tracer squares floats.
double scale_of(const glm::dmat4& m, const geometry::Bounds& bounds) {
  if (bounds.empty()) return 1.0;
  double farthest = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 p(corner & 1 ? bounds.high.x : bounds.low.x, corner & 2 ? bounds.high.y : bounds.low.y,
                       corner & 4 ? bounds.high.z : bounds.low.z);
    const glm::dvec4 q = m * glm::dvec4(p, 1.0);
    farthest = std::max({farthest, std::abs(q.x), std::abs(q.y), std::abs(q.z)});
  }
  if (!(farthest > 0.0) || !std::isfinite(farthest)) return 1.0;
  int exponent = 0;
  static_cast<void>(std::frexp(farthest, &exponent));
  return std::ldexp(1.0, std::clamp(-exponent, -1000, 1000));
}

}  // namespace

CameraRays::CameraRays(std::span<const TracedDraw> draws, const geometry::Camera& camera, glm::ivec2 size_px,
                       const geometry::Bounds& bounds, const std::function<void(double)>& progress)
    : camera_(camera), size_px_(size_px), start_(start_of(camera, bounds)) {
  glm::dmat4 query_from_world = geometry::camera_from_world(camera);
  query_from_world[3][2] += start_;  // z runs back, so that the plane at view distance `start` comes to z = 0
  scale_ = scale_of(query_from_world, bounds);
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 3; ++row) query_from_world[column][row] *= scale_;
  }
  std::vector<geometry::RayInstance> instances;
  for (const TracedDraw& traced : draws) {
    const auto& vertices = std::get<raster::ObjectVertices>(traced.draw->vertices);
    instances.push_back({vertices.positions, traced.draw->indices.value(), query_from_world * traced.world_from_object,
                         ray_cull(traced.draw->cull), traced.mask});
    draw_ids_.push_back(traced.draw->draw_id.value());
  }
  scene_.emplace(instances, progress);
}

geometry::Ray CameraRays::ray(glm::dvec2 p_px, std::uint32_t mask) const {
  const geometry::ViewRay view = geometry::view_ray(camera_, size_px_, p_px);
  glm::dvec3 origin = view.origin + start_ * view.direction;
  origin.z += start_;
  const auto in_float = [&](double t) {
    return std::isinf(t) ? HUGE_VALF : float(std::clamp(scale_ * t, -3e38, 3e38));
  };
  return {.origin = glm::vec3(glm::clamp(scale_ * origin, -3e38, 3e38)),
          .direction = glm::vec3(glm::clamp(view.direction, -3e38, 3e38)),
          .t_near = in_float(std::max(camera_.near - start_, 0.0)),
          .t_far = in_float(camera_.far - start_),
          .mask = mask};
}

raster::Ids CameraRays::nearest(glm::dvec2 p_px) const {
  const std::optional<geometry::RayHit> hit = scene_->nearest(ray(p_px));
  return hit ? ids(*hit) : raster::Ids{raster::kNoId, raster::kNoId};
}

std::vector<raster::Ids> trace_ids(const CameraRays& rays, glm::ivec2 size_px, int threads,
                                   const std::function<void()>& on_row) {
  std::vector<raster::Ids> all(std::size_t(size_px.x) * std::size_t(size_px.y));
  raster::parallel_for(std::size_t(size_px.y), raster::worker_count(threads), [&](std::size_t y, int) {
    for (int x = 0; x < size_px.x; ++x) {
      all[y * std::size_t(size_px.x) + std::size_t(x)] = rays.nearest({x + 0.5, double(y) + 0.5});
    }
    if (on_row) on_row();
  });
  return all;
}

}  // namespace lode::experiments::truth

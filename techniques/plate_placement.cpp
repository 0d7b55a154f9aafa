#include "techniques/plate_placement.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "techniques/screen_box.h"

namespace lode::techniques {

std::optional<raster::Rect> capture_window(const View& view, const geometry::Bounds& box) {
  const glm::dmat4 clip_from_world = geometry::clip_from_world(view.camera, view.size_px);
  const std::optional<ScreenBox> seen = whole_screen_box(clip_from_world, view.size_px, box);
  if (!seen || seen->empty()) return std::nullopt;
  return raster::Rect{seen->first_px - 1, seen->last_px - seen->first_px + 3};
}

bool plane_in_view(const View& view, const glm::dvec3& point) {
  constexpr double kMargin = 0x1p-30;  // of the distance: corners are rounded
  const double distance = glm::dot(view.camera.eye - point, view.camera.back), margin = kMargin * std::abs(distance);
  return distance - margin > view.camera.near && distance + margin < view.camera.far;
}

glm::dvec2 pixel_size_at(const View& view, const glm::dvec3& point) {
  const geometry::Camera& camera = view.camera;
  const glm::dvec2 size = 2.0 * geometry::half_extent(camera, view.size_px) / glm::dvec2(view.size_px);
  if (camera.projection == geometry::Projection::orthographic) return size;
  return size * glm::dot(camera.eye - point, camera.back);
}

PlateSides plate_sides(const View& view, const glm::dvec3& centre, const raster::Rect& window_px,
                       PlatePlacement placement) {
  const glm::dvec2 pixel = pixel_size_at(view, centre);
  const glm::dvec3 from_eye = centre - view.camera.eye;
  const glm::dvec2 centre_px =
      0.5 * glm::dvec2(view.size_px) +
      glm::dvec2(glm::dot(from_eye, view.camera.right), -glm::dot(from_eye, view.camera.up)) / pixel;
  const glm::dvec2 size(window_px.size_px);
  const glm::dvec2 first =
      placement == PlatePlacement::literal ? -0.5 * size : glm::dvec2(window_px.origin_px) - centre_px;
  return {.left = first.x * pixel.x,
          .top = first.y * pixel.y,
          .right = (first.x + size.x) * pixel.x,
          .bottom = (first.y + size.y) * pixel.y,
          .pixel = pixel.x};
}

std::array<glm::dvec3, 4> plate_corners(const View& view, const glm::dvec3& centre, const PlateSides& sides) {
  const auto corner = [&](double x, double y) { return centre + view.camera.right * x - view.camera.up * y; };
  return {corner(sides.left, sides.top), corner(sides.left, sides.bottom), corner(sides.right, sides.bottom),
          corner(sides.right, sides.top)};
}

}  // namespace lode::techniques

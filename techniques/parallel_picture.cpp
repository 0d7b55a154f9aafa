#include "techniques/parallel_picture.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace lode::techniques {

std::optional<ParallelPicture> parallel_picture(const geometry::Bounds& box, const glm::dvec3& direction, int texels) {
  if (box.empty()) return std::nullopt;
  ParallelPicture picture;
  geometry::Camera& camera = picture.camera;
  geometry::look_at(camera, direction, glm::dvec3(0.0));
  camera.eye = box.centre();
  camera.projection = geometry::Projection::orthographic;
  const glm::dvec3 half = 0.5 * box.high - 0.5 * box.low;
  const glm::dvec2 outline(glm::dot(glm::abs(camera.right), half), glm::dot(glm::abs(camera.up), half));
  const double texel = 2.0 * std::max(outline.x, outline.y) / texels;
  if (!(texel > 0.0) || !std::isfinite(texel)) return std::nullopt;
  const auto n_texels = [&](double outline_half) {
    return std::clamp(int(std::ceil(2.0 * outline_half / texel)), 1, texels);
  };
  picture.size_px = {n_texels(outline.x), n_texels(outline.y)};
  picture.half_extent = 0.5 * texel * glm::dvec2(picture.size_px);
  camera.height = 2.0 * picture.half_extent.y;
  // A little more than the box, so that no corner of it has depth 0, which stands for nothing.
  camera.far = (0.5 + 0x1p-8) * box.diagonal();
  camera.near = -camera.far;
  return picture;
}

glm::dvec3 towards_viewer(const View& view, const glm::dvec3& point) {
  return view.camera.projection == geometry::Projection::orthographic ? view.camera.back : view.camera.eye - point;
}

bool beyond_near_plane(const View& view, const glm::dvec3& point, double reach) {
  return glm::dot(view.camera.eye - point, view.camera.back) - reach > view.camera.near;
}

}  // namespace lode::techniques

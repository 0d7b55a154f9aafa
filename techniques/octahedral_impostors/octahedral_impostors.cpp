#include "techniques/octahedral_impostors/octahedral_impostors.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "techniques/objects_in_view.h"
#include "techniques/octahedral_impostors/blended_views.h"
#include "techniques/octahedral_impostors/hemi_octahedron.h"
#include "techniques/parallel_picture.h"
#include "techniques/plate_placement.h"

namespace lode::techniques {
namespace {

/// The plate that covers a box: in the plane through its centre that is parallel to the view's picture, the rectangle
/// around its corners as they are seen.
PlateSides covering_sides(const View& view, const geometry::Bounds& box) {
  const geometry::Camera& camera = view.camera;
  const bool perspective = camera.projection == geometry::Projection::perspective;
  const glm::dvec3 from_eye = box.centre() - camera.eye;
  const glm::dvec2 centre(glm::dot(from_eye, camera.right), glm::dot(from_eye, camera.up));
  const double distance = -glm::dot(from_eye, camera.back);
  glm::dvec2 low(1e300), high(-1e300);
  for (int k = 0; k < 8; ++k) {
    const glm::dvec3 corner(k & 1 ? box.high.x : box.low.x, k & 2 ? box.high.y : box.low.y,
                            k & 4 ? box.high.z : box.low.z);
    const glm::dvec3 p = corner - camera.eye;
    const double growth = perspective ? distance / -glm::dot(p, camera.back) : 1.0;
    const glm::dvec2 seen = growth * glm::dvec2(glm::dot(p, camera.right), glm::dot(p, camera.up)) - centre;
    low = glm::min(low, seen), high = glm::max(high, seen);
  }
  return {
      .left = low.x, .top = -high.y, .right = high.x, .bottom = -low.y, .pixel = pixel_size_at(view, box.centre()).x};
}

/// Not so far below the horizon, 30°, that its pictures would be seen too obliquely.
bool near_the_hemisphere(const glm::dvec3& towards_viewer) {
  return towards_viewer.y >= -0.5 * glm::length(towards_viewer);
}

/// Texels of a picture that a pixel of the view spans.
double texels_a_pixel(const CapturedPicture& picture, double pixel) {
  return pixel / (picture.camera.height / picture.size_px().y);
}

}  // namespace

void OctahedralImpostors::prepare(Stage& stage) {
  pictures_.assign(stage.world().objects().size(), {});
  picture_bytes_ = 0;
  for (ObjectId id = 0; id < pictures_.size(); ++id) {
    if (!take(id, stage)) pictures_[id].clear();
  }
}

/// Whether the object has an extent from everywhere, and its pictures have room.
bool OctahedralImpostors::take(ObjectId id, Stage& stage) {
  std::vector<ParallelPicture> wanted;
  std::uint64_t bytes = 0;
  for (int k = 0; k < params_.grid * params_.grid; ++k) {
    const glm::dvec3 direction = grid_direction({k % params_.grid, k / params_.grid}, params_.grid);
    const auto picture = parallel_picture(stage.world().objects()[id].bounds, direction, params_.texels);
    if (!picture) return false;
    wanted.push_back(*picture);
    bytes += captured_bytes(picture->size_px);
  }
  if (params_.most_bytes > 0 && picture_bytes_ + bytes > params_.most_bytes) return false;
  for (const ParallelPicture& picture : wanted) {
    pictures_[id].push_back(stage.capture({&id, 1}, picture.camera, picture.size_px));
  }
  picture_bytes_ += bytes;
  return true;
}

Counters OctahedralImpostors::draw(const View& view, Stage& stage) {
  std::uint64_t near = 0, unfit = 0, shown = 0;
  blended_ = 0;
  const std::vector<ObjectId> in_view = objects_in_view(stage.world(), view);
  for (const ObjectId id : in_view) {
    const geometry::Bounds& box = stage.world().objects()[id].bounds;
    const bool fits = !pictures_[id].empty() && plane_in_view(view, box.centre()) &&
                      beyond_near_plane(view, box.centre(), 0.5 * box.diagonal()) &&
                      near_the_hemisphere(towards_viewer(view, box.centre()));
    if (!params_.far.is_far(view, box)) {
      ++near;
      stage.object(id);
    } else if (!fits) {
      ++unfit;
      stage.object(id);
    } else {
      ++shown;
      show(view, id, stage);
    }
  }
  return {
      {"objects_in_view", in_view.size()}, {"near", near}, {"unfit", unfit}, {"shown", shown}, {"blended", blended_},
      {"picture_bytes", picture_bytes_}};
}

void OctahedralImpostors::show(const View& view, ObjectId id, Stage& stage) {
  const geometry::Bounds& box = stage.world().objects()[id].bounds;
  const glm::dvec3 centre = box.centre();
  const PlateSides sides = covering_sides(view, box);
  const std::array<glm::dvec3, 4> corners = plate_corners(view, centre, sides);
  const PlateRays plate{.corner = corners[0] - centre,
                        .along_u = corners[3] - corners[0],
                        .along_v = corners[1] - corners[0],
                        .eye = view.camera.eye - centre,
                        .direction = -view.camera.back,
                        .parallel = view.camera.projection == geometry::Projection::orthographic};
  GridTriangle triangle = grid_triangle(towards_viewer(view, centre), params_.grid);
  if (params_.blend == ViewBlend::nearest) {
    const auto nearest = std::max_element(triangle.weights.begin(), triangle.weights.end()) - triangle.weights.begin();
    triangle.weights = {};
    triangle.weights[std::size_t(nearest)] = 1.0;
  }
  std::array<WeightedView, 3> views;
  for (std::size_t k = 0; k < 3; ++k) {
    if (!(triangle.weights[k] > 0.0)) continue;
    const glm::ivec2 node = triangle.nodes[k];
    const CapturedPicture& picture = stage.picture(pictures_[id][std::size_t(node.y * params_.grid + node.x)]);
    views[k] = {&picture, triangle.weights[k], texels_a_pixel(picture, sides.pixel)};
    ++blended_;
  }
  stage.plate(id, corners, blended_views(plate, views, params_.parallax, stage.render_options().target));
}

}  // namespace lode::techniques

#include "techniques/twelve_views/twelve_views.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "geometry/trigonometry.h"
#include "techniques/objects_in_view.h"
#include "techniques/parallel_picture.h"

namespace lode::techniques {
namespace {

constexpr double kDegree = geometry::kPi / 180.0;

/// On the vertical plane through the box's centre, each point where the picture's own parallel rays meet it.
std::array<glm::dvec3, 4> upright_corners(const ParallelPicture& picture) {
  const glm::dvec3 right = picture.half_extent.x * picture.camera.right;
  const glm::dvec3 up(0.0, picture.half_extent.y / picture.camera.up.y, 0.0);
  return {up - right, -up - right, right - up, right + up};
}

}  // namespace

glm::dvec3 twelve_views_direction(int k, double elevation_deg) {
  const geometry::SinCos turn = geometry::sin_cos(30.0 * kDegree * k);
  const geometry::SinCos rise = geometry::sin_cos(elevation_deg * kDegree);
  return {turn.sin * rise.cos, rise.sin, turn.cos * rise.cos};
}

int nearest_of_twelve(const glm::dvec3& towards_eye) {
  int nearest = 0;
  double largest = -1e300;
  for (int k = 0; k < kTwelve; ++k) {
    const glm::dvec3 direction = twelve_views_direction(k, 0.0);
    const double along = towards_eye.x * direction.x + towards_eye.z * direction.z;
    if (along > largest) nearest = k, largest = along;
  }
  return nearest;
}

void TwelveViews::prepare(Stage& stage) {
  views_.assign(stage.world().objects().size(), std::nullopt);
  picture_bytes_ = 0;
  for (ObjectId id = 0; id < views_.size(); ++id) views_[id] = take(id, stage);
}

std::optional<TwelveViews::Views> TwelveViews::take(ObjectId id, Stage& stage) {
  std::array<std::optional<ParallelPicture>, kTwelve> wanted;
  std::uint64_t bytes = 0;
  for (int k = 0; k < kTwelve; ++k) {
    const glm::dvec3 direction = twelve_views_direction(k, params_.elevation_deg);
    wanted[std::size_t(k)] = parallel_picture(stage.world().objects()[id].bounds, direction, params_.texels);
    if (!wanted[std::size_t(k)]) return std::nullopt;
    bytes += captured_bytes(wanted[std::size_t(k)]->size_px);
  }
  if (params_.most_bytes > 0 && picture_bytes_ + bytes > params_.most_bytes) return std::nullopt;
  Views views;
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    const ParallelPicture& picture = *wanted[k];
    views.plates[k] = {.picture = stage.capture({&id, 1}, picture.camera, picture.size_px),
                       .corners = upright_corners(picture)};
    views.reach = std::max(views.reach, glm::length(views.plates[k].corners[0]));
  }
  picture_bytes_ += bytes;
  return views;
}

Counters TwelveViews::draw(const View& view, Stage& stage) {
  std::uint64_t near = 0, unfit = 0, shown = 0;
  const std::vector<ObjectId> in_view = objects_in_view(stage.world(), view);
  for (const ObjectId id : in_view) {
    const geometry::Bounds& box = stage.world().objects()[id].bounds;
    const glm::dvec3 centre = box.centre();
    if (!params_.far.is_far(view, box)) {
      ++near;
      stage.object(id);
    } else if (!views_[id] || !beyond_near_plane(view, centre, views_[id]->reach)) {
      ++unfit;
      stage.object(id);
    } else {
      ++shown;
      const Plate& plate = views_[id]->plates[std::size_t(nearest_of_twelve(towards_viewer(view, centre)))];
      std::array<glm::dvec3, 4> corners = plate.corners;
      for (glm::dvec3& corner : corners) corner += centre;
      stage.plate(id, plate.picture, corners, PlateEdge::cutout);
    }
  }
  return {{"objects_in_view", in_view.size()},
          {"near", near},
          {"unfit", unfit},
          {"shown", shown},
          {"picture_bytes", picture_bytes_}};
}

}  // namespace lode::techniques

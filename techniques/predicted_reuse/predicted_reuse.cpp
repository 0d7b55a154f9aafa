#include "techniques/predicted_reuse/predicted_reuse.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <utility>

#include "techniques/objects_in_view.h"
#include "techniques/predicted_reuse/relief.h"

namespace lode::techniques {
namespace {

constexpr double kNoPicture = 1e300;  ///< px: worse than any error

}  // namespace

double predicted_error_px(const View& view, const geometry::Bounds& box, const glm::dvec3& eye, double pixel) {
  const glm::dvec3 centre = box.centre(), then = eye - centre, now = view.camera.eye - centre;
  const double pixel_now = pixel_size_at(view, centre).x;
  const double lengths = glm::length(then) * glm::length(now);
  if (!(lengths > 0.0) || !(pixel_now > 0.0)) return kNoPicture;
  const double sine = glm::dot(then, now) > 0.0 ? glm::length(glm::cross(then, now)) / lengths : 1.0;
  const glm::dvec3 direction = glm::abs(now) / glm::length(now);
  const double reach = glm::dot(direction, 0.5 * (box.high - box.low));
  return reach * sine / pixel_now + 0.5 * std::max(pixel / pixel_now - 1.0, 0.0);
}

void PredictedReuse::prepare(Stage& stage) {
  const std::size_t n = stage.world().objects().size();
  pictures_.reset(2 * n);
  poses_.assign(n, {});
  fading_.assign(n, {});
  forget_ = false;
}

Counters PredictedReuse::draw(const View& view, Stage& stage) {
  pictures_.begin_frame();
  ++frame_;
  work_ = {};
  wanted_.clear();
  if (forget_) pictures_.drop_all(stage);
  forget_ = false;
  const std::vector<ObjectId> in_view = objects_in_view(stage.world(), view);
  for (const ObjectId id : in_view) look_at(view, id, stage);
  std::stable_sort(wanted_.begin(), wanted_.end(),
                   [](const Wanted& a, const Wanted& b) { return a.error_px > b.error_px; });
  {
    const auto timer = stage.time("capture");
    for (const Wanted& wanted : wanted_) capture(view, wanted, stage);
  }
  return {{"objects_in_view", in_view.size()},
          {"near", work_.near},
          {"reused", work_.reused},
          {"captured", work_.captured},
          {"late", work_.late},
          {"postponed", work_.postponed},
          {"unfit", work_.unfit},
          {"faded", work_.faded},
          {"evicted", pictures_.evicted()},
          {"picture_bytes", pictures_.bytes()},
          {"relief_triangles", work_.relief_triangles}};
}

/// Draws the object, shows its picture, or puts it among those that want a new one.
void PredictedReuse::look_at(const View& view, ObjectId id, Stage& stage) {
  const geometry::Bounds& box = stage.world().objects()[id].bounds;
  const glm::dvec3 centre = box.centre();
  if (!params_.far.is_far(view, box)) {
    ++work_.near;
    return stage.object(id);
  }
  const bool plane_is_seen = plane_in_view(view, centre);
  double error_px = kNoPicture;
  if (pictures_.find(id) && plane_is_seen) {
    error_px = predicted_error_px(view, box, poses_[id].eye, poses_[id].pixel);
    if (error_px < params_.error_px) {
      ++work_.reused;
      return show(view, id, stage);
    }
  }
  const std::optional<raster::Rect> window_px = plane_is_seen ? capture_window(view, box) : std::nullopt;
  if (!window_px || !worth_capturing(view, *window_px)) {
    ++work_.unfit;
    return stage.object(id);
  }
  wanted_.push_back({id, error_px, *window_px});
}

/// Takes a new picture and shows it; shows the old one, or the object, where that may not be.
void PredictedReuse::capture(const View& view, const Wanted& wanted, Stage& stage) {
  const ObjectId id = wanted.object;
  if (params_.most_captures > 0 && work_.captured == std::uint64_t(params_.most_captures)) {
    const bool has_picture = pictures_.find(id).has_value();
    ++(has_picture ? work_.late : work_.postponed);
    return has_picture ? show(view, id, stage) : stage.object(id);
  }
  retire(view, id, stage);
  const std::uint64_t bytes =
      captured_bytes(wanted.window_px.size_px) + most_relief_bytes(wanted.window_px.size_px, params_.cell_px);
  if (!pictures_.make_room(bytes, stage)) {
    ++work_.unfit;
    return stage.object(id);
  }
  const std::vector<ObjectId> alone = {id};
  const glm::dvec3 centre = stage.world().objects()[id].bounds.centre();
  const PictureId picture = stage.capture_covered(alone, view, wanted.window_px);
  const raster::Rect window_px = stage.picture(picture).window_px();
  const PlateSides sides = plate_sides(view, centre, window_px, PlatePlacement::corrected);
  pictures_.keep(id, picture,
                 captured_bytes(window_px.size_px) + most_relief_bytes(window_px.size_px, params_.cell_px));
  poses_[id] = {.eye = view.camera.eye, .pixel = sides.pixel, .corners_world = plate_corners(view, centre, sides)};
  if (params_.cell_px > 0) {
    poses_[id].relief =
        std::make_shared<const PictureRelief>(make_relief(stage.picture(picture), centre, params_.cell_px));
  }
  ++work_.captured;
  show(view, id, stage);
}

bool PredictedReuse::may_fade(const View& view, ObjectId id, Stage& stage) const {
  const Fading& fading = fading_[id];
  if (!pictures_.find(old_place(id)) || fading.last_seen + 1 != frame_) return false;
  const double error_px =
      predicted_error_px(view, stage.world().objects()[id].bounds, fading.pose.eye, fading.pose.pixel);
  return error_px <= kMostFadingErrors * params_.error_px;
}

void PredictedReuse::retire(const View& view, ObjectId id, Stage& stage) {
  if (may_fade(view, id, stage)) return pictures_.drop(id, stage);  // the fade goes on, to the newest picture
  pictures_.drop(old_place(id), stage);
  if (params_.fade_frames == 0 || !pictures_.find(id)) return pictures_.drop(id, stage);
  pictures_.move(id, old_place(id));
  fading_[id] = {.pose = std::move(poses_[id]), .last_seen = frame_ - 1};
}

void PredictedReuse::show(const View& view, ObjectId id, Stage& stage) {
  std::uint16_t pixels = kEveryPixel;
  if (may_fade(view, id, stage)) {
    Fading& fading = fading_[id];
    fading.last_seen = frame_;
    const int frames = params_.fade_frames + 1;
    pixels = dithered_pixels((16 * ++fading.step + frames - 1) / frames);
    if (pixels != kEveryPixel) {
      ++work_.faded;
      show(id, old_place(id), fading.pose, std::uint16_t(~pixels), stage);
    }
  }
  if (pixels == kEveryPixel) pictures_.drop(old_place(id), stage);
  show(id, id, poses_[id], pixels, stage);
}

void PredictedReuse::show(ObjectId id, std::size_t place, const Pose& pose, std::uint16_t pixels, Stage& stage) {
  pictures_.show(place);
  const PictureId picture = *pictures_.find(place);
  if (!pose.relief) return stage.plate(id, picture, pose.corners_world, PlateEdge::cutout, pixels);
  work_.relief_triangles += pose.relief->indices.size() / 3;
  stage.relief(id, picture, stage.world().objects()[id].bounds.centre(), pose.relief, PlateEdge::cutout, pixels);
}

}  // namespace lode::techniques

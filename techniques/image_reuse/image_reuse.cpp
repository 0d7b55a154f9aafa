#include "techniques/image_reuse/image_reuse.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "techniques/objects_in_view.h"

namespace lode::techniques {
namespace {

constexpr double kNoPicture = 1e300;  ///< turned by more than any angle

bool lies_within(const raster::Rect& window_px, glm::ivec2 size_px) {
  return window_px.origin_px.x >= 0 && window_px.origin_px.y >= 0 &&
         window_px.origin_px.x + window_px.size_px.x <= size_px.x &&
         window_px.origin_px.y + window_px.size_px.y <= size_px.y;
}

}  // namespace

ImageReuse::ImageReuse(const Params& params)
    : params_(params), threshold_(angle_measure(params.threshold_deg)), pictures_(params.most_bytes) {}

void ImageReuse::prepare(Stage& stage) {
  pictures_.reset(stage.world().objects().size());
  plates_.assign(stage.world().objects().size(), {});
  forget_ = false;
}

Counters ImageReuse::draw(const View& view, Stage& stage) {
  pictures_.begin_frame();
  work_ = {};
  wanted_.clear();
  if (forget_) pictures_.drop_all(stage);
  forget_ = false;
  in_view_ = objects_in_view(stage.world(), view);
  for (const ObjectId id : in_view_) look_at(view, id, stage);

  std::stable_sort(wanted_.begin(), wanted_.end(),
                   [](const Wanted& a, const Wanted& b) { return a.turned > b.turned; });
  {
    const auto timer = stage.time("capture");
    for (const Wanted& wanted : wanted_) capture(view, wanted, stage);
  }
  return {{"objects_in_view", in_view_.size()},  {"near", work_.near},           {"reused", work_.reused},
          {"captured", work_.captured},          {"postponed", work_.postponed}, {"unfit", work_.unfit},
          {"evicted", pictures_.evicted()},      {"picture_bytes", pictures_.bytes()}};
}

/// Draws the object, shows its picture, or puts it among those that want a new one.
void ImageReuse::look_at(const View& view, ObjectId id, Stage& stage) {
  const geometry::Bounds& box = stage.world().objects()[id].bounds;
  const glm::dvec3 centre = box.centre();
  if (!params_.far.is_far(view, box)) {
    ++work_.near;
    return stage.object(id);
  }
  const bool plate_is_seen = plane_in_view(view, centre);
  const glm::dvec3 direction = viewing_direction(centre, view.camera.eye, params_.angle);
  double turned = kNoPicture;
  if (pictures_.find(id) && plate_is_seen) {
    const Plate& plate = plates_[id];
    turned = angle_measure(plate.direction, direction);
    const bool grown =
        params_.magnification > 0.0 && plate.sides.pixel > params_.magnification * pixel_size_at(view, centre).x;
    if (!grown && (turned < threshold_ || params_.threshold_deg >= 180.0)) {
      ++work_.reused;
      return show(view, id, stage);
    }
  }
  const std::optional<raster::Rect> window_px = capture_window(view, box);
  // What the screen's edge cuts, the paper's copy of the frame buffer does not have.
  const bool fits = plate_is_seen && window_px && worth_capturing(view, *window_px) &&
                    (params_.placement == PlatePlacement::corrected || lies_within(*window_px, view.size_px));
  if (!fits) {
    ++work_.unfit;
    return stage.object(id);
  }
  wanted_.push_back({id, turned, *window_px});
}

/// Takes a new picture and shows it; shows the old one, or the object, where that may not be.
void ImageReuse::capture(const View& view, const Wanted& wanted, Stage& stage) {
  const ObjectId id = wanted.object;
  if (params_.most_captures > 0 && work_.captured == std::uint64_t(params_.most_captures)) {
    ++work_.postponed;
    return pictures_.find(id) ? show(view, id, stage) : stage.object(id);
  }
  pictures_.drop(id, stage);
  const std::uint64_t bytes = captured_bytes(wanted.window_px.size_px);
  if (!pictures_.make_room(bytes, stage)) {
    ++work_.unfit;
    return stage.object(id);
  }
  const bool literal = params_.placement == PlatePlacement::literal;
  const std::vector<ObjectId> alone = {id};
  const glm::dvec3 centre = stage.world().objects()[id].bounds.centre();
  const PictureId picture = literal ? stage.capture(in_view_, view, wanted.window_px, view.background)
                                    : stage.capture_covered(alone, view, wanted.window_px);
  const raster::Rect window_px = stage.picture(picture).window_px();
  pictures_.keep(id, picture, captured_bytes(window_px.size_px));
  plates_[id] = {.direction = viewing_direction(centre, view.camera.eye, params_.angle),
                 .sides = plate_sides(view, centre, window_px, params_.placement)};
  ++work_.captured;
  if (literal) return stage.object(id);  // the frame whose pixels are copied
  show(view, id, stage);
}

void ImageReuse::show(const View& view, ObjectId id, Stage& stage) {
  pictures_.show(id);
  stage.plate(id, *pictures_.find(id),
              plate_corners(view, stage.world().objects()[id].bounds.centre(), plates_[id].sides), PlateEdge::cutout);
}

}  // namespace lode::techniques

#include "techniques/image_reuse/image_reuse.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "techniques/objects_in_view.h"

namespace lode::techniques {
namespace {

constexpr int kMostSide_px = 16384;   ///< of a picture
constexpr double kNoPicture = 1e300;  ///< turned by more than any angle

bool lies_within(const raster::Rect& window_px, glm::ivec2 size_px) {
  return window_px.origin_px.x >= 0 && window_px.origin_px.y >= 0 &&
         window_px.origin_px.x + window_px.size_px.x <= size_px.x &&
         window_px.origin_px.y + window_px.size_px.y <= size_px.y;
}

/// Of the picture of a window: colours with mips, and depth.
std::uint64_t bytes_of(glm::ivec2 size_px) {
  std::uint64_t n = std::uint64_t(size_px.x) * std::uint64_t(size_px.y) * sizeof(float);
  for (glm::ivec2 level = size_px;; level = glm::max(level / 2, glm::ivec2(1))) {
    n += std::uint64_t(level.x) * std::uint64_t(level.y) * sizeof(glm::vec4);
    if (level == glm::ivec2(1)) return n;
  }
}

}  // namespace

ImageReuse::ImageReuse(const Params& params) : params_(params), threshold_(angle_measure(params.threshold_deg)) {}

void ImageReuse::prepare(Stage& stage) {
  kept_.assign(stage.world().objects().size(), std::nullopt);
  frame_ = bytes_ = 0;
  forget_ = false;
}

Counters ImageReuse::draw(const View& view, Stage& stage) {
  ++frame_;
  work_ = {};
  wanted_.clear();
  if (forget_) {
    for (ObjectId id = 0; id < kept_.size(); ++id) drop(id, stage);
    forget_ = false;
  }
  in_view_ = objects_in_view(stage.world(), view);
  for (const ObjectId id : in_view_) look_at(view, id, stage);

  std::stable_sort(wanted_.begin(), wanted_.end(),
                   [](const Wanted& a, const Wanted& b) { return a.turned > b.turned; });
  {
    const auto timer = stage.time("capture");
    for (const Wanted& wanted : wanted_) capture(view, wanted, stage);
  }
  return {{"objects_in_view", in_view_.size()}, {"near", work_.near},           {"reused", work_.reused},
          {"captured", work_.captured},         {"postponed", work_.postponed}, {"unfit", work_.unfit},
          {"evicted", work_.evicted},           {"picture_bytes", bytes_}};
}

/// Draws the object, shows its picture, or puts it among those that want a new one.
void ImageReuse::look_at(const View& view, ObjectId id, Stage& stage) {
  const geometry::Bounds& box = stage.world().objects()[id].bounds;
  const glm::dvec3 centre = box.centre();
  const double distance = glm::distance(centre, view.camera.eye);
  if (!(distance >= std::max(params_.near_distance, params_.near_radii * 0.5 * box.diagonal()))) {
    ++work_.near;
    return stage.object(id);
  }
  const bool plate_is_seen = plane_in_view(view, centre);
  const glm::dvec3 direction = viewing_direction(centre, view.camera.eye, params_.angle);
  double turned = kNoPicture;
  if (const std::optional<Kept>& kept = kept_[id]; kept && plate_is_seen) {
    turned = angle_measure(kept->direction, direction);
    const bool grown =
        params_.magnification > 0.0 && kept->sides.pixel > params_.magnification * pixel_size_at(view, centre).x;
    if (!grown && (turned < threshold_ || params_.threshold_deg >= 180.0)) {
      ++work_.reused;
      return show(view, id, stage);
    }
  }
  const std::optional<raster::Rect> window_px = capture_window(view, box);
  // A picture larger than the view's would cost more than the object's own pixels do; what the screen's edge cuts, the
  // paper's copy of the frame buffer does not have.
  const bool fits =
      plate_is_seen && window_px && glm::max(window_px->size_px.x, window_px->size_px.y) <= kMostSide_px &&
      std::int64_t(window_px->size_px.x) * window_px->size_px.y <= std::int64_t(view.size_px.x) * view.size_px.y &&
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
    return kept_[id] ? show(view, id, stage) : stage.object(id);
  }
  drop(id, stage);
  const std::uint64_t bytes = bytes_of(wanted.window_px.size_px);
  if (!make_room(bytes, stage)) {
    ++work_.unfit;
    return stage.object(id);
  }
  const bool literal = params_.placement == PlatePlacement::literal;
  const std::vector<ObjectId> alone = {id};
  const glm::dvec3 centre = stage.world().objects()[id].bounds.centre();
  kept_[id] = Kept{.picture = stage.capture(literal ? in_view_ : alone, view, wanted.window_px,
                                            literal ? view.background : glm::vec4(0.0f)),
                   .direction = viewing_direction(centre, view.camera.eye, params_.angle),
                   .sides = plate_sides(view, centre, wanted.window_px, params_.placement),
                   .bytes = bytes,
                   .shown = frame_};
  bytes_ += bytes;
  ++work_.captured;
  if (literal) return stage.object(id);  // the frame whose pixels are copied
  show(view, id, stage);
}

/// Lets pictures go that were not shown for the longest time, until there is room. Those of this frame stay.
bool ImageReuse::make_room(std::uint64_t bytes, Stage& stage) {
  if (params_.most_bytes == 0) return true;
  if (bytes > params_.most_bytes) return false;
  while (bytes_ + bytes > params_.most_bytes) {
    ObjectId oldest = ObjectId(kept_.size());
    for (ObjectId id = 0; id < kept_.size(); ++id) {
      if (!kept_[id] || kept_[id]->shown == frame_) continue;
      if (oldest == kept_.size() || kept_[id]->shown < kept_[oldest]->shown) oldest = id;
    }
    if (oldest == kept_.size()) return false;
    drop(oldest, stage);
    ++work_.evicted;
  }
  return true;
}

void ImageReuse::show(const View& view, ObjectId id, Stage& stage) {
  Kept& kept = *kept_[id];
  kept.shown = frame_;
  stage.plate(id, kept.picture, plate_corners(view, stage.world().objects()[id].bounds.centre(), kept.sides),
              PlateEdge::cutout);
}

void ImageReuse::drop(ObjectId id, Stage& stage) {
  if (!kept_[id]) return;
  stage.release(kept_[id]->picture);
  bytes_ -= kept_[id]->bytes;
  kept_[id].reset();
}

}  // namespace lode::techniques

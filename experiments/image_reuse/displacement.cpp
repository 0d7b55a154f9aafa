#include "experiments/image_reuse/displacement.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <optional>

namespace lode::experiments {
namespace {

/// Where a clip matrix sees a point, px; nothing at or behind the near plane.
std::optional<glm::dvec2> seen_at(const glm::dmat4& clip_from_world, const glm::dvec3& point, glm::ivec2 size_px) {
  const glm::dvec4 p = clip_from_world * glm::dvec4(point, 1.0);
  if (!(p.w > 0.0) || !(p.z < p.w)) return std::nullopt;
  return glm::dvec2((0.5 + 0.5 * p.x / p.w) * size_px.x, (0.5 - 0.5 * p.y / p.w) * size_px.y);
}

class PlateLens {
 public:
  PlateLens(const techniques::ShownPlate& plate, const techniques::View& view, const glm::dmat4& clip_from_world)
      : plate_(plate),
        view_(view),
        clip_from_world_(clip_from_world),
        capture_from_world_(geometry::clip_from_world(plate.picture->camera, plate.picture->view_size_px)) {}

  /// How far the plate shows a point from where it is, px.
  [[nodiscard]] std::optional<double> distance_px(const glm::dvec3& point) const {
    const techniques::CapturedPicture& picture = *plate_.picture;
    const auto captured = seen_at(capture_from_world_, point, picture.view_size_px);
    const auto right_place = seen_at(clip_from_world_, point, view_.size_px);
    if (!captured || !right_place) return std::nullopt;
    const glm::dvec2 uv = (*captured - glm::dvec2(picture.origin_px)) / glm::dvec2(picture.size_px());
    if (!(std::min(uv.x, uv.y) >= 0.0) || !(std::max(uv.x, uv.y) <= 1.0)) return std::nullopt;
    const auto& c = plate_.corners_world;  // upper left, lower left, lower right, upper right
    const auto shown = seen_at(clip_from_world_, c[0] + uv.x * (c[3] - c[0]) + uv.y * (c[1] - c[0]), view_.size_px);
    if (!shown) return std::nullopt;
    return glm::distance(*shown, *right_place);
  }

 private:
  const techniques::ShownPlate& plate_;
  const techniques::View& view_;
  const glm::dmat4& clip_from_world_;
  glm::dmat4 capture_from_world_;
};

}  // namespace

Displacement displacement(const techniques::World& world, const techniques::Stage& stage, const techniques::View& view,
                          std::size_t most_of_instance) {
  Displacement found;
  const geometry::Scene& scene = world.scene();
  const glm::dmat4 clip_from_world = geometry::clip_from_world(view.camera, view.size_px);
  for (const techniques::ShownPlate& plate : stage.plates()) {
    const PlateLens lens(plate, view, clip_from_world);
    const techniques::WorldObject& object = world.objects()[plate.object];
    for (std::uint32_t k = 0; k < object.n_instances; ++k) {
      const geometry::Instance& instance = scene.instances[object.first_instance + k];
      const auto& positions = scene.meshes[instance.mesh].positions;
      const std::size_t step = std::max<std::size_t>(positions.size() / std::max<std::size_t>(most_of_instance, 1), 1);
      for (std::size_t v = 0; v < positions.size(); v += step) {
        const auto px = lens.distance_px(glm::dvec3(instance.world_from_object * glm::dvec4(positions[v], 1.0)));
        if (!px) continue;
        found.max_px = std::max(found.max_px, *px);
        found.sum_px += *px;
        ++found.n;
      }
    }
  }
  return found;
}

}  // namespace lode::experiments

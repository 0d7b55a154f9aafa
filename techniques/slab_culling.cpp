#include "techniques/slab_culling.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "geometry/trigonometry.h"
#include "techniques/objects_in_view.h"

namespace lode::techniques {
namespace {

/// Depths are sums and quotients of a few doubles: two that are this close may be the other way round.
constexpr double kDepthRounding = 0x1p-40;

glm::dvec3 middle(const World& world, ObjectId id) { return world.objects()[id].bounds.centre(); }

/// Whether the eye is in the box of the points, and so may be in their hull.
bool may_hold(std::span<const glm::vec3> points, const glm::dmat4& object_from_world, const glm::dvec3& eye_world) {
  geometry::Bounds box;
  for (const glm::vec3& p : points) box.add(p);
  const glm::dvec3 eye(object_from_world * glm::dvec4(eye_world, 1.0));
  return glm::all(glm::lessThanEqual(box.low, eye)) && glm::all(glm::lessThanEqual(eye, box.high));
}

bool has_parts(const OccluderParts& shape) {
  return std::any_of(shape.levels.begin(), shape.levels.end(), [](const auto& level) { return !level.empty(); });
}

}  // namespace

SlabCulling::SlabCulling(const SlabCullingParams& params)
    : params_(params),
      least_cosine_(geometry::sin_cos(params.angle_limit_deg * geometry::kPi / 180.0).cos),
      slab_occluders_(params.n_slabs) {
  slab_params_.n_slabs = params.n_slabs;
  slab_params_.mode = params.slabs;
  footprints_ = geometry::SlabFootprints(slab_params_);
}

void SlabCulling::prepare(std::vector<OccluderParts> shapes, std::vector<double> areas) {
  shapes_ = std::move(shapes);
  areas_ = std::move(areas);
  n_levels_ = 0;
  for (const OccluderParts& shape : shapes_) n_levels_ = std::max(n_levels_, shape.levels.size());
}

/// Alg. 3.
Counters SlabCulling::draw(const View& view, Stage& stage) {
  const World& world = stage.world();
  clip_from_world_ = geometry::clip_from_world(view.camera, view.size_px);
  if (slab_params_.size_px != glm::dvec2(view.size_px)) {
    slab_params_.size_px = glm::dvec2(view.size_px);
    footprints_ = geometry::SlabFootprints(slab_params_);
  }
  n_points_ = n_parts_ = 0;

  // Step 1: what is in the view, and who may hide others.
  std::vector<ObjectId> inside, to_test;
  {
    const auto timer = stage.time("selection");
    inside = objects_in_view(world, view);
    std::vector<double> areas(areas_);
    for (const ObjectId id : inside) {
      if (!has_parts(shapes_[world.objects()[id].shape])) areas[id] = 0.0;
    }
    occluders_ = choose_occluders(world, view, inside, areas, params_.occluders);
    for (const ObjectId id : inside) {
      const bool chosen = std::find(occluders_.begin(), occluders_.end(), id) != occluders_.end();
      if (chosen && !(params_.test_occluders && params_.depth_rule)) {
        stage.object(id);
      } else {
        to_test.push_back(id);
      }
    }
  }

  // Step 2: their boxes on the virtual screen. What cannot be projected is visible.
  std::vector<Occludee> left;
  {
    const auto timer = stage.time("projection");
    for (const ObjectId id : to_test) {
      Occludee occludee{id, std::find(occluders_.begin(), occluders_.end(), id) != occluders_.end(), 0.0, {}};
      if (!occluders_.empty() && find_occludee(view, world, id, occludee)) {
        left.push_back(std::move(occludee));
      } else {
        stage.object(id);
      }
    }
  }

  // Step 3: level by level, what is still visible against the occluders' parts.
  const std::uint64_t n_tested = left.size();
  std::uint64_t n_culled = 0;
  const std::size_t first_level = params_.levels == LevelRule::last && n_levels_ > 0 ? n_levels_ - 1 : 0;
  for (std::size_t level = first_level; level < n_levels_ && !left.empty(); ++level) {
    {
      const auto timer = stage.time("projection");
      project_occluders(view, world, level);
    }
    const auto timer = stage.time("test");
    n_culled += std::erase_if(left, [&](const Occludee& occludee) { return hidden(view, world, occludee); });
  }
  for (const Occludee& occludee : left) stage.object(occludee.object);
  return {{"objects_in_view", inside.size()},
          {"occluders", occluders_.size()},
          {"tested", n_tested},
          {"culled", n_culled},
          {"parts", n_parts_},
          {"part_points", n_points_}};
}

bool SlabCulling::find_occludee(const View& view, const World& world, ObjectId id, Occludee& out) {
  const auto corners = geometry::corners(world.objects()[id].bounds);
  geometry::project_hull(corners, clip_from_world_, glm::dvec2(view.size_px), projected_);
  if (projected_.near_plane != geometry::NearPlane::in_front) return false;
  out.nearest_depth = projected_.nearest_depth;
  footprints_.of_occludee(projected_.points_px, out.footprint);
  return !out.footprint.empty();  // nothing of it on the screen: frustum culling is not ours to do again
}

void SlabCulling::project_occluders(const View& view, const World& world, std::size_t level) {
  parts_of_.clear();
  farthest_depth_.clear();
  hides_occluders_.clear();
  slab_occluders_.clear();
  for (const ObjectId id : occluders_) {
    const OccluderParts& shape = shapes_[world.objects()[id].shape];
    if (level >= shape.levels.size()) continue;
    if (params_.whole_occluders_only) {
      const auto corners = geometry::corners(world.objects()[id].bounds);
      geometry::project_hull(corners, clip_from_world_, glm::dvec2(view.size_px), projected_);
      if (projected_.near_plane != geometry::NearPlane::in_front) continue;
    }
    const auto begin = std::uint32_t(farthest_depth_.size());
    for (std::size_t i = 0; i < shape.levels[level].size(); ++i) {
      const bool hides_occluders = shape.hides_occluders.empty() || shape.hides_occluders[level][i] != 0;
      add_part(view, world, id, shape.levels[level][i], hides_occluders);
    }
    parts_of_.push_back({id, begin, std::uint32_t(farthest_depth_.size())});
  }
  slab_occluders_.sort();
}

void SlabCulling::add_part(const View& view, const World& world, ObjectId id, const std::vector<glm::vec3>& points,
                           bool hides_occluders) {
  const glm::dmat4& world_from_shape = world.objects()[id].world_from_shape;
  geometry::project_hull(points, clip_from_world_ * world_from_shape, glm::dvec2(view.size_px), projected_);
  ++n_parts_, n_points_ += points.size();
  if (projected_.near_plane == geometry::NearPlane::behind) return;
  const bool crosses = projected_.near_plane == geometry::NearPlane::crosses;
  if (crosses && (params_.whole_occluders_only || may_hold(points, glm::inverse(world_from_shape), view.camera.eye))) {
    return;  // from inside, a hull hides nothing
  }
  footprints_.of_occluder(projected_.points_px, footprint_);
  if (footprint_.empty()) return;
  slab_occluders_.add(footprint_);
  farthest_depth_.push_back(projected_.farthest_depth);
  hides_occluders_.push_back(hides_occluders);
}

bool SlabCulling::may_hide(const View& view, const World& world, ObjectId occluder, ObjectId occludee) const {
  if (occluder == occludee) return false;
  if (params_.angle_limit_deg >= 180.0) return true;
  const glm::dvec3 u = middle(world, occluder), to_occluder = u - view.camera.eye, onward = middle(world, occludee) - u;
  const double lengths = glm::length(to_occluder) * glm::length(onward);
  return glm::dot(to_occluder, onward) >= least_cosine_ * lengths;
}

bool SlabCulling::hidden(const View& view, const World& world, const Occludee& occludee) {
  counts_.assign(farthest_depth_.size(), 0);
  const double nearest = params_.depth_rule
                             ? occludee.nearest_depth + kDepthRounding * std::fabs(occludee.nearest_depth)
                             : -std::numeric_limits<double>::infinity();
  const std::uint8_t any = occludee.is_occluder ? 0 : 1;
  for (const PartsOf& parts : parts_of_) {
    if (!may_hide(view, world, parts.object, occludee.object)) continue;
    for (std::uint32_t k = parts.begin; k < parts.end; ++k) {
      counts_[k] = std::uint8_t((any | hides_occluders_[k]) & std::uint8_t(farthest_depth_[k] >= nearest));
    }
    if (params_.fusion == Fusion::per_occluder) {
      if (slab_occluders_.cover(occludee.footprint, counts_)) return true;
      std::fill(counts_.begin() + parts.begin, counts_.begin() + parts.end, std::uint8_t{0});
    }
  }
  return params_.fusion == Fusion::all && slab_occluders_.cover(occludee.footprint, counts_);
}

}  // namespace lode::techniques

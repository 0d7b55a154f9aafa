#include "techniques/masked_occlusion/cluster_walk.h"

#include <algorithm>
#include <cmath>

#include "geometry/frustum.h"

namespace lode::techniques {
namespace {

using raster::ClusterGroup;

geometry::Bounds box_of(const ClusterGroup& group, int k) {
  geometry::Bounds box;
  box.low = {group.low[0][k], group.low[1][k], group.low[2][k]};
  box.high = {group.high[0][k], group.high[1][k], group.high[2][k]};
  return box;
}

/// Whether all normals of the cone point away from the eye at all points of the box: the greatest n · (eye − p) is that
/// of the cone's nearest normal towards the box's centre, plus the box's radius.
bool faces_away(const ClusterGroup& group, int k, const geometry::Bounds& box, const glm::dvec4& eye,
                raster::Cull cull) {
  const double cosine = group.cone_cos[k];
  if (cull == raster::Cull::none || !(cosine > 0.0)) return false;
  const glm::dvec3 axis(group.cone_axis[0][k], group.cone_axis[1][k], group.cone_axis[2][k]);
  const glm::dvec3 to_eye = (cull == raster::Cull::back ? 1.0 : -1.0) * (glm::dvec3(eye) - eye.w * box.centre());
  const double along = glm::dot(axis, to_eye);
  const double across = std::sqrt(std::max(glm::dot(to_eye, to_eye) - along * along, 0.0));
  const double sine = std::sqrt(std::max(1.0 - cosine * cosine, 0.0));
  return (cosine * along + sine * across) + 0.5 * std::abs(eye.w) * box.diagonal() < 0.0;
}

}  // namespace

glm::dvec4 eye_of(const glm::dmat4& m) {
  // Cramer's rule: the minors of the rows x, y and w.
  const glm::dvec4 x(m[0][0], m[1][0], m[2][0], m[3][0]), y(m[0][1], m[1][1], m[2][1], m[3][1]),
      w(m[0][3], m[1][3], m[2][3], m[3][3]);
  const auto minor = [&](int a, int b, int c) {
    return glm::dot(glm::dvec3(x[a], x[b], x[c]),
                    glm::cross(glm::dvec3(y[a], y[b], y[c]), glm::dvec3(w[a], w[b], w[c])));
  };
  return {minor(1, 2, 3), -minor(0, 2, 3), minor(0, 1, 3), -minor(0, 1, 2)};
}

std::span<const std::uint32_t> ClusterWalk::worth_drawing(const raster::Draw& draw, glm::ivec2 size_px,
                                                          const MaskedDepth& buffer, std::uint64_t& n_read) {
  const raster::Clusters& clusters = *draw.clusters;
  const glm::dmat4& clip_from_object = std::get<raster::ObjectVertices>(draw.vertices).clip_from_object;
  const glm::dvec4 eye = eye_of(clip_from_object);
  const geometry::Frustum frustum = geometry::frustum(clip_from_object);
  by_depth_.clear();
  open_.clear();
  if (!clusters.groups.empty()) open_.push_back(0);
  while (!open_.empty()) {
    const ClusterGroup& group = clusters.groups[open_.back()];
    open_.pop_back();
    for (int k = 0; k < group.n; ++k) {
      const geometry::Bounds box = box_of(group, k);
      if (faces_away(group, k, box, eye, draw.cull)) continue;
      const std::optional<ScreenBox> on_screen = screen_box(clip_from_object, size_px, box);
      if (on_screen ? buffer.hides(*on_screen, n_read) : geometry::is_outside(frustum, box)) continue;
      const std::uint32_t child = group.child[k];
      if ((child & ClusterGroup::kIsCluster) != 0) {
        const float nearest = on_screen ? on_screen->nearest : 2.0f;
        by_depth_.emplace_back(-nearest, child & ~ClusterGroup::kIsCluster);
      } else {
        open_.push_back(child);
      }
    }
  }
  std::sort(by_depth_.begin(), by_depth_.end());
  found_.clear();
  for (const auto& [depth, cluster] : by_depth_) found_.push_back(cluster);
  return found_;
}

}  // namespace lode::techniques

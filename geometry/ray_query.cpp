#include "geometry/ray_query.h"

#include <algorithm>
#include <cmath>
#include <new>

#include "geometry/ray_query/embree.h"

namespace lode::geometry {
namespace {

/// Whether Embree takes the ray: some builds of it stop the program at one that it does not.
bool takes(const Ray& ray) {
  for (int i = 0; i < 3; ++i) {
    if (!(std::abs(ray.origin[i]) <= 1e18f && std::abs(ray.direction[i]) <= 1e18f)) return false;
  }
  return ray.t_near >= 0.0f && ray.t_near <= ray.t_far && ray.direction != glm::vec3(0.0f);
}

void set_ray(const Ray& from, RTCRay& to) {
  to.org_x = from.origin.x;
  to.org_y = from.origin.y;
  to.org_z = from.origin.z;
  to.tnear = from.t_near;
  to.dir_x = from.direction.x;
  to.dir_y = from.direction.y;
  to.dir_z = from.direction.z;
  to.time = 0.0f;
  to.tfar = from.t_far;
  to.mask = from.mask;
  to.id = 0;
  to.flags = 0;
}

/// Looks for the nearest hit, or, through the filter, for all.
RTCRayHit intersect(RTCScene scene, const Ray& ray, Context& context) {
  const DefaultFloatingPoint scope;
  RTCRayHit query;
  set_ray(ray, query.ray);
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
#if LODESTONE_EMBREE == 4
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.context = &context.embree;
  rtcIntersect1(scene, &query, &arguments);
#else
  rtcIntersect1(scene, &context.embree, &query);
#endif
  return query;
}

}  // namespace

std::optional<RayHit> RayScene::nearest(const Ray& ray) const {
  if (!takes(ray)) return std::nullopt;
  Context context;
  const RTCRayHit found = intersect(tree_->scene.get(), ray, context);
  if (found.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  return RayHit{found.hit.geomID, found.hit.primID, found.ray.tfar, found.hit.u, found.hit.v};
}

void RayScene::all(const Ray& ray, std::vector<RayHit>& hits) const {
  hits.clear();
  if (!takes(ray)) return;
  Context context;
  context.hits = &hits;
  static_cast<void>(intersect(tree_->scene.get(), ray, context));
  if (context.out_of_memory) throw std::bad_alloc();
  std::sort(hits.begin(), hits.end(), [](const RayHit& a, const RayHit& b) {
    if (a.t != b.t) return a.t < b.t;
    if (a.instance != b.instance) return a.instance < b.instance;
    return a.primitive < b.primitive;
  });
}

bool RayScene::occluded(const Ray& ray) const {
  if (!takes(ray)) return false;
  const DefaultFloatingPoint scope;
  Context context;
  RTCRay query;
  set_ray(ray, query);
#if LODESTONE_EMBREE == 4
  RTCOccludedArguments arguments;
  rtcInitOccludedArguments(&arguments);
  arguments.context = &context.embree;
  rtcOccluded1(tree_->scene.get(), &query, &arguments);
#else
  rtcOccluded1(tree_->scene.get(), &context.embree, &query);
#endif
  return query.tfar < 0.0f;  // Embree's sign of a hit
}

}  // namespace lode::geometry

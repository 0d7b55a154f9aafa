#include <algorithm>
#include <mutex>
#include <new>
#include <string>

#include "geometry/error.h"
#include "geometry/ray_query/embree.h"

namespace lode::geometry {

void fail(RTCError error) {
  const char* what = "it failed";
  if (error == RTC_ERROR_OUT_OF_MEMORY) what = "out of memory";
  if (error == RTC_ERROR_UNSUPPORTED_CPU) what = "this processor is not one that it supports";
  if (error == RTC_ERROR_INVALID_ARGUMENT) what = "it refused an argument";
  if (error == RTC_ERROR_INVALID_OPERATION) what = "it refused an operation";
  throw Error(ErrorKind::machine, std::string("ray tracing (Embree): ") + what);
}

void check(RTCDevice device) {
  const RTCError error = rtcGetDeviceError(device);
  if (error != RTC_ERROR_NONE) fail(error);
}

void filter_hit(const RTCFilterFunctionNArguments* args) {
  if (args->valid[0] != -1) return;  // 0: the hit is ignored
  const RTCRay& ray = *reinterpret_cast<const RTCRay*>(args->ray);
  const RTCHit& hit = *reinterpret_cast<const RTCHit*>(args->hit);
  const auto cull = static_cast<RayCull>(reinterpret_cast<std::uintptr_t>(args->geometryUserPtr));
  if (cull != RayCull::none) {
    const float along = hit.Ng_x * ray.dir_x + hit.Ng_y * ray.dir_y + hit.Ng_z * ray.dir_z;
    const bool front = along < 0.0f;  // the normal of a counter-clockwise triangle looks against the ray
    if (front == (cull == RayCull::front) || along == 0.0f) {
      args->valid[0] = 0;
      return;
    }
  }
  Context& context = *reinterpret_cast<Context*>(const_cast<QueryContext*>(args->context));
  if (!context.hits) return;
  args->valid[0] = 0;  // go on to the next
  try {
    context.hits->push_back({hit.geomID, hit.primID, ray.tfar, hit.u, hit.v});
  } catch (const std::bad_alloc&) {  // no exception may pass through Embree
    context.out_of_memory = true;
  }
}

namespace {

Geometry make_geometry(RTCDevice device, const RayInstance& instance) {
  Geometry geometry(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE));
  check(device);
  const std::size_t n_vertices = instance.positions.size(), n_triangles = instance.indices.size() / 3;
  auto* const vertices = static_cast<float*>(rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0,
                                                                     RTC_FORMAT_FLOAT3, 3 * sizeof(float), n_vertices));
  check(device);
  const glm::dmat4& m = instance.query_from_object;
  for (std::size_t i = 0; i < n_vertices; ++i) {
    const glm::dvec3 p(instance.positions[i]);
    for (int c = 0; c < 3; ++c) {
      // Beyond floats is beyond what Embree takes, too: such triangles are met by no ray.
      const double exact = ((m[0][c] * p.x + m[1][c] * p.y) + m[2][c] * p.z) + m[3][c];
      vertices[3 * i + std::size_t(c)] = float(std::clamp(exact, -3e38, 3e38));
    }
  }
  auto* const indices = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
      geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), n_triangles));
  check(device);
  std::copy_n(instance.indices.begin(), 3 * n_triangles, indices);
  rtcSetGeometryMask(geometry.get(), instance.mask);
  rtcSetGeometryUserData(geometry.get(), reinterpret_cast<void*>(static_cast<std::uintptr_t>(instance.cull)));
  rtcSetGeometryIntersectFilterFunction(geometry.get(), filter_hit);
  rtcSetGeometryOccludedFilterFunction(geometry.get(), filter_hit);
  rtcCommitGeometry(geometry.get());
  check(device);
  return geometry;
}

/// Embree's calls may come from several threads at once.
struct Progress {
  const std::function<void(double)>& report;
  std::mutex mutex;

  static bool step(void* self, double done) {
    Progress& progress = *static_cast<Progress*>(self);
    const std::lock_guard lock(progress.mutex);
    progress.report(done);
    return true;  // go on
  }
};

}  // namespace

RayScene::RayScene(std::span<const RayInstance> instances, const std::function<void(double)>& progress)
    : tree_(std::make_unique<Tree>()) {
  const DefaultFloatingPoint scope;
  tree_->device.reset(rtcNewDevice(nullptr));
  if (!tree_->device) fail(rtcGetDeviceError(nullptr));
  const RTCDevice device = tree_->device.get();
  tree_->scene.reset(rtcNewScene(device));
  check(device);
  const RTCScene scene = tree_->scene.get();
  rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
  rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_MEDIUM);  // HIGH cuts triangles: a hit would be found twice
  for (std::size_t i = 0; i < instances.size(); ++i) {
    if (instances[i].indices.size() < 3) continue;
    const Geometry geometry = make_geometry(device, instances[i]);
    rtcAttachGeometryByID(scene, geometry.get(), static_cast<unsigned>(i));
    check(device);
  }
  Progress monitor{progress, {}};
  if (progress) rtcSetSceneProgressMonitorFunction(scene, Progress::step, &monitor);
  rtcCommitScene(scene);
  check(device);
  if (progress) rtcSetSceneProgressMonitorFunction(scene, nullptr, nullptr);
}

RayScene::~RayScene() = default;

}  // namespace lode::geometry

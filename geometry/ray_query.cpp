#include "geometry/ray_query.h"

#if LODESTONE_EMBREE == 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#if defined(__x86_64__) || defined(__i386__)
#include <xmmintrin.h>
#endif

#include <algorithm>
#include <cmath>
#include <mutex>
#include <new>
#include <string>

#include "geometry/error.h"

namespace lode::geometry {
namespace {

/// The default floating-point state (no FTZ, no DAZ, nearest) for a scope, then the caller's own.
class DefaultFloatingPoint {
 public:
#if defined(__x86_64__) || defined(__i386__)
  DefaultFloatingPoint() : saved_(_mm_getcsr()) { _mm_setcsr(0x1F80); }
  ~DefaultFloatingPoint() { _mm_setcsr(saved_); }

 private:
  unsigned saved_;
#else  // Embree changes it on x86 alone
  DefaultFloatingPoint() {}
  ~DefaultFloatingPoint() {}

 public:
#endif
  DefaultFloatingPoint(const DefaultFloatingPoint&) = delete;
  DefaultFloatingPoint& operator=(const DefaultFloatingPoint&) = delete;
};

[[noreturn]] void fail(RTCError error) {
  const char* what = "an error of its own";
  switch (error) {
    case RTC_ERROR_OUT_OF_MEMORY:
      throw Error(ErrorKind::machine, "ray tracing: out of memory");
    case RTC_ERROR_UNSUPPORTED_CPU:
      what = "a processor that it supports";
      break;
    case RTC_ERROR_INVALID_ARGUMENT:
      what = "other arguments";
      break;
    case RTC_ERROR_INVALID_OPERATION:
      what = "another state";
      break;
    default:
      break;
  }
  throw Error(ErrorKind::machine, std::string("ray tracing: Embree failed: it expected ") + what);
}

void check(RTCDevice device) {
  const RTCError error = rtcGetDeviceError(device);
  if (error != RTC_ERROR_NONE) fail(error);
}

struct ReleaseDevice {
  void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};
struct ReleaseScene {
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
struct ReleaseGeometry {
  void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
};
using Device = std::unique_ptr<std::remove_pointer_t<RTCDevice>, ReleaseDevice>;
using Scene = std::unique_ptr<std::remove_pointer_t<RTCScene>, ReleaseScene>;
using Geometry = std::unique_ptr<std::remove_pointer_t<RTCGeometry>, ReleaseGeometry>;

#if LODESTONE_EMBREE == 4
using QueryContext = RTCRayQueryContext;
#else
using QueryContext = RTCIntersectContext;
#endif

/// What a query carries to the filter: where to put hits, or null for a query that looks for one.
struct Context {
  QueryContext embree;  // first: Embree hands a pointer to it on
  std::vector<RayHit>* hits = nullptr;
  bool out_of_memory = false;

  Context() {
#if LODESTONE_EMBREE == 4
    rtcInitRayQueryContext(&embree);
#else
    rtcInitIntersectContext(&embree);
#endif
  }
};

/// Called for each hit found on the way, single rays only; the hit is ignored where valid[0] becomes 0.
void filter(const RTCFilterFunctionNArguments* args) {
  if (args->valid[0] != -1) return;
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
  rtcSetGeometryIntersectFilterFunction(geometry.get(), filter);
  rtcSetGeometryOccludedFilterFunction(geometry.get(), filter);
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

struct RayScene::Tree {
  Device device;
  Scene scene;
};

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

std::optional<RayHit> RayScene::nearest(const Ray& ray) const {
  if (!takes(ray)) return std::nullopt;
  const DefaultFloatingPoint scope;
  Context context;
  RTCRayHit query;
  set_ray(ray, query.ray);
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
#if LODESTONE_EMBREE == 4
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.context = &context.embree;
  rtcIntersect1(tree_->scene.get(), &query, &arguments);
#else
  rtcIntersect1(tree_->scene.get(), &context.embree, &query);
#endif
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  return RayHit{query.hit.geomID, query.hit.primID, query.ray.tfar, query.hit.u, query.hit.v};
}

void RayScene::all(const Ray& ray, std::vector<RayHit>& hits) const {
  hits.clear();
  if (!takes(ray)) return;
  const DefaultFloatingPoint scope;
  Context context;
  context.hits = &hits;
  RTCRayHit query;
  set_ray(ray, query.ray);
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
#if LODESTONE_EMBREE == 4
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.context = &context.embree;
  rtcIntersect1(tree_->scene.get(), &query, &arguments);
#else
  rtcIntersect1(tree_->scene.get(), &context.embree, &query);
#endif
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

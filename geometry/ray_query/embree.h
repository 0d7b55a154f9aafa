#pragma once
/// Embree 3 or 4 as the two files beside this one use it: its handles, its errors, its floating-point state.

#if LODESTONE_EMBREE == 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#if defined(__x86_64__) || defined(__i386__)
#include <xmmintrin.h>
#endif

#include <memory>
#include <type_traits>
#include <vector>

#include "geometry/ray_query.h"

namespace lode::geometry {

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

/// Throws Error (machine) with what went wrong.
[[noreturn]] void fail(RTCError error);
/// Throws if the device has had an error since the last check.
void check(RTCDevice device);

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

struct RayScene::Tree {
  Device device;
  Scene scene;
};

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

/// Called for each hit found on the way, single rays only; culls, and collects hits where the context asks for them.
void filter_hit(const RTCFilterFunctionNArguments* args);

}  // namespace lode::geometry

#include "raster/fast/kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/fast/kernels.cpp"
#include <hwy/foreach_target.h>

#include "raster/fast/box-inl.h"
#include "raster/fast/coverage-inl.h"
#include "raster/fast/depth-inl.h"
#include "raster/fast/flat-inl.h"
#if HWY_TARGET != HWY_SCALAR  // which is in no table: the reference pipeline runs there
#include "raster/fast/ordered-inl.h"
#include "raster/fast/tint-inl.h"
#endif
#include "raster/fast/vertices-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lode::raster::fast {
namespace HWY_NAMESPACE {

#if HWY_TARGET == HWY_AVX3
constexpr Target kTarget = Target::avx512;
#elif HWY_TARGET == HWY_AVX2
constexpr Target kTarget = Target::avx2;
#elif HWY_TARGET == HWY_SSE4
constexpr Target kTarget = Target::sse4;
#else
constexpr Target kTarget = Target::scalar;
#endif

#if HWY_TARGET == HWY_SCALAR
constexpr auto ShadeTextured = nullptr, DrawTextured = nullptr;
#endif

extern const Kernels kKernels;
const Kernels kKernels = {kTarget, Project, Transform, Rasterize, LeastDepth, ShadeFlat, StoreBytes, ShadeTextured,
                          DrawTextured};

}  // namespace HWY_NAMESPACE
}  // namespace lode::raster::fast
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace lode::raster::fast {
namespace {

struct Entry {
  std::int64_t needs;
  const Kernels* kernels;
};

const Entry kEntries[] = {  // the widest first
#if HWY_TARGETS & HWY_AVX3
    {HWY_AVX3, &N_AVX3::kKernels},
#endif
#if HWY_TARGETS & HWY_AVX2
    {HWY_AVX2, &N_AVX2::kKernels},
#endif
#if HWY_TARGETS & HWY_SSE4
    {HWY_SSE4, &N_SSE4::kKernels},
#endif
};

}  // namespace

const Kernels* find_kernels(Target target) {
  for (const Entry& entry : kEntries) {
    const bool here = (hwy::SupportedTargets() & entry.needs) != 0;
    if (here && (target == Target::best || target == entry.kernels->target)) return entry.kernels;
  }
  return nullptr;
}

}  // namespace lode::raster::fast
#endif

#include "raster/fast/kernels.h"

#include <cstring>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/fast/kernels.cpp"
#include <hwy/foreach_target.h>

#include "raster/fast/box-inl.h"
#include "raster/fast/coverage-inl.h"
#include "raster/fast/depth-inl.h"
#include "raster/fast/flat-inl.h"
#include "raster/fast/vertices-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lode::raster::fast {
namespace HWY_NAMESPACE {

extern const Kernels kKernels;
const Kernels kKernels = {
    hwy::TargetName(HWY_TARGET), Project, Transform, Rasterize, LeastDepth, ShadeFlat, StoreBytes};

}  // namespace HWY_NAMESPACE
}  // namespace lode::raster::fast
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace lode::raster::fast {
namespace {

struct Entry {
  std::int64_t target;
  const char* name;
  const Kernels* kernels;
};

const Entry kEntries[] = {
#if HWY_TARGETS & HWY_AVX3
    {HWY_AVX3, "avx512", &N_AVX3::kKernels},
#endif
#if HWY_TARGETS & HWY_AVX2
    {HWY_AVX2, "avx2", &N_AVX2::kKernels},
#endif
#if HWY_TARGETS & HWY_SSE4
    {HWY_SSE4, "sse4", &N_SSE4::kKernels},
#endif
};

}  // namespace

const Kernels* find_kernels(const char* name) {
  for (const Entry& entry : kEntries) {
    if ((hwy::SupportedTargets() & entry.target) == 0) continue;
    if (std::strcmp(name, "best") == 0 || std::strcmp(name, entry.name) == 0) return entry.kernels;
  }
  return nullptr;
}

}  // namespace lode::raster::fast
#endif

#include "techniques/masked_occlusion/occluder_kernels.h"

#include "raster/fast/highway_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "techniques/masked_occlusion/occluder_kernels.cpp"
#include <hwy/foreach_target.h>

#include "techniques/masked_occlusion/draw_cluster-inl.h"
#include "techniques/masked_occlusion/draw_wide-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lode::techniques {
namespace HWY_NAMESPACE {

#if HWY_TARGET == HWY_AVX3
constexpr raster::Target kTarget = raster::Target::avx512;
#elif HWY_TARGET == HWY_AVX2
constexpr raster::Target kTarget = raster::Target::avx2;
#elif HWY_TARGET == HWY_SSE4
constexpr raster::Target kTarget = raster::Target::sse4;
#elif HWY_TARGET == LODE_NEON
constexpr raster::Target kTarget = raster::Target::neon;
#elif defined(__wasm_simd128__)
constexpr raster::Target kTarget = raster::Target::wasm;
#else
constexpr raster::Target kTarget = raster::Target::scalar;
#endif

extern const OccluderKernels kOccluderKernels;
const OccluderKernels kOccluderKernels = {kTarget, AllClean, DrawCluster, DrawTriangle};

}  // namespace HWY_NAMESPACE
}  // namespace lode::techniques
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace lode::techniques {
namespace {

#ifdef HWY_NEON_WITHOUT_AES
#define LODE_NEON_KERNELS_HERE N_NEON_WITHOUT_AES::kOccluderKernels
#else
#define LODE_NEON_KERNELS_HERE N_NEON::kOccluderKernels
#endif

const OccluderKernels* const kBuilt[] = {
#if HWY_TARGETS & HWY_AVX3
    &N_AVX3::kOccluderKernels,
#endif
#if HWY_TARGETS & HWY_AVX2
    &N_AVX2::kOccluderKernels,
#endif
#if HWY_TARGETS & HWY_SSE4
    &N_SSE4::kOccluderKernels,
#endif
#if HWY_TARGETS & LODE_NEON
    &LODE_NEON_KERNELS_HERE,
#endif
    &N_EMU128::kOccluderKernels,
};

}  // namespace

const OccluderKernels& occluder_kernels(raster::Target target) {
  const raster::fast::Kernels* const renderers = raster::fast::find_kernels(target);
  for (const OccluderKernels* kernels : kBuilt) {
    if (renderers != nullptr && kernels->target == renderers->target) return *kernels;
  }
  return N_EMU128::kOccluderKernels;
}

}  // namespace lode::techniques
#endif

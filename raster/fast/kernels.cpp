#include "raster/fast/kernels.h"

#include "raster/fast/highway_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/fast/kernels.cpp"
#include <hwy/foreach_target.h>

#include "raster/fast/box-inl.h"
#include "raster/fast/depth-inl.h"
#include "raster/fast/linear_texture-inl.h"
#include "raster/fast/ordered-inl.h"
#include "raster/fast/owners-inl.h"
#include "raster/fast/rasterize-inl.h"
#include "raster/fast/records-inl.h"
#include "raster/fast/resolve-inl.h"
#include "raster/fast/surface-inl.h"
#include "raster/fast/tint-inl.h"
#include "raster/fast/vertices-inl.h"
#include "raster/fast/write-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lode::raster::fast {
namespace HWY_NAMESPACE {

#if HWY_TARGET == HWY_AVX3
constexpr Target kTarget = Target::avx512;
#elif HWY_TARGET == HWY_AVX2
constexpr Target kTarget = Target::avx2;
#elif HWY_TARGET == HWY_SSE4
constexpr Target kTarget = Target::sse4;
#elif HWY_TARGET == LODE_NEON
constexpr Target kTarget = Target::neon;
#elif defined(__wasm_simd128__)
constexpr Target kTarget = Target::wasm;
#else
constexpr Target kTarget = Target::scalar;
#endif

extern const Kernels kKernels;
const Kernels kKernels = {
    .target = kTarget,
    .look = Look,
    .transform = Transform,
    .rasterize = Rasterize,
    .rasterize_lone = RasterizeLone,
    .hidden = Hidden,
    .make_records = MakeRecords,
    .shade_records = ShadeRecords,
    .resolve_records = ResolveRecords,
    .write_tile = WriteTile,
    .clear = Clear,
    .shade_owners = ShadeOwners,
    .shade_surface = ShadeSurface,
    .apply_linear_texture = ApplyLinearTexture,
    .cut_out_surface = CutOutSurface,
    .store_floats = StoreFloats,
    .store_bytes = StoreBytes,
    .shade_textured = ShadeTextured,
    .draw_textured = DrawTextured,
};

}  // namespace HWY_NAMESPACE
}  // namespace lode::raster::fast
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace lode::raster::fast {
namespace {

const Kernels* const kBuilt[] = {
// the widest first
#if HWY_TARGETS & HWY_AVX3
    &N_AVX3::kKernels,
#endif
#if HWY_TARGETS & HWY_AVX2
    &N_AVX2::kKernels,
#endif
#if HWY_TARGETS & HWY_SSE4
    &N_SSE4::kKernels,
#endif
#if HWY_TARGETS & LODE_NEON
    &LODE_NEON_KERNELS,
#endif
    &N_EMU128::kKernels,
};

/// All that Highway lets the compiler use for a target.
bool processor_has([[maybe_unused]] Target target) {
#if defined(__x86_64__) || defined(__i386__)
  __builtin_cpu_init();
  const bool sse4 =
      __builtin_cpu_supports("sse4.2") && __builtin_cpu_supports("pclmul") && __builtin_cpu_supports("aes");
  const bool avx2 = sse4 && __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
                    __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2");
  if (target == Target::sse4) return sse4;
  if (target == Target::avx2) return avx2;
  if (target == Target::avx512) {  // what server processors have had since 2017
    return avx2 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
           __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512vl");
  }
#endif
  return true;  // no machine runs a build for others
}

}  // namespace

const Kernels* find_kernels(Target target) {
  for (const Kernels* kernels : kBuilt) {
    if ((target == Target::best || target == kernels->target) && processor_has(kernels->target)) return kernels;
  }
  return nullptr;
}

}  // namespace lode::raster::fast
#endif

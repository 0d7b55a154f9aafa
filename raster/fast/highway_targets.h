#pragma once
/// Which instruction sets the kernels are built for: to be included before any header of Highway. All that are named
/// in raster/render.h and that the compiler can make, the scalar one among them, whatever the compiler's flags take for
/// granted. Highway's headers are all that is needed, its library is not.
///
/// scalar is Highway's EMU128: arrays of 16 bytes and plain loops. WebAssembly's vectors are the same code, which the
/// compiler turns into vectors: Highway has no doubles there before its version 1.0.6.

#define HWY_COMPILE_ALL_ATTAINABLE
// GCC before 12.3 may break EMU128 when it vectorizes its loops (GCC bug 106322), and Highway then has a lesser set of
// operations instead. raster/CMakeLists.txt turns that pass of the compiler off for these kernels.
#define HWY_BROKEN_EMU128 0
#define HWY_IS_DEBUG_BUILD 0  // its assertions end in the library
#include <hwy/detect_targets.h>

// What some versions lack is none of their targets.
#ifndef HWY_SSE2
#define HWY_SSE2 0
#endif
#ifndef HWY_AVX3_ZEN4
#define HWY_AVX3_ZEN4 0
#endif
#ifndef HWY_AVX3_SPR
#define HWY_AVX3_SPR 0
#endif
#ifndef HWY_AVX10_2
#define HWY_AVX10_2 0
#endif
#ifndef HWY_AVX10_2_512
#define HWY_AVX10_2_512 0
#endif
#ifndef HWY_NEON_BF16
#define HWY_NEON_BF16 0
#endif

// Every AArch64 has NEON: no function needs a target of its own, with which GCC could not inline constructors.
#if HWY_ARCH_ARM
#undef HWY_HAVE_RUNTIME_DISPATCH
#define HWY_HAVE_RUNTIME_DISPATCH 0
#endif

// NEON with and without AES are the same to these kernels: where a version tells them apart, the plain one.
#ifdef HWY_NEON_WITHOUT_AES
#define LODE_NEON HWY_NEON_WITHOUT_AES
#define LODE_NEON_KERNELS N_NEON_WITHOUT_AES::kKernels
#define LODE_NOT_NEON HWY_NEON
#else
#define LODE_NEON HWY_NEON
#define LODE_NEON_KERNELS N_NEON::kKernels
#define LODE_NOT_NEON 0
#endif

// Builds that are slow to compile (sanitizers) make do with the widest and the scalar kernels.
#ifdef LODESTONE_WIDEST_AND_SCALAR
#define LODE_LEFT_OUT (HWY_AVX2 | HWY_SSE4)
#else
#define LODE_LEFT_OUT 0
#endif

#undef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS                                                                                           \
  (HWY_SSE2 | HWY_SSSE3 | HWY_AVX3_DL | HWY_AVX3_ZEN4 | HWY_AVX3_SPR | HWY_AVX10_2 | HWY_AVX10_2_512 | LODE_NOT_NEON | \
   HWY_NEON_BF16 | LODE_LEFT_OUT | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_WASM | HWY_WASM_EMU256)

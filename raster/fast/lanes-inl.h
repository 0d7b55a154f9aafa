// Vectors that the kernels use: sixteen 32-bit lanes, or eight 64-bit ones, where the processor has them.
// Compiled once for each instruction set (Highway's re-included headers).

#include <cstdint>

#if defined(LODE_RASTER_FAST_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LODE_RASTER_FAST_LANES_INL_H_
#undef LODE_RASTER_FAST_LANES_INL_H_
#else
#define LODE_RASTER_FAST_LANES_INL_H_
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace lode::raster::fast {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Ints = hn::CappedTag<std::int32_t, 16>;
using Floats = hn::CappedTag<float, 16>;
using Doubles = hn::CappedTag<double, 8>;
using HalfInts = hn::Rebind<std::int32_t, Doubles>;  ///< as many lanes as Doubles
using HalfFloats = hn::Rebind<float, Doubles>;
using I = hn::Vec<Ints>;

// Where the sixteen lanes of a 4×4 are.
alignas(64) constexpr std::int32_t kLaneX_fx8[16] = {0, 256, 512, 768, 0, 256, 512, 768,
                                                     0, 256, 512, 768, 0, 256, 512, 768};
alignas(64) constexpr std::int32_t kLaneY_fx8[16] = {0,   0,   0,   0,   256, 256, 256, 256,
                                                     512, 512, 512, 512, 768, 768, 768, 768};
alignas(64) constexpr double kLaneXInDouble[16] = {0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3};
alignas(64) constexpr double kLaneYInDouble[16] = {0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3};
alignas(64) constexpr std::int32_t kLaneX[16] = {0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3};
alignas(64) constexpr std::int32_t kLaneY[16] = {0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3};

}  // namespace HWY_NAMESPACE
}  // namespace lode::raster::fast
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard

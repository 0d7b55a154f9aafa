// A cluster's triangles to a tile's samples (C2, C3, C5).
// Compiled once for each instruction set (Highway's re-included headers).

#include <algorithm>
#include <cstdint>

#include "raster/fast/kernels.h"

#if defined(LODE_RASTER_FAST_RASTERIZE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LODE_RASTER_FAST_RASTERIZE_INL_H_
#undef LODE_RASTER_FAST_RASTERIZE_INL_H_
#else
#define LODE_RASTER_FAST_RASTERIZE_INL_H_
#endif

#include "raster/fast/lanes-inl.h"
#include "raster/fast/large-inl.h"
#include "raster/fast/medium-inl.h"
#include "raster/fast/sift-inl.h"
#include "raster/fast/tiny-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lode::raster::fast {
namespace HWY_NAMESPACE {

/// The triangle at its canonical corners, or false where culled.
bool TakeOut(const RasterJob& job, int t, RasterCounts& counts, LoneTriangle& out) {
  const WindowVertices128& v = *job.vertices;
  std::size_t c[3] = {job.corners[3 * t], job.corners[3 * t + 1], job.corners[3 * t + 2]};
  if (job.cull != Cull::none) {
    const double ax = v.x_fx8(c[0]), ay = v.y_fx8(c[0]), bx = v.x_fx8(c[1]), by = v.y_fx8(c[1]), cx = v.x_fx8(c[2]),
                 cy = v.y_fx8(c[2]);
    const double area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
    const double wanted = job.cull == Cull::back ? -area : area;
    const double extents =
        (std::max({ax, bx, cx}) - std::min({ax, bx, cx})) + (std::max({ay, by, cy}) - std::min({ay, by, cy}));
    const int side = job.cull == Cull::back ? 1 : -1;
    if (wanted == 0.0) return ++counts.empty, false;
    if (wanted < 0.0 || (wanted <= 2.0 * extents + 4.0 && job.facing_sign(job.context, std::uint32_t(t)) * side <= 0)) {
      return ++counts.facing, false;
    }
  }
  const auto sort_pair = [&](int i, int j) {
    const std::int32_t ax = v.x_fx8(c[i]), bx = v.x_fx8(c[j]);
    if (bx < ax || (bx == ax && v.y_fx8(c[j]) < v.y_fx8(c[i]))) std::swap(c[i], c[j]);
  };
  sort_pair(0, 1);
  sort_pair(1, 2);
  sort_pair(0, 1);
  for (std::size_t k = 0; k < 3; ++k) out.x_fx8[k] = v.x_fx8(c[k]), out.y_fx8[k] = v.y_fx8(c[k]), out.z[k] = v.z[c[k]];
  out.owner = job.first_owner + std::uint32_t(t);
  return true;
}

bool Rasterize(const RasterJob& job, TileBuffers& tile, RasterCounts& counts) {
  Sifted sifted;
  Sift(job, counts, sifted);
  counts.tiny += std::uint64_t(sifted.flat.n + sifted.tall.n + sifted.tower.n);
  counts.medium += std::uint64_t(sifted.medium.n);
  int passed = 0;
  for (const TriangleList* list : {&sifted.flat, &sifted.tall, &sifted.tower})
    passed += RasterizeTiny(job, *list, tile, counts);
  int others_passed = RasterizeMedium(job, sifted.medium, tile, counts);
  for (int i = 0; i < sifted.n_others; ++i) {
    LoneTriangle lone;
    if (!TakeOut(job, sifted.others[i], counts, lone)) continue;
    ++counts.large;
    const int won = RasterizeLarge(job, lone, tile, counts);
    if (won > 0) job.marks[sifted.others[i]] = kWon | kWide;
    others_passed += won;
  }
  counts.fragments_kept += std::uint64_t(others_passed);
  passed += others_passed;
  counts.fragments_passed += std::uint64_t(passed);
  return passed > 0;
}

bool RasterizeLone(const RasterJob& job, const LoneTriangle& triangle, TileBuffers& tile, RasterCounts& counts) {
  ++counts.large;
  const int passed = RasterizeLarge(job, triangle, tile, counts);
  counts.fragments_passed += std::uint64_t(passed);
  counts.fragments_kept += std::uint64_t(passed);
  return passed > 0;
}

}  // namespace HWY_NAMESPACE
}  // namespace lode::raster::fast
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard

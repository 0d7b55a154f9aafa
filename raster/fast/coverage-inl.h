// Triangles of a cluster to samples (C2, C3, C5).
// Compiled once for each instruction set (Highway's re-included headers).

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "raster/fast/kernels.h"

#if defined(LODE_RASTER_FAST_COVERAGE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LODE_RASTER_FAST_COVERAGE_INL_H_
#undef LODE_RASTER_FAST_COVERAGE_INL_H_
#else
#define LODE_RASTER_FAST_COVERAGE_INL_H_
#endif

#include "raster/fast/depth-inl.h"
#include "raster/fast/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace lode::raster::fast {
namespace HWY_NAMESPACE {

/// A triangle ready for its samples: canonical order, edge functions positive inside.
struct Setup {
  std::int32_t x[3], y[3];  // canonical
  double z[3];
  double area;                // doubled, 1/256² px², positive
  std::int64_t dx[3], dy[3];  // of edge i
  std::int64_t bias[3];
  double z_low, z_high;
  int begin_x, begin_y, end_x, end_y;
  std::uint32_t owner;
};

/// Writes the samples of one vector that are covered and nearer; returns how many.
template <class M>
HWY_INLINE int Resolve(const RasterJob& job, TileBuffers& tile, int place, M covered, hn::Vec<HalfFloats> z,
                       std::uint32_t owner) {
  const HalfFloats f;
  const hn::Rebind<std::uint32_t, HalfFloats> u;
  const auto old = hn::Load(f, tile.depth + place);
  auto wins = hn::And(covered, hn::Gt(z, old));
  const auto equal = hn::And(covered, hn::Eq(z, old));
  if (HWY_UNLIKELY(!hn::AllFalse(f, equal))) {
    alignas(64) std::uint32_t flags[16];
    hn::Store(hn::VecFromMask(u, hn::RebindMask(u, equal)), u, flags);
    for (std::size_t i = 0; i < hn::Lanes(f); ++i) {
      flags[i] = flags[i] && job.key_before(job.context, owner, tile.owner[std::size_t(place) + i]) ? ~0u : 0u;
    }
    wins = hn::Or(wins, hn::RebindMask(f, hn::MaskFromVec(hn::BitCast(f, hn::Load(u, flags)))));
  }
  const std::size_t n = hn::CountTrue(f, wins);
  if (n == 0) return 0;
  hn::BlendedStore(z, wins, f, tile.depth + place);
  hn::BlendedStore(hn::Set(u, owner), hn::RebindMask(u, wins), u, tile.owner + place);
  return int(n);
}

/// C5: ((E₀·z₀ + E₁·z₁) + E₂·z₂) / area, clamped, rounded once.
HWY_INLINE hn::Vec<HalfFloats> DepthOf(const Setup& s, hn::Vec<Doubles> e0, hn::Vec<Doubles> e1, hn::Vec<Doubles> e2) {
  const Doubles d;
  const HalfFloats f;
  const auto sum = hn::Add(hn::Add(hn::Mul(e0, hn::Set(d, s.z[0])), hn::Mul(e1, hn::Set(d, s.z[1]))),
                           hn::Mul(e2, hn::Set(d, s.z[2])));
  const auto z = hn::Div(sum, hn::Set(d, s.area));
  return hn::DemoteTo(f, hn::Min(hn::Max(z, hn::Set(d, s.z_low)), hn::Set(d, s.z_high)));
}

/// Triangles of at most 64 px a side: all edge values of samples near them fit 32 bits.
int RasterizeSmall(const RasterJob& job, const Setup& s, TileBuffers& tile, RasterCounts& counts) {
  const Ints di;
  const Doubles d;
  const HalfInts hi;
  const HalfFloats hf;
  alignas(64) std::int32_t lane[3][16];
  std::int32_t base[3], step_x[3], step_y[3];
  const int bx0 = s.begin_x >> 2, by0 = s.begin_y >> 2, bx1 = (s.end_x - 1) >> 2, by1 = (s.end_y - 1) >> 2;
  const int px = bx0 * 1024 + job.sample_x_fx8, py = by0 * 1024 + job.sample_y_fx8;
  for (int i = 0; i < 3; ++i) {
    const auto dx = std::int32_t(s.dx[i]), dy = std::int32_t(s.dy[i]);
    const int a = (i + 1) % 3;  // any vertex on the edge
    base[i] = dx * (py - s.y[a]) - dy * (px - s.x[a]);
    step_x[i] = -dy * 1024;
    step_y[i] = dx * 1024;
    for (std::size_t l = 0; l < 16; l += hn::Lanes(di)) {
      hn::Store(hn::Sub(hn::Mul(hn::Set(di, dx), hn::Load(di, kLaneY_fx8 + l)),
                        hn::Mul(hn::Set(di, dy), hn::Load(di, kLaneX_fx8 + l))),
                di, lane[i] + l);
    }
  }
  int n_passed = 0;
  for (int by = by0; by <= by1; ++by) {
    for (int bx = bx0; bx <= bx1; ++bx) {
      ++counts.blocks;
      const std::int32_t b0 = base[0] + (bx - bx0) * step_x[0] + (by - by0) * step_y[0];
      const std::int32_t b1 = base[1] + (bx - bx0) * step_x[1] + (by - by0) * step_y[1];
      const std::int32_t b2 = base[2] + (bx - bx0) * step_x[2] + (by - by0) * step_y[2];
      const int place = place_in_tile(bx * 4, by * 4);
      int passed = 0;
      for (std::size_t l = 0; l < 16; l += hn::Lanes(d)) {
        const auto e0 = hn::Add(hn::Set(hi, b0), hn::Load(hi, lane[0] + l));
        const auto e1 = hn::Add(hn::Set(hi, b1), hn::Load(hi, lane[1] + l));
        const auto e2 = hn::Add(hn::Set(hi, b2), hn::Load(hi, lane[2] + l));
        const auto signs = hn::Or(hn::Or(hn::Sub(e0, hn::Set(hi, std::int32_t(s.bias[0]))),
                                         hn::Sub(e1, hn::Set(hi, std::int32_t(s.bias[1])))),
                                  hn::Sub(e2, hn::Set(hi, std::int32_t(s.bias[2]))));
        auto inside = hn::Gt(signs, hn::Set(hi, -1));
        const auto lx = hn::Load(hi, kLaneX + l), ly = hn::Load(hi, kLaneY + l);
        inside = hn::And(inside, hn::And(hn::Gt(lx, hn::Set(hi, s.begin_x - bx * 4 - 1)),
                                         hn::Lt(lx, hn::Set(hi, s.end_x - bx * 4))));
        inside = hn::And(inside, hn::And(hn::Gt(ly, hn::Set(hi, s.begin_y - by * 4 - 1)),
                                         hn::Lt(ly, hn::Set(hi, s.end_y - by * 4))));
        if (hn::AllFalse(hi, inside)) continue;
        const auto z = DepthOf(s, hn::PromoteTo(d, e0), hn::PromoteTo(d, e1), hn::PromoteTo(d, e2));
        passed += Resolve(job, tile, place + int(l), hn::RebindMask(hf, inside), z, s.owner);
      }
      if (passed) tile.stale[place >> 6] = 1;
      n_passed += passed;
    }
  }
  return n_passed;
}

/// Triangles of any size: edge values in double, where they are exact; blocks of 8×8 skipped by edges and by depth.
int RasterizeLarge(const RasterJob& job, const Setup& s, TileBuffers& tile, RasterCounts& counts) {
  const Doubles d;
  const HalfInts hi;
  const HalfFloats hf;
  alignas(64) double lane[3][16];
  double base[3], step_x[3], step_y[3], most[3];
  const int bx0 = s.begin_x >> 3, by0 = s.begin_y >> 3, bx1 = (s.end_x - 1) >> 3, by1 = (s.end_y - 1) >> 3;
  const double px = bx0 * 2048 + job.sample_x_fx8, py = by0 * 2048 + job.sample_y_fx8;
  for (int i = 0; i < 3; ++i) {
    const double dx = double(s.dx[i]), dy = double(s.dy[i]);
    const int a = (i + 1) % 3;
    base[i] = dx * (py - s.y[a]) - dy * (px - s.x[a]);
    step_x[i] = -dy * 256;
    step_y[i] = dx * 256;
    most[i] = 7.0 * (std::max(0.0, step_x[i]) + std::max(0.0, step_y[i]));  // from the block's first sample to its best
    for (int l = 0; l < 16; ++l) lane[i][l] = step_x[i] * kLaneX[l] + step_y[i] * kLaneY[l];
  }
  // The depth's plane over a block is nearest at one of its corner samples: z at the first one, and what it can gain.
  const double gain = 7.0 *
                      (std::fabs((step_x[0] * s.z[0] + step_x[1] * s.z[1]) + step_x[2] * s.z[2]) +
                       std::fabs((step_y[0] * s.z[0] + step_y[1] * s.z[1]) + step_y[2] * s.z[2])) /
                      s.area;
  int n_passed = 0;
  for (int by = by0; by <= by1; ++by) {
    for (int bx = bx0; bx <= bx1; ++bx) {
      double b[3];
      bool misses = false;
      for (int i = 0; i < 3; ++i) {
        b[i] = base[i] + step_x[i] * (8.0 * (bx - bx0)) + step_y[i] * (8.0 * (by - by0));
        misses |= b[i] + most[i] < double(s.bias[i]);
      }
      if (misses) continue;
      ++counts.blocks;
      const int block = by * kBlocksPerRow + bx;
      const double first = ((b[0] * s.z[0] + b[1] * s.z[1]) + b[2] * s.z[2]) / s.area;
      const double nearest = std::min(s.z_high, first + gain + 1e-9 * (std::fabs(first) + gain) + 0x1p-40);
      if (tile.stale[block]) {
        tile.stale[block] = 0;
        tile.block_min[block] = LeastOfBlock(tile, block);
      }
      if (nearest * (1.0 + 0x1p-20) < double(tile.block_min[block])) {
        ++counts.blocks_hidden;
        continue;
      }
      int passed = 0;
      for (int quarter = 0; quarter < 4; ++quarter) {
        const int qx = (quarter & 1) * 4, qy = (quarter >> 1) * 4;
        const double q0 = b[0] + step_x[0] * qx + step_y[0] * qy;
        const double q1 = b[1] + step_x[1] * qx + step_y[1] * qy;
        const double q2 = b[2] + step_x[2] * qx + step_y[2] * qy;
        for (std::size_t l = 0; l < 16; l += hn::Lanes(d)) {
          const auto e0 = hn::Add(hn::Set(d, q0), hn::Load(d, lane[0] + l));
          const auto e1 = hn::Add(hn::Set(d, q1), hn::Load(d, lane[1] + l));
          const auto e2 = hn::Add(hn::Set(d, q2), hn::Load(d, lane[2] + l));
          const auto in =
              hn::And(hn::And(hn::Ge(e0, hn::Set(d, double(s.bias[0]))), hn::Ge(e1, hn::Set(d, double(s.bias[1])))),
                      hn::Ge(e2, hn::Set(d, double(s.bias[2]))));
          if (hn::AllFalse(d, in)) continue;
          // Outside the box of pixels that may be written?
          const auto lx = hn::Load(hi, kLaneX + l), ly = hn::Load(hi, kLaneY + l);
          const int x0 = bx * 8 + qx, y0 = by * 8 + qy;
          const auto in_box =
              hn::And(hn::And(hn::Gt(lx, hn::Set(hi, s.begin_x - x0 - 1)), hn::Lt(lx, hn::Set(hi, s.end_x - x0))),
                      hn::And(hn::Gt(ly, hn::Set(hi, s.begin_y - y0 - 1)), hn::Lt(ly, hn::Set(hi, s.end_y - y0))));
          const auto narrow = hn::DemoteTo(hi, hn::IfThenElseZero(in, hn::Set(d, 1.0)));
          const auto inside = hn::And(hn::Ne(narrow, hn::Zero(hi)), in_box);
          if (hn::AllFalse(hi, inside)) continue;
          passed += Resolve(job, tile, block * 64 + quarter * 16 + int(l), hn::RebindMask(hf, inside),
                            DepthOf(s, e0, e1, e2), s.owner);
        }
      }
      if (passed) tile.stale[block] = 1;
      n_passed += passed;
    }
  }
  return n_passed;
}

bool SetUp(const RasterJob& job, int triangle, Setup* s) {
  const WindowVertices128& v = *job.vertices;
  int c[3] = {job.corners[3 * triangle], job.corners[3 * triangle + 1], job.corners[3 * triangle + 2]};
  bool odd = false;
  const auto sort_pair = [&](int i, int j) {
    const int a = c[i], b = c[j];
    if (v.x_fx8[b] < v.x_fx8[a] || (v.x_fx8[b] == v.x_fx8[a] && v.y_fx8[b] < v.y_fx8[a])) {
      std::swap(c[i], c[j]);
      odd = !odd;
    }
  };
  sort_pair(0, 1);
  sort_pair(1, 2);
  sort_pair(0, 1);
  for (int i = 0; i < 3; ++i) {
    s->x[i] = v.x_fx8[c[i]];
    s->y[i] = v.y_fx8[c[i]];
    s->z[i] = v.z[c[i]];
  }
  const std::int64_t area =
      std::int64_t(s->x[1] - s->x[0]) * (s->y[2] - s->y[0]) - std::int64_t(s->y[1] - s->y[0]) * (s->x[2] - s->x[0]);
  if (area == 0) return false;
  const std::int64_t sign = area > 0 ? 1 : -1;
  s->area = double(area * sign);
  for (int i = 0; i < 3; ++i) {
    const int a = (i + 1) % 3, b = (i + 2) % 3;
    s->dx[i] = sign * (s->x[b] - s->x[a]);
    s->dy[i] = sign * (s->y[b] - s->y[a]);
    s->bias[i] = s->dy[i] < 0 || (s->dy[i] == 0 && s->dx[i] > 0) ? 0 : 1;
  }
  s->z_low = std::min({s->z[0], s->z[1], s->z[2]});
  s->z_high = std::max({s->z[0], s->z[1], s->z[2]});
  return true;
}

/// Triangles of a cluster that may have samples, by how they are walked.
struct Survivors {
  alignas(64) std::int32_t tiny[kMaxClusterTriangles + 16];
  std::int32_t others[kMaxClusterTriangles];
  int n_tiny = 0, n_others = 0;
};

constexpr int kTinyPixels = 24;  ///< pixels in the box of a triangle that is walked in a lane

HWY_INLINE I Least(I a, I b, I c) { return hn::Min(hn::Min(a, b), c); }
HWY_INLINE I Most(I a, I b, I c) { return hn::Max(hn::Max(a, b), c); }

/// Corners of sixteen triangles.
struct Corners {
  I x[3], y[3];
  I local[3];
};
HWY_INLINE Corners LoadCorners(const RasterJob& job, I triangles) {
  const Ints di;
  const auto bytes = hn::GatherOffset(di, reinterpret_cast<const std::int32_t*>(job.corners),
                                      hn::Add(triangles, hn::Add(triangles, triangles)));
  const auto byte = hn::Set(di, 255);
  Corners c;
  c.local[0] = hn::And(bytes, byte);
  c.local[1] = hn::And(hn::ShiftRight<8>(bytes), byte);
  c.local[2] = hn::And(hn::ShiftRight<16>(bytes), byte);
  for (int k = 0; k < 3; ++k) {
    c.x[k] = hn::GatherIndex(di, job.vertices->x_fx8, c.local[k]);
    c.y[k] = hn::GatherIndex(di, job.vertices->y_fx8, c.local[k]);
  }
  return c;
}

/// Pixels whose samples the triangles' boxes hold, inside what may be written.
struct PixelBoxes {
  I begin_x, begin_y, end_x, end_y;
};
HWY_INLINE PixelBoxes BoxesOf(const RasterJob& job, const Corners& c) {
  const Ints di;
  const auto sx = hn::Set(di, job.sample_x_fx8), sy = hn::Set(di, job.sample_y_fx8), up = hn::Set(di, 255),
             one = hn::Set(di, 1);
  const auto x0 = Least(c.x[0], c.x[1], c.x[2]), x1 = Most(c.x[0], c.x[1], c.x[2]);
  const auto y0 = Least(c.y[0], c.y[1], c.y[2]), y1 = Most(c.y[0], c.y[1], c.y[2]);
  return {hn::Max(hn::Set(di, job.begin_x), hn::ShiftRight<8>(hn::Add(hn::Sub(x0, sx), up))),
          hn::Max(hn::Set(di, job.begin_y), hn::ShiftRight<8>(hn::Add(hn::Sub(y0, sy), up))),
          hn::Min(hn::Set(di, job.end_x), hn::Add(hn::ShiftRight<8>(hn::Sub(x1, sx)), one)),
          hn::Min(hn::Set(di, job.end_y), hn::Add(hn::ShiftRight<8>(hn::Sub(y1, sy)), one))};
}

/// Drops triangles without samples, turned away or without area, sixteen at a time.
void Sift(const RasterJob& job, RasterCounts& counts, Survivors& out) {
  const Ints di;
  const std::size_t lanes = hn::Lanes(di);
  for (int first = 0; first < job.n_triangles; first += int(lanes)) {
    const auto triangle = hn::Add(hn::Set(di, first), hn::Iota(di, 0));
    const auto exists = hn::Lt(triangle, hn::Set(di, job.n_triangles));
    const Corners c = LoadCorners(job, hn::IfThenElseZero(exists, triangle));
    const PixelBoxes box = BoxesOf(job, c);
    const auto w = hn::Sub(box.end_x, box.begin_x), h = hn::Sub(box.end_y, box.begin_y);
    auto alive = hn::And(exists, hn::And(hn::Gt(w, hn::Zero(di)), hn::Gt(h, hn::Zero(di))));
    counts.no_sample += hn::CountTrue(di, exists) - hn::CountTrue(di, alive);
    if (hn::AllFalse(di, alive)) continue;
    const auto extent_x = hn::Sub(Most(c.x[0], c.x[1], c.x[2]), Least(c.x[0], c.x[1], c.x[2]));
    const auto extent_y = hn::Sub(Most(c.y[0], c.y[1], c.y[2]), Least(c.y[0], c.y[1], c.y[2]));
    const auto narrow = hn::Lt(hn::Max(extent_x, extent_y), hn::Set(di, 64 * 256));
    const auto area = hn::Sub(hn::Mul(hn::Sub(c.x[1], c.x[0]), hn::Sub(c.y[2], c.y[0])),
                              hn::Mul(hn::Sub(c.y[1], c.y[0]), hn::Sub(c.x[2], c.x[0])));
    // Of narrow ones the area is exact here; the others are looked at one by one.
    const auto empty = hn::And(hn::And(alive, narrow), hn::Eq(area, hn::Zero(di)));
    counts.empty += hn::CountTrue(di, empty);
    alive = hn::AndNot(empty, alive);
    auto doubtful = hn::Lt(hn::Zero(di), hn::Zero(di));
    if (job.cull != Cull::none) {
      const auto wanted = job.cull == Cull::back ? hn::Sub(hn::Zero(di), area) : area;
      const auto away = hn::And(hn::And(alive, narrow), hn::Lt(wanted, hn::Zero(di)));
      counts.facing += hn::CountTrue(di, away);
      alive = hn::AndNot(away, alive);
      const auto doubt = hn::Add(hn::ShiftLeft<1>(hn::Add(extent_x, extent_y)), hn::Set(di, 4));
      doubtful = hn::And(hn::And(alive, narrow), hn::Not(hn::Gt(wanted, doubt)));
    }
    const auto tiny =
        hn::And(hn::And(alive, narrow),
                hn::AndNot(doubtful, hn::Not(hn::Gt(hn::Mul(hn::Min(w, hn::Set(di, 64)), hn::Min(h, hn::Set(di, 64))),
                                                    hn::Set(di, kTinyPixels)))));
    out.n_tiny += int(hn::CompressStore(triangle, tiny, di, out.tiny + out.n_tiny));
    alignas(64) std::int32_t rest[16];
    const auto n_rest = hn::CompressStore(triangle, hn::AndNot(tiny, alive), di, rest);
    for (std::size_t i = 0; i < n_rest; ++i) out.others[out.n_others++] = rest[i];
  }
}

/// Samples found by the lanes, to be given depths together.
struct Fragments {
  static constexpr int kMost = 16 * kTinyPixels;
  alignas(64) std::int32_t place[kMost + 16], lane[kMost + 16], e0[kMost + 16], e1[kMost + 16], e2[kMost + 16];
  int n = 0;
};

/// What the lanes' triangles have in common with a Setup, [16] each.
struct LaneSetups {
  alignas(64) double z0[16], z1[16], z2[16], area[16], low[16], high[16];
  alignas(64) std::int32_t owner[16];
};

/// Sixteen tiny triangles side by side: each lane walks the box of its own.
int RasterizeTiny(const RasterJob& job, const std::int32_t* list, int n, TileBuffers& tile) {
  const Ints di;
  const Doubles d;
  const HalfInts hi;
  const HalfFloats hf;
  const hn::RebindToSigned<Doubles> i64;
  alignas(64) LaneSetups setups;
  alignas(64) Fragments fragments;
  int passed = 0;
  for (int first = 0; first < n; first += int(hn::Lanes(di))) {
    const auto exists = hn::Lt(hn::Add(hn::Iota(di, 0), hn::Set(di, first)), hn::Set(di, n));
    const auto triangle = hn::IfThenElse(exists, hn::LoadU(di, list + first), hn::Set(di, list[first]));
    Corners c = LoadCorners(job, triangle);
    const PixelBoxes box = BoxesOf(job, c);
    const auto sort_pair = [&](int a, int b) HWY_ATTR {
      const auto swap = hn::Or(hn::Lt(c.x[b], c.x[a]), hn::And(hn::Eq(c.x[b], c.x[a]), hn::Lt(c.y[b], c.y[a])));
      for (I* v : {c.x, c.y, c.local}) {
        const I one = v[a], two = v[b];
        v[a] = hn::IfThenElse(swap, two, one);
        v[b] = hn::IfThenElse(swap, one, two);
      }
    };
    sort_pair(0, 1);
    sort_pair(1, 2);
    sort_pair(0, 1);
    const auto area = hn::Sub(hn::Mul(hn::Sub(c.x[1], c.x[0]), hn::Sub(c.y[2], c.y[0])),
                              hn::Mul(hn::Sub(c.y[1], c.y[0]), hn::Sub(c.x[2], c.x[0])));
    const auto negative = hn::Lt(area, hn::Zero(di));
    const auto px = hn::Add(hn::ShiftLeft<8>(box.begin_x), hn::Set(di, job.sample_x_fx8));
    const auto py = hn::Add(hn::ShiftLeft<8>(box.begin_y), hn::Set(di, job.sample_y_fx8));
    I row[3], step_x[3], step_y[3], bias[3];
    for (int k = 0; k < 3; ++k) {
      const int a = (k + 1) % 3, b = (k + 2) % 3;
      auto dx = hn::Sub(c.x[b], c.x[a]), dy = hn::Sub(c.y[b], c.y[a]);
      dx = hn::IfThenElse(negative, hn::Neg(dx), dx);
      dy = hn::IfThenElse(negative, hn::Neg(dy), dy);
      row[k] = hn::Sub(hn::Mul(dx, hn::Sub(py, c.y[a])), hn::Mul(dy, hn::Sub(px, c.x[a])));
      step_x[k] = hn::ShiftLeft<8>(hn::Neg(dy));
      step_y[k] = hn::ShiftLeft<8>(dx);
      const auto top_left =
          hn::Or(hn::Lt(dy, hn::Zero(di)), hn::And(hn::Eq(dy, hn::Zero(di)), hn::Gt(dx, hn::Zero(di))));
      bias[k] = hn::IfThenZeroElse(top_left, hn::Set(di, 1));
    }
    // Depths at the corners, for the fragments.
    for (std::size_t half = 0; half < hn::Lanes(di); half += hn::Lanes(d)) {
      alignas(64) std::int32_t local[3][16], areas[16];
      for (int k = 0; k < 3; ++k) hn::Store(c.local[k], di, local[k]);
      hn::Store(hn::Abs(area), di, areas);
      const auto z = [&](int k) HWY_ATTR {
        return hn::GatherIndex(d, job.vertices->z, hn::PromoteTo(i64, hn::LoadU(hi, local[k] + half)));
      };
      const auto z0 = z(0), z1 = z(1), z2 = z(2);
      hn::StoreU(z0, d, setups.z0 + half);
      hn::StoreU(z1, d, setups.z1 + half);
      hn::StoreU(z2, d, setups.z2 + half);
      hn::StoreU(hn::Min(hn::Min(z0, z1), z2), d, setups.low + half);
      hn::StoreU(hn::Max(hn::Max(z0, z1), z2), d, setups.high + half);
      hn::StoreU(hn::PromoteTo(d, hn::LoadU(hi, areas + half)), d, setups.area + half);
    }
    hn::Store(hn::Add(hn::Set(di, std::int32_t(job.first_owner)), triangle), di, setups.owner);

    // The walk.
    const auto w = hn::IfThenElseZero(exists, hn::Sub(box.end_x, box.begin_x)),
               h = hn::IfThenElseZero(exists, hn::Sub(box.end_y, box.begin_y));
    const int most_w = hn::GetLane(hn::MaxOfLanes(di, w)), most_h = hn::GetLane(hn::MaxOfLanes(di, h));
    fragments.n = 0;
    for (int dy = 0; dy < most_h; ++dy) {
      const auto row_alive = hn::Gt(h, hn::Set(di, dy));
      I e[3] = {row[0], row[1], row[2]};
      const auto y = hn::Add(box.begin_y, hn::Set(di, dy));
      for (int dx = 0; dx < most_w; ++dx) {
        const auto signs = hn::Or(hn::Or(hn::Sub(e[0], bias[0]), hn::Sub(e[1], bias[1])), hn::Sub(e[2], bias[2]));
        const auto inside = hn::And(hn::And(row_alive, hn::Gt(w, hn::Set(di, dx))), hn::Gt(signs, hn::Set(di, -1)));
        if (!hn::AllFalse(di, inside)) {
          const auto x = hn::Add(box.begin_x, hn::Set(di, dx));
          const auto packed = hn::Or(hn::ShiftLeft<16>(y), x);
          hn::CompressStore(packed, inside, di, fragments.place + fragments.n);
          hn::CompressStore(hn::Iota(di, 0), inside, di, fragments.lane + fragments.n);
          hn::CompressStore(e[0], inside, di, fragments.e0 + fragments.n);
          hn::CompressStore(e[1], inside, di, fragments.e1 + fragments.n);
          fragments.n += int(hn::CompressStore(e[2], inside, di, fragments.e2 + fragments.n));
        }
        for (int k = 0; k < 3; ++k) e[k] = hn::Add(e[k], step_x[k]);
      }
      for (int k = 0; k < 3; ++k) row[k] = hn::Add(row[k], step_y[k]);
    }

    // Depths, and who wins.
    for (int f = fragments.n; f < fragments.n + 16; ++f)
      fragments.lane[f] = 0, fragments.e0[f] = fragments.e1[f] = fragments.e2[f] = 0;
    for (int f = 0; f < fragments.n; f += int(hn::Lanes(d))) {
      const auto lane = hn::PromoteTo(i64, hn::LoadU(hi, fragments.lane + f));
      const auto e0 = hn::PromoteTo(d, hn::LoadU(hi, fragments.e0 + f));
      const auto e1 = hn::PromoteTo(d, hn::LoadU(hi, fragments.e1 + f));
      const auto e2 = hn::PromoteTo(d, hn::LoadU(hi, fragments.e2 + f));
      const auto sum = hn::Add(
          hn::Add(hn::Mul(e0, hn::GatherIndex(d, setups.z0, lane)), hn::Mul(e1, hn::GatherIndex(d, setups.z1, lane))),
          hn::Mul(e2, hn::GatherIndex(d, setups.z2, lane)));
      const auto z = hn::Div(sum, hn::GatherIndex(d, setups.area, lane));
      alignas(64) float depths[16];
      hn::StoreU(hn::DemoteTo(hf, hn::Min(hn::Max(z, hn::GatherIndex(d, setups.low, lane)),
                                          hn::GatherIndex(d, setups.high, lane))),
                 hf, depths);
      const int end = std::min(int(hn::Lanes(d)), fragments.n - f);
      for (int k = 0; k < end; ++k) {
        const std::int32_t packed = fragments.place[f + k];
        const int place = place_in_tile(packed & 0xFFFF, packed >> 16);
        const float depth = depths[k], old = tile.depth[place];
        const auto owner = std::uint32_t(setups.owner[fragments.lane[f + k]]);
        if (depth > old || (depth == old && job.key_before(job.context, owner, tile.owner[place]))) {
          tile.depth[place] = depth;
          tile.owner[place] = owner;
          tile.stale[place >> 6] = 1;
          ++passed;
        }
      }
    }
  }
  return passed;
}

/// A triangle by itself, of any size.
int RasterizeOne(const RasterJob& job, int t, TileBuffers& tile, RasterCounts& counts) {
  const WindowVertices128& v = *job.vertices;
  const int a = job.corners[3 * t], b = job.corners[3 * t + 1], c = job.corners[3 * t + 2];
  const int x0 = std::min({v.x_fx8[a], v.x_fx8[b], v.x_fx8[c]}), x1 = std::max({v.x_fx8[a], v.x_fx8[b], v.x_fx8[c]});
  const int y0 = std::min({v.y_fx8[a], v.y_fx8[b], v.y_fx8[c]}), y1 = std::max({v.y_fx8[a], v.y_fx8[b], v.y_fx8[c]});
  Setup s;
  s.begin_x = std::max(job.begin_x, (x0 - job.sample_x_fx8 + 255) >> 8);
  s.end_x = std::min(job.end_x, ((x1 - job.sample_x_fx8) >> 8) + 1);
  s.begin_y = std::max(job.begin_y, (y0 - job.sample_y_fx8 + 255) >> 8);
  s.end_y = std::min(job.end_y, ((y1 - job.sample_y_fx8) >> 8) + 1);
  if (job.cull != Cull::none) {
    const double area = double(v.x_fx8[b] - v.x_fx8[a]) * double(v.y_fx8[c] - v.y_fx8[a]) -
                        double(v.y_fx8[b] - v.y_fx8[a]) * double(v.x_fx8[c] - v.x_fx8[a]);
    // Counter-clockwise as seen has a negative area with y down. Snapping moves each difference by less than 1.
    const double wanted = job.cull == Cull::back ? -area : area;
    const double doubt = 2.0 * (double(x1 - x0) + double(y1 - y0)) + 4.0;
    if (wanted <= 0.0 ||
        (wanted <= doubt && job.facing_sign(job.context, std::uint32_t(t)) * (job.cull == Cull::back ? 1 : -1) <= 0)) {
      ++counts.facing;
      return 0;
    }
  }
  if (!SetUp(job, t, &s)) {
    ++counts.empty;
    return 0;
  }
  s.owner = job.first_owner + std::uint32_t(t);
  const bool small = x1 - x0 <= 64 * 256 && y1 - y0 <= 64 * 256;
  return small ? RasterizeSmall(job, s, tile, counts) : RasterizeLarge(job, s, tile, counts);
}

bool Rasterize(const RasterJob& job, TileBuffers& tile, RasterCounts& counts) {
  Survivors survivors;
  counts.triangles_in += std::uint64_t(job.n_triangles);
  Sift(job, counts, survivors);
  counts.rasterized += std::uint64_t(survivors.n_tiny);
  int passed = RasterizeTiny(job, survivors.tiny, survivors.n_tiny, tile);
  for (int i = 0; i < survivors.n_others; ++i) passed += RasterizeOne(job, survivors.others[i], tile, counts);
  counts.fragments_passed += std::uint64_t(passed);
  return passed > 0;
}

}  // namespace HWY_NAMESPACE
}  // namespace lode::raster::fast
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard

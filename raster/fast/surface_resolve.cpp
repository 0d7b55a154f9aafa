#include "raster/fast/surface_resolve.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace lode::raster::fast {
namespace {

constexpr int kManyLanes = 5;  ///< from which on a triangle is worth a kernel call of its own

/// Whether apply_linear_texture filters the surface's texture.
bool filtered_by_kernel(const Surface& s) {
  return s.texture->format == TextureFormat::linear && s.sampler.filter != Filter::nearest;
}

/// As the cut-out of the surface has it.
///   kept   a bit a sample: of those in pixels that are kept
void cut_out(const Kernels& kernels, const Surface& surface, std::uint32_t kept, SurfaceSamples& samples) {
  kernels.cut_out_surface(surface, samples);
  for_each_lane(0xFFFF & ~kept, [&](std::size_t k) {
    for (auto& channel : samples.rgba) channel[k] = 0.0f;
  });
}

}  // namespace

void shade_samples(const Kernels& kernels, const Surface& surface, const SurfaceTriangle& triangle,
                   glm::ivec2 first_fx8, std::uint32_t lanes, FrameStats& stats, SurfaceSamples& samples) {
  kernels.shade_surface(surface, triangle, first_fx8.x, first_fx8.y, samples);
  if (surface.texture) {
    stats.texels_read += filtered_by_kernel(surface) ? kernels.apply_linear_texture(surface, lanes, samples)
                                                     : apply_texture(surface, lanes, samples);
  }
  if (surface.cut_out) cut_out(kernels, surface, surface.kept_pixels, samples);
}

SurfaceResolver::SurfaceResolver(const Scene& scene, Worker& worker, const Owners& owners, const PixelBox& box,
                                 glm::ivec2 sample_fx8, ColorFormat format)
    : scene_(scene), w_(worker), owners_(owners), origin_px_(box.begin_px), sample_fx8_(sample_fx8), format_(format) {
  for (KeptSurface& kept : *w_.surfaces) kept.owner = kNoOwner;
}

bool SurfaceResolver::shade(std::uint32_t owner, int x_px, int y_px, std::uint32_t lanes) {
  const std::optional<Surface>& surface = scene_.surfaces[owners_.draw(owner)];
  if (!surface) return false;
  if ((owner & kPieceBit) || surface->texture || std::popcount(lanes) >= kManyLanes) {
    return shade_alone(*surface, owner, x_px, y_px, lanes);
  }
  for_each_lane(lanes, [&](std::size_t k) { shade_later(owner, x_px + int(k & 3), y_px + int(k >> 2)); });
  return true;
}

void SurfaceResolver::shade_later(std::uint32_t owner, int x_px, int y_px) {
  const std::uint32_t fast_draw = w_.residents[owner / kSlotTriangles].fast_draw;
  Batch& batch = batches_[fast_draw % batches_.size()];
  if (batch.n == 16 || batch.fast_draw != fast_draw) flush(batch);
  batch.fast_draw = fast_draw;
  batch.owners[batch.n] = owner, batch.places[batch.n] = std::uint32_t(place_in_tile(x_px, y_px));
  batch.x_fx8[batch.n] = x_px * 256 + sample_fx8_.x, batch.y_fx8[batch.n] = y_px * 256 + sample_fx8_.y;
  ++batch.n;
}

void SurfaceResolver::finish() {
  for (Batch& batch : batches_) flush(batch);
}

void SurfaceResolver::flush(Batch& batch) {
  if (batch.n == 0) return;
  for (std::size_t k = batch.n; k < 16; ++k) {
    batch.owners[k] = batch.owners[0], batch.places[k] = batch.places[0];
    batch.x_fx8[k] = batch.x_fx8[0], batch.y_fx8[k] = batch.y_fx8[0];
  }
  const FastDraw& fast = scene_.fast[batch.fast_draw];
  OwnersJob job = fast.owners_job;
  job.surface = &*scene_.surfaces[fast.draw];
  job.residents = w_.residents.data(), job.vertices = w_.vertices.get();
  job.x_fx8 = batch.x_fx8.data(), job.y_fx8 = batch.y_fx8.data();
  SurfaceSamples samples;
  scene_.kernels->shade_owners(job, batch.owners.data(), samples);
  if (job.surface->cut_out) {
    std::uint32_t kept = 0;
    for (std::size_t k = 0; k < 16; ++k) kept |= (job.surface->kept_pixels >> (batch.places[k] & 15) & 1) << k;
    cut_out(*scene_.kernels, *job.surface, kept, samples);
  }
  store(samples, [&](auto visit) {
    for (std::size_t k = 0; k < batch.n; ++k) visit(k, batch.places[k]);
  });
  batch.n = 0;
}

bool SurfaceResolver::shade_alone(const Surface& surface, std::uint32_t owner, int x_px, int y_px,
                                  std::uint32_t lanes) {
  KeptSurface& kept = (*w_.surfaces)[owner % w_.surfaces->size()];
  if (kept.owner != owner) {
    Piece made;
    const Piece& p = owners_.piece_of(owner, made);
    if (!std::holds_alternative<reference::Triangle>(p.shape)) return false;
    keep(kept, owner, make_surface_triangle(scene_.frame->draws[p.draw], p, origin_px_), surface);
  }
  const auto base = std::size_t(place_in_tile(x_px, y_px));
  if (kept.one_color) {
    fill(kept, base, lanes);
    return true;
  }
  SurfaceSamples samples;
  shade_samples(*scene_.kernels, surface, kept.triangle, glm::ivec2(x_px, y_px) * 256 + sample_fx8_, lanes, w_.stats,
                samples);
  store(samples, [&](auto visit) { for_each_lane(lanes, [&](std::size_t k) { visit(k, base + k); }); });
  return true;
}

void SurfaceResolver::keep(KeptSurface& kept, std::uint32_t owner, const SurfaceTriangle& triangle,
                           const Surface& surface) {
  kept = {owner, triangle, has_one_color(surface, triangle)};
  if (!kept.one_color) return;
  SurfaceSamples samples;
  shade_samples(*scene_.kernels, surface, triangle, {0, 0}, 1, w_.stats, samples);
  if (format_ == ColorFormat::rgba8) {
    std::array<std::uint32_t, 16> bytes;
    scene_.kernels->store_bytes(samples.rgba[0], bytes.data());
    kept.rgba8 = bytes[0];
  } else {
    alignas(64) std::array<glm::vec4, 16> colors;
    scene_.kernels->store_floats(samples, &colors[0].x);
    kept.rgba32f = colors[0];
  }
}

void SurfaceResolver::fill(const KeptSurface& kept, std::size_t base, std::uint32_t lanes) {
  if (format_ == ColorFormat::rgba8) {
    for_each_lane(lanes, [&](std::size_t k) { std::memcpy(static_cast<void*>(&w_.rgba8[base + k]), &kept.rgba8, 4); });
    return;
  }
  one_color_owner_ = kept.owner, one_color_ = kept.rgba32f;
  if (lanes == 0xFFFF) {
    std::fill_n(w_.rgba32f.begin() + std::ptrdiff_t(base), 16, kept.rgba32f);
  } else {
    for_each_lane(lanes, [&](std::size_t k) { w_.rgba32f[base + k] = kept.rgba32f; });
  }
}

template <class ForEach>
void SurfaceResolver::store(const SurfaceSamples& samples, ForEach for_each) {
  if (format_ == ColorFormat::rgba8) {
    std::array<std::uint32_t, 16> bytes;
    scene_.kernels->store_bytes(samples.rgba[0], bytes.data());
    for_each(
        [&](std::size_t k, std::size_t place) { std::memcpy(static_cast<void*>(&w_.rgba8[place]), &bytes[k], 4); });
  } else {
    alignas(64) std::array<glm::vec4, 16> colors;
    scene_.kernels->store_floats(samples, &colors[0].x);
    for_each([&](std::size_t k, std::size_t place) { w_.rgba32f[place] = colors[k]; });
  }
}

}  // namespace lode::raster::fast

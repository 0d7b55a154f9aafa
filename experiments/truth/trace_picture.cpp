#include "experiments/truth/trace_picture.h"

#include <algorithm>
#include <optional>
#include <tuple>

#include "experiments/truth/surface_point.h"
#include "raster/blend.h"
#include "raster/parallel.h"

namespace lode::experiments::truth {
namespace {

constexpr std::uint32_t kSolid = 1, kMasked = 2, kBlended = 4;

std::uint32_t mask_of(const raster::Draw& draw) {
  if (draw.blend != raster::Blend::none) return kBlended;
  return draw.alpha_test ? kMasked : kSolid;
}

struct Surface {
  raster::Ids ids{raster::kNoId, raster::kNoId};
  SurfacePoint point;
  std::optional<glm::vec4> rgba;  ///< where shading was needed to know that it is there
};

/// The rasterizer's order (C6): nearer first, then lower ids.
bool wins(const Surface& a, const Surface& b) {
  if (a.point.depth != b.point.depth) return a.point.depth > b.point.depth;
  return std::tie(a.ids.draw, a.ids.primitive) < std::tie(b.ids.draw, b.ids.primitive);
}

/// A colour as a target of either format stores it.
struct Stored {
  glm::u8vec4 rgba8{0};
  glm::vec4 rgba32f{0.0f};
};

class PictureTracer {
 public:
  PictureTracer(std::span<const raster::Draw> draws, const CameraRays& rays, const PictureRequest& request,
                raster::Image& image)
      : draws_(draws), rays_(rays), request_(request), image_(image) {
    for (const raster::Draw& draw : draws) {
      if (draw.topology == raster::Topology::triangles) present_ |= mask_of(draw);
    }
    has_color_ = !image.rgba8.empty() || !image.rgba32f.empty();
  }

  void trace_row(int y) const {
    std::vector<geometry::RayHit> hits;
    for (int x = 0; x < request_.size_px.x; ++x) trace_pixel({x, y}, hits);
  }

 private:
  void trace_pixel(glm::ivec2 px, std::vector<geometry::RayHit>& hits) const {
    const std::size_t i = std::size_t(px.y) * std::size_t(request_.size_px.x) + std::size_t(px.x);
    glm::uvec4 sum_rgba8(0);
    glm::dvec4 sum_rgba32f(0.0);
    for (const glm::ivec2 sample_fx8 : request_.samples_fx8) {
      const glm::dvec2 p_px = glm::dvec2(px) + glm::dvec2(sample_fx8) / 256.0;
      const std::optional<Surface> solid = nearest_solid(px, p_px, hits);
      if (!image_.ids.empty()) image_.ids[i] = solid ? solid->ids : raster::Ids{raster::kNoId, raster::kNoId};
      if (!image_.depth.empty()) image_.depth[i] = solid ? solid->point.depth : 0.0f;
      if (!has_color_) continue;
      const Stored color = color_at(px, p_px, solid, hits);
      sum_rgba8 += glm::uvec4(color.rgba8);
      sum_rgba32f += glm::dvec4(color.rgba32f);
    }
    const auto n = static_cast<unsigned>(request_.samples_fx8.size());
    if (!image_.rgba8.empty()) image_.rgba8[i] = glm::u8vec4((2u * sum_rgba8 + glm::uvec4(n)) / (2u * n));
    if (!image_.rgba32f.empty()) image_.rgba32f[i] = raster::store_rgba32f(glm::vec4(sum_rgba32f / double(n)));
  }

  Surface surface(const geometry::RayHit& hit, glm::dvec2 p_px) const {
    return {rays_.ids(hit), surface_point(draw_of(hit), hit.primitive, request_.size_px, p_px), {}};
  }
  const raster::Draw& draw_of(const geometry::RayHit& hit) const { return draws_[rays_.ids(hit).draw]; }

  glm::vec4 shaded(const Surface& s, glm::ivec2 px) const {
    return s.rgba ? *s.rgba : shade(draws_[s.ids.draw], s.ids, request_.format, px, s.point);
  }

  std::optional<Surface> nearest_solid(glm::ivec2 px, glm::dvec2 p_px, std::vector<geometry::RayHit>& hits) const {
    std::optional<Surface> best;
    if (present_ & kSolid) {
      const std::optional<geometry::RayHit> hit = rays_.scene().nearest(rays_.ray(p_px, kSolid));
      if (hit) best = surface(*hit, p_px);
    }
    if (!(present_ & kMasked)) return best;
    rays_.scene().all(rays_.ray(p_px, kMasked), hits);
    const float full = request_.format == raster::ColorFormat::rgba8 ? 255.0f : 1.0f;
    for (const geometry::RayHit& hit : hits) {
      Surface candidate = surface(hit, p_px);
      if (best && !wins(candidate, *best)) continue;
      candidate.rgba = shaded(candidate, px);
      const double alpha = double(candidate.rgba->a) / double(full);
      if (alpha >= *draw_of(hit).alpha_test) best = candidate;
    }
    return best;
  }

  Stored color_at(glm::ivec2 px, glm::dvec2 p_px, const std::optional<Surface>& solid,
                  std::vector<geometry::RayHit>& hits) const {
    const glm::vec4 behind = solid ? shaded(*solid, px) : request_.clear;
    Stored color{raster::store_rgba8(behind), raster::store_rgba32f(behind)};
    if (!(present_ & kBlended)) return color;
    rays_.scene().all(rays_.ray(p_px, kBlended), hits);
    std::vector<Surface> layers;
    for (const geometry::RayHit& hit : hits) {
      const Surface layer = surface(hit, p_px);
      if (!solid || layer.point.depth > solid->point.depth) layers.push_back(layer);
    }
    std::sort(layers.begin(), layers.end(), [](const Surface& a, const Surface& b) {
      return std::tie(a.ids.draw, a.ids.primitive) < std::tie(b.ids.draw, b.ids.primitive);
    });
    for (const Surface& layer : layers) {
      const glm::vec4 rgba = shaded(layer, px);
      const raster::Blend blend = draws_[layer.ids.draw].blend;
      color.rgba8 = raster::blend_rgba8(blend, raster::store_rgba8(rgba), color.rgba8);
      color.rgba32f = raster::blend_rgba32f(blend, rgba, color.rgba32f);
    }
    return color;
  }

  std::span<const raster::Draw> draws_;
  const CameraRays& rays_;
  const PictureRequest& request_;
  raster::Image& image_;
  std::uint32_t present_ = 0;  ///< masks of the draws there are
  bool has_color_ = false;
};

}  // namespace

raster::Image trace_picture(const techniques::SceneDraws& scene_draws, const geometry::Camera& camera,
                            const geometry::Bounds& bounds, const PictureRequest& request, int threads,
                            const std::function<void()>& on_row) {
  raster::Image image = raster::make_image(request.size_px, request.format, request.planes);
  std::vector<raster::Draw> draws = scene_draws.draws(camera, request.size_px);
  std::vector<TracedDraw> traced;
  for (std::size_t i = 0; i < draws.size(); ++i) {
    draws[i].draw_id = std::uint32_t(i);
    if (draws[i].topology != raster::Topology::triangles) continue;
    traced.push_back({&draws[i], scene_draws.scene().instances[i].world_from_object, mask_of(draws[i])});
  }
  const CameraRays rays(traced, camera, request.size_px, bounds);
  const PictureTracer tracer(draws, rays, request, image);
  raster::parallel_for(std::size_t(request.size_px.y), raster::worker_count(threads), [&](std::size_t y, int) {
    tracer.trace_row(int(y));
    if (on_row) on_row();
  });
  return image;
}

}  // namespace lode::experiments::truth

#include "techniques/octahedral_impostors/blended_views.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <optional>
#include <span>

#include "raster/sample.h"

namespace lode::techniques {
namespace {

constexpr raster::Sampler kSampler{
    .filter = raster::Filter::trilinear, .wrap_u = raster::Wrap::border, .wrap_v = raster::Wrap::border};

constexpr std::size_t kMost = raster::kMaxSampleBatch;

/// One picture, with the plate's rays in its camera's space.
class ShownView {
 public:
  ShownView(const PlateRays& plate, const WeightedView& view)
      : picture_(*view.picture), weight_(view.weight), texels_(view.texels_a_pixel), parallel_(plate.parallel) {
    const geometry::Camera& camera = picture_.camera;
    const auto seen = [&](const glm::dvec3& v) {
      return glm::dvec3(glm::dot(v, camera.right), glm::dot(v, camera.up), glm::dot(v, camera.back));
    };
    point_from_uv_ = glm::dmat3(seen(plate.along_u), seen(plate.along_v), seen(plate.corner));
    eye_ = seen(plate.eye), direction_ = seen(plate.direction);
    uv_from_units_ = 0.5 / geometry::half_extent(camera, picture_.size_px());
  }

  /// Adds the weighted colours at up to kMost places of the plate.
  void add_to(std::span<glm::dvec4> sums, const glm::vec2* plate_uvs, bool parallax, raster::Target target) const {
    raster::SampleBatch batch;
    batch.rho_squared = texels_ * texels_;
    for (std::size_t i = 0; i < sums.size(); ++i) {
      const std::optional<glm::dvec2> uv = place_of(glm::dvec2(plate_uvs[i]), parallax);
      if (!uv) continue;
      batch.u[i] = uv->x, batch.v[i] = uv->y;
      batch.wanted |= 1u << i;
    }
    if (batch.wanted == 0) return;
    std::array<glm::vec4, kMost> texels;
    raster::sample_linear(picture_.texture, kSampler, batch, target, texels);
    for (std::size_t i = 0; i < sums.size(); ++i) {
      if (batch.wanted >> i & 1) sums[i] += weight_ * glm::dvec4(texels[i]);
    }
  }

 private:
  /// In the picture, where the ray through a place of the plate reads it; nothing if the ray does not come down on it.
  [[nodiscard]] std::optional<glm::dvec2> place_of(const glm::dvec2& plate_uv, bool parallax) const {
    const glm::dvec3 p = point_from_uv_ * glm::dvec3(plate_uv, 1.0);
    const glm::dvec3 ray = parallel_ ? direction_ : p - eye_;
    if (!(ray.z < 0.0)) return std::nullopt;
    const glm::dvec2 uv = where_at(0.0, p, ray);
    if (!parallax) return uv;
    const std::optional<double> height = height_at(uv);
    return height ? where_at(*height, p, ray) : uv;
  }

  /// In the picture, where a ray through p meets the plane of a height before the centre.
  [[nodiscard]] glm::dvec2 where_at(double height, const glm::dvec3& p, const glm::dvec3& ray) const {
    const glm::dvec2 met = glm::dvec2(p) + (height - p.z) / ray.z * glm::dvec2(ray);
    return 0.5 + glm::dvec2(met.x, -met.y) * uv_from_units_;
  }

  /// Of the object before the plane through the centre; nothing where the picture has nothing.
  [[nodiscard]] std::optional<double> height_at(const glm::dvec2& uv) const {
    const glm::ivec2 size_px = picture_.size_px();
    if (!(uv.x >= 0.0 && uv.x < 1.0 && uv.y >= 0.0 && uv.y < 1.0)) return std::nullopt;
    const glm::ivec2 texel(uv * glm::dvec2(size_px));
    const double depth = picture_.depth[std::size_t(texel.y) * std::size_t(size_px.x) + std::size_t(texel.x)];
    if (!(depth > 0.0)) return std::nullopt;
    // The eye is the centre; the depth is (far − d)/(far − near) at view distance d.
    return depth * (picture_.camera.far - picture_.camera.near) - picture_.camera.far;
  }

  const CapturedPicture& picture_;
  double weight_, texels_;
  bool parallel_;
  glm::dmat3 point_from_uv_{1.0};  ///< of (u, v, 1)
  glm::dvec3 eye_{0.0}, direction_{0.0};
  glm::dvec2 uv_from_units_{0.0};
};

struct Blend {
  std::vector<ShownView> views;
  bool parallax;
  raster::Target target;
};

void shade_blend(const void* state, const raster::ShadeBatch& batch, glm::vec4* rgba) noexcept {
  const Blend& blend = *static_cast<const Blend*>(state);
  for (std::size_t first = 0; first < std::size_t(batch.n); first += kMost) {
    std::array<glm::dvec4, kMost> sums{};
    const std::size_t n = std::min(kMost, std::size_t(batch.n) - first);
    for (const ShownView& view : blend.views) {
      view.add_to({sums.data(), n}, batch.uv + first, blend.parallax, blend.target);
    }
    for (std::size_t i = 0; i < n; ++i) {
      const bool kept = sums[i].a >= 0.5;
      rgba[first + i] = kept ? glm::vec4(glm::vec3(glm::dvec3(sums[i]) / sums[i].a), 1.0f) : glm::vec4(0.0f);
    }
  }
}

}  // namespace

raster::Shader blended_views(const PlateRays& plate, const std::array<WeightedView, 3>& views, bool parallax,
                             raster::Target target) {
  Blend blend{.views = {}, .parallax = parallax, .target = target};
  for (const WeightedView& view : views) {
    if (view.weight > 0.0) blend.views.emplace_back(plate, view);
  }
  return {shade_blend, std::make_shared<const Blend>(std::move(blend))};
}

}  // namespace lode::techniques

#include "techniques/octahedral_impostors/blended_views.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <optional>

namespace lode::techniques {
namespace {

constexpr raster::Sampler kSampler{
    .filter = raster::Filter::trilinear, .wrap_u = raster::Wrap::border, .wrap_v = raster::Wrap::border};

/// One picture, with the plate's rays in its camera's space.
class ShownView {
 public:
  ShownView(const PlateRays& plate, const WeightedView& view)
      : picture_(*view.picture), weight_(view.weight), lambda_fx8_(view.lambda_fx8), parallel_(plate.parallel) {
    const geometry::Camera& camera = picture_.camera;
    const auto seen = [&](const glm::dvec3& v) {
      return glm::dvec3(glm::dot(v, camera.right), glm::dot(v, camera.up), glm::dot(v, camera.back));
    };
    point_from_uv_ = glm::dmat3(seen(plate.along_u), seen(plate.along_v), seen(plate.corner));
    eye_ = seen(plate.eye), direction_ = seen(plate.direction);
    uv_from_units_ = 0.5 / geometry::half_extent(camera, picture_.size_px());
  }

  [[nodiscard]] double weight() const { return weight_; }

  [[nodiscard]] glm::vec4 color(const glm::dvec2& plate_uv, bool parallax) const {
    const glm::dvec3 p = point_from_uv_ * glm::dvec3(plate_uv, 1.0);
    const glm::dvec3 ray = parallel_ ? direction_ : p - eye_;
    if (!(ray.z < 0.0)) return glm::vec4(0.0f);
    glm::dvec2 uv = where_at(0.0, p, ray);
    if (parallax) {
      if (const std::optional<double> height = height_at(uv)) uv = where_at(*height, p, ray);
    }
    return raster::sample_linear(picture_.texture, kSampler, uv, lambda_fx8_);
  }

 private:
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
  double weight_;
  std::int32_t lambda_fx8_;
  bool parallel_;
  glm::dmat3 point_from_uv_{1.0};  ///< of (u, v, 1)
  glm::dvec3 eye_{0.0}, direction_{0.0};
  glm::dvec2 uv_from_units_{0.0};
};

}  // namespace

raster::Shader blended_views(const PlateRays& plate, const std::array<WeightedView, 3>& views, bool parallax) {
  std::vector<ShownView> shown;
  for (const WeightedView& view : views) {
    if (view.weight > 0.0) shown.emplace_back(plate, view);
  }
  return raster::pixel_shader([shown = std::move(shown), parallax](const raster::Pixel& pixel) {
    glm::dvec4 sum(0.0);
    for (const ShownView& view : shown) {
      sum += view.weight() * glm::dvec4(view.color(glm::dvec2(pixel.uv), parallax));
    }
    if (!(sum.a >= 0.5)) return glm::vec4(0.0f);
    return glm::vec4(glm::vec3(glm::dvec3(sum) / sum.a), 1.0f);
  });
}

}  // namespace lode::techniques

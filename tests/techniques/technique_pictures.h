#pragma once
/// Pictures by techniques, and small random scenes to take them of.

#include <algorithm>
#include <cstring>
#include <glm/gtc/matrix_transform.hpp>
#include <string>
#include <string_view>

#include "geometry/procedural.h"
#include "geometry/random.h"
#include "raster/render.h"
#include "techniques/plain/plain.h"
#include "techniques/stage.h"
#include "tests/raster/both_pipelines.h"

namespace lode::tests {

inline constexpr techniques::SceneDraws::Params kRawUnlit{techniques::Shading::unlit, techniques::ColorSpace::raw};

/// What a technique makes of a view: the picture with all planes, and what it counted.
struct TechniquePicture {
  raster::Image image;
  techniques::Counters counters;
  std::vector<bool> drawn;  ///< [objects]

  [[nodiscard]] std::uint64_t count(std::string_view name) const {
    for (const techniques::Counter& counter : counters) {
      if (counter.name == name) return counter.value;
    }
    ADD_FAILURE() << "no counter " << name;
    return 0;
  }
};

/// A technique that goes through the views of one world.
template <class T>
class Showing {
 public:
  Showing(const techniques::World& world, T technique, raster::Skips skips = {})
      : world_(world),
        technique_(std::move(technique)),
        options_{.threads = 1, .skips = skips},
        stage_(world, options_) {
    technique_.prepare(stage_);
  }

  [[nodiscard]] TechniquePicture picture(const techniques::View& view) {
    TechniquePicture result;
    stage_.begin(view);
    result.counters = technique_.draw(view, stage_);
    for (techniques::ObjectId id = 0; id < world_.objects().size(); ++id) result.drawn.push_back(stage_.drawn(id));
    result.image = raster::make_image(view.size_px, techniques::color_format(world_.color_space()));
    raster::render({.draws = stage_.draws(), .clear = {}, .viewport = {}, .scissor = {}}, result.image, options_);
    return result;
  }

 private:
  const techniques::World& world_;
  T technique_;
  raster::RenderOptions options_;
  techniques::Stage stage_;
};

/// Makes objects of one to three instances each.
inline void group(geometry::Scene& scene, std::uint64_t seed) {
  const auto n = std::uint32_t(scene.instances.size());
  for (std::uint32_t first = 0; first < n;) {
    geometry::Random random(seed, 4, first);
    const std::uint32_t n_instances = std::min(1 + random.below(3), n - first);
    scene.objects.push_back({.name = {}, .first_instance = first, .n_instances = n_instances});
    first += n_instances;
  }
}

/// Boxes, balls and walls around the origin, some of them turned, mirrored, see-through, there twice, or in one plane.
inline geometry::Scene random_scene(std::uint64_t seed, int n_objects) {
  geometry::Scene scene;
  for (int k = 0; k < n_objects; ++k) {
    geometry::Random random(seed, 0, std::uint64_t(k));
    const auto point = [&](double reach) {
      const double x = random.uniform(-reach, reach), y = random.uniform(-reach, reach);
      return glm::dvec3(x, y, random.uniform(-reach, reach));
    };
    glm::dmat4 place = glm::translate(glm::dmat4(1.0), point(8.0));
    if (random.below(3) == 0) place = glm::rotate(place, random.uniform(0.0, 6.0), glm::normalize(point(1.0) + 2.0));
    if (random.below(5) == 0) place = glm::scale(place, glm::dvec3(-1.0, 1.0, 1.0));
    geometry::Material material;
    material.color = {float(random.uniform()), float(random.uniform()), float(random.uniform()), 0.5f};
    const std::uint32_t kind = random.below(10);
    if (kind == 0) material.alpha_mode = geometry::AlphaMode::blend;
    if (kind == 1) material.alpha_mode = geometry::AlphaMode::mask;
    material.double_sided = random.below(3) == 0;
    const double size = random.below(4) == 0 ? 4.0 : 0.7;
    const glm::dvec3 half = size * (0.1 + glm::abs(point(1.0)));
    geometry::Mesh mesh =
        random.below(3) == 0 ? geometry::sphere(glm::dvec3(0.0), half.x, 9, 6) : geometry::box(-half, half);
    if (random.below(6) == 0) mesh = geometry::box({-half.x, -half.y, 0.0}, {half.x, half.y, 0.0});  // a wall
    geometry::add_instance(scene, mesh, material, place);
    if (random.below(8) == 0) geometry::add_instance(scene, mesh, material, place);
  }
  if (seed % 4 >= 2) group(scene, seed);
  return scene;
}

/// From anywhere in such a scene, at times inside an object, in either projection.
inline techniques::View random_view(std::uint64_t seed, std::uint64_t element) {
  geometry::Random random(seed, 1, element);
  const auto coordinate = [&] { return random.uniform(-12.0, 12.0); };
  techniques::View view;
  view.size_px = {30 + int(random.below(120)), 30 + int(random.below(80))};
  const double x = coordinate(), y = coordinate(), z = coordinate();
  const glm::dvec3 eye(x, y, z);
  const double at_x = coordinate(), at_y = coordinate(), at_z = coordinate();  // one after the other on any compiler
  geometry::look_at(view.camera, eye, 0.3 * glm::dvec3(at_x, at_y, at_z));
  view.camera.near = random.below(2) == 0 ? 0.01 : 0.5;
  if (random.below(3) == 0) view.camera.far = 25.0;
  if (random.below(5) == 0) {
    view.camera.projection = geometry::Projection::orthographic;
    view.camera.height = random.uniform(2.0, 20.0);
    view.camera.far = 40.0;
  }
  return view;
}

/// Boxes with corners on a lattice of halves: shared planes, edges and corners everywhere.
inline geometry::Scene lattice_scene(std::uint64_t seed, int n_objects) {
  geometry::Scene scene;
  for (int k = 0; k < n_objects; ++k) {
    geometry::Random random(seed, 2, std::uint64_t(k));
    const auto point = [&](std::uint32_t n) {
      const double x = random.below(n), y = random.below(n);
      return 0.5 * glm::dvec3(x, y, random.below(n));
    };
    const glm::dvec3 low = point(24) - 6.0;
    const glm::dvec3 high = low + point(random.below(4) == 0 ? 20 : 6);
    geometry::Material material;
    material.double_sided = random.below(3) == 0;
    geometry::add_instance(scene, geometry::box(low, high), material);
  }
  if (seed % 4 >= 2) group(scene, seed);
  return scene;
}

/// Along an axis, one to four pixels a unit, so that such a scene's edges run through samples and between pixels.
inline techniques::View lattice_view(std::uint64_t seed, std::uint64_t element) {
  geometry::Random random(seed, 3, element);
  techniques::View view;
  view.size_px = {40 + int(random.below(8)), 40 + int(random.below(8))};
  glm::dvec3 eye(0.0);
  const std::uint32_t side = random.below(6);
  eye[int(side % 3)] = side < 3 ? 20.0 : -20.0;
  geometry::look_at(view.camera, eye, glm::dvec3(0.0));
  if (random.below(4) == 0) {
    view.camera.tan_half_fov_y = 1.0;
    return view;
  }
  view.camera.projection = geometry::Projection::orthographic;
  view.camera.height = double(view.size_px.y) / double(1u << random.below(3));
  view.camera.near = 0.0;
  view.camera.far = 40.0;
  return view;
}

/// Empty if the technique's picture of the view is that of the whole scene.
inline std::string difference_from_plain(const TechniquePicture& technique, const TechniquePicture& plain) {
  return raster::test::first_difference(technique.image, plain.image);
}

}  // namespace lode::tests

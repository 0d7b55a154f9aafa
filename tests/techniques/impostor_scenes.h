#pragma once
/// Scenes for pictures that are taken beforehand of objects, and what to look for in them.

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <optional>
#include <set>

#include "geometry/procedural.h"
#include "geometry/trigonometry.h"
#include "raster/error.h"
#include "raster/image.h"
#include "techniques/technique.h"

namespace lode::tests {

inline geometry::Material colored(const glm::vec4& color, bool unlit = false) {
  geometry::Material material;
  material.color = color;
  material.unlit = unlit;
  return material;
}

inline glm::dmat4 moved(double x, double z) { return glm::translate(glm::dmat4(1.0), glm::dvec3(x, 0.0, z)); }

/// Balls of radius 3 around (x, 0, 0), x = −20, −10, 0, 10, 20.
inline geometry::Scene row_of_balls() {
  geometry::Scene scene;
  for (int k = 0; k < 5; ++k) {
    const auto share = float(k) / 4.0f;
    geometry::add_instance(scene, geometry::sphere(glm::dvec3(0.0), 3.0, 24, 12),
                           colored({1.0f - share, share, 0.5f, 1}), moved(-20.0 + 10.0 * k, 0.0));
  }
  return scene;
}

inline constexpr glm::dvec3 kKnob{3.0, 2.0, 3.5};

/// One object that looks alike from no two sides: two boxes, and a ball of radius 0.3 around kKnob, the only thing that
/// is red.
inline geometry::Scene lopsided_object() {
  geometry::Scene scene;
  geometry::add_instance(scene, geometry::box({-4.0, 0.0, -3.0}, {4.0, 4.0, 3.0}), colored({0, 0.6f, 0.3f, 1}));
  geometry::add_instance(scene, geometry::box({1.0, 4.0, -2.0}, {3.0, 6.0, 0.0}), colored({0, 0.2f, 0.9f, 1}));
  geometry::add_instance(scene, geometry::sphere(kKnob, 0.3, 16, 8), colored({1, 0, 0, 1}, true));
  for (geometry::Instance& instance : scene.instances) instance.node = scene.instances[0].node;
  scene.objects = {{"all", 0, 3}};
  return scene;
}

/// Middle of what is red, px; nothing if nothing is.
inline std::optional<glm::dvec2> knob_px(const raster::Image& image) {
  glm::dvec2 sum(0.0);
  double n = 0.0;
  for (int i = 0; i < image.size_px.x * image.size_px.y; ++i) {
    if (image.rgba32f[std::size_t(i)].r < 0.5f) continue;
    sum += glm::dvec2(i % image.size_px.x, i / image.size_px.x), n += 1.0;
  }
  if (n == 0.0) return std::nullopt;
  return sum / n;
}

/// A hall around (0, 0, 0), and a wall without size: to be seen from within the hall.
inline geometry::Scene awkward_objects() {
  geometry::Scene scene;
  geometry::Material walls = colored({0.2f, 0.3f, 0.4f, 1});
  walls.double_sided = true;
  geometry::add_instance(scene, geometry::box(glm::dvec3(-500.0), glm::dvec3(500.0)), walls);
  geometry::add_instance(scene, geometry::box(glm::dvec3(1.0), glm::dvec3(1.0)), colored({1, 1, 1, 1}));
  return scene;
}

inline techniques::View view_from(const glm::dvec3& eye, const glm::dvec3& target = glm::dvec3(0.0)) {
  techniques::View view{.camera = {}, .size_px = {320, 200}};
  geometry::look_at(view.camera, eye, target);
  return view;
}

/// So far from the origin, turned about the vertical through it from +z towards +x, at a height.
inline glm::dvec3 around(double angle_deg, double distance, double height = 4.0) {
  const geometry::SinCos turn = geometry::sin_cos(angle_deg * geometry::kPi / 180.0);
  return {distance * turn.sin, height, distance * turn.cos};
}

/// How many draws have a pixel.
inline std::size_t ids_seen(const raster::Image& image) {
  std::set<std::uint32_t> draws;
  for (const auto& ids : image.ids) {
    if (ids.draw != raster::kNoId) draws.insert(ids.draw);
  }
  return draws.size();
}

/// Pixels whose colours are not the same to the last bit.
inline int n_different(const raster::Image& a, const raster::Image& b) {
  int n = 0;
  for (std::size_t i = 0; i < a.rgba32f.size(); ++i) n += a.rgba32f[i] == b.rgba32f[i] ? 0 : 1;
  return n;
}

}  // namespace lode::tests

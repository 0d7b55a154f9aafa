#pragma once
/// Random scenes and cameras that are hard in the ways that real ones are, all at once.

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <string>

#include "geometry/camera.h"
#include "geometry/procedural.h"
#include "geometry/random.h"

namespace lode::experiments::truth {

using geometry::Random;

inline double log_uniform(Random& random, double low, double high) {
  return low * std::pow(high / low, random.uniform());
}

inline glm::dvec3 in_cube(Random& random) {
  const double x = random.uniform(-1.0, 1.0), y = random.uniform(-1.0, 1.0);
  return {x, y, random.uniform(-1.0, 1.0)};
}

/// Triangles of all sizes in a cube; some are slivers, some have no area, some stand in the place of another.
inline geometry::Mesh soup(Random& random, int n_triangles) {
  geometry::Mesh mesh;
  for (int i = 0; i < n_triangles; ++i) {
    const auto first = std::uint32_t(mesh.positions.size());
    if (i > 0 && random.below(16) == 0) {  // again, perhaps turned over
      const std::size_t other = random.below(std::uint32_t(i));
      for (std::size_t k = 0; k < 3; ++k)
        mesh.positions.push_back(mesh.positions[3 * other + (random.below(2) ? k : 2 - k)]);
    } else {
      const glm::dvec3 centre = in_cube(random);
      const double size = log_uniform(random, 1e-3, 1.0);
      for (int k = 0; k < 3; ++k) mesh.positions.emplace_back(centre + size * in_cube(random));
      if (random.below(4) == 0) {  // a sliver: the third corner beside the others' line
        const glm::vec3 a = mesh.positions[first], b = mesh.positions[first + 1];
        mesh.positions.back() =
            glm::mix(a, b, float(random.uniform())) + glm::vec3(log_uniform(random, 1e-7, 1e-2) * in_cube(random));
      }
      if (random.below(32) == 0) mesh.positions.back() = mesh.positions[first];
    }
    mesh.indices.insert(mesh.indices.end(), {first, first + 1, first + 2});
  }
  return mesh;
}

/// Long thin blades from a point or side by side.
inline geometry::Mesh blades(Random& random, int n_blades) {
  geometry::Mesh mesh;
  for (int i = 0; i < n_blades; ++i) {
    const glm::dvec3 root = 0.5 * in_cube(random), tip = root + 2.0 * in_cube(random);
    const glm::dvec3 width = log_uniform(random, 1e-5, 1e-2) * in_cube(random);
    const auto first = std::uint32_t(mesh.positions.size());
    for (const glm::dvec3& p : {root, root + width, tip}) mesh.positions.emplace_back(p);
    mesh.indices.insert(mesh.indices.end(), {first, first + 1, first + 2});
  }
  return mesh;
}

inline geometry::Mesh random_mesh(Random& random, std::string& name) {
  switch (random.below(6)) {
    case 0:
      name += " sphere";
      return geometry::sphere(0.3 * in_cube(random), 0.8, int(3 + random.below(60)), int(2 + random.below(40)));
    case 1:
      name += " torus";
      return geometry::torus({0, 0, 0}, 0.7, 0.3, int(3 + random.below(60)), int(3 + random.below(30)));
    case 2:
      name += " terrain";
      return geometry::terrain(2.0, int(1 + random.below(40)), random.below(2) ? 0.5 : 0.0, random.word());
    case 3:
      name += " box";
      return geometry::box(-glm::abs(in_cube(random)), glm::abs(in_cube(random)));
    case 4:
      name += " blades";
      return blades(random, 60);
    default:
      name += " soup";
      return soup(random, 250);
  }
}

/// One to four meshes, turned, stretched, mirrored; at times all of it far from the origin.
inline geometry::Scene random_scene(Random& random) {
  geometry::Scene scene;
  const double scale = log_uniform(random, 1e-3, 1e3);
  const glm::dvec3 place = random.below(4) == 0 ? scale * 1e5 * in_cube(random) : glm::dvec3(0.0);
  for (std::uint32_t n = 1 + random.below(4); n > 0; --n) {
    geometry::Material material;
    material.double_sided = random.below(2) == 0;
    glm::dmat4 m = glm::translate(glm::dmat4(1.0), place + 0.5 * scale * in_cube(random));
    if (random.below(3) != 0)
      m = glm::rotate(m, random.uniform(0.0, 6.0), glm::normalize(in_cube(random) + glm::dvec3(0.01)));
    glm::dvec3 stretch(scale);
    if (random.below(3) == 0) stretch *= glm::dvec3(1.0, log_uniform(random, 1e-2, 1.0), random.below(2) ? -1.0 : 1.0);
    geometry::add_instance(scene, random_mesh(random, scene.name), material, glm::scale(m, stretch));
  }
  return scene;
}

/// From outside, from within, cut by the near plane, a thousand diagonals away (seen small, or through a long lens),
/// orthographic, with a finite far plane.
inline geometry::Camera random_camera(Random& random, const geometry::Bounds& bounds, glm::ivec2 size_px,
                                      std::string& name) {
  const double d = bounds.diagonal();
  const glm::dvec3 centre = bounds.centre(), direction = glm::normalize(in_cube(random) + glm::dvec3(0.01));
  geometry::Camera camera;
  const auto look = [&](double distance) {
    const glm::dvec3 aside = 0.2 * d * in_cube(random);
    geometry::look_at(camera, centre + distance * d * direction, centre + aside, in_cube(random) + glm::dvec3(0.01));
  };
  camera.near = d / 1000.0;
  switch (random.below(7)) {
    case 0:
      name += ", inside";
      look(0.3 * random.uniform() + 0.01);
      camera.near = d * log_uniform(random, 1e-6, 1e-2);
      break;
    case 1:
      name += ", near plane cuts";
      look(0.8);
      camera.near = d * random.uniform(0.3, 1.2);
      break;
    case 2: {
      name += ", far away";
      look(1000.0);
      const double half_px = 1000.0 * d * geometry::half_extent(camera, size_px).y / size_px.y;
      camera.eye += half_px * (random.uniform() * camera.right + random.uniform() * camera.up);
      break;
    }
    case 3:
      name += ", far away through a long lens";
      look(1000.0);
      camera.tan_half_fov_y = 0.0004;
      break;
    case 4:
      name += ", orthographic";
      look(1.0);
      camera.projection = geometry::Projection::orthographic;
      camera.height = d * random.uniform(0.3, 1.2);
      camera.near = d * random.uniform(0.0, 1.0);
      camera.far = d * random.uniform(1.0, 2.0);
      break;
    case 5:
      name += ", finite far plane";
      look(1.0);
      camera.far = d * random.uniform(0.8, 1.5);
      break;
    default:
      name += ", outside";
      look(random.uniform(0.6, 1.5));
  }
  return camera;
}

}  // namespace lode::experiments::truth

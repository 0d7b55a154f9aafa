#pragma once
/// Small models by rule, for tests, examples and as built-in scenes. Closed ones face outwards, counter-clockwise.

#include <cstdint>
#include <glm/vec3.hpp>
#include <utility>

#include "geometry/mesh.h"
#include "geometry/scene.h"

namespace lode::geometry {

/// A ball's surface, poles up and down: `segments` around, `rings` from pole to pole, 2·segments·(rings − 1) triangles,
/// with normals and texture coordinates (a seam of doubled vertices). segments ≥ 3, rings ≥ 2.
[[nodiscard]] Mesh sphere(const glm::dvec3& centre, double radius, int segments, int rings);

/// 2·segments·sides triangles around the y axis. segments, sides ≥ 3.
[[nodiscard]] Mesh torus(const glm::dvec3& centre, double radius, double tube_radius, int segments, int sides);

/// Twelve triangles, with normals and a texture on each face.
[[nodiscard]] Mesh box(const glm::dvec3& low, const glm::dvec3& high);

/// A square of side `size` in the plane y = 0, cells × cells × 2 triangles, seen from above; raised by up to `height`
/// by seeded noise of four octaves. cells ≥ 1.
[[nodiscard]] Mesh terrain(double size, int cells, double height, std::uint64_t seed);

/// A scene of one mesh at the origin with one material.
[[nodiscard]] Scene scene_of(Mesh mesh, const Material& material = {});

/// Adds a mesh in the world as a node and an instance of its own; returns the instance's index.
std::uint32_t add_instance(Scene& scene, Mesh mesh, const Material& material = {},
                           const glm::dmat4& world_from_object = glm::dmat4(1.0));

}  // namespace lode::geometry

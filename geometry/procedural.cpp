#include "geometry/procedural.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "geometry/random.h"
#include "geometry/trigonometry.h"

namespace lode::geometry {
namespace {

/// A grid of (n_u + 1) × (n_v + 1) vertices, u fastest; make(mesh, u, v) appends one with u, v in [0, 1].
template <class MakeVertex>
Mesh grid(int n_u, int n_v, MakeVertex make) {
  Mesh mesh;
  for (int j = 0; j <= n_v; ++j) {
    for (int i = 0; i <= n_u; ++i) make(mesh, i, j);
  }
  return mesh;
}

std::uint32_t at(int n_u, int i, int j) { return std::uint32_t(j) * std::uint32_t(n_u + 1) + std::uint32_t(i); }

void add_triangle(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  mesh.indices.insert(mesh.indices.end(), {a, b, c});
}

/// Angle i of n around, the last one the first again to the bit, so that seams are closed.
SinCos around(int i, int n) { return sin_cos(2.0 * kPi * double(i % n) / double(n)); }

/// Noise on integer points, [0, 1).
double lattice(std::uint64_t seed, std::uint32_t octave, int x, int z) {
  const std::uint64_t element = std::uint64_t(std::uint32_t(x)) << 32 | std::uint32_t(z);
  return Random(seed, octave, element).uniform();
}

/// Lattice noise, smoothly interpolated.
double noise(std::uint64_t seed, std::uint32_t octave, double x, double z) {
  const double fx = std::floor(x), fz = std::floor(z);
  const auto smooth = [](double t) { return t * t * (3.0 - 2.0 * t); };
  const double u = smooth(x - fx), v = smooth(z - fz);
  const int i = int(fx), j = int(fz);
  const double near = (1.0 - u) * lattice(seed, octave, i, j) + u * lattice(seed, octave, i + 1, j);
  const double far = (1.0 - u) * lattice(seed, octave, i, j + 1) + u * lattice(seed, octave, i + 1, j + 1);
  return (1.0 - v) * near + v * far;
}

}  // namespace

Mesh sphere(const glm::dvec3& centre, double radius, int segments, int rings) {
  Mesh mesh = grid(segments, rings, [&](Mesh& m, int i, int j) {
    const SinCos a = around(i, segments);
    const SinCos b = sin_cos(kPi * double(j) / double(rings));
    const double ring = j == 0 || j == rings ? 0.0 : b.sin;  // the poles are points, to the bit
    const glm::dvec3 normal(ring * a.sin, b.cos, ring * a.cos);
    m.positions.emplace_back(centre + radius * normal);
    m.normals.emplace_back(normal);
    m.uvs.emplace_back(double(i) / double(segments), double(j) / double(rings));
  });
  for (int j = 0; j < rings; ++j) {
    for (int i = 0; i < segments; ++i) {
      const auto v = [&](int di, int dj) { return at(segments, i + di, j + dj); };
      if (j > 0) add_triangle(mesh, v(0, 0), v(0, 1), v(1, 0));
      if (j < rings - 1) add_triangle(mesh, v(1, 0), v(0, 1), v(1, 1));
    }
  }
  return mesh;
}

Mesh torus(const glm::dvec3& centre, double radius, double tube_radius, int segments, int sides) {
  Mesh mesh = grid(segments, sides, [&](Mesh& m, int i, int j) {
    const SinCos a = around(i, segments), b = around(j, sides);
    const glm::dvec3 normal(b.cos * a.sin, -b.sin, b.cos * a.cos);
    m.positions.emplace_back(centre + radius * glm::dvec3(a.sin, 0.0, a.cos) + tube_radius * normal);
    m.normals.emplace_back(normal);
    m.uvs.emplace_back(double(i) / double(segments), double(j) / double(sides));
  });
  for (int j = 0; j < sides; ++j) {
    for (int i = 0; i < segments; ++i) {
      const auto v = [&](int di, int dj) { return at(segments, i + di, j + dj); };
      add_triangle(mesh, v(0, 0), v(0, 1), v(1, 0));
      add_triangle(mesh, v(1, 0), v(0, 1), v(1, 1));
    }
  }
  return mesh;
}

Mesh box(const glm::dvec3& low, const glm::dvec3& high) {
  Mesh mesh;
  for (int axis = 0; axis < 3; ++axis) {
    for (const bool upper : {false, true}) {
      // Two other axes u, v with u × v along the face's normal.
      const int u_axis = (axis + (upper ? 1 : 2)) % 3, v_axis = (axis + (upper ? 2 : 1)) % 3;
      const auto first = std::uint32_t(mesh.positions.size());
      glm::dvec3 normal(0.0);
      normal[axis] = upper ? 1.0 : -1.0;
      for (const auto& [u, v] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
        glm::dvec3 p;
        p[axis] = upper ? high[axis] : low[axis];
        p[u_axis] = u ? high[u_axis] : low[u_axis];
        p[v_axis] = v ? high[v_axis] : low[v_axis];
        mesh.positions.emplace_back(p);
        mesh.normals.emplace_back(normal);
        mesh.uvs.emplace_back(float(u), float(1 - v));
      }
      add_triangle(mesh, first, first + 1, first + 2);
      add_triangle(mesh, first, first + 2, first + 3);
    }
  }
  return mesh;
}

Mesh terrain(double size, int cells, double height, std::uint64_t seed) {
  Mesh mesh = grid(cells, cells, [&](Mesh& m, int i, int j) {
    const double u = double(i) / double(cells), v = double(j) / double(cells);
    double y = 0.0, weight = 8.0 / 15.0, frequency = 4.0;
    for (std::uint32_t octave = 0; octave < 4; ++octave, weight *= 0.5, frequency *= 2.0) {
      y += weight * noise(seed, octave, frequency * u, frequency * v);
    }
    m.positions.emplace_back(size * (u - 0.5), height * y, size * (v - 0.5));
    m.uvs.emplace_back(u, v);
  });
  for (int j = 0; j < cells; ++j) {
    for (int i = 0; i < cells; ++i) {
      const auto v = [&](int di, int dj) { return at(cells, i + di, j + dj); };
      add_triangle(mesh, v(0, 0), v(0, 1), v(1, 0));
      add_triangle(mesh, v(1, 0), v(0, 1), v(1, 1));
    }
  }
  return with_smooth_normals(mesh);
}

std::uint32_t add_instance(Scene& scene, Mesh mesh, const Material& material, const glm::dmat4& world_from_object) {
  mesh.material = std::uint32_t(scene.materials.size());
  scene.materials.push_back(material);
  scene.meshes.push_back(std::move(mesh));
  scene.nodes.push_back(
      {.name = {}, .parent = {}, .parent_from_node = world_from_object, .world_from_node = world_from_object});
  scene.instances.push_back({.mesh = std::uint32_t(scene.meshes.size() - 1),
                             .node = std::uint32_t(scene.nodes.size() - 1),
                             .world_from_object = world_from_object});
  return std::uint32_t(scene.instances.size() - 1);
}

Scene scene_of(Mesh mesh, const Material& material) {
  Scene scene;
  add_instance(scene, std::move(mesh), material);
  return scene;
}

}  // namespace lode::geometry

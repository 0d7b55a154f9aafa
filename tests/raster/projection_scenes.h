#pragma once
/// Sheets and closed meshes, and cameras beside and inside them: what is hard on projection and clipping.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat4x4.hpp>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "hashed_numbers.h"

namespace lode::raster::test {

struct Mesh {
  std::vector<glm::vec3> positions;
  std::vector<std::uint32_t> indices;  ///< counter-clockwise seen from the front, or from outside
  void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) { indices.insert(indices.end(), {a, b, c}); }
  void add_quad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    add_triangle(a, b, c);
    add_triangle(a, c, d);
  }
};

struct Scene {
  std::string name;
  Mesh mesh;
  glm::dmat4 clip_from_object{1.0};
  glm::ivec2 size_px{64, 64};
};

// ---- Meshes.

/// n × m quads in the plane z = 0 over [−half, half], finer towards the middle, the inner vertices moved.
[[nodiscard]] inline Mesh sheet_mesh(HashedNumbers& random, int n, int m, glm::vec2 half, float power) {
  Mesh mesh;
  const auto place = [&](int i, int count, float extent) {
    if (i == 0 || i == count) return i == 0 ? -extent : extent;
    const double u = 2.0 * (i + 0.9 * (random.unit() - 0.5)) / count - 1.0;
    return float(std::copysign(std::pow(std::abs(u), double(power)), u)) * extent;
  };
  for (int j = 0; j <= m; ++j) {
    for (int i = 0; i <= n; ++i) {
      const float x = place(i, n, half.x);
      mesh.positions.emplace_back(x, place(j, m, half.y), 0.0f);
    }
  }
  for (int j = 0; j < m; ++j) {
    for (int i = 0; i < n; ++i) {
      const std::uint32_t a = std::uint32_t(j * (n + 1) + i), d = a + std::uint32_t(n) + 1;
      mesh.add_quad(a, a + 1, d + 1, d);
    }
  }
  return mesh;
}

/// A fan in the plane z = 0 from `centre` to n points around the rectangle [−half, half].
[[nodiscard]] inline Mesh fan_sheet(int n, glm::vec2 centre, glm::vec2 half) {
  Mesh mesh;
  mesh.positions.emplace_back(centre, 0.0f);
  for (int i = 0; i < n; ++i) {
    const double along = 4.0 * i / n;
    const float s = float(2.0 * (along - std::floor(along)) - 1.0);
    const glm::vec2 corner[] = {{s, -1.0f}, {1.0f, s}, {-s, 1.0f}, {-1.0f, -s}};
    mesh.positions.emplace_back(corner[int(along)] * half, 0.0f);
  }
  for (std::uint32_t i = 0; i < std::uint32_t(n); ++i) mesh.add_triangle(0, 1 + i, 1 + (i + 1) % std::uint32_t(n));
  return mesh;
}

/// n × n quads a face over [−1, 1]³, each vertex moved by up to `jitter` in every direction.
[[nodiscard]] inline Mesh cube_mesh(HashedNumbers& random, int n, double jitter) {
  Mesh mesh;
  std::map<std::array<int, 3>, std::uint32_t> index_at;
  const auto vertex = [&](const std::array<int, 3>& at) {
    const auto [place, is_new] = index_at.try_emplace(at, std::uint32_t(mesh.positions.size()));
    if (is_new) {
      glm::vec3 p;
      for (int c = 0; c < 3; ++c)
        p[c] = float(2.0 * at[std::size_t(c)] / n - 1.0 + jitter * (2.0 * random.unit() - 1.0));
      mesh.positions.push_back(p);
    }
    return place->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const int side : {0, n}) {
      for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
          const auto at = [&](int di, int dj) {
            std::array<int, 3> p;
            p[axis] = side;
            p[(axis + 1) % 3] = i + di;
            p[(axis + 2) % 3] = j + dj;
            return vertex(p);
          };
          const std::uint32_t a = at(0, 0), b = at(1, 0), c = at(1, 1), d = at(0, 1);
          side == 0 ? mesh.add_quad(a, d, c, b) : mesh.add_quad(a, b, c, d);
        }
      }
    }
  }
  return mesh;
}

/// A star-shaped sphere: n meridians, m rings, radii in [1 − rough, 1].
[[nodiscard]] inline Mesh star_mesh(HashedNumbers& random, int n, int m, double rough) {
  constexpr double kPi = 3.14159265358979323846;
  Mesh mesh;
  const auto radius = [&] { return 1.0 - rough * random.unit(); };
  mesh.positions.emplace_back(0.0f, 0.0f, float(radius()));
  for (int j = 1; j < m; ++j) {
    for (int i = 0; i < n; ++i) {
      const double theta = kPi * j / m, phi = 2.0 * kPi * i / n, r = radius();
      mesh.positions.emplace_back(r * std::sin(theta) * std::cos(phi), r * std::sin(theta) * std::sin(phi),
                                  r * std::cos(theta));
    }
  }
  mesh.positions.emplace_back(0.0f, 0.0f, float(-radius()));
  const auto at = [&](int j, int i) { return std::uint32_t(1 + (j - 1) * n + i % n); };
  const std::uint32_t south = std::uint32_t(mesh.positions.size()) - 1;
  for (int i = 0; i < n; ++i) {
    mesh.add_triangle(0, at(1, i), at(1, i + 1));
    for (int j = 1; j + 1 < m; ++j) mesh.add_quad(at(j, i), at(j + 1, i), at(j + 1, i + 1), at(j, i + 1));
    mesh.add_triangle(at(m - 1, i), south, at(m - 1, i + 1));
  }
  return mesh;
}

[[nodiscard]] inline Mesh torus_mesh(int n, int m, double tube) {
  constexpr double kPi = 3.14159265358979323846;
  Mesh mesh;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < m; ++j) {
      const double phi = 2.0 * kPi * i / n, theta = 2.0 * kPi * j / m, r = 1.0 - tube + tube * std::cos(theta);
      mesh.positions.emplace_back(r * std::cos(phi), r * std::sin(phi), tube * std::sin(theta));
    }
  }
  const auto at = [&](int i, int j) { return std::uint32_t((i % n) * m + j % m); };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < m; ++j) mesh.add_quad(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
  }
  return mesh;
}

// ---- Cameras.

/// Reversed depth, 1 at near; far may be infinite. Looks along −z, y up.
[[nodiscard]] inline glm::dmat4 clip_from_view(double fov_y_rad, double aspect, double near, double far) {
  const double f = 1.0 / std::tan(0.5 * fov_y_rad);
  const double a = std::isinf(far) ? 0.0 : near / (far - near);
  glm::dmat4 m(0.0);
  m[0][0] = f / aspect;
  m[1][1] = f;
  m[2][2] = a;
  m[3][2] = std::isinf(far) ? near : a * far;
  m[2][3] = -1.0;
  return m;
}

[[nodiscard]] inline glm::dvec3 random_direction(HashedNumbers& random) {
  for (;;) {
    const double x = 2.0 * random.unit() - 1.0, y = 2.0 * random.unit() - 1.0;
    const glm::dvec3 d{x, y, 2.0 * random.unit() - 1.0};
    const double length = glm::length(d);
    if (length > 0.01 && length <= 1.0) return d / length;
  }
}

[[nodiscard]] inline double log_uniform(HashedNumbers& random, double low, double high) {
  return low * std::pow(high / low, random.unit());
}

/// From `eye`, towards `aim`, rolled at random, 10° to 150° high.
[[nodiscard]] inline glm::dmat4 random_clip_from_object(HashedNumbers& random, const glm::dvec3& eye,
                                                        const glm::dvec3& aim, double near, double far,
                                                        glm::ivec2 size_px) {
  const double fov_y_rad = glm::radians(10.0 + 140.0 * random.unit());
  const glm::dvec3 nearby_aim = aim + 1e-3 * random_direction(random), up = random_direction(random);
  return clip_from_view(fov_y_rad, double(size_px.x) / size_px.y, near, far) * glm::lookAt(eye, nearby_aim, up);
}

// ---- Scenes.

/// A sheet or fan in the plane z = 0, small to huge (10^6), the camera close above or below it, at times grazing.
[[nodiscard]] inline Scene random_sheet_scene(HashedNumbers& random, int most_triangles) {
  Scene scene;
  scene.size_px = {random.between(40, 120), random.between(40, 120)};
  const double extent = log_uniform(random, 1.0, 1e6);
  const glm::vec2 half{float(extent), float(extent * log_uniform(random, 0.1, 10.0))};
  const double side = random.below(2) == 0 ? 1.0 : -1.0, height = side * log_uniform(random, 1e-3, 10.0);
  const glm::dvec2 over = glm::dvec2{random.unit() - 0.5, random.unit() - 0.5} * 2.0 * std::min(extent, 5.0);
  const glm::dvec3 eye{over, height};
  glm::dvec3 look = random_direction(random);
  if (random.below(2) == 0) look.z *= 0.02;  // grazing
  if (look.z * height > 0.0 && random.below(4) != 0) look.z = -look.z;
  const double near = log_uniform(random, 1e-3, 3.0);
  const double far =
      random.below(4) == 0 ? near * log_uniform(random, 2.0, 1e4) : std::numeric_limits<double>::infinity();
  scene.clip_from_object = random_clip_from_object(random, eye, eye + look, near, far, scene.size_px);
  if (random.below(2) == 0) {
    const int n = random.between(1, most_triangles);
    const glm::dvec2 centre = over + glm::dvec2{random.unit() - 0.5, random.unit() - 0.5} * std::abs(height);
    scene.name = "fan of " + std::to_string(n);
    scene.mesh = fan_sheet(n + 2, glm::clamp(glm::vec2(centre), -0.9f * half, 0.9f * half), half);
  } else {
    const int most = std::max(1, int(std::sqrt(most_triangles / 2.0)));
    const int n = random.between(1, most), m = random.between(1, most);
    scene.name = "grid of " + std::to_string(n) + " x " + std::to_string(m);
    scene.mesh = sheet_mesh(random, n, m, half, float(log_uniform(random, 1.0, 6.0)));
  }
  return scene;
}

/// A cube (smooth or crumpled), star or torus of size about 1, the camera anywhere within about 3.
[[nodiscard]] inline Scene random_closed_scene(HashedNumbers& random, int most_triangles) {
  Scene scene;
  scene.size_px = {random.between(40, 120), random.between(40, 120)};
  const int side = std::max(3, int(std::sqrt(most_triangles / 12.0)));
  const int n = random.between(1, side);
  switch (random.below(4)) {
    case 0:
      scene.mesh = cube_mesh(random, n, 0.0);
      scene.name = "cube";
      break;
    case 1:
      scene.mesh = cube_mesh(random, n, 0.5 / n);
      scene.name = "crumpled cube";
      break;
    case 2:
      scene.mesh = star_mesh(random, 2 * n + 2, n + 2, random.unit() * 0.6);
      scene.name = "star";
      break;
    default:
      scene.mesh = torus_mesh(2 * n + 3, n + 3, 0.1 + 0.4 * random.unit());
      scene.name = "torus";
      break;
  }
  const double distance = 3.0 * std::pow(random.unit(), 2.0);
  const glm::dvec3 eye = random_direction(random) * distance;
  const glm::dvec3 aim = random.below(2) == 0 ? random_direction(random) : eye + random_direction(random);
  const double near = log_uniform(random, 1e-4, 1.0);
  const double far = random.below(4) == 0 ? near + 3.0 * random.unit() + 0.1 : std::numeric_limits<double>::infinity();
  scene.clip_from_object = random_clip_from_object(random, eye, aim, near, far, scene.size_px);
  return scene;
}

}  // namespace lode::raster::test

#pragma once
/// Random surfels for tests: scenes as they are, structured ones full of ties, and hostile ones over the whole
/// range of the formats.

#include <cmath>
#include <cstring>
#include <limits>

#include "tests/raster/counter_random.h"
#include "tests/raster/surfel_oracle.h"

namespace lode::tests {

enum class SurfelKind { scene, structured, hostile };

/// A perspective or orthographic camera that turns about the origin at a distance; depth 1 near, 0 far.
inline glm::dmat4 random_camera(const CounterRandom& random) {
  const double yaw = 3.2 * random.real(100), pitch = 1.5 * random.real(101), distance = 4.0 + 3.0 * random.real(102);
  const double cy = std::cos(yaw), sy = std::sin(yaw), cp = std::cos(pitch), sp = std::sin(pitch);
  const glm::dmat4 view{glm::dvec4{cy, sp * sy, -cp * sy, 0.0}, glm::dvec4{0.0, cp, sp, 0.0},
                        glm::dvec4{sy, -sp * cy, cp * cy, 0.0}, glm::dvec4{0.0, 0.0, -distance, 1.0}};
  glm::dmat4 projection{0.0};
  const double near = 0.1, far = 50.0;
  switch (random.integer(103, 0, 2)) {
    case 0:  // infinite far plane: depth near/d
      projection = {glm::dvec4{1.5, 0, 0, 0}, glm::dvec4{0, 1.5, 0, 0}, glm::dvec4{0, 0, 0, -1},
                    glm::dvec4{0, 0, near, 0}};
      break;
    case 1:  // finite
      projection = {glm::dvec4{1.5, 0, 0, 0}, glm::dvec4{0, 1.5, 0, 0}, glm::dvec4{0, 0, near / (far - near), -1},
                    glm::dvec4{0, 0, near * far / (far - near), 0}};
      break;
    default:  // orthographic: depth (far − d)/(far − near)
      projection = {glm::dvec4{0.3, 0, 0, 0}, glm::dvec4{0, 0.3, 0, 0}, glm::dvec4{0, 0, 1 / (far - near), 0},
                    glm::dvec4{0, 0, far / (far - near), 1}};
  }
  return projection * view;
}

inline SurfelCase scene_surfel(const CounterRandom& random) {
  SurfelCase s;
  for (int i = 0; i < 3; ++i) {
    s.centre[i] = float(2.0 * random.real(std::uint64_t(i)));
    s.normal[i] = float(random.real(std::uint64_t(10 + i)));
  }
  s.radius = float(std::ldexp(1.0 + random.real(20), random.integer(21, -6, 1)));
  s.clip_from_object = random_camera(random);
  s.viewport_size_px = {random.integer(22, 1, 2000), random.integer(23, 1, 2000)};
  s.viewport_origin_px = {random.integer(24, -300, 300), random.integer(25, -300, 300)};
  // Every fourth far away from the object's origin, and the camera with it.
  if (random.integer(26, 0, 3) == 0) {
    const glm::dvec3 away{1e5, -3e5, 2e5};
    s.clip_from_object[3] -= s.clip_from_object * glm::dvec4(away, 0.0);
    s.centre = glm::vec3(glm::dvec3(s.centre) + away);
  }
  return s;
}

/// Small whole numbers and powers of two: rims through samples, planes through the eye, in the near plane, …
inline SurfelCase structured_surfel(const CounterRandom& random) {
  SurfelCase s;
  for (int i = 0; i < 3; ++i) {
    s.centre[i] = float(random.integer(std::uint64_t(i), -4, 4)) / 4.0f;
    s.normal[i] = float(random.integer(std::uint64_t(10 + i), -2, 2));
  }
  s.radius = float(random.integer(20, 0, 20)) / 16.0f;
  s.viewport_size_px = glm::ivec2(1 << random.integer(22, 0, 6));
  s.viewport_origin_px = {random.integer(24, -2, 2), random.integer(25, -2, 2)};
  const int kind = random.integer(103, 0, 3);
  if (kind == 0) return s;  // clip space is object space
  for (int i = 0; i < 16; ++i) {
    s.clip_from_object[i / 4][i % 4] = kind == 1 ? random.integer(std::uint64_t(200 + i), -1, 1)
                                                 : double(random.integer(std::uint64_t(200 + i), -4, 4)) / 2.0;
  }
  if (kind == 3) {
    // Perspective along −z: x, y, near 1/4, w = −z + 2.
    s.clip_from_object = {glm::dvec4{1, 0, 0, 0}, glm::dvec4{0, 1, 0, 0}, glm::dvec4{0, 0, 0, -1},
                          glm::dvec4{0, 0, 0.25, 2}};
  }
  return s;
}

/// Any bit pattern, or one of the corners of the format.
inline float hostile_float(const CounterRandom& random, std::uint64_t purpose) {
  using Limits = std::numeric_limits<float>;
  constexpr float kCorners[] = {0.0f,
                                -0.0f,
                                1.0f,
                                -1.0f,
                                Limits::max(),
                                Limits::lowest(),
                                Limits::denorm_min(),
                                1e-40f,
                                1e30f,
                                1e-30f,
                                Limits::infinity(),
                                -Limits::infinity(),
                                3.0f,
                                0.5f};
  const std::uint64_t bits = random.bits(purpose);
  if (bits % 3 != 0) return kCorners[(bits >> 8) % std::size(kCorners)];
  const auto pattern = std::uint32_t(bits >> 16);
  float x;
  std::memcpy(&x, &pattern, sizeof x);
  return std::isnan(x) ? 2.0f : x;
}
inline double hostile_double(const CounterRandom& random, std::uint64_t purpose) {
  constexpr double kCorners[] = {0.0, 1.0, -1.0, 0x1p1023, -0x1.8p1000, 5e-324, 1e-310, 1e300, 1e-300, 1e30, 1e-30};
  const std::uint64_t bits = random.bits(purpose);
  if (bits % 3 != 0) return kCorners[(bits >> 8) % std::size(kCorners)];
  const std::uint64_t pattern = random.bits(purpose + 5000);
  double x;
  std::memcpy(&x, &pattern, sizeof x);
  return std::isfinite(x) ? x : 0.25;
}

/// A scene or structured surfel with some of its numbers replaced.
inline SurfelCase hostile_surfel(const CounterRandom& random) {
  SurfelCase s = random.integer(300, 0, 1) == 0 ? scene_surfel(random) : structured_surfel(random);
  const int mode = random.integer(301, 0, 3);
  for (int i = 0; i < 3; ++i) {
    if (mode != 1 && random.integer(std::uint64_t(310 + i), 0, 2) == 0)
      s.centre[i] = hostile_float(random, std::uint64_t(320 + i));
    if (mode != 2 && random.integer(std::uint64_t(330 + i), 0, 2) == 0)
      s.normal[i] = hostile_float(random, std::uint64_t(340 + i));
  }
  if (random.integer(350, 0, 1) == 0) s.radius = hostile_float(random, 351);
  if (mode == 3) {
    for (int i = 0; i < 16; ++i) {
      if (random.integer(std::uint64_t(400 + i), 0, 3) == 0)
        s.clip_from_object[i / 4][i % 4] = hostile_double(random, std::uint64_t(420 + i));
    }
  } else if (mode == 2) {
    // The whole matrix near the end of the range: sums and products overflow or vanish.
    const int exponent =
        random.integer(450, 0, 1) == 0 ? random.integer(451, 900, 1000) : random.integer(452, -1074, -900);
    for (int i = 0; i < 16; ++i)
      s.clip_from_object[i / 4][i % 4] = std::ldexp(s.clip_from_object[i / 4][i % 4], exponent);
  }
  return s;
}

/// The pixel of the disc's centre, if it is near the origin, otherwise (8, 8).
inline glm::ivec2 middle_of(const SurfelCase& s) {
  const glm::dvec4 clip = s.clip_from_object * glm::dvec4(glm::dvec3(s.centre), 1.0);
  const glm::dvec2 middle = glm::dvec2(s.viewport_origin_px) +
                            glm::dvec2(s.viewport_size_px) * 0.5 * (1.0 + glm::dvec2(clip.x, -clip.y) / clip.w);
  return std::abs(middle.x) < 3000.0 && std::abs(middle.y) < 3000.0 ? glm::ivec2(middle) : glm::ivec2(8);
}

inline SurfelCase random_surfel(SurfelKind kind, const CounterRandom& random) {
  return kind == SurfelKind::scene        ? scene_surfel(random)
         : kind == SurfelKind::structured ? structured_surfel(random)
                                          : hostile_surfel(random);
}

}  // namespace lode::tests

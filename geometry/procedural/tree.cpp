#include <cmath>
#include <glm/geometric.hpp>

#include "geometry/procedural/parts.h"
#include "geometry/procedural/town_models.h"
#include "geometry/random.h"
#include "geometry/trigonometry.h"

namespace lode::geometry {
namespace {

constexpr int kBranches = 12;

Material leaves(std::uint64_t seed) {
  const float warm = float(seed % 3) * 0.035f;
  Material material = two_sided(paint("leaves " + std::to_string(seed % 3), 0.07f + warm, 0.19f + 0.3f * warm, 0.04f));
  material.alpha_mode = AlphaMode::mask;
  return material;
}

/// A point of the unit ball.
glm::dvec3 in_ball(Random& random) {
  for (;;) {
    const double x = random.uniform(-1, 1), y = random.uniform(-1, 1), z = random.uniform(-1, 1);
    const glm::dvec3 p(x, y, z);
    if (glm::dot(p, p) <= 1.0 && glm::dot(p, p) > 1e-3) return p;
  }
}

/// Half of the crown's size, and its centre.
struct Crown {
  glm::dvec3 centre, half;
};

/// A leaf that faces away from the middle of its bough, shaded as the bough's hull would be.
void add_leaf(Mesh& mesh, const glm::dvec3& at, const glm::dvec3& out, double size, Random& random) {
  const glm::dvec3 facing = glm::normalize(glm::normalize(out) + 0.7 * in_ball(random));
  const glm::dvec3 helper = std::abs(facing.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
  const glm::dvec3 u = glm::normalize(glm::cross(helper, facing)), v = glm::cross(facing, u);
  const SinCos turn = sin_cos(random.uniform(0.0, 2.0 * kPi));
  const glm::dvec3 a = (u * turn.cos + v * turn.sin) * size, b = (v * turn.cos - u * turn.sin) * (0.62 * size);
  add_quad(mesh, at - a, at - b, at + a, at + b);
  mesh.normals.resize(mesh.positions.size(), glm::vec3(glm::normalize(glm::normalize(out) + 0.35 * facing)));
}

}  // namespace

Model tree(std::uint64_t seed) {
  Model model{.name = "tree", .surfaces = {}};
  const Material bark = paint("bark", 0.13f, 0.09f, 0.06f), green = leaves(seed);
  for (const Material& m : {bark, green}) (void)model.surface(m);
  Random random(seed, 0x74726565);
  const double trunk = random.uniform(2.2, 2.9), high = random.uniform(7.0, 9.5), wide = random.uniform(2.0, 2.7);
  const Crown crown{{0.0, 0.5 * (trunk + high) + 0.2, 0.0}, {wide, 0.5 * (high - trunk) + 0.2, wide}};

  Mesh& wood = model.surface(bark);
  const glm::dvec2 stem[] = {{.30, 0},     {.22, .15},         {.18, .6},          {.165, 1.4},
                             {.16, trunk}, {.12, trunk + 1.2}, {.07, 0.75 * high}, {.02, 0.93 * high}};
  add_turned(wood, stem, 12, glm::dmat4(1.0));  // 192 triangles

  // Boughs: a branch to the middle of a cloud of leaves each.
  std::vector<glm::dvec3> boughs;
  for (int k = 0; k < kBranches; ++k) {
    const SinCos around = sin_cos(2.399963229728653 * k + random.uniform(-0.3, 0.3));  // golden angle
    const double t = (k + 0.5) / kBranches, out = 0.66 * std::sqrt(1.0 - (2 * t - 1) * (2 * t - 1)) + 0.08;
    boughs.push_back(crown.centre + crown.half * glm::dvec3(out * around.sin, 0.72 * (2 * t - 1), out * around.cos));
    const glm::dvec3 from(0.0, std::min(trunk + 0.15 * k, boughs[std::size_t(k)].y - 0.3), 0.0);
    const double length = glm::distance(from, boughs.back());
    const glm::dvec2 branch[] = {{.07, 0}, {.05, .4 * length}, {.035, .7 * length}, {.015, length}};
    add_turned(wood, branch, 6, frame_along(from, boughs.back()));  // 48
  }
  Mesh& foliage = model.surface(green);
  const std::size_t n_leaves = (kTreeTriangles - n_triangles(model)) / 2;
  for (std::size_t k = 0; k < n_leaves; ++k) {
    const glm::dvec3 bough = boughs[k % kBranches], ball = in_ball(random);
    const glm::dvec3 reach = crown.half * glm::dvec3(0.52, 0.34, 0.52);
    const glm::dvec3 p = bough + reach * ball * (0.55 + 0.45 / glm::length(ball) * 0.8);
    add_leaf(foliage, p, (p - crown.centre) / crown.half + 0.8 * ball, random.uniform(0.16, 0.27), random);
  }
  expect_triangles(model, kTreeTriangles);
  return model;
}

}  // namespace lode::geometry

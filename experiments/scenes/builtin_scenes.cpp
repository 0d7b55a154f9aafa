#include <glm/gtc/matrix_transform.hpp>

#include "experiments/scenes/builtin_scene.h"
#include "experiments/scenes/laboratory_scenes.h"
#include "geometry/procedural.h"
#include "geometry/random.h"

namespace lode::experiments {
namespace {

using geometry::Scene;

const Parameter kSegments = {"segments", "vertices around", 3, 2048, 64, true};

geometry::Material colored(float r, float g, float b) {
  geometry::Material material;
  material.color = {r, g, b, 1.0f};
  return material;
}

/// cells × cells squares of two colours, some px each; those of the second colour have the alpha given.
geometry::Picture checker(int cells, int cell_px, glm::u8vec4 first, glm::u8vec4 second) {
  geometry::Picture picture{.name = "checker", .size_px = glm::ivec2(cells * cell_px), .texels = {}};
  picture.has_alpha = first.a < 255 || second.a < 255;
  for (int y = 0; y < picture.size_px.y; ++y) {
    for (int x = 0; x < picture.size_px.x; ++x) {
      picture.texels.push_back((x / cell_px + y / cell_px) % 2 == 0 ? first : second);
    }
  }
  return picture;
}

Scene make_sphere(const SceneValues& v) {
  const glm::dvec3 centre(v.at("x"), v.at("y"), v.at("z"));
  return geometry::scene_of(geometry::sphere(centre, v.at("radius"), int(v.at("segments")), int(v.at("rings"))),
                            colored(0.8f, 0.3f, 0.15f));
}

Scene make_torus(const SceneValues& v) {
  return geometry::scene_of(
      geometry::torus(glm::dvec3(0.0), v.at("radius"), v.at("tube"), int(v.at("segments")), int(v.at("sides"))),
      colored(0.2f, 0.45f, 0.7f));
}

Scene make_cube(const SceneValues& v) {
  const glm::dvec3 half(0.5 * v.at("side"));
  return geometry::scene_of(geometry::box(-half, half), colored(0.75f, 0.6f, 0.25f));
}

Scene make_terrain(const SceneValues& v) {
  return geometry::scene_of(
      geometry::terrain(v.at("size"), int(v.at("cells")), v.at("height"), std::uint64_t(v.at("seed"))),
      colored(0.35f, 0.5f, 0.2f));
}

/// Eight meshes, one a colour, instanced: colours, sizes and places vary with the seed.
Scene make_spheres(const SceneValues& v) {
  const int side = int(v.at("side")), segments = int(v.at("segments"));
  const auto seed = std::uint64_t(v.at("seed"));
  Scene scene;
  for (std::uint32_t k = 0; k < 8; ++k) {
    geometry::Random random(seed, 0, k);
    const auto channel = [&] { return float(random.uniform(0.05, 0.9)); };
    const float r = channel(), g = channel(), b = channel();
    scene.meshes.push_back(geometry::sphere(glm::dvec3(0.0), 1.0, segments, segments / 2));
    scene.meshes.back().material = k;
    scene.materials.push_back(colored(r, g, b));
  }
  for (int k = 0; k < side * side; ++k) {
    geometry::Random random(seed, 1, std::uint64_t(k));
    const double radius = random.uniform(0.2, 0.5);
    const glm::dvec3 centre(double(k % side) - 0.5 * (side - 1), radius, double(k / side) - 0.5 * (side - 1));
    const glm::dmat4 place = glm::scale(glm::translate(glm::dmat4(1.0), centre), glm::dvec3(radius));
    scene.nodes.push_back({.name = {}, .parent = {}, .parent_from_node = place, .world_from_node = place});
    scene.instances.push_back({.mesh = random.below(8), .node = std::uint32_t(k), .world_from_object = place});
  }
  return scene;
}

/// A checkered square in the plane y = 0, for texture filters.
Scene make_ground(const SceneValues& v) {
  geometry::Material material;
  material.color_texture = geometry::TextureUse{};
  material.unlit = true;
  Scene scene = geometry::scene_of(geometry::terrain(v.at("size"), 1, 0.0, 0), material);
  scene.pictures.push_back(checker(int(v.at("checks")), 16, {240, 240, 235, 255}, {30, 60, 110, 255}));
  return scene;
}

/// A box for each alpha mode, with the same half transparent checker, in a row: opaque, mask, blend, and a mirrored
/// instance of the masked one. A solid box stands behind.
Scene make_alpha(const SceneValues& v) {
  Scene scene;
  scene.pictures.push_back(checker(int(v.at("checks")), 8, {230, 200, 60, 255}, {40, 120, 200, 100}));
  const geometry::Mesh cube = geometry::box(glm::dvec3(-0.5), glm::dvec3(0.5));
  const auto place = [](double x) { return glm::translate(glm::dmat4(1.0), glm::dvec3(x, 0.0, 0.0)); };
  using enum geometry::AlphaMode;
  double x = -2.1;
  for (const geometry::AlphaMode mode : {opaque, mask, blend, mask}) {
    const bool last = x > 2.0;
    geometry::Material material;
    material.color_texture = geometry::TextureUse{};
    material.alpha_mode = mode;
    material.alpha_cutoff = v.at("cutoff");
    material.double_sided = mode != opaque;
    geometry::add_instance(scene, cube, material, last ? glm::scale(place(x), glm::dvec3(-1.0, 1.0, 1.0)) : place(x));
    x += 1.4;
  }
  geometry::add_instance(scene, geometry::box({-3.0, -0.6, -1.4}, {3.0, 0.6, -1.2}), colored(0.5f, 0.1f, 0.1f));
  return scene;
}

std::vector<BuiltinScene> make_list() {
  const Parameter seed = {"seed", "of the random numbers", 0, 9007199254740992.0, 1, true};
  const auto radius = [](const char* name, const char* meaning, double value) {
    return Parameter{name, meaning, 1e-6, 1e6, value};
  };
  const auto coordinate = [](const char* name) { return Parameter{name, "of the centre", -1e9, 1e9, 0}; };
  const Parameter checks = {"checks", "squares along a side of the texture", 1, 256, 16, true};
  std::vector<BuiltinScene> list = {
      {"sphere",
       "A ball's surface, 2 segments (rings - 1) triangles",
       {radius("radius", "of the ball", 1),
        kSegments,
        {"rings", "from pole to pole", 2, 1024, 32, true},
        coordinate("x"),
        coordinate("y"),
        coordinate("z")},
       make_sphere},
      {"torus",
       "A ring around the y axis, 2 segments sides triangles",
       {radius("radius", "of the ring", 1),
        radius("tube", "radius of the tube", 0.4),
        kSegments,
        {"sides", "vertices around the tube", 3, 2048, 32, true}},
       make_torus},
      {"cube", "Twelve triangles around the origin", {radius("side", "of the cube", 1)}, make_cube},
      {"terrain",
       "A square of hills, 2 cells² triangles",
       {radius("size", "side of the square", 10),
        {"cells", "along a side", 1, 2048, 128, true},
        {"height", "of the highest hill possible", 0, 1e6, 2},
        seed},
       make_terrain},
      {"spheres",
       "Balls of many sizes and colours on a square of side² places, one draw each",
       {{"side", "balls along a side", 1, 32, 6, true}, {"segments", "vertices around each", 4, 128, 48, true}, seed},
       make_spheres},
      {"ground",
       "A checkered square in the plane y = 0",
       {radius("size", "side of the square", 10), checks},
       make_ground},
      {"alpha",
       "Boxes with one texture in each alpha mode: opaque, mask, blend, and mask mirrored",
       {{"cutoff", "of the masked ones", 0, 1, 0.5}, {"checks", checks.meaning, 1, 256, 4, true}},
       make_alpha},
  };
  for (BuiltinScene& scene : laboratory_scenes()) list.push_back(std::move(scene));
  return list;
}

}  // namespace

std::span<const BuiltinScene> builtin_scenes() {
  static const std::vector<BuiltinScene> list = make_list();
  return list;
}

}  // namespace lode::experiments

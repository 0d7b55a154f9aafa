/// Light on a scene's surfaces.

#include "techniques/scene_shader.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/techniques/small_scenes.h"

namespace lode::tests {
namespace {

using techniques::ColorSpace;
using techniques::kAmbient;
using techniques::kToLight;
using techniques::Shading;

constexpr techniques::SceneDraws::Params kLit{Shading::material, ColorSpace::srgb};

/// What a white square along +z gets of the light: 0.25 + 0.75 · 4/√61.
constexpr float kFacing = kAmbient + (1.0f - kAmbient) * kToLight.z;

float light_of(const geometry::Scene& scene, const techniques::SceneDraws::Params& params, bool from_behind = false) {
  return picture_of(scene, params, glm::vec4(0.0f), 1, from_behind).rgba32f[0].r;
}

geometry::Scene white_square(const geometry::Material& material = {}, const glm::dmat4& place = glm::dmat4(1.0)) {
  geometry::Scene scene;
  add(scene, unit_square(), material, place);
  return scene;
}

TEST(SceneShader, TheLightIsAUnitVector) {
  const double x = kToLight.x, y = kToLight.y, z = kToLight.z;
  EXPECT_NEAR(x * x + y * y + z * z, 1.0, 1e-7);
}

TEST(SceneShader, LightIsAmbientAndTheCosine) {
  EXPECT_FLOAT_EQ(light_of(white_square(), kLit), kFacing);
  geometry::Scene away = white_square();
  away.meshes[0].normals.assign(4, {0, 0, -3});
  EXPECT_FLOAT_EQ(light_of(away, kLit), kAmbient);
  away.meshes[0].normals.assign(4, {0, 0, 0});
  EXPECT_FLOAT_EQ(light_of(away, kLit), kAmbient);
}

TEST(SceneShader, MaterialsThatAreUnlitAreLitOnlyWhereAllAre) {
  geometry::Material unlit;
  unlit.unlit = true;
  EXPECT_EQ(light_of(white_square(unlit), kLit), 1.0f);
  EXPECT_FLOAT_EQ(light_of(white_square(unlit), {Shading::lambert, ColorSpace::srgb}), kFacing);
  EXPECT_EQ(light_of(white_square(), {Shading::unlit, ColorSpace::srgb}), 1.0f);
}

TEST(SceneShader, TheBackOfATwoSidedSquareIsLitFromItsOwnSide) {
  // From behind, the normal that is seen points to −z, away from the light.
  geometry::Material both;
  both.double_sided = true;
  EXPECT_FLOAT_EQ(light_of(white_square(both), kLit, false), kFacing);
  EXPECT_FLOAT_EQ(light_of(white_square(both), kLit, true), kAmbient);
  // Mirrored in x, the same square's front is still its front.
  const glm::dmat4 mirror = glm::scale(glm::translate(glm::dmat4(1.0), {1, 0, 0}), glm::dvec3(-1, 1, 1));
  EXPECT_FLOAT_EQ(light_of(white_square(both, mirror), kLit, false), kFacing);
  EXPECT_FLOAT_EQ(light_of(white_square(both, mirror), kLit, true), kAmbient);
}

TEST(SceneShader, TrianglesWithoutNormalsAreFlat) {
  geometry::Scene scene = white_square();
  scene.meshes[0].normals.clear();
  EXPECT_FLOAT_EQ(light_of(scene, kLit), kFacing);
}

TEST(SceneShader, NormalsStayPerpendicularAndOutside) {
  // Stretched twofold in x, the plane x + z = 0 becomes x/2 + z = 0: normals (1, 0, 1) become (0.5, 0, 1).
  const glm::mat3 stretched = techniques::world_from_normal(glm::scale(glm::dmat4(1.0), {2, 1, 1}));
  EXPECT_EQ(stretched * glm::vec3(1, 0, 1), glm::vec3(0.5f, 0, 1));
  // Mirrored in x, outwards along +x is outwards along −x.
  const glm::mat3 mirrored = techniques::world_from_normal(glm::scale(glm::dmat4(1.0), {-1, 1, 1}));
  EXPECT_EQ(mirrored * glm::vec3(1, 2, 3), glm::vec3(-1, 2, 3));
}

TEST(SceneShader, TransformsOfAnySizeKeepTheirNormalsAndBrokenOnesHaveNone) {
  for (const double s : {1e-200, 1e-30, 1e30, 1e200}) {
    EXPECT_EQ(techniques::world_from_normal(glm::scale(glm::dmat4(1.0), glm::dvec3(s))), glm::mat3(1.0f)) << s;
  }
  EXPECT_EQ(techniques::world_from_normal(glm::dmat4(0.0)), glm::mat3(0.0f));
  glm::dmat4 broken(1.0);
  broken[1][1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(techniques::world_from_normal(broken), glm::mat3(0.0f));
}

}  // namespace
}  // namespace lode::tests

/// What a scene's materials, colours and transforms become on a pixel.

#include "techniques/scene_draws.h"

#include <gtest/gtest.h>

#include "raster/error.h"
#include "raster/srgb.h"
#include "tests/techniques/small_scenes.h"

namespace lode::tests {
namespace {

using geometry::AlphaMode;
using geometry::Material;
using techniques::ColorSpace;
using techniques::Shading;

constexpr techniques::SceneDraws::Params kRaw{Shading::unlit, ColorSpace::raw};
constexpr techniques::SceneDraws::Params kSrgb{Shading::unlit, ColorSpace::srgb};

Material textured(AlphaMode mode) {
  Material material;
  material.alpha_mode = mode;
  material.color_texture = geometry::TextureUse{};
  return material;
}

/// One square with a texture of one texel.
geometry::Scene one_square(glm::u8vec4 texel, AlphaMode mode) {
  geometry::Scene scene;
  scene.pictures.push_back(one_texel(texel));
  add(scene, unit_square(), textured(mode));
  return scene;
}

TEST(SceneDraws, OpaqueCountsAlphaAsOneEverywhere) {
  geometry::Scene scene = one_square({200, 100, 50, 10}, AlphaMode::opaque);
  EXPECT_EQ(picture_of(scene, kRaw).rgba8[0], glm::u8vec4(200, 100, 50, 255));
  scene.materials[0].color.a = 0.25f;
  scene.meshes[0].colors.assign(4, {1, 1, 1, 0.5f});
  EXPECT_EQ(picture_of(scene, kRaw).rgba8[0], glm::u8vec4(200, 100, 50, 255));
  EXPECT_EQ(raster::srgb8_from_linear(picture_of(scene, kSrgb).rgba32f[0]), glm::u8vec4(200, 100, 50, 255));
}

TEST(SceneDraws, MaskedSamplesAreOpaqueOrNotThere) {
  // 127/255 < 0.5 <= 128/255. Raw: premultiplied bytes round(200·128/255) = 100, 50, 25; divided again
  // 100/128·255 = 199.2, 99.6, 49.8. Linear floats come back to the same code.
  const raster::Image gone = picture_of(one_square({200, 100, 50, 127}, AlphaMode::mask), kRaw, {1, 2, 3, 4});
  EXPECT_EQ(gone.rgba8[0], glm::u8vec4(1, 2, 3, 4));
  EXPECT_EQ(gone.ids[0].draw, raster::kNoId);
  const geometry::Scene there = one_square({200, 100, 50, 128}, AlphaMode::mask);
  EXPECT_EQ(picture_of(there, kRaw).rgba8[0], glm::u8vec4(199, 100, 50, 255));
  const raster::Image linear = picture_of(there, kSrgb);
  EXPECT_EQ(raster::srgb8_from_linear(linear.rgba32f[0]), glm::u8vec4(200, 100, 50, 255));
  EXPECT_EQ(linear.rgba32f[0].a, 1.0f);
  EXPECT_EQ(linear.ids[0], (raster::Ids{0, 0}));
}

TEST(SceneDraws, AMaskThatCutsNothingOutIsDrawnAsOpaque) {
  geometry::Scene scene;
  Material material;
  material.alpha_mode = AlphaMode::mask;
  material.color = {0.3f, 0.6f, 0.9f, 1.0f};
  add(scene, unit_square(), material);
  const auto tests_alpha = [&] {
    const techniques::SceneDraws draws(scene, kSrgb);
    return draws.draw(0, glm::dmat4(1.0)).alpha_test.has_value();
  };
  EXPECT_FALSE(tests_alpha());
  EXPECT_EQ(picture_of(scene, kSrgb).rgba32f[0].a, 1.0f);
  scene.meshes[0].colors.assign(4, {1, 1, 1, 1});
  EXPECT_FALSE(tests_alpha());
  scene.meshes[0].colors[2].a = 0.75f;  // above the cutoff here, but not everywhere above any
  EXPECT_TRUE(tests_alpha());
  scene.meshes[0].colors.clear();
  scene.materials[0].alpha_cutoff = 1.5;
  EXPECT_TRUE(tests_alpha());
}

TEST(SceneDraws, AlphaEqualToTheCutoffIsKept) {
  geometry::Scene scene;
  Material material;
  material.alpha_mode = AlphaMode::mask;
  material.color = {1.0f, 0.5f, 0.25f, 0.5f};
  add(scene, unit_square(), material);
  for (const auto& params : {kRaw, kSrgb}) {
    scene.materials[0].alpha_cutoff = 0.5;
    EXPECT_EQ(picture_of(scene, params).ids[0].draw, 0u);
    scene.materials[0].alpha_cutoff = 0.5 + 1e-9;
    EXPECT_EQ(picture_of(scene, params).ids[0].draw, raster::kNoId);
  }
  // A cutoff of 0 keeps even alpha 0, whose colour premultiplication has lost: black.
  scene.materials[0].alpha_cutoff = 0.0;
  scene.materials[0].color.a = 0.0f;
  EXPECT_EQ(picture_of(scene, kSrgb).rgba32f[0], glm::vec4(0, 0, 0, 1));
}

TEST(SceneDraws, BlendedSquaresLieOverWhatIsBehindInTheirOrder) {
  // Over blue: red at a quarter, (0.25, 0, 0.75, 1); then green at a half, (0.125, 0.5, 0.375, 1), though green is
  // farther away: nothing sorts, and nothing blended writes depth. What an opaque square hides is not drawn.
  geometry::Scene scene;
  Material material;
  material.alpha_mode = AlphaMode::blend;
  material.color = {1, 0, 0, 0.25f};
  add(scene, unit_square(2.0f), material);
  material.color = {0, 1, 0, 0.5f};
  add(scene, unit_square(1.0f), material);
  add(scene, unit_square(-2.0f), material);
  Material solid;
  solid.color = {0, 0, 1, 1};
  add(scene, unit_square(0.0f), solid);
  const raster::Image image = picture_of(scene, kSrgb);
  EXPECT_EQ(image.rgba32f[0], glm::vec4(0.125f, 0.5f, 0.375f, 1.0f));
  EXPECT_EQ(image.ids[0].draw, 3u);
  EXPECT_EQ(image.depth[0], 0.5f);  // z = 0 is halfway from near to far
}

TEST(SceneDraws, RawBlendsBytesAndSrgbBlendsLight) {
  // White at alpha 128/255 over black. Bytes: 128. Light: 128/255 = 0.50196, and encode(0.50196) = 188.1.
  geometry::Scene scene = one_square({255, 255, 255, 128}, AlphaMode::blend);
  EXPECT_EQ(picture_of(scene, kRaw, {0, 0, 0, 255}).rgba8[0], glm::u8vec4(128, 128, 128, 255));
  const glm::vec4 light = picture_of(scene, kSrgb, {0, 0, 0, 1}).rgba32f[0];
  EXPECT_EQ(raster::srgb8_from_linear(light), glm::u8vec4(188, 188, 188, 255));
}

TEST(SceneDraws, FactorsAndVertexColorsAreLinearInSrgbAndBytesInRaw) {
  // 0.5 · 0.5 · texel: linear decode(255)/4 = 0.25, encode 137.0; raw 255/4 = 63.75.
  geometry::Scene scene = one_square({255, 255, 255, 255}, AlphaMode::opaque);
  scene.materials[0].color = {0.5f, 0.5f, 0.5f, 1.0f};
  scene.meshes[0].colors.assign(4, {0.5f, 0.5f, 0.5f, 1.0f});
  EXPECT_EQ(picture_of(scene, kSrgb).rgba32f[0], glm::vec4(0.25f, 0.25f, 0.25f, 1.0f));
  EXPECT_EQ(picture_of(scene, kRaw).rgba8[0], glm::u8vec4(64, 64, 64, 255));
}

TEST(SceneDraws, VertexColorsOfWholeBytesComeBackAsTheseBytes) {
  for (int k = 0; k < 256; ++k) {
    geometry::Scene scene;
    geometry::Mesh mesh = unit_square();
    mesh.colors.assign(4, glm::vec4(float(k) / 255.0f, 0.0f, 1.0f, 1.0f));
    add(scene, mesh, {});
    ASSERT_EQ(picture_of(scene, kRaw).rgba8[0], glm::u8vec4(k, 0, 255, 255)) << k;
  }
}

TEST(SceneDraws, OneSidedSquaresShowTheirFrontAlsoWhereTheyAreMirrored) {
  geometry::Scene plain, mirrored, two_sided;
  add(plain, unit_square(), {});
  add(mirrored, unit_square(), {}, glm::scale(glm::translate(glm::dmat4(1.0), {1, 0, 0}), glm::dvec3(-1, 1, 1)));
  Material both;
  both.double_sided = true;
  add(two_sided, unit_square(), both);
  const auto seen = [](const geometry::Scene& scene, bool from_behind) {
    return picture_of(scene, kRaw, glm::vec4(0.0f), 1, from_behind).ids[0].draw == 0u;
  };
  EXPECT_TRUE(seen(plain, false));
  EXPECT_FALSE(seen(plain, true));
  EXPECT_TRUE(seen(mirrored, false));
  EXPECT_FALSE(seen(mirrored, true));
  EXPECT_TRUE(seen(two_sided, false));
  EXPECT_TRUE(seen(two_sided, true));
}

TEST(SceneDraws, LinesAndPointsHaveNoSidesAndStayUnlitWithoutNormals) {
  geometry::Scene scene;
  geometry::Mesh points;
  points.kind = geometry::MeshKind::points;
  points.positions = {{0.5f, 0.5f, 0.0f}};
  points.indices = {0};
  add(scene, points, {});
  geometry::Mesh line;
  line.kind = geometry::MeshKind::lines;
  line.positions = {{1.1f, 0.5f, 0.0f}, {3.0f, 0.5f, 0.0f}};
  line.indices = {0, 1};
  add(scene, line, {});
  const raster::Image image = picture_of(scene, {Shading::lambert, ColorSpace::raw}, glm::vec4(0.0f), 2);
  EXPECT_EQ(image.rgba8[2], glm::u8vec4(255));  // the lower row
  EXPECT_EQ(image.ids[2].draw, 0u);
  EXPECT_EQ(image.rgba8[3], glm::u8vec4(255));
  EXPECT_EQ(image.ids[3].draw, 1u);
}

TEST(SceneDraws, TexturesRunFromTheTopDown) {
  geometry::Scene scene;
  scene.pictures.push_back({.name = "two rows", .size_px = {1, 2}, .texels = {{255, 0, 0, 255}, {0, 0, 255, 255}}});
  Material material = textured(AlphaMode::opaque);
  material.color_texture->filter = geometry::TextureFilter::nearest;
  add(scene, unit_square(), material, glm::scale(glm::dmat4(1.0), glm::dvec3(2.0)));
  const raster::Image image = picture_of(scene, kRaw, glm::vec4(0.0f), 2);
  EXPECT_EQ(image.rgba8[0], glm::u8vec4(255, 0, 0, 255));  // the upper row: v = 0
  EXPECT_EQ(image.rgba8[2], glm::u8vec4(0, 0, 255, 255));
}

TEST(SceneDraws, APictureSharedByOpaqueAndMaskedMaterialsHasItsAlphaOnlyInOne) {
  geometry::Scene scene = one_square({9, 9, 9, 0}, AlphaMode::opaque);
  add(scene, unit_square(1.0f), textured(AlphaMode::mask));
  const raster::Image image = picture_of(scene, kRaw);
  EXPECT_EQ(image.ids[0].draw, 0u);
  EXPECT_EQ(image.rgba8[0], glm::u8vec4(9, 9, 9, 255));
}

TEST(SceneDraws, DrawsAreInstancesAndPrimitivesThoseOfTheMesh) {
  geometry::Scene scene;
  add(scene, unit_square(), {});
  scene.instances.push_back(scene.instances[0]);
  scene.instances[1].world_from_object = glm::translate(glm::dmat4(1.0), {1, 0, 0});
  const raster::Image image = picture_of(scene, kRaw, glm::vec4(0.0f), 2);
  // The lower row has both squares; samples in the middle, on the diagonal, belong to one of the two triangles.
  EXPECT_EQ(image.ids[0].draw, raster::kNoId);
  EXPECT_EQ(image.ids[2].draw, 0u);
  EXPECT_EQ(image.ids[3].draw, 1u);
  EXPECT_LT(image.ids[3].primitive, 2u);
}

TEST(SceneDraws, InstancesOfAMeshOfTrianglesShareItsClusters) {
  geometry::Scene scene;
  add(scene, unit_square(), {});
  scene.instances.push_back(scene.instances[0]);
  add(scene, unit_square(1.0f), {});
  geometry::Mesh line = unit_square();
  line.kind = geometry::MeshKind::lines;
  line.indices = {0, 1};
  add(scene, line, {});
  techniques::SceneDraws scene_draws(scene, kRaw);
  for (const raster::Draw& draw : scene_draws.draws(square_camera(1), {1, 1})) EXPECT_EQ(draw.clusters, nullptr);
  scene_draws.cut_clusters();
  const std::vector<raster::Draw> draws = scene_draws.draws(square_camera(1), {1, 1});
  ASSERT_NE(draws[0].clusters, nullptr);
  EXPECT_EQ(draws[0].clusters->n_positions, 4u);
  EXPECT_EQ(draws[0].clusters->n_primitives, 2u);
  EXPECT_EQ(draws[1].clusters, draws[0].clusters);
  ASSERT_NE(draws[2].clusters, nullptr);
  EXPECT_NE(draws[2].clusters, draws[0].clusters);
  EXPECT_EQ(draws[3].clusters, nullptr);
}

TEST(SceneDraws, ClustersAreOfWhatIsDrawn) {
  // Lit without normals, the square is drawn as two triangles of three vertices each.
  geometry::Scene scene;
  geometry::Mesh square = unit_square();
  square.normals.clear();
  add(scene, square, {});
  techniques::SceneDraws scene_draws(scene, {Shading::lambert, ColorSpace::raw});
  scene_draws.cut_clusters();
  const raster::Draw draw = scene_draws.draws(square_camera(1), {1, 1})[0];
  EXPECT_EQ(draw.clusters->n_positions, std::get<raster::ObjectVertices>(draw.vertices).positions.size());
  EXPECT_EQ(draw.clusters->n_positions, 6u);
}

TEST(SceneDraws, APictureThatIsTooLargeIsNamed) {
  geometry::Scene scene;
  scene.pictures.push_back({.name = "wall.png", .size_px = {16385, 1}, .texels = {}});
  scene.pictures[0].texels.resize(16385);
  add(scene, unit_square(), textured(AlphaMode::opaque));
  try {
    const techniques::SceneDraws draws(scene, kRaw);
    FAIL();
  } catch (const raster::Error& error) {
    EXPECT_NE(std::string(error.what()).find("picture wall.png: "), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace lode::tests

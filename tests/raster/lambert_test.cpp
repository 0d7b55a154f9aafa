#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "raster/shader.h"

namespace lode::raster {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();

/// The shader's result for one material and a batch of normals.
std::vector<glm::vec4> shaded(const Lambert& lambert, const glm::vec4& material, std::vector<glm::vec3> normals) {
  const Shader shader = lambert_shader(lambert);
  const std::vector<glm::vec4> materials(normals.size(), material);
  std::vector<glm::vec4> rgba(normals.size());
  ShadeBatch batch;
  batch.n = static_cast<int>(normals.size());
  batch.material = materials.data();
  batch.normal = normals.data();
  shader.function(shader.state.get(), batch, rgba.data());
  return rgba;
}

TEST(Lambert, LightIsAmbientPlusTheRestTimesTheCosineAndAlphaIsKept) {
  const Lambert lambert{.to_light = {0.0f, 1.0f, 0.0f}, .ambient = 0.25f, .two_sided = false};
  const glm::vec4 material{200.0f, 100.0f, 40.0f, 128.0f};
  // Cosines 1, 0.6 (a 3-4-5 normal, of any length), 0 and −1: 0.25 + 0.75·cosine, at least 0.25.
  const auto rgba = shaded(lambert, material, {{0, 5, 0}, {4, 3, 0}, {0, 0, 2}, {0, -1, 0}});
  EXPECT_EQ(rgba[0], material);
  EXPECT_EQ(rgba[1], glm::vec4(200.0f * (0.25f + 0.75f * 0.6f), 100.0f * (0.25f + 0.75f * 0.6f),
                               40.0f * (0.25f + 0.75f * 0.6f), 128.0f));
  EXPECT_EQ(rgba[2], glm::vec4(50.0f, 25.0f, 10.0f, 128.0f));
  EXPECT_EQ(rgba[3], rgba[2]);
}

TEST(Lambert, TwoSidedTakesTheCosinesMagnitude) {
  const Lambert lambert{.to_light = {0.0f, 0.0f, 1.0f}, .ambient = 0.5f, .two_sided = true};
  const auto rgba = shaded(lambert, glm::vec4(1.0f), {{0, 0, -3}, {0, 4, -3}, {0, 4, 3}});
  EXPECT_EQ(rgba[0], glm::vec4(1.0f));
  EXPECT_EQ(rgba[1], rgba[2]);
  EXPECT_EQ(rgba[1].r, 0.5f + 0.5f * 0.6f);
}

TEST(Lambert, NormalsFarFromUnitLengthKeepTheirDirection) {
  const Lambert lambert{.to_light = {0.0f, 1.0f, 0.0f}, .ambient = 0.0f, .two_sided = false};
  const float huge = 3e38f, tiny = 1e-40f;
  const auto rgba = shaded(lambert, glm::vec4(1.0f), {{0, huge, 0}, {0, tiny, 0}, {huge, huge, 0}, {tiny, tiny, 0}});
  EXPECT_EQ(rgba[0].r, 1.0f);
  EXPECT_EQ(rgba[1].r, 1.0f);
  EXPECT_EQ(rgba[2].r, 1.0f / std::sqrt(2.0f));
  EXPECT_EQ(rgba[3].r, 1.0f / std::sqrt(2.0f));
}

TEST(Lambert, NormalsAreTurnedIntoTheLightsSpaceAndThoseOfBacksRound) {
  // x goes to 2y and y to z: (3, 4, 0) becomes (0, 6, 4), of length √52.
  Lambert lambert{.to_light = {0.0f, 0.0f, 1.0f}, .ambient = 0.0f};
  lambert.light_from_normal = glm::mat3{{0, 2, 0}, {0, 0, 1}, {0, 0, 0}};
  EXPECT_EQ(shaded(lambert, glm::vec4(1.0f), {{3, 4, 0}})[0].r, 4.0f / std::sqrt(52.0f));
  // The batch is a front. It is a back to a mirrored draw, and only then lit from behind.
  lambert.light_from_normal = glm::mat3(1.0f);
  for (const bool mirrored : {false, true}) {
    lambert.turns_backs = true, lambert.front_is_clockwise = mirrored;
    const auto rgba = shaded(lambert, glm::vec4(1.0f), {{0, 0, 1}, {0, 0, -1}});
    EXPECT_EQ(rgba[0].r, mirrored ? 0.0f : 1.0f);
    EXPECT_EQ(rgba[1].r, mirrored ? 1.0f : 0.0f);
  }
}

TEST(Lambert, IsFoundAgainInItsShader) {
  const Shader shader = lambert_shader({.ambient = 0.125f});
  ASSERT_NE(material_of(shader), nullptr);
  EXPECT_EQ(material_of(shader)->light->ambient, 0.125f);
  EXPECT_FALSE(material_of(shader)->cut_out);
  EXPECT_EQ(material_of({}), nullptr);
  EXPECT_EQ(material_of(pixel_shader([](const Pixel& p) { return p.material; })), nullptr);
}

TEST(Lambert, AZeroOrNonFiniteNormalGetsAmbientLightOnly) {
  for (const bool two_sided : {false, true}) {
    const Lambert lambert{.to_light = {0.6f, 0.8f, 0.0f}, .ambient = 0.25f, .two_sided = two_sided};
    const std::vector<glm::vec3> normals{{0, 0, 0},    {-0.0f, 0, 0}, {kNan, 1, 0},  {0, kNan, 0},
                                         {0, 1, kNan}, {0, kInf, 0},  {-kInf, 0, 1}, {1, 1, kInf}};
    for (const glm::vec4& rgba : shaded(lambert, {4.0f, 8.0f, 12.0f, 16.0f}, normals)) {
      EXPECT_EQ(rgba, glm::vec4(1.0f, 2.0f, 3.0f, 16.0f));
    }
  }
}

}  // namespace
}  // namespace lode::raster

// What colour a sample gets: draw colour × vertex colour × texel, shaders, storing and blending on both formats.
#include <bit>
#include <cmath>
#include <limits>

#include "small_scene.h"

namespace lode::raster::test {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN(), kInf = std::numeric_limits<float>::infinity();

std::uint32_t bits(float value) { return std::bit_cast<std::uint32_t>(value); }

/// A draw that covers the target and has the same uv, vertex colour and normal everywhere.
Draw& cover(SmallScene& scene, double z = 0.5) {
  return scene.rect({0, 0}, scene.image.size_px, z, {255, 255, 255, 255});
}

TEST(Material, IsWhiteByDefaultInTheTargetsUnit) {
  SmallScene bytes({1, 1});
  cover(bytes).color.reset();
  bytes.render();
  EXPECT_EQ(bytes.image.rgba8[0], glm::u8vec4(255));
  SmallScene floats({1, 1}, ColorFormat::rgba32f);
  cover(floats).color.reset();
  floats.render();
  EXPECT_EQ(floats.image.rgba32f[0], glm::vec4(1.0f));
}

TEST(Material, IsDrawColourTimesVertexColourTimesTexelRoundedOnceHalfUp) {
  SmallScene scene({1, 1});
  // 200·100/255·51/255 = 15.68…; 255·255/255·51/255 = 51; 10·1/255·255/255 = 0.039…; 128·254/255·255/255 = 127.498…
  Draw& draw = cover(scene);
  draw.color = glm::vec4(200, 255, 10, 128);
  draw.colors = scene.keep(std::vector<glm::vec4>(4, {100, 255, 1, 254}));
  const std::vector<glm::u8vec4> texel(1, {51, 51, 255, 255});
  const Texture texture = make_raw_texture({1, 1}, texel, Mips::none);
  draw.uvs = scene.keep(std::vector<glm::vec2>(4, {0.5f, 0.5f}));
  draw.texture = &texture;
  scene.render();
  EXPECT_EQ(scene.image.rgba8[0], glm::u8vec4(16, 51, 0, 127));
}

TEST(Material, RoundsHalvesUpAndKeepsWholeCodes) {
  SmallScene scene({1, 1});
  cover(scene).color = glm::vec4(0.5f, 1.49f, 254.5f, 300.0f);
  scene.render();
  EXPECT_EQ(scene.image.rgba8[0], glm::u8vec4(1, 1, 255, 255));
}

TEST(Material, OfARawTextureIsFractionsOfOneInAFloatTarget) {
  SmallScene scene({1, 1}, ColorFormat::rgba32f);
  const std::vector<glm::u8vec4> texel(1, {51, 102, 255, 255});
  const Texture texture = make_raw_texture({1, 1}, texel, Mips::none);
  Draw& draw = cover(scene);
  draw.color = glm::vec4(2.0f, 1.0f, 1.0f, 0.5f);
  draw.uvs = scene.keep(std::vector<glm::vec2>(4, {0.5f, 0.5f}));
  draw.texture = &texture;
  scene.render();
  EXPECT_EQ(scene.image.rgba32f[0], glm::vec4(2.0f * (51.0f / 255.0f), 102.0f / 255.0f, 1.0f, 0.5f));
}

TEST(Material, OfALinearTextureIsItsTexels) {
  SmallScene scene({1, 1}, ColorFormat::rgba32f);
  const std::vector<glm::vec4> texel(1, {0.25f, 7.0f, 0.0f, 0.5f});
  const Texture texture = make_linear_texture({1, 1}, texel, Mips::none);
  Draw& draw = cover(scene);
  draw.color.reset();
  draw.uvs = scene.keep(std::vector<glm::vec2>(4, {0.5f, 0.5f}));
  draw.texture = &texture;
  scene.render();
  EXPECT_EQ(scene.image.rgba32f[0], texel[0]);
}

// Four texels over 4×2 pixels, nearest: each corner of the picture shows its own.
TEST(Material, PutsTheTextureUprightWithVZeroAtTheTop) {
  SmallScene scene({4, 2});
  const std::vector<glm::u8vec4> texels = {{10, 0, 0, 255}, {20, 0, 0, 255}, {30, 0, 0, 255}, {40, 0, 0, 255}};
  const Texture texture = make_raw_texture({2, 2}, texels, Mips::none);
  Draw& draw = cover(scene);
  draw.uvs = scene.keep<glm::vec2>({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  draw.texture = &texture;
  draw.sampler.filter = Filter::nearest;
  scene.render();
  EXPECT_EQ(picture(scene.image, [&](std::size_t i) { return char('0' + scene.image.rgba8[i].r / 10); }),
            "1122\n3344\n");
}

TEST(FloatTarget, HoldsOneNanAndNoNegativeZeroFromClearDrawAndBlend) {
  for (const Blend blend : {Blend::none, Blend::over, Blend::add}) {
    SmallScene scene({2, 1}, ColorFormat::rgba32f);
    scene.frame.clear = {std::bit_cast<float>(0xFFFFFFFFu), -0.0f, -kInf, 1.0f};
    Draw& draw = scene.rect({0, 0}, {1, 1}, 0.5, {std::bit_cast<float>(0xFF800001u), -0.0f, kInf, 0.0f});
    draw.blend = blend;
    scene.render();
    const glm::vec4 drawn = scene.image.rgba32f[0], cleared = scene.image.rgba32f[1];
    EXPECT_EQ(bits(drawn.r), 0x7FC00000u);
    EXPECT_EQ(bits(drawn.g), 0u);
    EXPECT_EQ(bits(drawn.b), blend == Blend::none ? bits(kInf) : 0x7FC00000u) << "Inf − Inf";
    EXPECT_EQ(bits(cleared.r), 0x7FC00000u);
    EXPECT_EQ(bits(cleared.g), 0u);
    EXPECT_EQ(cleared.b, -kInf);
  }
}

TEST(ByteTarget, StoresNanAsZeroAndClampsInfinities) {
  SmallScene scene({1, 1});
  scene.frame.clear = {kNan, 1, 1, 1};
  cover(scene).color = glm::vec4(kNan, kInf, -kInf, -0.0f);
  scene.render();
  EXPECT_EQ(scene.image.rgba8[0], glm::u8vec4(0, 255, 0, 0));
}

TEST(Blending, OnBytesStoresTheSourceFirstThenRoundsTheResultHalfUp) {
  // Source 100.5 is stored as 101, alpha 51 (⅕). Over 200: 101 + ⌊200·204/255 + ½⌋ = 101 + 160. Alpha over 255:
  // 51 + 204. Add: 301, held at 255; 51 + 255 held at 255.
  for (const Blend blend : {Blend::over, Blend::add}) {
    SmallScene scene({1, 1});
    scene.frame.clear = {200, 10, 0, 255};
    Draw& draw = cover(scene);
    draw.color = glm::vec4(100.5f, 3, 0, 51);
    draw.blend = blend;
    scene.render();
    EXPECT_EQ(scene.image.rgba8[0], blend == Blend::over ? glm::u8vec4(255, 11, 0, 255) : glm::u8vec4(255, 13, 0, 255));
  }
}

TEST(Blending, OnFloatsIsPremultipliedAndUnclamped) {
  for (const Blend blend : {Blend::over, Blend::add}) {
    SmallScene scene({1, 1}, ColorFormat::rgba32f);
    scene.frame.clear = {4.0f, 0.5f, 0.0f, 1.0f};
    Draw& draw = cover(scene);
    draw.color = glm::vec4(8.0f, 0.25f, 0.125f, 0.25f);
    draw.blend = blend;
    scene.render();
    // over: s + d·¾; add: s + d. All exact.
    EXPECT_EQ(scene.image.rgba32f[0],
              blend == Blend::over ? glm::vec4(11.0f, 0.625f, 0.125f, 1.0f) : glm::vec4(12.0f, 0.75f, 0.125f, 1.25f));
  }
}

TEST(Quads, BlendEverySampleExactlyOnceAlongTheirDiagonals) {
  // A square whose diagonals run through sample centres, and a lopsided quad inside a bigger target.
  for (const auto& corners : {std::vector<glm::dvec3>{{0, 0, 0.5}, {8, 0, 0.5}, {8, 8, 0.5}, {0, 8, 0.5}},
                              std::vector<glm::dvec3>{{0, 8, 0.5}, {0, 0, 0.5}, {8, 0, 0.5}, {8, 8, 0.5}}}) {
    SmallScene scene({8, 8});
    Draw& draw = scene.window(Topology::quads, corners);
    draw.color = glm::vec4(1, 0, 0, 0);
    draw.blend = Blend::add;
    EXPECT_EQ(scene.render().fragments_blended, 64u);
    EXPECT_EQ(scene.image.rgba8, PixelPlane<glm::u8vec4>(64, glm::u8vec4(1, 0, 0, 0)));
  }
}

TEST(Quads, AreTrianglesZeroOneTwoAndZeroTwoThree) {
  const std::vector<glm::dvec3> p = {{1.3, 0.4, 0.1}, {7.2, 2.5, 0.9}, {6.1, 7.7, 0.3}, {0.6, 5.2, 0.7}};
  const std::vector<glm::vec4> c = {{250, 0, 9, 255}, {0, 250, 9, 255}, {9, 0, 250, 255}, {99, 99, 99, 255}};
  SmallScene quad({8, 8}), triangles({8, 8});
  quad.window(Topology::quads, p).colors = quad.keep(c);
  Draw& pair = triangles.window(Topology::triangles, {p[0], p[1], p[2], p[0], p[2], p[3]});
  pair.colors = triangles.keep<glm::vec4>({c[0], c[1], c[2], c[0], c[2], c[3]});
  pair.primitive_id = 0;
  quad.render();
  triangles.render();
  EXPECT_TRUE(same_bytes(quad.image, triangles.image));
}

TEST(Shader, SeesThePixelAndItsInterpolatedInputs) {
  // A right triangle on 8×8 pixels, affine: at the sample (x + ½, y + ½) the weights are known exactly, because 8 is a
  // power of two. Attributes grow by 1 a pixel: uv = (x, y) / 8, normal = (x, y, 1) from 0 at the corner.
  SmallScene scene({8, 8}, ColorFormat::rgba32f);
  Draw& draw = scene.window(Topology::triangles, {{0, 0, 0.25}, {0, 8, 0.25}, {8, 0, 0.75}});
  draw.uvs = scene.keep<glm::vec2>({{0, 0}, {0, 1}, {1, 0}});
  draw.normals = scene.keep<glm::vec3>({{0, 0, 1}, {0, 8, 1}, {8, 0, 1}});
  draw.colors = scene.keep<glm::vec4>({{0, 0, 1, 1}, {0, 1, 1, 1}, {1, 0, 1, 1}});
  draw.color = glm::vec4(2.0f);
  const std::vector<glm::vec4> texel(1, glm::vec4(0.5f));
  const Texture texture = make_linear_texture({1, 1}, texel, Mips::none);
  draw.texture = &texture;
  draw.draw_id = 11;
  draw.primitive_id = 22;
  draw.shader = pixel_shader([](const Pixel& p) {
    const float x = float(p.x_px) + 0.5f, y = float(p.y_px) + 0.5f;
    bool right = p.depth == 0.25f + 0.5f * x / 8.0f;
    right = right && p.uv == glm::vec2(x, y) / 8.0f && p.normal == glm::vec3(x, y, 1.0f);
    right = right && p.color == 2.0f * glm::vec4(x / 8.0f, y / 8.0f, 1.0f, 1.0f);
    right = right && p.texel == glm::vec4(0.5f) && p.material == p.color * 0.5f;
    right = right && p.draw == 11 && p.primitive == 22 && p.front_facing;
    return glm::vec4(x, y, right ? 1.0f : -1.0f, 1.0f);
  });
  const FrameStats stats = scene.render();
  EXPECT_EQ(stats.fragments_shaded, 28u);  // 8·7/2: the diagonal is a right edge
  for (int i = 0; i < 64; ++i) {
    const int x = i % 8, y = i / 8;
    const glm::vec4 expected = x + y < 7 ? glm::vec4(float(x) + 0.5f, float(y) + 0.5f, 1, 1) : glm::vec4(0);
    ASSERT_EQ(scene.image.rgba32f[std::size_t(i)], expected) << x << ", " << y;
  }
}

TEST(Shader, SeesZeroNormalWhiteTexelAndZeroUvWhereTheDrawHasNone) {
  SmallScene scene({1, 1});
  cover(scene).shader = pixel_shader([](const Pixel& p) {
    const bool right = p.normal == glm::vec3(0) && p.uv == glm::vec2(0) && p.texel == glm::vec4(255) &&
                       p.material == glm::vec4(255) && p.draw == 0 && p.primitive == 0;
    return glm::vec4(right ? 1.0f : 2.0f);
  });
  scene.render();
  EXPECT_EQ(scene.image.rgba8[0], glm::u8vec4(1));
}

TEST(Shader, SeesWhichSideFacesTheEye) {
  SmallScene scene({2, 1});
  // Counter-clockwise on screen (y down), then clockwise.
  Draw& draw = scene.window(Topology::triangles,
                            {{0, 0, 0.5}, {0, 1, 0.5}, {1, 0.4, 0.5}, {1, 0, 0.5}, {2, 0.4, 0.5}, {1, 1, 0.5}});
  draw.shader = pixel_shader([](const Pixel& p) { return glm::vec4(p.front_facing ? 1.0f : 2.0f); });
  scene.render();
  EXPECT_EQ(picture(scene.image, [&](std::size_t i) { return char('0' + scene.image.rgba8[i].r); }), "12\n");
}

TEST(Shader, DecidesTheAlphaTest) {
  SmallScene scene({4, 1});
  Draw& draw = cover(scene);
  draw.alpha_test = 0.5f;
  draw.shader = pixel_shader([](const Pixel& p) { return glm::vec4(9, 9, 9, p.x_px % 2 == 0 ? 255 : 0); });
  scene.render();
  EXPECT_EQ(ids_picture(scene.image), "A.A.\n");
}

TEST(Shader, RunsOnceForEveryVisibleSampleOfOrderFreeDraws) {
  // 100 pixels in a row: two batches of at most kMaxShadeBatch; what is hidden is not shaded.
  SmallScene scene({100, 1});
  const auto mark = [](float value) {
    return pixel_shader([value](const Pixel& p) { return glm::vec4(value, float(p.x_px), 0, 0); });
  };
  cover(scene, 0.25).shader = mark(1);
  scene.rect({10, 0}, {95, 1}, 0.5, {}).shader = mark(2);
  EXPECT_EQ(scene.render({.threads = 1, .tile_size_px = 128}).fragments_shaded, 100u);
  for (int x = 0; x < 100; ++x) {
    ASSERT_EQ(scene.image.rgba8[std::size_t(x)], glm::u8vec4(x >= 10 && x < 95 ? 2 : 1, x, 0, 0));
  }
}

TEST(LambertShader, LightsTheMaterialByTheInterpolatedNormal) {
  // Light from +z, ambient ¼. n·l = 0.6 for (0.8, 0, 0.6) of any length: 1/4 + 3/4·0.6 = 0.7; 200 · 0.7 = 140.
  // From behind: ambient alone, 50; two-sided: 140 again. Alpha is kept.
  for (const bool behind : {false, true}) {
    for (const bool two_sided : {false, true}) {
      SmallScene scene({1, 1});
      Draw& draw = cover(scene);
      draw.color = glm::vec4(200, 200, 200, 99);
      draw.normals = scene.keep(std::vector<glm::vec3>(4, glm::vec3(1.6f, 0.0f, behind ? -1.2f : 1.2f)));
      draw.shader = lambert_shader({.to_light = {0, 0, 1}, .ambient = 0.25f, .two_sided = two_sided});
      scene.render();
      const int lit = behind && !two_sided ? 50 : 140;
      EXPECT_EQ(scene.image.rgba8[0], glm::u8vec4(lit, lit, lit, 99));
    }
  }
}

}  // namespace
}  // namespace lode::raster::test

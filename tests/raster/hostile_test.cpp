// Hostile input (notes/numerics.md, stress counts): the right picture, derived here, or nothing at all.
#include <cmath>

#include "everything.h"
#include "hostile_values.h"

namespace lode::raster::test {
namespace {

constexpr glm::vec4 kRed{255, 0, 0, 255};
constexpr double kNan = std::numeric_limits<double>::quiet_NaN(), kInf = std::numeric_limits<double>::infinity();
constexpr float kNanF = std::numeric_limits<float>::quiet_NaN(), kInfF = std::numeric_limits<float>::infinity();
constexpr float kMaxF = std::numeric_limits<float>::max(), kTinyF = std::numeric_limits<float>::denorm_min();
constexpr Topology kTopologies[] = {Topology::triangles, Topology::quads, Topology::lines,  Topology::line_strip,
                                    Topology::points,    Topology::discs, Topology::surfels};

bool is_full(const Image& image) {
  return std::all_of(image.ids.begin(), image.ids.end(), [](const Ids& ids) { return ids.draw == 0; });
}
bool is_empty(const Image& image) {
  return std::all_of(image.ids.begin(), image.ids.end(), [](const Ids& ids) { return ids.draw == kNoId; });
}

// ---- NaN in a position --------------------------------------------------------------------------------------------

// One primitive beside the picture with a NaN in it, and one in the picture: the first is counted, the second drawn.
TEST(NanInAPosition, DiscardsItsPrimitiveAloneInEverySpaceTopologyVertexAndComponent) {
  for (const Topology topology : kTopologies) {
    const std::size_t n = topology == Topology::quads       ? 4
                          : topology == Topology::triangles ? 3
                          : topology == Topology::lines     ? 2
                                                            : 1;
    if (topology == Topology::line_strip) continue;  // shares its vertices: below
    for (int space = topology == Topology::surfels ? 2 : 0; space < 3; ++space) {
      for (std::size_t vertex = 0; vertex < n; ++vertex) {
        for (int component = 0; component < (space == 1 ? 4 : 3); ++component) {
          std::vector<glm::dvec4> p;  // the unit square's corners, in turn
          for (std::size_t i = 0; i < 2 * n; ++i)
            p.push_back({i % n == 1 || i % n == 2 ? 0.9 : -0.7, i % n >= 2 ? 0.9 : -0.6, 0.5, 1});
          for (std::size_t i = 0; i < n; ++i) p[i].x += 50.0;
          p[vertex][component] = kNan;
          SmallScene scene({8, 8});
          std::vector<glm::dvec3> window;
          std::vector<glm::vec3> object;
          for (const glm::dvec4& q : p) {
            window.push_back({4 * q.x + 4, 4 * q.y + 4, q.z});
            object.push_back(glm::vec3(q));
          }
          Draw& draw = space == 0   ? scene.window(topology, window)
                       : space == 1 ? scene.clip(topology, p)
                                    : scene.object(topology, object);
          draw.radii = scene.keep(std::vector<float>(p.size(), 0.5f));
          draw.normals = scene.keep(std::vector<glm::vec3>(p.size(), {0, 0, 1}));
          const FrameStats stats = scene.render();
          const std::string where = "topology " + std::to_string(int(topology)) + ", space " + std::to_string(space) +
                                    ", vertex " + std::to_string(vertex) + ", component " + std::to_string(component);
          EXPECT_GE(stats.primitives_not_finite, 1u) << where;
          EXPECT_LE(stats.primitives_not_finite, topology == Topology::quads ? 2u : 1u) << where;
          EXPECT_GT(stats.fragments_shaded, 0u) << where;
          for (const Ids& ids : scene.image.ids) ASSERT_TRUE(ids.draw == kNoId || ids.primitive == 1) << where;
        }
      }
    }
  }
}

TEST(NanInAPosition, OfALineStripDiscardsTheTwoSegmentsThatShareIt) {
  SmallScene scene({9, 1});
  scene.window(Topology::line_strip, {{0.5, 0.5, 0}, {3.5, 0.5, 0}, {kNan, 0.5, 0}, {5.5, 0.5, 0}, {8.5, 0.5, 0}});
  EXPECT_EQ(scene.render().primitives_not_finite, 2u);  // a segment's last pixel belongs to the next one
  EXPECT_EQ(ids_picture(scene.image), "AAA..AAA.\n");
}

// ---- Infinities, the largest numbers, zeros, denormals ------------------------------------------------------------

// Corners at (−L, −L), (L, −L), (0, L): seen from any picture this is everything, if L is large. All depths are ½.
TEST(HugePositions, CoverTheWholePictureAtTheRightDepth) {
  for (const double l : {1e4, 1e9, double(kMaxF), 1e200, std::numeric_limits<double>::max(), kInf}) {
    SmallScene scene({16, 8});
    scene.clip(Topology::triangles, {{-l, -l, 0.5, 1}, {l, -l, 0.5, 1}, {0, l, 0.5, 1}});
    scene.render();
    EXPECT_TRUE(is_full(scene.image)) << l;
    for (const float depth : scene.image.depth) ASSERT_EQ(depth, 0.5f) << l;
  }
  for (const float l : {1e4f, 1e9f, kMaxF, kInfF}) {
    SmallScene scene({16, 8});
    glm::dmat4 flat(1.0);  // z becomes ½
    flat[2][2] = 0.0;
    flat[3][2] = 0.5;
    scene.object(Topology::triangles, {{-l, -l, 1}, {l, -l, 1}, {0, l, 1}}, flat);
    scene.render();
    EXPECT_TRUE(is_full(scene.image)) << l;
    for (const float depth : scene.image.depth) ASSERT_EQ(depth, 0.5f) << l;
  }
}

// An edge through the middle of the picture, from far beyond it to far beyond it: what matters is its slope.
TEST(HugePositions, LeaveEdgesThroughThePictureWhereTheyAre) {
  const auto picture_with = [](double l) {
    SmallScene scene({32, 32});
    scene.clip(Topology::triangles, {{-l, -0.75 * l, 0.5, 1}, {0.875 * l, 0.65625 * l, 0.5, 1}, {l, -l, 0.5, 1}});
    scene.clip(Topology::lines, {{-l, 0.5 * l, 0.75, 1}, {l, -0.5 * l, 0.75, 1}});
    scene.render();
    return scene.image;
  };
  const Image plain = picture_with(0x1p20);
  for (std::size_t i = 0; i < 32 * 32; ++i) {  // y down; the triangle's edge rises by ¾, the line falls by ½
    const double x = double(i % 32) + 0.5 - 16.0, y = double(i / 32) + 0.5 - 16.0;
    const double below_edge = y + 0.75 * x, below_line = y - 0.5 * x;
    if (std::abs(below_edge) < 0.01 || (std::abs(below_line) > 0.45 && std::abs(below_line) < 0.55)) continue;
    const std::uint32_t expected = std::abs(below_line) < 0.5 ? 1u : below_edge > 0.0 ? 0u : kNoId;
    ASSERT_EQ(plain.ids[i].draw, expected) << x << ", " << y;
  }
  for (const int exponent : {30, 53, 64, 100, 127, 200, 300})
    EXPECT_TRUE(same_bytes(plain, picture_with(std::ldexp(1.0, exponent)))) << exponent;
}

TEST(HugePositions, OfALineAreClippedToWhereItPasses) {
  for (const double l : {1e4, double(kMaxF), kInf}) {
    SmallScene scene({6, 3});
    scene.clip(Topology::lines, {{-l, 0, 0.5, 1}, {l, 0, 0.5, 1}});
    scene.render();
    EXPECT_EQ(ids_picture(scene.image), "......\nAAAAAA\n......\n") << l;
  }
}

TEST(ZerosAndDenormals, AreNumbersLikeOthers) {
  // Every 0 of these corners may be −0 or the least number of either sign: less than any snap can see.
  const auto picture_with = [](double zero) {
    SmallScene scene({8, 8}, ColorFormat::rgba32f);
    scene.clip(Topology::triangles, {{-1, zero, 0.5, 1}, {1, zero, 0.5, 1}, {zero, 1, 0.5, 1}});
    scene.window(Topology::triangles, {{zero, zero, 0.25}, {8, zero, 0.25}, {zero, 3, 0.25}});
    scene.window(Topology::lines, {{zero, 5, 0.25}, {8, 7, 0.25}});
    scene.object(Topology::points, {{0.5f, float(zero), 0.75f}});
    scene.render();
    return scene.image;
  };
  const Image plain = picture_with(0.0);
  for (const double zero : {-0.0, 5e-324, -5e-324, double(kTinyF), -double(kTinyF)})
    EXPECT_TRUE(same_bytes(plain, picture_with(zero))) << zero;
}

// ---- w ------------------------------------------------------------------------------------------------------------

TEST(W, OfZeroAtAllVerticesIsOutside) {
  SmallScene scene({4, 4});
  scene.clip(Topology::triangles,
             {{-1, -1, 0, 0}, {1, -1, 0, 0}, {0, 1, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}});
  scene.clip(Topology::lines, {{-1, -1, 0, 0}, {1, 1, 0, 0}});
  scene.clip(Topology::points, {{0, 0, 0, 0}});
  EXPECT_EQ(scene.render().primitives_outside, 4u);
  EXPECT_TRUE(is_empty(scene.image));
}

TEST(W, NegativeAtAllVerticesIsOutside) {
  SmallScene scene({4, 4});
  scene.clip(Topology::triangles, {{-1, -1, -2, -1}, {1, -1, -2, -1}, {0, 1, -2, -1}});
  EXPECT_EQ(scene.render().primitives_outside, 1u);
  EXPECT_TRUE(is_empty(scene.image));
}

// A corner at infinity, straight up: what is seen is the strip |x| ≤ 1 above y = −1, the whole picture. Depth 0.
TEST(W, OfZeroAtOneVertexIsADirection) {
  SmallScene scene({8, 8});
  scene.clip(Topology::triangles, {{-1, -1, 0, 1}, {1, -1, 0, 1}, {0, 1, 0, 0}});
  EXPECT_EQ(scene.render().primitives_clipped, 1u);
  EXPECT_TRUE(is_full(scene.image));
}

// The third corner is the point (0, −3) seen from behind (all signs turned): the triangle runs from the picture's lower
// edge away from it, upwards and widening: all of the picture. Seen with w > 0 it would be below the picture.
TEST(W, NegativeAtOneVertexTurnsTheTriangleInsideOut) {
  SmallScene scene({8, 8});
  scene.clip(Topology::triangles, {{-1, -1, 0.25, 1}, {1, -1, 0.25, 1}, {0, 3, -0.25, -1}});
  scene.render();
  EXPECT_TRUE(is_full(scene.image));
  for (const float depth : scene.image.depth) EXPECT_EQ(depth, 0.25f);
}

TEST(W, OfAnySizeAboveTheSmallestFloatGivesTheSamePicture) {
  const auto picture_with = [](double w) {
    SmallScene scene({8, 8});
    scene.clip(Topology::triangles, {{-w, -0.5 * w, 0.25 * w, w}, {w, -w, 0.5 * w, w}, {0.25 * w, w, 0.75 * w, w}});
    scene.render();
    return scene.image;
  };
  const Image plain = picture_with(1.0);
  EXPECT_FALSE(is_empty(plain));
  for (const int exponent : {-149, -126, -20, 20, 127, 299})
    EXPECT_TRUE(same_bytes(plain, picture_with(std::ldexp(1.0, exponent)))) << exponent;
  EXPECT_TRUE(is_empty(picture_with(std::ldexp(1.0, -150))));
}

// ---- No area ------------------------------------------------------------------------------------------------------

TEST(NoArea, DrawsNothingAndIsCounted) {
  SmallScene scene({8, 8});
  scene.clip(Topology::triangles, {{0.1, 0.2, 0.5, 1},
                                   {0.1, 0.2, 0.5, 1},
                                   {0.1, 0.2, 0.5, 1},  // one point
                                   {-1, -1, 0.5, 1},
                                   {0, 0, 0.5, 1},
                                   {1, 1, 0.5, 1},  // collinear
                                   {-0.5, 0, 0.5, 1},
                                   {0.5, 0, 0.5, 1},
                                   {0, 1e-4, 0.5, 1}});  // none after the snap
  scene.window(Topology::triangles, {{1, 1, 0.5}, {5, 1.001, 0.5}, {7, 1, 0.5}});
  scene.window(Topology::lines, {{2, 2, 0.5}, {2, 2.001, 0.5}});
  scene.window(Topology::line_strip, {{2, 2, 0.5}});
  EXPECT_EQ(scene.render().primitives_empty, 5u);
  EXPECT_TRUE(is_empty(scene.image));
}

TEST(CoplanarTriangles, InOnePlaceGoToTheLowerKeyEverywhere) {
  // The same triangle twice, the second with its corners turned: equal depth at every sample, sloped as it is.
  SmallScene scene({32, 32});
  const std::vector<glm::dvec3> p = {{1.3, 2.1, 0.137}, {30.2, 7.9, 0.911}, {11.1, 29.7, 0.433}};
  scene.window(Topology::triangles, {p[0], p[1], p[2], p[1], p[2], p[0]});
  const FrameStats stats = scene.render();
  EXPECT_EQ(stats.fragments_depth_failed * 2, stats.fragments_covered);
  for (const Ids& ids : scene.image.ids) EXPECT_TRUE(ids.draw == kNoId || ids.primitive == 0);
}

// ---- Coincident layers --------------------------------------------------------------------------------------------

TEST(CoincidentLayers, GoToTheLowestKey) {
  SmallScene scene({8, 8});
  add_layers(scene, 8);
  const FrameStats stats = scene.render();
  EXPECT_EQ(stats.fragments_covered, 64 * kLayers);
  EXPECT_EQ(stats.fragments_shaded, 64u);
  EXPECT_EQ(scene.image.ids, PixelPlane<Ids>(64, Ids{0, 0}));
}

TEST(CoincidentLayers, AreAllBlended) {
  SmallScene scene({4, 2}, ColorFormat::rgba32f);
  Draw& draw = add_layers(scene, 4);
  draw.blend = Blend::add;
  draw.color = glm::vec4(0x1p-17f, 1.0f, 3.0f, 0.0f);  // sums of whole multiples below 2^24 are exact
  scene.render();
  const float n = float(kLayers);
  EXPECT_EQ(scene.image.rgba32f, PixelPlane<glm::vec4>(8, glm::vec4(n * 0x1p-17f, n, 3 * n, 0)));
}

// ---- Nothing to draw, odd targets ---------------------------------------------------------------------------------

TEST(NoPrimitives, LeaveTheClear) {
  SmallScene nothing({3, 3});
  nothing.frame.clear = kRed;
  nothing.render();
  EXPECT_EQ(nothing.image.rgba8, PixelPlane<glm::u8vec4>(9, glm::u8vec4(kRed)));
  for (const Topology topology : kTopologies) {
    SmallScene scene({3, 3});
    scene.object(topology, {});
    scene.frame.clear = kRed;
    EXPECT_EQ(scene.render().primitives_in, 0u);
    EXPECT_TRUE(is_empty(scene.image));
    EXPECT_EQ(scene.image.rgba8[4], glm::u8vec4(kRed));
  }
}

TEST(Targets, WithoutPixelsTakeAnyFrame) {
  for (const glm::ivec2 size : {glm::ivec2{0, 0}, {0, 7}, {7, 0}, {0, 20000}}) {
    for (const int threads : {1, 3}) {
      SmallScene scene(size, ColorFormat::rgba32f);
      add_everything(scene);
      EXPECT_EQ(scene.render({.threads = threads}).fragments_covered, 0u);
    }
  }
}

// Column by column or row by row a long target is like any other: a diagonal line and a rectangle at its far end.
TEST(Targets, OfOnePixelsWidthOrHeightAreDrawnToTheirEnds) {
  for (const glm::ivec2 size : {glm::ivec2{1, 16384}, {16384, 1}, {1, 32768}, {32768, 1}, {1, 1}}) {
    SmallScene scene(size);
    scene.rect(size - 1, size, 0.5, kRed);
    scene.clip(Topology::triangles, {{-1, -1, 0.25, 1}, {3, -1, 0.25, 1}, {-1, 3, 0.25, 1}});
    scene.render();
    EXPECT_EQ(scene.image.ids.back().draw, 0u);
    for (std::size_t i = 0; i + 1 < scene.image.ids.size(); ++i) ASSERT_EQ(scene.image.ids[i].draw, 1u) << i;
  }
}

TEST(Targets, WithoutAnyPlaneStillCount) {
  SmallScene scene({4, 4}, ColorFormat::rgba8, {.color = false, .depth = false, .ids = false});
  scene.rect({0, 0}, {4, 4}, 0.5, kRed);
  EXPECT_EQ(scene.render().fragments_covered, 16u);
}

// ---- Textures -----------------------------------------------------------------------------------------------------

TEST(Textures, OfAnySizeWithOrWithoutMipsStayConstantIfTheyAre) {
  for (const glm::ivec2 size : {glm::ivec2{1, 1}, {3, 7}, {1, 9}, {16, 16}}) {
    const std::vector<glm::u8vec4> texels(std::size_t(size.x * size.y), glm::u8vec4(10, 20, 30, 255));
    for (const Mips mips : {Mips::none, Mips::all}) {
      for (const Filter filter : {Filter::nearest, Filter::bilinear, Filter::trilinear, Filter::anisotropic}) {
        Texture texture = make_raw_texture(size, texels, mips);
        if (mips == Mips::all && texture.levels.size() > 2) texture.levels.pop_back();  // the chain ends early
        SmallScene scene({8, 8});
        Draw& draw = scene.rect({0, 0}, {8, 8}, 0.5, {255, 255, 255, 255});
        draw.uvs = scene.keep<glm::vec2>({{-5, 0}, {90, 3}, {70, 1000}, {-30, 90}});
        draw.texture = &texture;
        draw.sampler.filter = filter;
        scene.render();
        EXPECT_EQ(scene.image.rgba8, PixelPlane<glm::u8vec4>(64, glm::u8vec4(10, 20, 30, 255)));
      }
    }
  }
}

TEST(Textures, AreReadAtZeroWhereTheirCoordinateIsNotFinite) {
  const std::vector<glm::u8vec4> texels = {{10, 20, 30, 255}, {90, 90, 90, 255}};
  const Texture texture = make_raw_texture({2, 1}, texels, Mips::all);
  for (const float u : {kNanF, kInfF, -kInfF}) {
    SmallScene scene({4, 4});
    Draw& draw = scene.rect({0, 0}, {4, 4}, 0.5, {255, 255, 255, 255});
    draw.uvs = scene.keep(std::vector<glm::vec2>(4, {u, 0.5f}));
    draw.texture = &texture;
    draw.sampler.filter = Filter::nearest;
    scene.render();
    EXPECT_EQ(scene.image.rgba8, PixelPlane<glm::u8vec4>(16, glm::u8vec4(10, 20, 30, 255))) << u;
  }
}

// ---- Points, discs, surfels ---------------------------------------------------------------------------------------

TEST(PointsAndDiscs, OfNoSizeDrawNothingAndHugeOnesEverything) {
  for (const Topology topology : {Topology::points, Topology::discs}) {
    for (const float size : {kNanF, 0.0f, -0.0f, -1.0f, -kInfF, kTinyF, 1e-30f, 1e9f, 1e30f, kMaxF, kInfF}) {
      SmallScene scene({6, 4});
      Draw& draw = scene.window(topology, {{2.5, 1.5, 0.5}});
      draw.point_size_px = size;
      draw.radii = scene.keep<float>({size});
      EXPECT_EQ(scene.render().primitives_empty, size > 1.0f ? 0u : 1u) << size;
      EXPECT_TRUE(size > 1.0f ? is_full(scene.image) : is_empty(scene.image)) << size;
    }
  }
}

// Seen along its normal from 2 away, with the near plane at 1: radius r covers a disc of r/2 in clip space.
TEST(Surfels, OfNoSizeDrawNothingAndHugeOnesEverything) {
  for (const float radius : {kNanF, 0.0f, -1.0f, -kInfF, kTinyF, 1e30f, kMaxF, kInfF}) {
    SmallScene scene({6, 4});
    Draw& draw = scene.object(Topology::surfels, {{0, 0, -2}}, perspective(1.0));
    draw.normals = scene.keep<glm::vec3>({{0, 0, 1}});
    draw.radii = scene.keep<float>({radius});
    scene.render();
    EXPECT_TRUE(radius > 1.0f ? is_full(scene.image) : is_empty(scene.image)) << radius;
    EXPECT_EQ(scene.image.depth[0], radius > 1.0f ? 0.5f : 0.0f) << radius;
  }
}

TEST(Surfels, WithNormalsOfNoDirectionOrAcrossTheViewDrawNothing) {
  for (const glm::vec3 normal : {glm::vec3{0, 0, 0},
                                 {-0.0f, 0, -0.0f},
                                 {kNanF, 0, 1},
                                 {0, kNanF, 0},
                                 {1, 0, 0},
                                 {0, kTinyF, 0},
                                 {kMaxF, 0, 0}}) {
    SmallScene scene({6, 4});
    Draw& draw = scene.object(Topology::surfels, {{0, 0, -2}}, perspective(1.0));
    draw.normals = scene.keep<glm::vec3>({normal});
    draw.radii = scene.keep<float>({1.0f});
    scene.render();
    EXPECT_TRUE(is_empty(scene.image)) << normal.x << " " << normal.y << " " << normal.z;
  }
}

TEST(Surfels, WithNormalsOfAnyLengthAreTheSame) {
  const auto picture_with = [](float length) {
    SmallScene scene({16, 16});
    Draw& draw = scene.object(Topology::surfels, {{0.1f, 0, -2}}, perspective(1.0));
    draw.normals = scene.keep<glm::vec3>({{0, length, length}});
    draw.radii = scene.keep<float>({0.75f});
    scene.render();
    return scene.image;
  };
  const Image plain = picture_with(1.0f);
  EXPECT_FALSE(is_empty(plain));
  for (const float length : {kTinyF, 1e-38f, 0.5f, 2e30f, kMaxF, -1.0f})
    EXPECT_TRUE(same_bytes(plain, picture_with(length))) << length;
}

// ---- Matrices -----------------------------------------------------------------------------------------------------

/// Every topology through one matrix.
SmallScene through(const glm::dmat4& matrix) {
  SmallScene scene({8, 8});
  for (const Topology topology : kTopologies) {
    Draw& draw = scene.object(topology, std::vector<glm::vec3>(12, glm::vec3(0.1f, 0.2f, -2.0f)), matrix);
    std::vector<glm::vec3> positions;
    for (int i = 0; i < 12; ++i)
      positions.push_back({float(i % 3) - 1.0f, float(i % 5) * 0.4f - 0.9f, -1.0f - float(i)});
    std::get<ObjectVertices>(draw.vertices).positions = scene.keep(positions);
    draw.normals = scene.keep(std::vector<glm::vec3>(12, {0, 0.6f, 0.8f}));
    draw.radii = scene.keep(std::vector<float>(12, 0.5f));
  }
  return scene;
}

/// As a camera makes it: reversed depth, finite far plane. Degenerate cameras give Inf and NaN.
glm::dmat4 camera(double near, double far, double fov_rad) {
  const double scale = 1.0 / std::tan(0.5 * fov_rad);
  glm::dmat4 m(0.0);
  m[0][0] = m[1][1] = scale;
  m[2][2] = near / (far - near);
  m[3][2] = near * far / (far - near);
  m[2][3] = -1.0;
  return m;
}

TEST(Matrices, ThatAreNotFiniteDrawNothing) {
  for (const double value : {kNan, kInf, -kInf}) {
    glm::dmat4 all;
    for (int i = 0; i < 4; ++i) all[i] = glm::dvec4(value);
    SmallScene scene = through(all);
    scene.render();
    EXPECT_TRUE(is_empty(scene.image)) << value;
  }
}

TEST(Matrices, OfDegenerateCamerasDrawNothingOrASoundPicture) {
  const double pi = 3.14159265358979323846;
  for (const glm::dmat4& matrix :
       {camera(1, 1, 1), camera(0, 100, 1), camera(-1, 100, 1), camera(1, kInf, 1), camera(1, 100, 0),
        camera(1, 100, pi), camera(0, 0, 0), camera(100, 1, 1), glm::dmat4(0.0)}) {
    SmallScene scene = through(matrix);
    scene.render();
    expect_sound(scene.image, scene.draws.size());
  }
  // near = far divides by zero, and so does a field of view of 0: every z or x is infinite or NaN. Nothing is left.
  SmallScene flat = through(camera(1, 1, 1));
  flat.render();
  EXPECT_TRUE(is_empty(flat.image));
}

TEST(Matrices, WithoutAnInverseFlattenWhatTheyDraw) {
  for (int row = 0; row < 2; ++row) {  // everything on one line of the screen
    glm::dmat4 matrix = perspective(1.0);
    for (int column = 0; column < 4; ++column) matrix[column][row] = 0.0;
    SmallScene scene({8, 8});
    scene.object(Topology::triangles, {{-1, -1, -2}, {1, -1, -3}, {0, 1, -2}}, matrix);
    EXPECT_EQ(scene.render().primitives_empty, 1u);
    EXPECT_TRUE(is_empty(scene.image));
  }
  SmallScene zero = through(glm::dmat4(0.0));
  zero.render();
  EXPECT_TRUE(is_empty(zero.image));
}

TEST(Camera, InsideTheGeometrySeesItFromInside) {
  // A box of ±3 around the eye: every pixel is covered, at the depth 1/3 of the wall ahead.
  std::vector<glm::vec3> corners;
  for (int i = 0; i < 8; ++i) corners.push_back({i & 1 ? 3 : -3, i & 2 ? 3 : -3, i & 4 ? 3 : -3});
  SmallScene scene({8, 8});
  scene.object(Topology::quads, corners, perspective(1.0)).indices =
      scene.keep<std::uint32_t>({0, 1, 3, 2, 4, 5, 7, 6, 0, 1, 5, 4, 2, 3, 7, 6, 0, 2, 6, 4, 1, 3, 7, 5});
  scene.render();
  EXPECT_TRUE(is_full(scene.image));
  for (const float depth : scene.image.depth) EXPECT_EQ(depth, float(1.0 / 3.0));
}

// ---- All together -------------------------------------------------------------------------------------------------

TEST(HostileFrames, GiveSoundPicturesThatDoNotDependOnThreadsOrTiles) { draw_hostile_frames(1'500, 1); }

TEST(HostileAttributes, LeaveCoverageAndDepthAlone) {
  const auto picture_with = [](float value) {
    SmallScene scene({8, 8});
    Draw& draw = scene.window(Topology::triangles, {{0, 0, 0.2}, {8, 1, 0.9}, {2, 8, 0.4}});
    draw.colors = scene.keep<glm::vec4>({glm::vec4(value), {1, 2, 3, 4}, glm::vec4(-value)});
    draw.normals = scene.keep(std::vector<glm::vec3>(3, glm::vec3(value)));
    draw.uvs = scene.keep(std::vector<glm::vec2>(3, glm::vec2(value)));
    draw.shader = lambert_shader({});
    scene.render();
    return scene.image;
  };
  const Image plain = picture_with(1.0f);
  for (const float value : kHostile<float>) {
    const Image image = picture_with(value);
    EXPECT_TRUE(same_bytes(plain.depth, image.depth) && same_bytes(plain.ids, image.ids)) << value;
  }
}

TEST(HostileAttributes, StayInTheHullOfHugeVerticesInsteadOfOverflowing) {
  SmallScene scene({8, 8}, ColorFormat::rgba32f);
  Draw& draw = scene.window(Topology::triangles, {{0, 0, 0.2}, {8, 1, 0.9}, {2, 8, 0.4}});
  draw.colors = scene.keep(std::vector<glm::vec4>(3, {kMaxF, -kMaxF, kTinyF, 1e-40f}));
  scene.render();
  for (std::size_t i = 0; i < 64; ++i) {
    const glm::vec4 inside(kMaxF, -kMaxF, kTinyF, 1e-40f);
    ASSERT_EQ(scene.image.rgba32f[i], scene.image.ids[i].draw == 0 ? inside : glm::vec4(0.0f));
  }
}

}  // namespace
}  // namespace lode::raster::test

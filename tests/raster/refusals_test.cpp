// Everything `render` refuses: one clear line that names draw and element, and targets as they were.
#include <limits>

#include "raster/error.h"
#include "small_scene.h"

namespace lode::raster::test {
namespace {

constexpr glm::vec4 kRed{255, 0, 0, 255};
constexpr int kMin = std::numeric_limits<int>::min(), kMax = std::numeric_limits<int>::max();
constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// A scene with a good draw in front, so that what is broken is draw 1, and an image with something in it.
SmallScene good_scene() {
  SmallScene scene({3, 2});
  scene.rect({0, 0}, {3, 2}, 0.5, kRed);
  for (glm::u8vec4& pixel : scene.image.rgba8) pixel = {1, 2, 3, 4};
  for (float& depth : scene.image.depth) depth = 0.125f;
  for (Ids& ids : scene.image.ids) ids = {5, 6};
  return scene;
}

void expect_refused(SmallScene& scene, const char* message, const RenderOptions& options = {.threads = 1}) {
  const Image before = scene.image;
  std::vector<DrawStats> per_draw(scene.draws.size(), {77, 78});
  RenderOptions with_stats = options;
  if (with_stats.per_draw.empty()) with_stats.per_draw = per_draw;
  try {
    scene.render(with_stats);
    ADD_FAILURE() << "nothing thrown, expected: " << message;
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_input);
    EXPECT_STREQ(error.what(), message);
  }
  EXPECT_TRUE(same_bytes(scene.image, before)) << message;
  for (const DrawStats& stats : per_draw) EXPECT_EQ(stats.covered, 77u) << message;
}

TEST(Refusals, OfAnIndexOutOfRangeNameDrawAndIndex) {
  for (const std::uint32_t index : {3u, 7u, 0xFFFFFFFFu}) {
    SmallScene scene = good_scene();
    scene.window(Topology::triangles, {{0, 0, 0}, {3, 0, 0}, {0, 3, 0}}).indices =
        scene.keep<std::uint32_t>({0, 1, 2, 0, index, 1});
    const std::string message = "draw 1: index 4 is " + std::to_string(index) + ", expected below 3";
    expect_refused(scene, message.c_str());
  }
}

TEST(Refusals, OfAnIndexInADrawWithoutPositions) {
  SmallScene scene = good_scene();
  scene.window(Topology::points, {}).indices = scene.keep<std::uint32_t>({0});
  expect_refused(scene, "draw 1: index 0 is 0, expected below 0");
}

TEST(Refusals, OfVertexCountsThatMakeNoWholePrimitives) {
  struct Case {
    Topology topology;
    std::size_t n;
    const char* message;
  };
  for (const Case& c : {Case{Topology::triangles, 4, "draw 1: 4 vertices for triangles, expected a multiple of 3"},
                        {Topology::quads, 6, "draw 1: 6 vertices for quads, expected a multiple of 4"},
                        {Topology::lines, 3, "draw 1: 3 vertices for lines, expected a multiple of 2"}}) {
    for (const bool indexed : {false, true}) {
      SmallScene scene = good_scene();
      Draw& draw = scene.window(c.topology, std::vector<glm::dvec3>(indexed ? 1 : c.n));
      if (indexed) draw.indices = scene.keep(std::vector<std::uint32_t>(c.n, 0u));
      expect_refused(scene, c.message);
    }
  }
}

TEST(Refusals, OfAttributesThatAreNotOneAVertex) {
  const auto three = [](SmallScene& scene) -> Draw& {
    return scene.object(Topology::triangles, {{0, 0, 0}, {3, 0, 0}, {0, 3, 0}});
  };
  {
    SmallScene scene = good_scene();
    three(scene).colors = scene.keep(std::vector<glm::vec4>(2));
    expect_refused(scene, "draw 1: 2 colors, expected one for each of its 3 positions");
  }
  {
    SmallScene scene = good_scene();
    three(scene).normals = scene.keep(std::vector<glm::vec3>(4));
    expect_refused(scene, "draw 1: 4 normals, expected one for each of its 3 positions");
  }
  {
    SmallScene scene = good_scene();
    three(scene).uvs = scene.keep(std::vector<glm::vec2>(1));
    expect_refused(scene, "draw 1: 1 uvs, expected one for each of its 3 positions");
  }
  for (const Topology topology : {Topology::discs, Topology::surfels}) {
    SmallScene scene = good_scene();
    Draw& draw = three(scene);
    draw.topology = topology;
    draw.normals = scene.keep(std::vector<glm::vec3>(3));
    expect_refused(scene, "draw 1: 0 radii, expected one for each of its 3 positions");
  }
  SmallScene scene = good_scene();
  Draw& draw = three(scene);
  draw.topology = Topology::surfels;
  draw.radii = scene.keep(std::vector<float>(3, 1.0f));
  expect_refused(scene, "draw 1: 0 normals, expected one for each of its 3 positions");
}

TEST(Refusals, OfSurfelsOutsideObjectSpace) {
  SmallScene scene = good_scene();
  Draw& draw = scene.clip(Topology::surfels, {{0, 0, 0, 1}});
  draw.normals = scene.keep<glm::vec3>({{0, 0, 1}});
  draw.radii = scene.keep<float>({1});
  expect_refused(scene, "draw 1: surfels need object-space positions");
}

TEST(Refusals, OfWindowPositionsBeyondTheGuardBand) {
  struct Case {
    glm::dvec3 p;
    const char* message;
  };
  for (const Case& c : {Case{{32768.001, 0, 0}, "draw 1: position 2 (32768, 0) is beyond the guard band of +-32768 px"},
                        {{0, -1e300, 0}, "draw 1: position 2 (0, -1e+300) is beyond the guard band of +-32768 px"},
                        {{kInf, 0, 0}, "draw 1: position 2 (inf, 0) is beyond the guard band of +-32768 px"}}) {
    SmallScene scene = good_scene();
    scene.window(Topology::triangles, {{0, 0, 0}, {1, 1, 0}, c.p});
    expect_refused(scene, c.message);
  }
  SmallScene scene = good_scene();  // on the guard band is inside, and so is any depth
  scene.window(Topology::triangles, {{-32768, -32768, kInf}, {32768, -32768, kInf}, {0, 32768, kInf}});
  scene.render();
  EXPECT_EQ(ids_picture(scene.image), "BBB\nBBB\n");
  EXPECT_EQ(scene.image.depth[0], 1.0f);
}

TEST(Refusals, OfScissorsAndViewportsOfNegativeSize) {
  for (const glm::ivec2 size : {glm::ivec2{-1, 2}, {2, -1}, {kMin, kMin}}) {
    const std::string of_size =
        "size " + std::to_string(size.x) + " x " + std::to_string(size.y) + ", expected 0 or more";
    SmallScene draw_scissor = good_scene();
    draw_scissor.rect({0, 0}, {1, 1}, 0.5, kRed).scissor = Rect{{0, 0}, size};
    expect_refused(draw_scissor, ("draw 1: scissor " + of_size).c_str());
    SmallScene frame_scissor = good_scene();
    frame_scissor.frame.scissor = Rect{{0, 0}, size};
    expect_refused(frame_scissor, ("scissor: " + of_size).c_str());
    SmallScene viewport = good_scene();
    viewport.frame.viewport = Rect{{0, 0}, size};
    expect_refused(viewport, ("viewport: " + of_size).c_str());
  }
}

TEST(Refusals, OfViewportsTooFarOutOrTooLarge) {
  for (const Rect& rect : {Rect{{0, 0}, {65537, 1}},
                           {{0, 65537}, {1, 1}},
                           {{-65537, 0}, {1, 1}},
                           {{kMin, 0}, {1, 1}},
                           {{0, kMin}, {1, 1}},
                           {{kMax, kMax}, {kMax, kMax}}}) {
    SmallScene scene = good_scene();
    scene.frame.viewport = rect;
    const std::string message = "viewport: " + std::to_string(rect.size_px.x) + " x " + std::to_string(rect.size_px.y) +
                                " at (" + std::to_string(rect.origin_px.x) + ", " + std::to_string(rect.origin_px.y) +
                                "), expected at most 65536";
    expect_refused(scene, message.c_str());
  }
}

TEST(Refusals, OfThreadsTilesAndStatistics) {
  SmallScene scene = good_scene();
  expect_refused(scene, "-1 threads: expected 0 (all) or more", {.threads = -1});
  for (const int tile : {0, -64, 4, 7, 65, 512}) {
    const std::string message = "tile size " + std::to_string(tile) + " px: expected a power of two from 8 to 256";
    expect_refused(scene, message.c_str(), {.threads = 1, .tile_size_px = tile});
  }
  std::vector<DrawStats> two(2);
  expect_refused(scene, "2 statistics for 1 draws", {.threads = 1, .per_draw = two});
}

TEST(Refusals, OfStipplesAndAlphaTests) {
  for (const int factor : {0, -3, 257}) {
    SmallScene scene = good_scene();
    scene.window(Topology::lines, {{0, 0, 0}, {1, 1, 0}}).stipple = Stipple{0xFFFF, factor};
    const std::string message = "draw 1: stipple factor " + std::to_string(factor) + ", expected 1 to 256";
    expect_refused(scene, message.c_str());
  }
  SmallScene scene = good_scene();
  scene.rect({0, 0}, {1, 1}, 0.5, kRed).alpha_test = kNan;
  expect_refused(scene, "draw 1: the alpha test is not a number");
}

TEST(Refusals, OfImagesWhosePlanesDoNotFit) {
  {
    SmallScene scene = good_scene();
    scene.image.rgba8.resize(5);
    expect_refused(scene, "image plane rgba8: 5 elements, expected none or 6");
  }
  {
    SmallScene scene = good_scene();
    scene.image.depth.resize(7);
    expect_refused(scene, "image plane depth: 7 elements, expected none or 6");
  }
  {
    SmallScene scene = good_scene();
    scene.image.ids.resize(1);
    expect_refused(scene, "image plane ids: 1 elements, expected none or 6");
  }
  {
    SmallScene scene = good_scene();
    scene.image.rgba32f.resize(6);
    expect_refused(scene, "image: the colour plane is not of the image's format");
  }
  for (const glm::ivec2 size : {glm::ivec2{-1, 2}, {3, 32769}, {kMin, kMax}}) {
    SmallScene scene = good_scene();
    scene.image.size_px = size;
    const std::string message =
        "image size " + std::to_string(size.x) + " x " + std::to_string(size.y) + ": expected 0 to 32768 a side";
    expect_refused(scene, message.c_str());
  }
}

TEST(Refusals, OfImageSizesBeforeAnyMemoryIsAskedFor) {
  for (const glm::ivec2 size : {glm::ivec2{-1, 1}, {1, -1}, {32769, 1}, {kMax, kMax}, {kMin, kMin}}) {
    try {
      (void)make_image(size, ColorFormat::rgba8);
      ADD_FAILURE() << size.x << " x " << size.y;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::bad_input);
      EXPECT_NE(std::string(error.what()).find("expected 0 to 32768 a side"), std::string::npos);
    }
  }
}

TEST(Refusals, OfTexturesThatCannotBeRead) {
  const std::vector<glm::u8vec4> bytes(6, glm::u8vec4(255));
  const std::vector<glm::vec4> floats(6, glm::vec4(1));
  const auto textured = [](SmallScene& scene, const Texture& texture) {
    scene.rect({0, 0}, {1, 1}, 0.5, kRed);
    Draw& draw = scene.draws.back();
    draw.uvs = scene.keep(std::vector<glm::vec2>(4));
    draw.texture = &texture;
  };
  {
    SmallScene scene = good_scene();
    const Texture empty;
    textured(scene, empty);
    expect_refused(scene, "draw 1: the texture has no levels");
  }
  {
    SmallScene scene = good_scene();
    const Texture linear = make_linear_texture({3, 2}, floats, Mips::none);
    textured(scene, linear);
    expect_refused(scene, "draw 1: a linear texture cannot be drawn into an rgba8 target");
  }
  {
    SmallScene scene = good_scene();
    Texture broken = make_raw_texture({3, 2}, bytes, Mips::all);
    broken.levels[1].raw.clear();
    textured(scene, broken);
    expect_refused(scene, "draw 1: texture level 1 does not hold its 1 x 1 texels");
  }
  {
    SmallScene scene = good_scene();
    Texture broken = make_raw_texture({3, 2}, bytes, Mips::none);
    broken.levels[0].size_px = {-3, -2};
    textured(scene, broken);
    expect_refused(scene, "draw 1: texture level 0 does not hold its -3 x -2 texels");
  }
  {
    SmallScene scene = good_scene();
    Texture broken = make_raw_texture({3, 2}, bytes, Mips::none);
    broken.levels.push_back(broken.levels[0]);
    textured(scene, broken);
    expect_refused(scene, "draw 1: texture level 1 is 3 x 2, expected 1 x 1");
  }
  for (const int anisotropy : {0, -1, 17}) {
    SmallScene scene = good_scene();
    const Texture good = make_raw_texture({3, 2}, bytes, Mips::none);
    textured(scene, good);
    scene.draws.back().sampler.max_anisotropy = anisotropy;
    const std::string message = "draw 1: max_anisotropy " + std::to_string(anisotropy) + ", expected 1 to 16";
    expect_refused(scene, message.c_str());
  }
}

TEST(Refusals, OfNumbersThatAreNoValuesOfTheirEnumerations) {
  const auto broken = [](auto change) {
    SmallScene scene = good_scene();
    scene.rect({0, 0}, {1, 1}, 0.5, kRed);
    change(scene.draws.back());
    expect_refused(scene, "draw 1: topology, cull, blend, filter or wrap is none of its values");
  };
  broken([](Draw& draw) { draw.topology = Topology(7); });
  broken([](Draw& draw) { draw.cull = Cull(3); });
  broken([](Draw& draw) { draw.blend = Blend(255); });
  broken([](Draw& draw) { draw.sampler.filter = Filter(4); });
  broken([](Draw& draw) { draw.sampler.wrap_u = Wrap(4); });
  broken([](Draw& draw) { draw.sampler.wrap_v = Wrap(4); });
}

}  // namespace
}  // namespace lode::raster::test

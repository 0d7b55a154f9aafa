// What techniques are given: a world's objects and shapes, and a stage that draws, captures and shows pictures.
#include "techniques/stage.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "geometry/procedural.h"
#include "raster/error.h"
#include "techniques/plain/plain.h"
#include "tests/techniques/technique_pictures.h"

namespace lode::techniques {
namespace {

using geometry::Scene;

geometry::Material colored(const glm::vec4& color) {
  geometry::Material material;
  material.color = color;
  material.unlit = true;
  return material;
}

glm::dmat4 moved(double x, double z) { return glm::translate(glm::dmat4(1.0), glm::dvec3(x, 0.0, z)); }

/// Boxes of one mesh at x = −2, 0, 2, the middle one in front, and a ball behind them.
Scene boxes_and_ball() {
  Scene scene;
  const geometry::Mesh box = geometry::box(glm::dvec3(-0.5), glm::dvec3(0.5));
  geometry::add_instance(scene, box, colored({1, 0, 0, 1}), moved(-2, 0));
  for (const glm::dmat4& place : {moved(0, 2), moved(2, 0)}) {
    scene.nodes.push_back({.name = {}, .parent = {}, .parent_from_node = place, .world_from_node = place});
    scene.instances.push_back({.mesh = 0, .node = std::uint32_t(scene.nodes.size() - 1), .world_from_object = place});
  }
  geometry::add_instance(scene, geometry::sphere(glm::dvec3(0.0), 1.0, 16, 8), colored({0, 0, 1, 1}), moved(0, -4));
  return scene;
}

View front_view() {
  View view{.camera = {}, .size_px = {96, 64}};
  geometry::look_at(view.camera, {0.0, 0.5, 9.0}, {0.0, 0.0, 0.0});
  return view;
}

raster::Image picture_of(Stage& stage, const View& view) {
  raster::Image image = raster::make_image(view.size_px, raster::ColorFormat::rgba32f);
  raster::render({.draws = stage.draws(), .clear = glm::vec4(0.0f), .viewport = {}, .scissor = {}}, image);
  return image;
}

TEST(World, HasAnObjectForEachNodeAndAShapeForEachKind) {
  const Scene scene = boxes_and_ball();
  const World world(scene, {}, false);
  ASSERT_EQ(world.objects().size(), 4u);
  EXPECT_EQ(world.n_shapes(), 2u);  // the three boxes are one
  EXPECT_EQ(world.objects()[1].shape, world.objects()[0].shape);
  EXPECT_EQ(world.objects()[1].bounds.low, glm::dvec3(-0.5, -0.5, 1.5));
  EXPECT_EQ(world.objects()[3].n_primitives, 2u * 16u * 7u);
  EXPECT_EQ(world.object_of(2), 2u);
  EXPECT_TRUE(world.shape(0).hides);
  EXPECT_EQ(world.shape(0).indices.size(), 36u);
}

TEST(World, OfPartsInOnePlaceHasShapesToTheLastBit) {
  Scene scene;
  const glm::dmat4 place = glm::rotate(moved(1.1, 2.3), 0.7, glm::dvec3(0.0, 1.0, 0.0));
  geometry::add_instance(scene, geometry::box(glm::dvec3(-0.3), glm::dvec3(0.7)), {}, place);
  geometry::add_instance(scene, geometry::sphere(glm::dvec3(0.1), 0.3, 8, 4), {}, place);
  scene.instances[1].node = 0;
  scene.objects = {{"both", 0, 2}};
  const World exact(scene, {}, false);
  EXPECT_TRUE(exact.shape(0).exact);
  EXPECT_EQ(exact.shape(0).positions.back(), scene.meshes[1].positions.back());
  scene.instances[1].world_from_object = moved(0.1, 0.0) * place;
  EXPECT_FALSE(World(scene, {}, false).shape(0).exact);
}

TEST(World, FindsThingsOutOnce) {
  const Scene scene = boxes_and_ball();
  const World world(scene, {}, false);
  int n_made = 0;
  const auto make = [&] { return std::vector<int>{++n_made}; };
  const auto first = world.once<std::vector<int>>("a", make), again = world.once<std::vector<int>>("a", make);
  EXPECT_EQ(first, again);
  EXPECT_EQ(world.once<std::vector<int>>("b", make)->at(0), 2);
}

TEST(Stage, PictureOfEverythingIsThatOfTheSceneInWhateverOrder) {
  const Scene scene = boxes_and_ball();
  const World world(scene, {}, false);
  const View view = front_view();
  raster::Image whole = raster::make_image(view.size_px, raster::ColorFormat::rgba32f);
  const auto draws = world.draws().draws(view.camera, view.size_px);
  raster::render({.draws = draws, .clear = glm::vec4(0.0f), .viewport = {}, .scissor = {}}, whole);
  Stage stage(world);
  stage.begin(view);
  for (const ObjectId id : {3u, 1u, 0u, 2u, 1u}) stage.object(id);
  const raster::Image image = picture_of(stage, view);
  EXPECT_EQ(image.ids, whole.ids);
  EXPECT_EQ(image.rgba32f, whole.rgba32f);
  EXPECT_EQ(stage.work().objects, 4u);  // one was named twice
  EXPECT_EQ(stage.work().primitives, 3u * 12u + 224u);
  stage.begin(view);
  EXPECT_TRUE(stage.draws().empty());
}

/// A plate that faces the camera of its picture and stands where the object does shows what the object would.
TEST(Stage, PlateShowsWhatWasCapturedAndCarriesTheObjectsId) {
  const Scene scene = boxes_and_ball();
  const World world(scene, {}, false);
  const View view = front_view();
  Stage stage(world);
  stage.begin(view);
  geometry::Camera camera;
  camera.projection = geometry::Projection::orthographic;
  camera.height = 3.0, camera.near = 0.1, camera.far = 10.0;
  geometry::look_at(camera, {0.0, 0.0, 0.0}, {0.0, 0.0, -4.0});
  const ObjectId ball = 3;
  const PictureId picture = stage.capture({&ball, 1}, camera, {64, 64});
  EXPECT_EQ(stage.work().captured_px, 64u * 64u);
  EXPECT_EQ(stage.picture(picture).depth[0], 0.0f);             // beside the ball
  EXPECT_GT(stage.picture(picture).depth[32 * 64 + 32], 0.0f);  // in its middle
  const auto corner = [](double x, double y) { return glm::dvec3(1.5 * x, 1.5 * y, -4.0); };
  stage.plate(ball, picture, {corner(-1, 1), corner(-1, -1), corner(1, -1), corner(1, 1)}, PlateEdge::cutout);
  const raster::Image image = picture_of(stage, view);
  const std::size_t middle = 34 * 96 + 48;
  EXPECT_EQ(image.ids[middle].draw, 3u);
  EXPECT_EQ(image.ids[middle].primitive, kStandInPrimitive);
  EXPECT_EQ(image.rgba32f[middle], glm::vec4(0, 0, 1, 1));
  EXPECT_EQ(image.ids[0].draw, raster::kNoId);  // the plate's corners are cut out
}

/// Draws everything from copies of its own meshes.
struct Copies {
  std::vector<AlternateMesh> meshes;  ///< [the scene's]
  [[nodiscard]] static Promise promise() { return Promise::exact; }
  void prepare(Stage& stage) {
    const Scene& scene = stage.world().scene();
    for (std::uint32_t k = 0; k < scene.meshes.size(); ++k) {
      meshes.push_back(stage.world().draws().alternate(k, scene.meshes[k]));
    }
  }
  void cut() {}
  Counters draw(const View&, Stage& stage) {
    for (ObjectId id = 0; id < stage.world().objects().size(); ++id) {
      const WorldObject& object = stage.world().objects()[id];
      std::vector<const AlternateMesh*> shown;
      for (std::uint32_t i = object.first_instance; i < object.first_instance + object.n_instances; ++i) {
        shown.push_back(&meshes[stage.world().scene().instances[i].mesh]);
      }
      stage.stand_in(id, shown);
    }
    return {};
  }
};

/// Whatever the material, the shading and the pipeline: meshes of every alpha mode, mirrored, without normals, with
/// vertex colours.
TEST(Stage, CopiesOfMeshesInTheirPlaceLookTheSame) {
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    Scene scene = tests::random_scene(seed, 30);
    for (std::size_t k = 0; k < scene.meshes.size(); ++k) {
      geometry::Mesh& mesh = scene.meshes[k];
      if (k % 3 == 0) mesh.normals.clear();
      for (std::size_t i = 0; k % 4 == 0 && i < mesh.positions.size(); ++i) {
        mesh.colors.emplace_back(0.1f * float(i % 10), 0.5f, 1.0f, i % 2 == 0 ? 0.25f : 1.0f);
      }
    }
    for (const ColorSpace space : {ColorSpace::srgb, ColorSpace::raw}) {
      const World world(scene, {Shading::material, space}, seed % 2 == 0, 1);
      tests::Showing copies(world, Copies{});
      tests::Showing plain(world, Plain{});
      const View view = tests::random_view(seed, 0);
      tests::TechniquePicture picture = copies.picture(view), expected = plain.picture(view);
      std::size_t n_drawn = 0;
      for (raster::Ids& ids : picture.image.ids) {
        if (ids.draw == raster::kNoId) continue;
        EXPECT_EQ(ids.primitive, kStandInPrimitive);
        ids.primitive = 0, ++n_drawn;
      }
      for (raster::Ids& ids : expected.image.ids) {
        if (ids.draw != raster::kNoId) ids.primitive = 0;
      }
      EXPECT_GT(n_drawn, 0u);
      EXPECT_EQ(tests::difference_from_plain(picture, expected), "") << "scene " << seed;
    }
  }
}

TEST(Stage, CountsWhatStandsInAndDrawsTheRestAsItIs) {
  Scene scene = boxes_and_ball();
  scene.objects = {{"boxes", 0, 3}, {"ball", 3, 1}};
  const World world(scene, {}, false);
  geometry::Mesh half = scene.meshes[0];
  half.indices.resize(18);
  const AlternateMesh alternate = world.draws().alternate(0, half);
  Stage stage(world);
  stage.begin(front_view());
  stage.stand_in(0, std::vector<const AlternateMesh*>{nullptr, &alternate, nullptr});
  stage.stand_in(1, std::vector<const AlternateMesh*>{nullptr});  // the ball itself
  EXPECT_EQ(stage.work().stand_ins, 1u);
  EXPECT_EQ(stage.work().stand_in_primitives, 12u + 6u + 12u);
  EXPECT_EQ(stage.work().objects, 1u);
  EXPECT_FALSE(stage.drawn(0));
  EXPECT_TRUE(stage.drawn(1));
  ASSERT_EQ(stage.draws().size(), 4u);
  for (std::uint32_t k = 0; k < 4; ++k) {
    EXPECT_EQ(stage.draws()[k].draw_id, k);
    EXPECT_EQ(stage.draws()[k].primitive_id.has_value(), k == 1);
  }
}

TEST(Stage, RefusesMeshesThatCannotStandIn) {
  Scene scene = boxes_and_ball();
  scene.pictures.push_back({.name = "texel", .size_px = {1, 1}, .texels = {glm::u8vec4(255)}, .has_alpha = false});
  scene.materials[1].color_texture = geometry::TextureUse{};
  const World world(scene, {}, false);
  const SceneDraws& draws = world.draws();
  const geometry::Mesh& box = scene.meshes[0];
  const AlternateMesh alternate = draws.alternate(0, box);
  Stage stage(world);
  stage.begin(front_view());
  const std::vector<const AlternateMesh*> one = {&alternate}, two = {&alternate, &alternate};
  EXPECT_THROW(stage.stand_in(0, two), raster::Error);  // one instance
  EXPECT_THROW(stage.stand_in(3, one), raster::Error);  // another mesh
  EXPECT_TRUE(stage.draws().empty());
  const auto refuses = [&](std::uint32_t of, const auto& change) {
    geometry::Mesh mesh = box;
    change(mesh);
    EXPECT_THROW(static_cast<void>(draws.alternate(of, mesh)), raster::Error);
  };
  refuses(0, [](geometry::Mesh& mesh) { mesh.kind = geometry::MeshKind::points; });
  refuses(0, [](geometry::Mesh& mesh) { mesh.indices[0] = std::uint32_t(mesh.positions.size()); });
  refuses(0, [](geometry::Mesh& mesh) { mesh.indices.pop_back(); });
  refuses(0, [](geometry::Mesh& mesh) { mesh.normals.pop_back(); });
  refuses(1, [](geometry::Mesh& mesh) { mesh.uvs.clear(); });
}

/// The shader makes the plate's lower half transparent, and red what is left in it, by uv.
TEST(Stage, ShadedPlateHasWhatItsShaderMakesOfUvAndTheObjectsId) {
  const Scene scene = boxes_and_ball();
  const World world(scene, {}, false);
  View view{.camera = {}, .size_px = {8, 8}};
  view.camera.projection = geometry::Projection::orthographic;
  view.camera.height = 8.0, view.camera.near = 0.0, view.camera.far = 10.0;
  Stage stage(world);
  stage.begin(view);
  const auto shade = [](const raster::Pixel& p) {
    return p.uv.y < 0.5f ? glm::vec4(p.uv.x < 0.5f ? 1.0f : 0.0f, 0.0f, 0.0f, 1.0f) : glm::vec4(0.25f);
  };
  const auto corner = [](double x, double y) { return glm::dvec3(x, y, -5.0); };
  stage.plate(3, {corner(-2, 2), corner(-2, -2), corner(2, -2), corner(2, 2)}, raster::pixel_shader(shade));
  const raster::Image image = picture_of(stage, view);
  EXPECT_EQ(stage.work().plates, 1u);
  std::string picture;
  for (std::size_t i = 0; i < 64; ++i) {
    const raster::Ids& ids = image.ids[i];
    EXPECT_TRUE(ids.draw == raster::kNoId || ids == (raster::Ids{3, kStandInPrimitive}));
    picture += ids.draw == raster::kNoId ? '.' : (image.rgba32f[i].r > 0.5f ? 'r' : 'b');
    if (i % 8 == 7) picture += '\n';
  }
  EXPECT_EQ(picture,
            "........\n"
            "........\n"
            "..rrbb..\n"
            "..rrbb..\n"
            "........\n"
            "........\n"
            "........\n"
            "........\n");
}

TEST(Stage, KeepsAReleasedPictureUntilTheNextFrame) {
  const Scene scene = boxes_and_ball();
  const World world(scene, {}, false);
  Stage stage(world);
  stage.begin(front_view());
  const ObjectId box = 0;
  const PictureId picture = stage.capture({&box, 1}, front_view().camera, {8, 4});
  // Colour of 8 × 4, 4 × 2, 2 × 1 and 1 × 1 texels of 16 bytes, and depth of the first.
  EXPECT_EQ(stage.picture_bytes(), (32u + 8u + 2u + 1u) * 16u + 32u * 4u);
  stage.plate(box, picture, {glm::dvec3(0, 1, 0), glm::dvec3(0), glm::dvec3(1, 0, 0), glm::dvec3(1, 1, 0)},
              PlateEdge::blended);
  stage.release(picture);
  EXPECT_EQ(stage.picture_bytes(), 0u);
  EXPECT_EQ(stage.draws().size(), 1u);
  EXPECT_NO_THROW(picture_of(stage, front_view()));
  EXPECT_THROW(stage.plate(box, picture, {}, PlateEdge::cutout), raster::Error);
}

TEST(Stage, CapturesLinearColoursOnly) {
  const Scene scene = boxes_and_ball();
  const World world(scene, {.shading = Shading::material, .color_space = ColorSpace::raw}, false);
  Stage stage(world);
  const ObjectId box = 0;
  EXPECT_THROW(static_cast<void>(stage.capture({&box, 1}, front_view().camera, {8, 8})), raster::Error);
}

TEST(Stage, AddsUpTheTimesOfAPart) {
  const Scene scene = boxes_and_ball();
  const World world(scene, {}, false);
  Stage stage(world);
  stage.begin(front_view());
  for (int k = 0; k < 2; ++k) const auto timer = stage.time("test");
  ASSERT_EQ(stage.times().size(), 1u);
  EXPECT_EQ(stage.times()[0].part, "test");
  EXPECT_GE(stage.times()[0].ms, 0.0);
}

}  // namespace
}  // namespace lode::techniques

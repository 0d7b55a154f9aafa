/// Nodes, cameras, materials and pictures of glTF files.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "tests/geometry/gltf_builder.h"
#include "tests/geometry/model_reading.h"
#include "tests/geometry/png_bytes.h"

namespace lode::geometry {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;
using tests::base64;
using tests::GltfBuilder;
using tests::model_error;
using tests::read_model;

Scene read(const GltfBuilder& file) { return read_model("a.gltf", file.gltf()); }
std::string error(const GltfBuilder& file) { return model_error("a.gltf", file.gltf()); }

std::string red_png() {
  const std::array<int, 4> texels[] = {{255, 0, 0, 255}, {0, 0, 0, 0}};
  return tests::rgba_png(2, 1, texels);
}
std::string data_uri(const std::string& png) { return "data:image/png;base64," + base64(png); }

/// A file of nodes without anything at them; "children" and whatever else a test wants.
GltfBuilder nodes(const json& list, const json& roots) {
  GltfBuilder file;
  file.json["nodes"] = list;
  file.json["scenes"] = {{{"nodes", roots}}};
  return file;
}

std::vector<std::string> names(const Scene& scene) {
  std::vector<std::string> list;
  for (const Node& node : scene.nodes) list.push_back(node.name);
  return list;
}

TEST(GltfNodes, ComeDepthFirstInDocumentOrder) {
  const json list = {{{"name", "c"}, {"children", {3, 1}}},
                     {{"name", "e"}},
                     {{"name", "b"}, {"children", {0}}},
                     {{"name", "d"}},
                     {{"name", "a"}},
                     {{"name", "not in the scene"}}};
  const Scene scene = read(nodes(list, {4, 2}));
  EXPECT_THAT(names(scene), ElementsAre("a", "b", "c", "d", "e"));
  EXPECT_EQ(scene.nodes[4].parent, 2u);
}

TEST(GltfNodes, TransformsMultiplyFromTheRoot) {
  // Parent: turned by 90° about z and moved; child: scaled, then moved in the parent's frame.
  // The child's point (1, 0, 0) -> (2, 0, 0) -> (7, 0, 0) in the parent -> (0, 7, 0) -> (10, 7, 0) in the world.
  const double h = std::sqrt(0.5);
  const json list = {{{"translation", {10, 0, 0}}, {"rotation", {0, 0, h, h}}, {"children", {1}}},
                     {{"translation", {5, 0, 0}}, {"scale", {2, 2, 2}}}};
  const Scene scene = read(nodes(list, {0}));
  const glm::dvec4 p = scene.nodes.at(1).world_from_node * glm::dvec4(1, 0, 0, 1);
  EXPECT_NEAR(p.x, 10.0, 1e-14);
  EXPECT_NEAR(p.y, 7.0, 1e-14);
  EXPECT_EQ(p.z, 0.0);
  EXPECT_EQ(scene.nodes[1].parent, 0u);
  EXPECT_EQ(scene.nodes[0].parent, std::nullopt);
}

TEST(GltfNodes, MatricesAreColumnByColumnInDouble) {
  const json list = {{{"matrix", {1, 2, 3, 0, 4, 5, 6, 0, 7, 8, 9, 0, 0.1, 11, 12, 1}}}};
  const glm::dmat4 m = read(nodes(list, {0})).nodes.at(0).parent_from_node;
  EXPECT_EQ(m[0], glm::dvec4(1, 2, 3, 0));
  EXPECT_EQ(m[3], glm::dvec4(0.1, 11, 12, 1));
}

TEST(GltfNodes, TheDefaultSceneIsReadElseTheFirstElseAllRoots) {
  GltfBuilder file;
  file.json["nodes"] = {{{"name", "a"}, {"children", {2}}}, {{"name", "b"}}, {{"name", "c"}}};
  file.json["scenes"] = {{{"nodes", {0}}}, {{"nodes", {1}}}};
  file.json["scene"] = 1;
  EXPECT_THAT(names(read(file)), ElementsAre("b"));
  file.json.erase("scene");
  EXPECT_THAT(names(read(file)), ElementsAre("a", "c"));
  file.json.erase("scenes");
  EXPECT_THAT(names(read(file)), ElementsAre("a", "c", "b"));
}

TEST(GltfNodes, InstancesOfOneMeshShareItAndAreDrawsOfTheirOwn) {
  GltfBuilder file;
  file.primitive({{"POSITION", file.floats("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0})}});
  file.json["meshes"][0]["primitives"].push_back(file.json["meshes"][0]["primitives"][0]);
  file.json["nodes"].push_back({{"mesh", 0}, {"translation", {0, 0, 5}}});
  file.json["scenes"][0]["nodes"] = {1, 0};
  const Scene scene = read(file);
  EXPECT_EQ(scene.meshes.size(), 2u);
  ASSERT_EQ(scene.instances.size(), 4u);
  for (std::uint32_t i = 0; i < 4; ++i) EXPECT_EQ(scene.instances[i].mesh, i % 2);
  EXPECT_EQ(scene.instances[1].world_from_object[3].z, 5.0);
  EXPECT_EQ(scene.instances[2].world_from_object[3].z, 0.0);
}

TEST(GltfNodes, ADeepChainIsFollowedWithoutRecursion) {
  json list = json::array();
  for (int i = 0; i < 20000; ++i) list.push_back({{"translation", {1, 0, 0}}, {"children", {i + 1}}});
  list.push_back(json::object());
  const Scene scene = read(nodes(list, {0}));
  EXPECT_EQ(scene.nodes.back().world_from_node[3].x, 20000.0);
}

TEST(GltfNodeErrors, GraphsThatAreNoTreesAreNamed) {
  const auto graph = [](const json& list, const json& roots) { return error(nodes(list, roots)); };
  EXPECT_EQ(graph({{{"children", {1}}}, {{"children", {0}}}}, {0}),
            "nodes[0]: is its own ancestor: expected nodes without cycles");
  EXPECT_EQ(graph({{{"children", {0}}}}, json::array()),
            "nodes[0]: is its own ancestor: expected nodes without cycles");
  EXPECT_EQ(graph({{{"children", {2}}}, {{"children", {2}}}, json::object()}, {0}),
            "nodes[1].children[0]: node 2 is already a child of node 0: expected one parent for each node");
  EXPECT_EQ(graph({{{"children", {1, 1}}}, json::object()}, {0}),
            "nodes[0].children[1]: node 1 is already a child of node 0: expected one parent for each node");
  EXPECT_EQ(graph({{{"children", {1}}}, json::object()}, {1}),
            "scenes[0].nodes[0]: node 1 is a child of node 0: expected a node without a parent");
  EXPECT_EQ(graph(json::array({json::object()}), {0, 0}), "scenes[0].nodes[1]: node 0 is listed twice");
  EXPECT_EQ(graph({{{"children", {7}}}}, {0}),
            "nodes[0].children[0]: expected an index of one of the 1 nodes, found 7");
}

TEST(GltfNodeErrors, TransformsThatAreNoneAreNamed) {
  const auto node = [](const json& n) { return error(nodes(json::array({n}), {0})); };
  EXPECT_EQ(node({{"rotation", {0, 0, 0, 0}}}), "nodes[0].rotation: expected a unit quaternion, found [0,0,0,0]");
  EXPECT_EQ(node({{"scale", {1, 2}}}), "nodes[0].scale: expected [x, y, z], found [1,2]");
  EXPECT_EQ(node({{"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}, {"scale", {1, 1, 1}}}),
            "nodes[0]: has both \"matrix\" and a translation, rotation or scale");
  EXPECT_EQ(node({{"matrix", {1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}}),
            "nodes[0].matrix: expected a last row of 0 0 0 1");
  EXPECT_EQ(error(nodes({{{"scale", {1e300, 1, 1}}, {"children", {1}}}, {{"scale", {1e300, 1, 1}}}}, {0})),
            "nodes[1]: its place in the world is not finite");
}

TEST(GltfNodeErrors, MoreNodesThanMemoryAllowsAreRefused) {
  // Three bytes a node in the file, hundreds in memory.
  std::string text = R"({"asset": {"version": "2.0"}, "nodes": [{})";
  for (int i = 0; i < 1500000; ++i) text += ",{}";
  EXPECT_THAT(model_error("a.gltf", text + "]}"), HasSubstr("nodes: claims "));
}

TEST(GltfCameras, StandWhereTheirNodesDoWithoutScale) {
  // Turned by 180° about y, and stretched: looks along +z, its right is −x.
  GltfBuilder file = nodes(
      {{{"name", "eye"}, {"camera", 0}, {"translation", {1, 2, 3}}, {"rotation", {0, 1, 0, 0}}, {"scale", {3, 5, 7}}}},
      {0});
  file.json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1.5707963267948966}, {"znear", 0.5}}}}};
  const Scene scene = read(file);
  ASSERT_EQ(scene.cameras.size(), 1u);
  const Camera& c = scene.cameras[0].camera;
  EXPECT_EQ(scene.cameras[0].name, "eye");
  EXPECT_EQ(c.eye, glm::dvec3(1, 2, 3));
  EXPECT_EQ(c.back, glm::dvec3(0, 0, -1));
  EXPECT_EQ(c.up, glm::dvec3(0, 1, 0));
  EXPECT_EQ(c.right, glm::dvec3(-1, 0, 0));
  EXPECT_EQ(c.projection, Projection::perspective);
  EXPECT_NEAR(c.tan_half_fov_y, 1.0, 1e-15);
  EXPECT_EQ(c.near, 0.5);
  EXPECT_TRUE(std::isinf(c.far));
}

TEST(GltfCameras, OrthographicOnesSeeTwiceTheirMagnification) {
  GltfBuilder file = nodes({{{"camera", 0}}}, {0});
  file.json["cameras"] = {{{"name", "plan"},
                           {"type", "orthographic"},
                           {"orthographic", {{"xmag", 9}, {"ymag", 2.5}, {"znear", 0}, {"zfar", 10}}}}};
  const SceneCamera camera = read(file).cameras.at(0);
  EXPECT_EQ(camera.name, "plan");
  EXPECT_EQ(camera.camera.projection, Projection::orthographic);
  EXPECT_EQ(camera.camera.height, 5.0);
  EXPECT_EQ(camera.camera.near, 0.0);
  EXPECT_EQ(camera.camera.far, 10.0);
}

TEST(GltfCameraErrors, RangesAreChecked) {
  const auto camera = [](const json& perspective, const json& node) {
    GltfBuilder file = nodes(json::array({node}), {0});
    file.json["cameras"] = {{{"type", "perspective"}, {"perspective", perspective}}};
    return error(file);
  };
  EXPECT_THAT(camera({{"yfov", 1}, {"znear", 0}}, {{"camera", 0}}),
              HasSubstr("cameras[0].perspective.znear: expected"));
  EXPECT_THAT(camera({{"yfov", 0}, {"znear", 1}}, {{"camera", 0}}),
              HasSubstr("yfov: expected an angle between 0 and pi"));
  EXPECT_THAT(camera({{"yfov", 1}, {"znear", 1}, {"zfar", 1}}, {{"camera", 0}}),
              HasSubstr("zfar: expected more than znear"));
  EXPECT_EQ(camera({{"yfov", 1}, {"znear", 1}}, {{"camera", 0}, {"scale", {1, 1, 0}}}),
            "nodes[0].camera: a camera at a node that is flat: expected a scale without zeros");
}

/// A triangle with one material of a texture.
GltfBuilder textured(const json& base_color_texture = {{"index", 0}}) {
  GltfBuilder file;
  auto& primitive = file.primitive({{"POSITION", file.floats("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0})}});
  primitive["attributes"]["TEXCOORD_0"] = file.floats("VEC2", {0, 0, 1, 0, 0.25f, 0.5f});
  primitive["attributes"]["TEXCOORD_1"] = file.floats("VEC2", {5, 5, 6, 6, 7, 7});
  primitive["material"] = 0;
  file.json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", base_color_texture}}}}};
  file.json["textures"] = {{{"source", 0}}};
  file.json["images"] = {{{"uri", data_uri(red_png())}}};
  return file;
}

TEST(GltfMaterials, ValuesAreRead) {
  GltfBuilder file;
  file.json["materials"] = {json::object(),
                            {{"name", "m"},
                             {"pbrMetallicRoughness", {{"baseColorFactor", {0.1, 0.2, 0.3, 0.4}}}},
                             {"alphaMode", "MASK"},
                             {"alphaCutoff", 0.1},
                             {"doubleSided", true},
                             {"extensions", {{"KHR_materials_unlit", json::object()}}}},
                            {{"alphaMode", "BLEND"}}};
  const Scene scene = read(file);
  ASSERT_EQ(scene.materials.size(), 3u);
  const Material &plain = scene.materials[0], &full = scene.materials[1];
  EXPECT_EQ(plain.color, glm::vec4(1.0f));
  EXPECT_EQ(plain.alpha_mode, AlphaMode::opaque);
  EXPECT_EQ(plain.alpha_cutoff, 0.5);
  EXPECT_FALSE(plain.double_sided || plain.unlit || plain.color_texture);
  EXPECT_EQ(full.name, "m");
  EXPECT_EQ(full.color, glm::vec4(0.1f, 0.2f, 0.3f, 0.4f));
  EXPECT_EQ(full.alpha_mode, AlphaMode::mask);
  EXPECT_EQ(full.alpha_cutoff, 0.1);  // in double, as it is written
  EXPECT_TRUE(full.double_sided && full.unlit);
  EXPECT_EQ(scene.materials[2].alpha_mode, AlphaMode::blend);
}

TEST(GltfMaterials, DiffuseOfTheOlderModelIsTheBaseColour) {
  GltfBuilder file = textured();
  file.json["materials"][0] = {{"pbrMetallicRoughness", {{"baseColorFactor", {1, 0, 0, 1}}}},
                               {"extensions",
                                {{"KHR_materials_pbrSpecularGlossiness",
                                  {{"diffuseFactor", {0, 1, 0, 0.5}}, {"diffuseTexture", {{"index", 0}}}}}}}};
  const Scene scene = read(file);
  EXPECT_EQ(scene.materials[0].color, glm::vec4(0, 1, 0, 0.5f));
  EXPECT_TRUE(scene.materials[0].color_texture);
  EXPECT_EQ(scene.meshes[0].uvs.size(), 3u);
}

TEST(GltfTextures, PicturesComeFromDataFilesAndBufferViews) {
  const std::vector<glm::u8vec4> texels = {{255, 0, 0, 255}, {0, 0, 0, 0}};
  EXPECT_EQ(read(textured()).pictures.at(0).texels, texels);

  GltfBuilder in_buffer = textured();
  in_buffer.json["images"][0] = {{"bufferView", in_buffer.view(red_png())}, {"mimeType", "image/png"}};
  EXPECT_EQ(read(in_buffer).pictures.at(0).texels, texels);
  EXPECT_EQ(read_model("a.glb", in_buffer.glb()).pictures.at(0).texels, texels);

  GltfBuilder in_file = textured();
  in_file.json["images"][0]["uri"] = "the%20pictures/r%C3%A9d.png";
  const tests::TemporaryFolder folder;
  folder.write(
      "the pictures/r\xC3\xA9"
      "d.png",
      red_png());
  const Scene scene = read_model_file(folder.write("a.gltf", in_file.gltf()));
  EXPECT_EQ(scene.pictures.at(0).texels, texels);
  EXPECT_EQ(scene.pictures[0].name, folder.path("the pictures/r\xC3\xA9"
                                                "d.png"));
}

TEST(GltfTextures, OneImageIsOnePictureHoweverOftenItIsUsed) {
  GltfBuilder file = textured();
  file.json["textures"].push_back({{"source", 0}, {"sampler", 0}});
  file.json["samplers"] = {{{"wrapS", 33071}}};
  file.json["materials"].push_back({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 1}}}}}});
  const Scene scene = read(file);
  EXPECT_EQ(scene.pictures.size(), 1u);
  EXPECT_EQ(scene.materials[1].color_texture->wrap_u, TextureWrap::clamp);
}

TEST(GltfTextures, SamplersBecomeWrapsAndOneFilter) {
  const auto use = [](const json& sampler) {
    GltfBuilder file = textured();
    file.json["textures"][0]["sampler"] = 0;
    file.json["samplers"] = json::array({sampler});
    return *read(file).materials[0].color_texture;
  };
  EXPECT_EQ(*read(textured()).materials[0].color_texture, TextureUse{});  // trilinear, repeat
  EXPECT_EQ(use({{"wrapS", 33648}, {"wrapT", 33071}}),
            (TextureUse{.wrap_u = TextureWrap::mirror, .wrap_v = TextureWrap::clamp}));
  const auto filter = [&](const json& sampler) { return use(sampler).filter; };
  EXPECT_EQ(filter({{"magFilter", 9728}}), TextureFilter::nearest);
  EXPECT_EQ(filter({{"magFilter", 9728}, {"minFilter", 9987}}), TextureFilter::nearest);
  EXPECT_EQ(filter({{"magFilter", 9729}}), TextureFilter::trilinear);
  EXPECT_EQ(filter({{"minFilter", 9728}}), TextureFilter::nearest);
  EXPECT_EQ(filter({{"minFilter", 9729}}), TextureFilter::bilinear);
  EXPECT_EQ(filter({{"minFilter", 9984}}), TextureFilter::nearest);
  EXPECT_EQ(filter({{"minFilter", 9985}}), TextureFilter::trilinear);
  EXPECT_EQ(filter({{"minFilter", 9986}}), TextureFilter::trilinear);
  EXPECT_EQ(filter({{"magFilter", 9729}, {"minFilter", 9987}}), TextureFilter::trilinear);
}

TEST(GltfTextures, CoordinatesAreOfTheSetThatTheTextureNames) {
  EXPECT_THAT(read(textured()).meshes[0].uvs, ElementsAre(glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(0.25f, 0.5f)));
  EXPECT_THAT(read(textured({{"index", 0}, {"texCoord", 1}})).meshes[0].uvs,
              ElementsAre(glm::vec2(5), glm::vec2(6), glm::vec2(7)));
}

TEST(GltfTextures, TransformsAreAppliedToTheCoordinates) {
  const auto uvs = [](const json& transform) {
    return read(textured({{"index", 0}, {"extensions", {{"KHR_texture_transform", transform}}}})).meshes[0].uvs;
  };
  EXPECT_THAT(uvs({{"offset", {0, 1}}, {"scale", {1, -1}}}),
              ElementsAre(glm::vec2(0, 1), glm::vec2(1, 1), glm::vec2(0.25f, 0.5f)));
  // The extension's own example: the lower left quarter of the picture, turned clockwise. Turned counter-clockwise by
  // 90° where v points down, (1, 0) goes to (0, −1) and (0, 1) to (1, 0); halved and moved by (0, 1):
  // (0,0) -> (0, 1), (1,0) -> (0, 0.5), (0.25, 0.5) -> (0.25, 0.875).
  const std::vector<glm::vec2> turned = uvs({{"offset", {0, 1}}, {"rotation", 1.57079632679}, {"scale", {0.5, 0.5}}});
  const glm::vec2 expected[] = {{0, 1}, {0, 0.5f}, {0.25f, 0.875f}};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(turned[i].x, expected[i].x, 1e-7);  // 1.57079632679 is 90° less 5e-12
    EXPECT_NEAR(turned[i].y, expected[i].y, 1e-7);
  }
  EXPECT_THAT(uvs({{"texCoord", 1}}), ElementsAre(glm::vec2(5), glm::vec2(6), glm::vec2(7)));
}

TEST(GltfTextureErrors, ArePlacedInTheFile) {
  GltfBuilder file = textured();
  file.json["images"][0]["uri"] = "none.png";
  const tests::TemporaryFolder folder;
  EXPECT_EQ(model_error(folder.write("a.gltf", file.gltf())),
            "images[0].uri: " + folder.path("none.png") + ": cannot be read: No such file or directory");
  file.json["images"][0]["uri"] = "https://example.org/a.png";
  EXPECT_EQ(error(file),
            "images[0].uri: expected a file beside this one, or \"data:\", found \"https://example.org/a.png\"");
  file.json["images"][0]["uri"] = "data:image/png;base64,?";
  EXPECT_EQ(error(file), "images[0].uri: expected base64 after \"data:...;base64,\"");
  file.json["images"][0]["uri"] = "data:image/png;base64,AAAA";
  EXPECT_EQ(error(file), "images[0].uri: expected a PNG or JPEG picture");
  file.json["textures"][0]["source"] = 1;
  EXPECT_EQ(error(file), "textures[0].source: expected an index of one of the 1 images, found 1");
  file.json["textures"][0].erase("source");
  EXPECT_EQ(error(file), "textures[0]: expected \"source\": a PNG or JPEG image");
  EXPECT_THAT(error(textured({{"index", 0}, {"texCoord", 2}})),
              HasSubstr("meshes[0].primitives[0].attributes: expected \"TEXCOORD_2\""));
}

}  // namespace
}  // namespace lode::geometry

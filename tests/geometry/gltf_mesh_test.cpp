/// What a glTF file's accessors and primitives become.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/geometry/gltf_builder.h"
#include "tests/geometry/model_reading.h"

namespace lode::geometry {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;
using tests::bytes_of;
using tests::GltfBuilder;
using tests::model_error;
using tests::read_model;

const std::vector<float> kTriangle = {0, 0, 0, 1, 0, 0, 0, 1, 0};

Scene read(const GltfBuilder& file) { return read_model("a.gltf", file.gltf()); }
std::string error(const GltfBuilder& file) { return model_error("a.gltf", file.gltf()); }

/// Positions as the file has them, of one accessor that replaces the triangle's.
std::vector<glm::vec3> positions_of(const GltfBuilder& file) { return read(file).meshes.at(0).positions; }

TEST(GltfMesh, ATriangleIsItself) {
  GltfBuilder file;
  file.primitive({{"POSITION", file.floats("VEC3", kTriangle)}})["indices"] = file.indices({2, 0, 1});
  const Scene scene = read(file);
  ASSERT_EQ(scene.instances.size(), 1u);
  ASSERT_EQ(scene.meshes.size(), 1u);
  EXPECT_EQ(scene.meshes[0].kind, MeshKind::triangles);
  EXPECT_EQ(scene.meshes[0].n_primitives(), 1u);
  EXPECT_EQ(scene.meshes[0].material, std::nullopt);
}

TEST(GltfMesh, GlbIsTheSame) {
  GltfBuilder file;
  file.primitive({{"POSITION", file.floats("VEC3", kTriangle)}});
  const Scene text = read(file), binary = read_model("a.glb", file.glb());
  EXPECT_EQ(binary.meshes.at(0).positions, text.meshes.at(0).positions);
  EXPECT_EQ(binary.meshes.at(0).indices, text.meshes.at(0).indices);
}

TEST(GltfMesh, IndicesOfEveryWidthAreRead) {
  for (const int width : {1, 2, 4}) {
    GltfBuilder file;
    auto& primitive = file.primitive({{"POSITION", file.floats("VEC3", kTriangle)}});
    primitive["attributes"]["NORMAL"] = file.floats("VEC3", kTriangle);  // so that vertices stay shared
    std::string bytes;
    for (const char i : {'\2', '\0', '\1'}) bytes += i + std::string(std::size_t(width - 1), '\0');
    primitive["indices"] = file.accessor(file.view(bytes), width == 4 ? 5125 : 5119 + 2 * width, "SCALAR", 3);
    EXPECT_THAT(read(file).meshes[0].indices, ElementsAre(2, 0, 1)) << width;
  }
}

TEST(GltfMesh, ComponentsOfEveryTypeAreRead) {
  // Signed: c / max, no less than −1; unsigned: c / max. Not normalized: the number itself.
  const auto vertex = [](int type, const std::string& bytes, bool normalized) {
    GltfBuilder file;
    auto& primitive = file.primitive({{"POSITION", file.accessor(file.view(bytes), type, "VEC3", 1)}});
    primitive["mode"] = 0;
    file.json["accessors"][0]["normalized"] = normalized;
    return positions_of(file).at(0);
  };
  const std::string bytes = bytes_of<std::int8_t>({-128, 64, 127}), shorts = bytes_of<std::int16_t>({-32768, 1, 32767});
  const std::string ubytes = bytes_of<std::uint8_t>({0, 51, 255}), ushorts = bytes_of<std::uint16_t>({0, 13107, 65535});
  EXPECT_EQ(vertex(5120, bytes, true), glm::vec3(-1.0f, 64.0f / 127.0f, 1.0f));
  EXPECT_EQ(vertex(5120, bytes, false), glm::vec3(-128, 64, 127));
  EXPECT_EQ(vertex(5121, ubytes, true), glm::vec3(0.0f, 0.2f, 1.0f));
  EXPECT_EQ(vertex(5121, ubytes, false), glm::vec3(0, 51, 255));
  EXPECT_EQ(vertex(5122, shorts, true), glm::vec3(-1.0f, 1.0f / 32767.0f, 1.0f));
  EXPECT_EQ(vertex(5123, ushorts, true), glm::vec3(0.0f, 0.2f, 1.0f));
  EXPECT_EQ(vertex(5126, bytes_of<float>({0.1f, -0.0f, 1e-40f}), false), glm::vec3(0.1f, -0.0f, 1e-40f));
}

TEST(GltfMesh, StridesAndOffsetsAreFollowed) {
  // Elements 20 bytes apart, the first 8 bytes into the view; what is between them is NaN.
  const float nan = std::numeric_limits<float>::quiet_NaN();
  GltfBuilder file;
  const std::size_t view = file.view(bytes_of<float>({nan, nan, 1, 2, 3, nan, nan, 4, 5, 6}), 20);
  file.primitive({{"POSITION", file.accessor(view, 5126, "VEC3", 2)}})["mode"] = 0;
  file.json["accessors"][0]["byteOffset"] = 8;
  EXPECT_THAT(positions_of(file), ElementsAre(glm::vec3(1, 2, 3), glm::vec3(4, 5, 6)));
}

TEST(GltfMesh, SparseAccessorsReplaceElements) {
  GltfBuilder file;
  file.primitive({{"POSITION", file.floats("VEC3", kTriangle)}})["mode"] = 0;
  const std::size_t where = file.view(bytes_of<std::uint8_t>({0, 2})),
                    what = file.view(bytes_of<float>({7, 8, 9, 4, 5, 6}));
  file.json["accessors"][0]["sparse"] = {
      {"count", 2}, {"indices", {{"bufferView", where}, {"componentType", 5121}}}, {"values", {{"bufferView", what}}}};
  EXPECT_THAT(positions_of(file), ElementsAre(glm::vec3(7, 8, 9), glm::vec3(1, 0, 0), glm::vec3(4, 5, 6)));
  file.json["accessors"][0].erase("bufferView");  // zeros, where nothing replaces them
  EXPECT_THAT(positions_of(file), ElementsAre(glm::vec3(7, 8, 9), glm::vec3(0), glm::vec3(4, 5, 6)));
}

TEST(GltfMesh, EveryModeBecomesAListInTheFilesOrder) {
  // glTF 2.0, sec. 3.7.2.1, for vertices 0 to 4.
  const auto list = [](int mode) {
    GltfBuilder file;
    auto& primitive = file.primitive({{"POSITION", file.floats("VEC3", std::vector<float>(15))}});
    primitive["attributes"]["NORMAL"] = file.floats("VEC3", std::vector<float>(15));
    primitive["mode"] = mode;
    if (mode == 1 || mode == 4)
      primitive["indices"] =
          file.indices(mode == 1 ? std::vector<std::uint32_t>{0, 1, 2, 3} : std::vector<std::uint32_t>{0, 1, 2});
    return read(file).meshes[0];
  };
  EXPECT_EQ(list(0).kind, MeshKind::points);
  EXPECT_THAT(list(0).indices, ElementsAre(0, 1, 2, 3, 4));
  EXPECT_EQ(list(1).kind, MeshKind::lines);
  EXPECT_THAT(list(1).indices, ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(list(2).indices, ElementsAre(0, 1, 1, 2, 2, 3, 3, 4, 4, 0));
  EXPECT_THAT(list(3).indices, ElementsAre(0, 1, 1, 2, 2, 3, 3, 4));
  EXPECT_EQ(list(3).kind, MeshKind::lines);
  EXPECT_THAT(list(4).indices, ElementsAre(0, 1, 2));
  EXPECT_THAT(list(5).indices, ElementsAre(0, 1, 2, 1, 3, 2, 2, 3, 4));
  EXPECT_THAT(list(6).indices, ElementsAre(1, 2, 0, 2, 3, 0, 3, 4, 0));
  EXPECT_EQ(list(6).kind, MeshKind::triangles);
}

TEST(GltfMesh, LitTrianglesWithoutNormalsGetFlatOnes) {
  GltfBuilder file;
  auto& primitive = file.primitive({{"POSITION", file.floats("VEC3", kTriangle)}});
  primitive["indices"] = file.indices({0, 1, 2, 0, 2, 1});
  const Mesh lit = read(file).meshes[0];
  EXPECT_EQ(lit.positions.size(), 6u);  // each corner a vertex of its own
  EXPECT_EQ(lit.normals, (std::vector<glm::vec3>{{0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, -1}, {0, 0, -1}, {0, 0, -1}}));

  file.json["materials"] = {{{"extensions", {{"KHR_materials_unlit", json::object()}}}}};
  primitive["material"] = 0;
  const Mesh unlit = read(file).meshes[0];
  EXPECT_EQ(unlit.positions.size(), 3u);
  EXPECT_TRUE(unlit.normals.empty());
}

TEST(GltfMesh, ColoursAreThreeOrFourNumbers) {
  GltfBuilder file;
  auto& primitive = file.primitive({{"POSITION", file.floats("VEC3", kTriangle)}});
  primitive["mode"] = 0;
  primitive["attributes"]["COLOR_0"] = file.floats("VEC3", {0.5f, 0, 0, 0, 2, 0, 0, 0, 1});
  EXPECT_THAT(read(file).meshes[0].colors,
              ElementsAre(glm::vec4(0.5f, 0, 0, 1), glm::vec4(0, 2, 0, 1), glm::vec4(0, 0, 1, 1)));

  const std::size_t bytes = file.accessor(
      file.view(bytes_of<std::uint8_t>({255, 0, 51, 102, 0, 0, 0, 0, 255, 255, 255, 255})), 5121, "VEC4", 3);
  primitive["attributes"]["COLOR_0"] = bytes;
  EXPECT_THAT(error(file), HasSubstr("a colour: expected floats, or normalized"));
  file.json["accessors"][bytes]["normalized"] = true;
  EXPECT_EQ(read(file).meshes[0].colors[0], glm::vec4(1.0f, 0.0f, 0.2f, 0.4f));
}

TEST(GltfMesh, NormalsThatAreNotFiniteAreNone) {
  GltfBuilder file;
  auto& primitive = file.primitive({{"POSITION", file.floats("VEC3", kTriangle)}});
  primitive["attributes"]["NORMAL"] = file.floats("VEC3", {0, 0, 1, NAN, 0, 0, 0, INFINITY, 0});
  EXPECT_THAT(read(file).meshes[0].normals, ElementsAre(glm::vec3(0, 0, 1), glm::vec3(0), glm::vec3(0)));
}

TEST(GltfMesh, APrimitiveWithoutPositionsKeepsItsPlace) {
  // Draw ids count (node, primitive) pairs: the second one is draw 1.
  GltfBuilder file;
  file.primitive({{"POSITION", file.floats("VEC3", kTriangle)}});
  auto& primitives = file.json["meshes"][0]["primitives"];
  primitives.insert(primitives.begin(), json{{"attributes", json::object()}});
  const Scene scene = read(file);
  ASSERT_EQ(scene.instances.size(), 2u);
  EXPECT_EQ(scene.meshes[scene.instances[0].mesh].n_primitives(), 0u);
  EXPECT_EQ(scene.meshes[scene.instances[1].mesh].n_primitives(), 1u);
}

TEST(GltfMeshErrors, WhatIsWrongIsNamedWithItsPlace) {
  const auto with = [](auto change) {
    GltfBuilder file;
    auto& primitive = file.primitive({{"POSITION", file.floats("VEC3", kTriangle)}});
    primitive["indices"] = file.indices({0, 1, 2});
    change(file, primitive);
    return error(file);
  };
  EXPECT_EQ(with([](auto& f, auto& p) {
              p["indices"] = f.indices({0, 1, 2, 0, 1, 3});
            }),
            "accessors[2]: element 5: index 3: expected less than 3");
  EXPECT_EQ(with([](auto&, auto& p) { p["indices"] = 9; }),
            "meshes[0].primitives[0].indices: expected an index of one of the 2 accessors, found 9");
  EXPECT_EQ(with([](auto&, auto& p) { p["indices"] = 0; }), "accessors[0].type: expected \"SCALAR\", found \"VEC3\"");
  EXPECT_EQ(with([](auto& f, auto& p) {
              p["indices"] = f.indices({0, 1, 2, 0});
            }),
            "meshes[0].primitives[0]: 4 vertices: expected a multiple of 3");
  EXPECT_EQ(with([](auto& f, auto& p) {
              p["indices"] = f.indices({0, 1});
            }),
            "meshes[0].primitives[0]: 2 vertices: expected at least 3");
  EXPECT_EQ(with([](auto&, auto& p) { p["mode"] = 7; }),
            "meshes[0].primitives[0].mode: expected a whole number 0 to 6, found 7");
  EXPECT_EQ(with([](auto&, auto& p) { p["material"] = 0; }),
            "meshes[0].primitives[0].material: expected an index of one of the 0 materials, found 0");
  EXPECT_EQ(with([](auto& f, auto& p) {
              p["attributes"]["NORMAL"] = f.floats("VEC3", {0, 0, 1});
            }),
            "meshes[0].primitives[0].attributes.NORMAL: 1 elements: expected 3, one for each position");
  EXPECT_EQ(with([](auto& f, auto& p) {
              p["attributes"]["POSITION"] = f.floats("VEC2", {0, 0});
            }),
            "accessors[2].type: expected \"VEC3\", found \"VEC2\"");
  EXPECT_EQ(with([](auto& f, auto& p) {
              p["attributes"]["POSITION"] = f.floats("VEC3", {0, 0, 0, 0, INFINITY, 0});
            }),
            "meshes[0].primitives[0].attributes.POSITION: accessors[2], element 1: a position that is not finite");
  EXPECT_EQ(with([](auto& f, auto&) { f.json["accessors"][0]["componentType"] = 5124; }),
            "accessors[0].componentType: expected 5120 to 5123, 5125 or 5126, found 5124");
  EXPECT_EQ(with([](auto& f, auto&) { f.json["accessors"][0]["count"] = 4; }),
            "accessors[0]: 4 elements of 12 bytes, 12 apart: the buffer view holds 36 bytes");
  EXPECT_EQ(with([](auto& f, auto&) { f.json["accessors"][0]["count"] = 4294967295u; }),
            "accessors[0]: 4294967295 elements of 12 bytes, 12 apart: the buffer view holds 36 bytes");
  EXPECT_EQ(with([](auto& f, auto&) { f.json["accessors"][0]["count"] = 0; }),
            "accessors[0].count: expected a whole number 1 to 4294967295, found 0");
  EXPECT_EQ(with([](auto& f, auto&) { f.json["bufferViews"][0]["byteLength"] = 1000; }),
            "bufferViews[0].byteLength: expected a whole number 1 to 48, found 1000");
  EXPECT_EQ(with([](auto& f, auto&) { f.json["bufferViews"][0]["byteStride"] = 300; }),
            "bufferViews[0].byteStride: expected a whole number 4 to 252, found 300");
}

TEST(GltfMeshErrors, ZerosThatNoFileHoldsAreRefusedBeforeTheyAreAllocated) {
  GltfBuilder file;
  file.primitive({{"POSITION", file.floats("VEC3", kTriangle)}});
  file.json["accessors"][0].erase("bufferView");
  file.json["accessors"][0]["count"] = 4294967295u;
  EXPECT_THAT(error(file), HasSubstr("accessors[0]: claims 49151 MiB of memory: expected at most 8 times the bytes"));
}

}  // namespace
}  // namespace lode::geometry

/// The container, buffers and uris of glTF files.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "geometry/model_file/gltf/uri.h"
#include "tests/geometry/gltf_builder.h"
#include "tests/geometry/model_reading.h"

namespace lode::geometry {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::StartsWith;
using tests::GltfBuilder;
using tests::model_error;
using tests::read_model;
using tests::TemporaryFolder;

GltfBuilder triangle() {
  GltfBuilder file;
  file.primitive({{"POSITION", file.floats("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0})}});
  return file;
}

TEST(Uri, EscapesBecomeBytesAndWhatIsNoneStays) {
  EXPECT_EQ(percent_decoded("a%20b%2Fc"), "a b/c");
  EXPECT_EQ(percent_decoded("100%.png%"), "100%.png%");
  EXPECT_EQ(percent_decoded("%4"), "%4");
}

TEST(Uri, DataIsBase64WithOrWithoutPadding) {
  const auto text = [](const char* uri) {
    const auto bytes = data_uri_bytes(uri);
    return bytes ? std::string(reinterpret_cast<const char*>(bytes->data()), bytes->size()) : "none";
  };
  EXPECT_EQ(text("data:;base64,TG9kZQ=="), "Lode");  // RFC 4648: "Lode" is 4C 6F 64 65
  EXPECT_EQ(text("data:image/png;base64,TG9kZQ"), "Lode");
  EXPECT_EQ(text("data:;base64,"), "");
  EXPECT_EQ(text("data:text/plain,Lode"), "none");
  EXPECT_EQ(text("data:;base64,TG9 ZQ"), "none");
}

TEST(Uri, AFileNameWithAColonInAFolderIsNoScheme) {
  EXPECT_TRUE(has_scheme("https://example.org/a.bin"));
  EXPECT_FALSE(has_scheme("a b:c.bin"));
  EXPECT_FALSE(has_scheme("C:/a.bin"));
  EXPECT_FALSE(has_scheme("a.bin"));
}

TEST(GltfDocument, BuffersAreFilesBesideIt) {
  GltfBuilder file = triangle();
  file.json["buffers"] = {{{"byteLength", file.buffer.size()}, {"uri", "data/my%20buffer.bin"}}};
  const TemporaryFolder folder;
  folder.write("data/my buffer.bin", file.buffer);
  EXPECT_EQ(read_model_file(folder.write("a.gltf", file.json.dump())).meshes.at(0).positions.size(), 3u);
}

TEST(GltfDocument, GlbAndGltfAreToldApartByTheirFirstBytes) {
  EXPECT_EQ(read_model("a.gltf", triangle().glb()).meshes.size(), 1u);
  EXPECT_EQ(read_model("a.glb", triangle().gltf()).meshes.size(), 1u);
}

TEST(GltfDocument, AGlbWithNulsAfterItsJsonIsRead) {
  std::string bytes = triangle().glb();
  for (std::size_t i = bytes.find("BIN") - 5; bytes[i] == ' '; --i) bytes[i] = '\0';
  EXPECT_EQ(read_model("a.glb", bytes).meshes.size(), 1u);
}

TEST(GltfDocumentErrors, WhatIsNoGltf2IsNamed) {
  EXPECT_EQ(model_error("a.gltf", "{}"), "expected \"asset\"");
  EXPECT_EQ(model_error("a.gltf", "[]"), "expected an object, found []");
  EXPECT_EQ(model_error("a.gltf", R"({"asset": {"version": "1.0"}})"),
            "asset.version: expected \"2.0\", the version of glTF that is read, found \"1.0\"");
  EXPECT_EQ(model_error("a.gltf", R"({"asset": {"version": "2.1", "minVersion": "2.1"}})"),
            "asset.minVersion: expected \"2.0\", found \"2.1\"");
  EXPECT_THAT(model_error("a.gltf", "{\n \"asset\": }"), StartsWith("line 2, column 11: "));
  EXPECT_THAT(model_error("a.gltf", std::string("{}\0{}", 5)), HasSubstr("a NUL byte: expected JSON text"));
}

TEST(GltfDocumentErrors, ARequiredExtensionThatWeDoNotReadIsNamed) {
  GltfBuilder file = triangle();
  file.json["extensionsRequired"] = {"KHR_texture_transform", "KHR_draco_mesh_compression"};
  EXPECT_EQ(model_error("a.gltf", file.gltf()),
            "extensionsRequired[1]: the file requires KHR_draco_mesh_compression, which is not read: export it without "
            "that extension");
  file.json["extensionsUsed"] = {"KHR_draco_mesh_compression"};
  file.json.erase("extensionsRequired");
  EXPECT_EQ(read_model("a.gltf", file.gltf()).meshes.size(), 1u);
}

TEST(GltfDocumentErrors, BuffersThatAreNotThereAreNamed) {
  const TemporaryFolder folder;
  GltfBuilder file = triangle();
  const auto error = [&](const json& buffer) {
    file.json["buffers"] = json::array({buffer});
    return model_error(folder.write("a.gltf", file.json.dump()));
  };
  EXPECT_EQ(error({{"byteLength", 36}, {"uri", "no.bin"}}),
            "buffers[0].uri: " + folder.path("no.bin") + ": cannot be read: No such file or directory");
  EXPECT_EQ(error({{"byteLength", 36}}),
            "buffers[0]: expected \"uri\": only the first buffer of a .glb file may lack it");
  folder.write("short.bin", "abc");
  EXPECT_EQ(error({{"byteLength", 36}, {"uri", "short.bin"}}), "buffers[0].byteLength: claims 36 bytes, found 3");
  EXPECT_EQ(error({{"byteLength", 4294967296}, {"uri", "short.bin"}}),
            "buffers[0].byteLength: claims 4294967296 bytes, found 3");
  EXPECT_EQ(error({{"byteLength", 3}, {"uri", "short.bin"}}),
            "bufferViews[0].byteLength: expected a whole number 1 to 3, found 36");
  EXPECT_EQ(error({{"byteLength", 3}, {"uri", "bad%00name"}}),
            "buffers[0].uri: " + folder.path("bad") + ": a NUL byte follows in the path");
}

TEST(GlbErrors, ContainersThatDoNotHoldWhatTheySayAreNamed) {
  const std::string whole = triangle().glb();
  const auto with = [&](std::size_t at, std::uint32_t value) {
    std::string bytes = whole;
    return model_error("a.glb", bytes.replace(at, 4, tests::little_endian(value)));
  };
  const std::string size = std::to_string(whole.size());
  EXPECT_EQ(with(4, 1), "byte 4: GLB version 1: expected 2");
  EXPECT_EQ(with(8, 4294967295u), "byte 8: claims 4294967295 bytes: the file has " + size);
  EXPECT_EQ(with(12, 4294967280u), "byte 12: a chunk of 4294967280 bytes: the file ends before it does");
  EXPECT_EQ(with(16, 0x004E4942), "byte 16: expected a chunk of JSON first");
  EXPECT_EQ(with(8, 20),
            "byte 12: a chunk of " + std::to_string(whole.find("BIN") - 24) + " bytes: the file ends before it does");
  EXPECT_EQ(with(8, 12), "byte 12: expected a chunk of JSON");
  EXPECT_EQ(model_error("a.glb", whole.substr(0, 10)), "byte 10: the file ends within its header");
}

}  // namespace
}  // namespace lode::geometry

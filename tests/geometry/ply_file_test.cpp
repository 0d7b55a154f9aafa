/// What PLY files become, and what is said of bad ones.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <limits>

#include "tests/geometry/model_reading.h"

namespace lode::geometry {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using tests::model_error;

Mesh read(const std::string& bytes) { return tests::read_model("a.ply", bytes).meshes.at(0); }
std::string error(const std::string& bytes) { return model_error("a.ply", bytes); }

/// A header; the elements are lines.
std::string header(const std::string& format, const std::string& elements) {
  return "ply\nformat " + format + " 1.0\n" + elements + "end_header\n";
}

const std::string kXyz = "property float x\nproperty float y\nproperty float z\n";
const std::string kTriangle = "element vertex 3\n" + kXyz + "element face 1\nproperty list uchar int vertex_indices\n";

template <class T>
std::string number(T value, bool big_endian) {
  std::string bytes(sizeof value, '\0');
  std::memcpy(bytes.data(), &value, sizeof value);
  if (big_endian) std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

TEST(PlyFile, TextAndBothByteOrdersAreTheSame) {
  const std::string ascii = header("ascii", kTriangle) + "0 0 0\n1.5 0 0\n0 0.1 0\n3 2 0 1\n";
  const Mesh text = read(ascii);
  EXPECT_THAT(text.positions, ElementsAre(glm::vec3(0), glm::vec3(1.5f, 0, 0), glm::vec3(0, 0.1f, 0)));
  EXPECT_THAT(text.indices, ElementsAre(2, 0, 1));
  EXPECT_THAT(text.normals, ElementsAre(glm::vec3(0, 0, 1), glm::vec3(0, 0, 1), glm::vec3(0, 0, 1)));  // smooth
  for (const bool big : {false, true}) {
    std::string bytes = header(big ? "binary_big_endian" : "binary_little_endian", kTriangle);
    for (const float x : {0.0f, 0.0f, 0.0f, 1.5f, 0.0f, 0.0f, 0.0f, 0.1f, 0.0f}) bytes += number(x, big);
    bytes += '\3';
    for (const std::int32_t i : {2, 0, 1}) bytes += number(i, big);
    EXPECT_EQ(read(bytes).positions, text.positions);
    EXPECT_EQ(read(bytes).indices, text.indices);
  }
}

TEST(PlyFile, EveryTypeIsRead) {
  // x as each of the types in turn, y and z as float; both sets of names.
  const auto x = [](const char* type, const std::string& bytes) {
    return read(header("binary_little_endian", "element vertex 1\nproperty " + std::string(type) +
                                                   " x\nproperty float32 y\nproperty float32 z\n") +
                bytes + std::string(8, '\0'))
        .positions.at(0)
        .x;
  };
  EXPECT_EQ(x("char", number<std::int8_t>(-5, false)), -5.0f);
  EXPECT_EQ(x("uint8", number<std::uint8_t>(200, false)), 200.0f);
  EXPECT_EQ(x("int16", number<std::int16_t>(-30000, false)), -30000.0f);
  EXPECT_EQ(x("ushort", number<std::uint16_t>(60000, false)), 60000.0f);
  EXPECT_EQ(x("int", number<std::int32_t>(-16777217, false)), -16777216.0f);
  EXPECT_EQ(x("uint32", number<std::uint32_t>(4000000000u, false)), 4e9f);
  EXPECT_EQ(x("double", number(0.1, false)), 0.1f);
}

TEST(PlyFile, TextIsRoundedOnceAsItsTypeIs) {
  // 16777217.0000001 lies just above halfway between two floats: rounded to float at once it goes up, rounded to double
  // first, too; as "double" it is what a binary file of doubles would give.
  const auto x = [](const char* type, const char* text) {
    return read(header("ascii",
                       "element vertex 1\nproperty " + std::string(type) + " x\nproperty float y\nproperty float z\n") +
                text + " 0 0\n")
        .positions.at(0)
        .x;
  };
  EXPECT_EQ(x("float", "16777217.0000000000000000001"), 16777218.0f);
  EXPECT_EQ(x("double", "16777217.0000000000000000001"), 16777216.0f);  // the double is 16777217: half to even
}

TEST(PlyFile, AttributesAreReadWhereverTheyStand) {
  const std::string text =
      header("ascii",
             "comment made by hand\nobj_info x\nelement vertex 3\nproperty uchar red\nproperty list uchar float junk\n"
             "property float y\nproperty float x\nproperty float z\nproperty uchar green\nproperty uchar blue\n"
             "property uchar alpha\nproperty float nx\nproperty float ny\nproperty float nz\nproperty float s\n"
             "property float t\nproperty float quality\n") +
      "255 2 9 9 2 1 3 0 51 102 0 0 1 0.5 0.25 7\n0 0 0 0 0 0 0 0 0 0 0 0 0 7\n0 0 0 0 0 0 0 0 0 0 0 0 0 7\n";
  const Mesh mesh = read(text);
  EXPECT_EQ(mesh.positions.at(0), glm::vec3(1, 2, 3));
  EXPECT_EQ(mesh.colors.at(0), glm::vec4(1.0f, 0.0f, 0.2f, 0.4f));
  EXPECT_EQ(mesh.normals.at(0), glm::vec3(0, 0, 1));
  EXPECT_EQ(mesh.uvs.at(0), glm::vec2(0.5f, 0.75f));  // t = 0 is the bottom
}

TEST(PlyFile, ColoursOfOtherTypesAreFractionsOrFloats) {
  const auto color = [](const char* type, const char* values) {
    const std::string t = "property " + std::string(type) + " ";
    return read(header("ascii", "element vertex 1\n" + kXyz + t + "red\n" + t + "green\n" + t + "blue\n") + "0 0 0 " +
                values + "\n")
        .colors.at(0);
  };
  EXPECT_EQ(color("ushort", "65535 13107 0"), glm::vec4(1.0f, 0.2f, 0.0f, 1.0f));
  EXPECT_EQ(color("float", "0.25 2 0"), glm::vec4(0.25f, 2.0f, 0.0f, 1.0f));
}

TEST(PlyFile, PolygonsAreTrianglesAndOtherElementsAreSkipped) {
  const std::string text =
      header("ascii", "element edge 1\nproperty int a\nproperty int b\nelement vertex 4\n" + kXyz +
                          "element nothing 4000000000\nelement face 2\nproperty uchar flags\n"
                          "property list uchar uint vertex_index\nelement tail 1\nproperty float f\n") +
      "7 8\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n5 4 0 1 2 3\n5 3 0 3 1\n1\n";
  EXPECT_THAT(read(text).indices, ElementsAre(0, 1, 2, 0, 2, 3, 4, 5, 6));  // the last one faces away: its corners
}

TEST(PlyFile, StripsTurnEveryOtherTriangle) {
  const std::string text =
      header("ascii", "element vertex 5\n" + kXyz + "element tristrips 1\nproperty list int int vertex_indices\n") +
      "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n9 0 1 2 3 -1 2 3 4 -1\n";
  EXPECT_THAT(read(text).indices, ElementsAre(0, 1, 2, 1, 3, 2, 2, 3, 4));
}

TEST(PlyFile, VerticesAloneArePoints) {
  for (const char* faces : {"", "element face 0\nproperty list uchar int vertex_indices\n"}) {
    const Mesh mesh = read(header("ascii", "element vertex 2\n" + kXyz + faces) + "1 2 3\n4 5 6\n");
    EXPECT_EQ(mesh.kind, MeshKind::points);
    EXPECT_THAT(mesh.indices, ElementsAre(0, 1));
    EXPECT_THAT(mesh.normals, IsEmpty());
  }
}

TEST(PlyFile, EverythingIsTwoSided) {
  const Scene scene = tests::read_model("a.ply", header("ascii", kTriangle) + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  EXPECT_TRUE(scene.materials.at(scene.meshes[0].material.value()).double_sided);
}

TEST(PlyErrors, OfTheHeaderNameTheLine) {
  EXPECT_EQ(error("plx\n"), "line 1: expected \"ply\"");
  EXPECT_EQ(error("ply\nformat ascii 2.0\n"), "line 2: expected version 1.0, found \"2.0\"");
  EXPECT_EQ(error("ply\nformat ebcdic 1.0\n"),
            "line 2: expected ascii, binary_little_endian or binary_big_endian, found \"ebcdic\"");
  EXPECT_EQ(error("ply\nformat ascii 1.0\nelement vertex x\n"), "line 3: expected a name and a count, found \"x\"");
  EXPECT_EQ(error("ply\nformat ascii 1.0\nelement vertex -1\n"),
            "line 3: expected a count that is not negative, found \"-1\"");
  EXPECT_EQ(error("ply\nformat ascii 1.0\nproperty float x\n"), "line 3: a property before the first element");
  EXPECT_THAT(error("ply\nelement vertex 1\nproperty half x\n"), HasSubstr("line 3: expected a type (char, "));
  EXPECT_EQ(error("ply\nend_header\n"), "line 2: the header ends without \"format\"");
  EXPECT_THAT(error("ply\nformat ascii 1.0\n"), HasSubstr("the file ends within its header: expected \"end_header\""));
}

TEST(PlyErrors, CountsThatTheFileCannotHoldAreRefusedBeforeAnythingIsAllocated) {
  EXPECT_EQ(error(header("binary_little_endian", "element vertex 4294967295\n" + kXyz) + std::string(24, 'x')),
            "claims 4294967295 elements \"vertex\" of at least 12 bytes: the file has 24 left for them");
  EXPECT_EQ(error(header("ascii", "element vertex 9223372036854775807\n" + kXyz) + "0 0 0\n"),
            "claims 9223372036854775807 elements \"vertex\" of at least 6 bytes: the file has 6 left for them");
  const std::string faces = "element vertex 0\n" + kXyz + "element face 1\nproperty list uint double vertex_indices\n";
  EXPECT_THAT(error(header("binary_little_endian", faces) + "\xFF\xFF\xFF\xFF"),
              HasSubstr("a list \"vertex_indices\" that the file does not hold"));
  EXPECT_THAT(error(header("ascii", faces) + "4294967295 0 0 0\n"),
              HasSubstr("a list \"vertex_indices\" of another length than the line has words for"));
}

TEST(PlyErrors, OfTheDataNameTheirPlace) {
  const auto text = [](const std::string& data) { return error(header("ascii", kTriangle) + data); };
  EXPECT_EQ(text("0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"), "line 13: face 0: vertex 3: expected a whole number below 3");
  EXPECT_EQ(text("0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n"), "line 13: face 0: vertex -1: expected a whole number below 3");
  EXPECT_EQ(text("0 0 0\n1 0 0\n0 1 0\n2 0 1    \n"), "line 13: face 0 of 2 vertices: expected at least 3");
  EXPECT_EQ(text("0 0 0\n1 0 a\n0 1 0\n3 0 1 2\n"), "line 11: expected a number for \"z\", found \"a\"");
  EXPECT_EQ(text("0 0 0\n1 0 0\n0 1 0       \n"), "line 13: the file ends: expected another element \"face\"");

  const auto binary = [](float z) {
    std::string bytes = header("binary_little_endian", "element vertex 1\n" + kXyz);
    return error(bytes + number(0.0f, false) + number(0.0f, false) + number(z, false));
  };
  EXPECT_EQ(binary(std::numeric_limits<float>::infinity()), "byte 115: vertex 0: a position that is not finite");
  EXPECT_EQ(error(header("ascii", "element vertex 1\nproperty float x\nproperty float y\n") + "0 0\n"),
            "expected the properties x, y and z of \"vertex\"");
  EXPECT_EQ(error(header("ascii", "element face 1\nproperty list uchar int vertex_indices\n") + "3 0 1 2\n"),
            "\"face\" before \"vertex\"");
  EXPECT_EQ(error(header("ascii", "element vertex 1\n" + kXyz + "element face 1\nproperty int vertex_indices\n") +
                  "0 0 0\n0\n"),
            "expected a list vertex_indices in the element \"face\"");
}

}  // namespace
}  // namespace lode::geometry

/// What STL files become, and what is said of bad ones.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "tests/geometry/model_reading.h"

namespace lode::geometry {
namespace {

using testing::ElementsAre;
using tests::model_error;

Scene read(const std::string& bytes) { return tests::read_model("a.stl", bytes); }
std::string error(const std::string& bytes) { return model_error("a.stl", bytes); }

std::string bytes_of(std::uint32_t n) {
  return {char(n & 255), char(n >> 8 & 255), char(n >> 16 & 255), char(n >> 24)};
}

/// A binary file of one triangle, with a wrong normal and an attribute.
std::string binary(std::string head, std::uint32_t count = 1, float last = 0.0f) {
  head.resize(80, ' ');
  std::string bytes = head + bytes_of(count);
  for (const float x : {9.0f, 9.0f, 9.0f, 0.0f, 0.0f, 0.0f, 2.0f, 0.0f, 0.0f, 0.0f, 2.0f, last}) {
    std::uint32_t bits = 0;
    std::memcpy(&bits, &x, 4);
    bytes += bytes_of(bits);
  }
  return bytes + "\xFF\x7F";
}

const std::string kFacet =
    "facet normal 9 9 9\n outer loop\n  vertex 0 0 0\n  vertex 2 0 0\n  vertex 0 2 0\n endloop\nendfacet\n";

TEST(StlFile, TextAndBinaryAreTheSame) {
  for (const std::string& bytes : {binary("a name"), "solid a name\n" + kFacet + "endsolid a name\n"}) {
    const Scene scene = read(bytes);
    const Mesh& mesh = scene.meshes.at(0);
    EXPECT_THAT(mesh.positions, ElementsAre(glm::vec3(0), glm::vec3(2, 0, 0), glm::vec3(0, 2, 0)));
    EXPECT_THAT(mesh.indices, ElementsAre(0, 1, 2));
    EXPECT_EQ(mesh.normals, std::vector<glm::vec3>(3, {0, 0, 1}));  // the triangle's own, not the file's
    EXPECT_TRUE(scene.materials.at(mesh.material.value()).double_sided);
  }
}

TEST(StlFile, ABinaryFileMayBeginWithSolid) { EXPECT_EQ(read(binary("solid")).meshes.at(0).n_primitives(), 1u); }

TEST(StlFile, FacetsKeepTheirOrderAndTheirOwnVertices) {
  const Mesh mesh = read("solid\n" + kFacet + kFacet + "endsolid\n").meshes.at(0);
  EXPECT_THAT(mesh.indices, ElementsAre(0, 1, 2, 3, 4, 5));
}

TEST(StlFile, NoFacetsAreAnEmptyMesh) {
  EXPECT_EQ(read("solid\nendsolid\n").meshes.at(0).n_primitives(), 0u);
  EXPECT_EQ(read(binary("", 0).substr(0, 84)).meshes.at(0).n_primitives(), 0u);
}

TEST(StlErrors, NameTheirPlace) {
  EXPECT_EQ(error("hello"), "expected an STL file");
  EXPECT_EQ(error(binary("x", 4294967295u)),
            "byte 80: claims 4294967295 facets: expected a file of 214748364834 bytes, found 134");
  EXPECT_EQ(error(binary("x") + "?"), "byte 80: claims 1 facets: expected a file of 134 bytes, found 135");
  EXPECT_EQ(error(binary("x", 1, INFINITY)), "facet 0, byte 120: a corner that is not finite");
  EXPECT_EQ(error("solid\nfacet normal 0 0 0\nouter loop\nvertex 0 0 x\n"), "line 4: expected a number, found \"x\"");
  EXPECT_EQ(error("solid\n" + kFacet + "facet\nnormal"), "line 11: the file ends: expected endsolid");
  EXPECT_EQ(error("solid\nface\n"), "line 2: expected facet or endsolid, found \"face\"");
  EXPECT_EQ(error("solid\nfacet normal 0 0 0 inner\n"), "line 2: expected outer, found \"inner\"");
}

}  // namespace
}  // namespace lode::geometry

/// What OBJ and MTL files become, and what is said of bad ones.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <array>

#include "tests/geometry/model_reading.h"
#include "tests/geometry/png_bytes.h"

namespace lode::geometry {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using tests::model_error;
using tests::TemporaryFolder;

Scene read(const std::string& text) { return tests::read_model("a.obj", text); }
std::string error(const std::string& text) { return model_error("a.obj", text); }

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

/// The scene of an OBJ with "mtllib a.mtl", and these files beside it.
struct Files {
  std::string mtl;
  std::string picture;  ///< "a.png", if it is not empty
};
std::string write_with(const TemporaryFolder& folder, const std::string& obj, const Files& files) {
  folder.write("a.mtl", files.mtl);
  if (!files.picture.empty()) folder.write("a.png", files.picture);
  return folder.write("a.obj", "mtllib a.mtl\n" + kSquare + obj);
}
Scene read_with(const Files& files, const std::string& obj = "vt 0 0\nusemtl m\nf 1/1 2/1 3/1\n") {
  const TemporaryFolder folder;
  return read_model_file(write_with(folder, obj, files));
}
std::string error_with(const Files& files) {
  const TemporaryFolder folder;
  const std::string text = model_error(write_with(folder, "usemtl m\nf 1 2 3\n", files));
  return text.starts_with(folder.path()) ? text.substr(folder.path().size() + 1) : text;
}

TEST(ObjFile, NumbersAreRoundedCorrectly) {
  // The nearest floats, as the compiler has them; what is below float's smallest is 0.
  const Scene scene = read("v 0.1 -3.4028235e38 +1e-45\nv 1e-60 1E2 .5\nv 8388608.5 16777217 0.00000001\np 1 2 3\n");
  EXPECT_THAT(scene.meshes.at(0).positions,
              ElementsAre(glm::vec3(0.1f, -3.4028235e38f, 1e-45f), glm::vec3(0.0f, 100.0f, 0.5f),
                          glm::vec3(8388608.0f, 16777216.0f, 1e-8f)));
}

TEST(ObjFile, EveryFormOfIndexLeadsToItsVertex) {
  const std::string data = kSquare + "vt 0.25 0.25\nvt 0.5 0\nvn 0 0 1\nvn 0 1 0\n";
  for (const char* face : {"f 1/2/1 2/1/2 3/2/1\n", "f -4/-1/-2 -3/-2/-1 -2/-1/-2\n"}) {
    const Mesh mesh = read(data + face).meshes.at(0);
    EXPECT_THAT(mesh.positions, ElementsAre(glm::vec3(0, 0, 0), glm::vec3(1, 0, 0), glm::vec3(1, 1, 0)));
    EXPECT_THAT(mesh.uvs,
                ElementsAre(glm::vec2(0.5f, 1), glm::vec2(0.25f, 0.75f), glm::vec2(0.5f, 1)));  // v = 0 is the bottom
    EXPECT_THAT(mesh.normals, ElementsAre(glm::vec3(0, 0, 1), glm::vec3(0, 1, 0), glm::vec3(0, 0, 1)));
  }
  EXPECT_THAT(read(data + "f 1//2 2//2 3//2\n").meshes[0].uvs, IsEmpty());
  EXPECT_EQ(read(data + "f 1//2 2//2 3//2\n").meshes[0].normals.size(), 3u);
  EXPECT_EQ(read(data + "f 1/1 2/1 3/1\n").meshes[0].uvs.size(), 3u);
}

TEST(ObjFile, NegativeIndicesCountFromWhereTheyStand) {
  const Mesh mesh = read("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 5 5 5\nf -1 -2 -3\n").meshes.at(0);
  EXPECT_THAT(mesh.indices, ElementsAre(0, 1, 2, 3, 2, 1));
  EXPECT_EQ(mesh.positions[3], glm::vec3(5));
}

TEST(ObjFile, EqualCornersAreOneVertex) {
  // Two triangles of a square share two corners; another normal makes another vertex.
  EXPECT_EQ(read(kSquare + "f 1 2 3\nf 1 3 4\n").meshes[0].positions.size(), 4u);
  EXPECT_EQ(read(kSquare + "vn 0 0 1\nvn 0 0 2\nf 1//1 2//1 3//1\nf 1//1 3//2 4//1\n").meshes[0].positions.size(), 5u);
}

TEST(ObjFile, PolygonsAreTrianglesInTheFilesOrder) {
  const Mesh mesh = read(kSquare + "v 0.5 2 0\nf 1 2 3 4\nf 4 3 5\n").meshes.at(0);
  EXPECT_THAT(mesh.indices, ElementsAre(0, 1, 2, 0, 2, 3, 3, 2, 4));
}

TEST(ObjFile, NormalsThatLackAreSmooth) {
  // Two faces that meet at 45°: of each, two triangles have a corner at vertex 0, with area normals (0, 0, 1) and
  // (0, −1, 1).
  const Mesh mesh = read(kSquare + "v 0 -1 -1\nv 1 -1 -1\nf 1 2 3 4\nf 1 5 6 2\n").meshes.at(0);
  EXPECT_EQ(mesh.normals[0], glm::vec3(glm::normalize(glm::dvec3(0, -1, 2))));
  EXPECT_EQ(mesh.normals[2], glm::vec3(0, 0, 1));
  // Where some corners have normals, those stay.
  const Mesh some = read(kSquare + "vn 5 0 0\nf 1//1 2 3\n").meshes.at(0);
  EXPECT_THAT(some.normals, ElementsAre(glm::vec3(5, 0, 0), glm::vec3(0, 0, 1), glm::vec3(0, 0, 1)));
}

TEST(ObjFile, VerticesMayHaveColours) {
  const Mesh mesh = read("v 0 0 0\nv 1 0 0 0.5 0.25 1\nv 0 1 0 1 0 0 0.5\nv 0 0 0 2\nf 1 2 3\n").meshes.at(0);
  EXPECT_THAT(mesh.colors, ElementsAre(glm::vec4(1), glm::vec4(0.5f, 0.25f, 1, 1), glm::vec4(1, 0, 0, 0.5f)));
  EXPECT_THAT(read("v 0 0 0 1\nv 1 0 0 1\nv 0 1 0 1\nf 1 2 3\n").meshes[0].colors, IsEmpty());  // weights
}

TEST(ObjFile, LinesAndPointsAreMeshesOfTheirKinds) {
  const Scene scene = read(kSquare + "l 1 2 3\np 4 1\nf 1 2 3\nl 4 1\n");
  ASSERT_EQ(scene.meshes.size(), 3u);
  EXPECT_EQ(scene.meshes[0].kind, MeshKind::lines);
  EXPECT_THAT(scene.meshes[0].indices, ElementsAre(0, 1, 1, 2, 3, 0));
  EXPECT_EQ(scene.meshes[1].kind, MeshKind::points);
  EXPECT_THAT(scene.meshes[1].positions, ElementsAre(glm::vec3(0, 1, 0), glm::vec3(0, 0, 0)));
  EXPECT_EQ(scene.meshes[2].kind, MeshKind::triangles);
}

TEST(ObjFile, ObjectsAndGroupsAreNodesAndMaterialsTheirMeshes) {
  // Draws: (first, red), (first, blue), (b, red): g b occurs twice within its object and is one node; the object
  // without faces is none, and the second "first" is another object.
  const Scene scene =
      read(kSquare +
           "o first\nusemtl red\nf 1 2 3\nusemtl blue\nf 1 2 3\nusemtl red\nf 2 3 4\n"
           "o empty\no second\ng b\nf 1 2 3\ng c\nusemtl blue\nf 1 2 3\ng b\nusemtl red\nf 1 2 4\no first\nf 1 2 3\n");
  ASSERT_EQ(scene.nodes.size(), 4u);
  EXPECT_EQ(scene.nodes[0].name, "first");
  EXPECT_EQ(scene.nodes[1].name, "b");
  EXPECT_EQ(scene.nodes[2].name, "c");
  EXPECT_EQ(scene.nodes[3].name, "first");
  std::vector<std::string> draws;
  for (const Instance& i : scene.instances) {
    const Mesh& mesh = scene.meshes[i.mesh];
    draws.push_back(scene.nodes[i.node].name + " " + scene.materials[*mesh.material].name + " " +
                    std::to_string(mesh.n_primitives()));
  }
  EXPECT_THAT(draws, ElementsAre("first red 2", "first blue 1", "b red 2", "c blue 1", "first red 1"));
}

TEST(ObjFile, LinesEndInAnyWayAndMayGoOn) {
  const Mesh mesh = read("# text\r\n\r\nv 0 0 0\r\nv 1 \\\r\n 0 \\\r\n 0\nv\t0  1 0  \nf 1 2 \\\n3").meshes.at(0);
  EXPECT_THAT(mesh.positions, ElementsAre(glm::vec3(0, 0, 0), glm::vec3(1, 0, 0), glm::vec3(0, 1, 0)));
}

TEST(ObjFile, EverythingIsTwoSided) {
  EXPECT_TRUE(read(kSquare + "f 1 2 3\n").materials.at(0).double_sided);
  EXPECT_TRUE(read_with({"newmtl m\n", ""}).materials.at(0).double_sided);
}

TEST(MtlFile, ColoursAndOpacityAreRead) {
  const Material opaque =
      read_with({"newmtl other\nKd 1 1 1\n\nnewmtl m\nNs 5\nKd 0.1 0.2 0.3\nillum 2\n", ""}).materials.at(0);
  EXPECT_EQ(opaque.name, "m");
  EXPECT_EQ(opaque.color, glm::vec4(0.1f, 0.2f, 0.3f, 1));
  EXPECT_EQ(opaque.alpha_mode, AlphaMode::opaque);
  const auto with = [](const std::string& text) { return read_with({"newmtl m\n" + text, ""}).materials.at(0); };
  EXPECT_EQ(with("Kd 0.5\n").color, glm::vec4(0.5f, 0.5f, 0.5f, 1));
  EXPECT_EQ(with("d 0.25\n").color.a, 0.25f);
  EXPECT_EQ(with("d 0.25\n").alpha_mode, AlphaMode::blend);
  EXPECT_EQ(with("Tr 0.25\n").color.a, 0.75f);
  EXPECT_EQ(with("d 1\nTr 1\n").alpha_mode, AlphaMode::opaque);  // d says more than Tr
}

std::string png(std::initializer_list<std::array<int, 4>> texels) {
  return tests::rgba_png(std::uint32_t(texels.size()), 1, std::vector(texels));
}

TEST(MtlFile, MapsArePicturesBesideIt) {
  const Scene scene = read_with({"newmtl m\nmap_Kd a.png\n", png({{1, 2, 3, 4}})});
  EXPECT_THAT(scene.pictures.at(0).texels, ElementsAre(glm::u8vec4(1, 2, 3, 4)));
  EXPECT_EQ(scene.materials.at(0).color_texture, TextureUse{});
  EXPECT_EQ(scene.materials[0].alpha_mode, AlphaMode::opaque);

  const TemporaryFolder folder;
  folder.write("my textures/a b.png", png({{9, 9, 9, 255}}));
  const std::string path =
      write_with(folder, "usemtl m\nf 1 2 3\n", {"newmtl m\r\nmap_Kd my textures\\a b.png  \r\n", ""});
  EXPECT_EQ(read_model_file(path).pictures.at(0).texels.at(0), glm::u8vec4(9, 9, 9, 255));
}

TEST(MtlFile, OptionsScaleMoveAndClamp) {
  // (u, v) with v up becomes (2u + 0.5, 1 − (3v + 0.25)).
  const std::string obj = "vt 0.125 0.0625\nusemtl m\nf 1/1 2/1 3/1\n";
  const Scene scene =
      read_with({"newmtl m\nmap_Kd -s 2 3 1 -o 0.5 0.25 -clamp on -blendu off a.png\n", png({{1, 2, 3, 4}})}, obj);
  EXPECT_EQ(scene.meshes.at(0).uvs.at(0), glm::vec2(0.75f, 0.5625f));
  EXPECT_EQ(scene.materials.at(0).color_texture->wrap_u, TextureWrap::clamp);
}

TEST(MtlFile, OpacityMapsAreAlphaTestedAtOneHalf) {
  // The picture has alpha: that is the opacity, whatever its colours.
  const Scene same = read_with({"newmtl m\nmap_Kd a.png\nmap_d a.png\n", png({{1, 2, 3, 4}, {5, 6, 7, 255}})});
  EXPECT_THAT(same.pictures.at(0).texels, ElementsAre(glm::u8vec4(1, 2, 3, 4), glm::u8vec4(5, 6, 7, 255)));
  EXPECT_EQ(same.pictures.size(), 1u);
  EXPECT_EQ(same.materials.at(0).alpha_mode, AlphaMode::mask);
  EXPECT_EQ(same.materials[0].alpha_cutoff, 0.5);

  // It has none: its luminance is, 0.2126 R + 0.7152 G + 0.0722 B; without map_Kd the colours are white.
  const Scene grey =
      read_with({"newmtl m\nmap_d a.png\n", png({{255, 0, 0, 255}, {10, 200, 30, 255}, {7, 7, 7, 255}})});
  EXPECT_THAT(grey.pictures.at(0).texels, ElementsAre(glm::u8vec4(255, 255, 255, 54), glm::u8vec4(255, 255, 255, 147),
                                                      glm::u8vec4(255, 255, 255, 7)));
}

TEST(MtlFile, AnOpacityMapOfAnotherSizeIsLookedUpAtTexelCentres) {
  // Four texels over a mask of two: 0 0 1 1; over one of three: 0, 1, 1, 2 (centres at 1/8, 3/8, 5/8, 7/8).
  const auto alphas = [](const std::string& mask) {
    const TemporaryFolder folder;
    folder.write("mask.png", mask);
    const std::string mtl = "newmtl m\nmap_Kd a.png\nmap_d mask.png\n";
    const std::string path = write_with(folder, "usemtl m\nf 1 2 3\n",
                                        {mtl, png({{1, 1, 1, 255}, {2, 2, 2, 255}, {3, 3, 3, 255}, {4, 4, 4, 255}})});
    std::vector<int> list;
    const Scene scene = read_model_file(path);
    for (const auto& t : scene.pictures.at(0).texels) list.push_back(t.a);
    return list;
  };
  EXPECT_THAT(alphas(png({{0, 0, 0, 10}, {0, 0, 0, 20}})), ElementsAre(10, 10, 20, 20));
  EXPECT_THAT(alphas(png({{0, 0, 0, 10}, {0, 0, 0, 20}, {0, 0, 0, 30}})), ElementsAre(10, 20, 20, 30));
}

TEST(MtlFile, PicturesOfUnusedMaterialsAreNotRead) {
  EXPECT_TRUE(read_with({"newmtl unused\nmap_Kd none.png\nnewmtl m\n", ""}).pictures.empty());
}

TEST(ObjErrors, NameTheLine) {
  EXPECT_EQ(error(kSquare + "f 1 2 5\n"),
            "line 5: vertex 5: expected 1 to 4, or as much below 0: there are 4 up to here");
  EXPECT_THAT(error(kSquare + "f 1 2 0\n"), HasSubstr("line 5: vertex 0: expected 1 to 4"));
  EXPECT_THAT(error(kSquare + "f 1 2 -5\n"), HasSubstr("line 5: vertex -5: expected 1 to 4"));
  EXPECT_THAT(error(kSquare + "f 1 2 99999999999999999999\n"), HasSubstr("line 5: expected v, v/vt, v//vn or v/vt/vn"));
  EXPECT_THAT(error(kSquare + "f 1/1 2 3\n"), HasSubstr("line 5: texture coordinate 1: expected 1 to 0"));
  EXPECT_THAT(error(kSquare + "f 1//1 2 3\n"), HasSubstr("line 5: normal 1: expected 1 to 0"));
  EXPECT_EQ(error(kSquare + "f 1 2\n"), "line 5: a face of 2 vertices: expected at least 3");
  EXPECT_EQ(error(kSquare + "l 1\n"), "line 5: a line of 1 vertices: expected at least 2");
  EXPECT_EQ(error(kSquare + "f 1 2 x\n"), "line 5: expected v, v/vt, v//vn or v/vt/vn, found \"x\"");
  EXPECT_EQ(error("v 1 2\n"), "line 1: expected x y z, found the end of the line");
  EXPECT_EQ(error("\nv 1 2 1,5\n"), "line 2: expected x y z, found \"1,5\"");
  EXPECT_EQ(error("v 1 2 nan\n"), "line 1: expected x y z, found \"nan\"");
  EXPECT_EQ(error("v 1 2 1e39\n"), "line 1: expected x y z, found \"1e39\"");
  EXPECT_EQ(error("v 0 0 \\\n0\nv 1\n"), "line 3: expected x y z, found the end of the line");
  EXPECT_EQ(error(kSquare + "surf 0 1 0 1 1 2\n"),
            "line 5: \"surf\" is not read: expected v, vt, vn, f, l, p, o, g, usemtl or mtllib");
}

TEST(ObjErrors, ALongConcaveFaceIsNamed) {
  std::string text, face = "f";
  for (int i = 1; i <= 2100; ++i) {
    text += "v " + std::to_string(i) + " " + std::to_string(i % 2) + " 0\n";
    face += " " + std::to_string(i);
  }
  EXPECT_EQ(error(text + "v 0 9 0\n" + face + " 2101\n"),
            "line 2102: a concave face of 2101 vertices: expected at most 2048");
}

TEST(ObjErrors, LibrariesAndPicturesThatAreNotThereAreNamedWithTheirLine) {
  const TemporaryFolder folder;
  EXPECT_EQ(model_error(folder.write("a.obj", "v 0 0 0\nmtllib sub\\none.mtl\n")),
            "line 2: " + folder.path("sub/none.mtl") + ": cannot be read: No such file or directory");
  EXPECT_EQ(error_with({"newmtl x\n", ""}), "line 6: no material library has \"m\"");

  const TemporaryFolder other;
  const std::string path = write_with(other, "usemtl m\nf 1 2 3\n", {"newmtl m\nmap_Kd none.png\n", ""});
  try {
    (void)read_model_file(path);
    ADD_FAILURE() << "no error";
  } catch (const Error& e) {
    EXPECT_EQ(e.what(), other.path("a.mtl") + ": line 2: " + other.path("none.png") +
                            ": cannot be read: No such file or directory");
  }
}

TEST(MtlErrors, NameTheLine) {
  const auto error_of = [](const std::string& mtl) {
    try {
      (void)read_with({mtl, ""});
    } catch (const Error& e) {
      const std::string text = e.what();
      return text.substr(text.find("a.mtl"));
    }
    return std::string("no error");
  };
  EXPECT_EQ(error_of("Kd 1 1 1\n"), "a.mtl: line 1: \"Kd\" before the first \"newmtl\"");
  EXPECT_EQ(error_of("newmtl m\nKd a b c\n"), "a.mtl: line 2: expected a colour, r g b, found \"a\"");
  EXPECT_EQ(error_of("newmtl m\nmap_Kd\n"), "a.mtl: line 2: expected a picture's name, found the end of the line");
  EXPECT_EQ(error_of("newmtl m\nmap_Kd -mm 0 2 a.png\n"),
            "a.mtl: line 2: the option -mm is not read: expected a picture without it");
  EXPECT_EQ(error_of("newmtl m\nmap_Kd -x a.png\n"), "a.mtl: line 2: unknown option \"-x\" before a picture's name");
  EXPECT_EQ(error_of("newmtl m\nmap_Kd -clamp a.png\n"), "a.mtl: line 2: expected on or off, found \"a.png\"");
}

}  // namespace
}  // namespace lode::geometry

/// Real models: every model file in the folder that the environment variable LODESTONE_ASSETS names is read, and its
/// counts and its box are those of the folder's INDEX.tsv.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "geometry/error.h"
#include "geometry/model_file.h"

namespace lode::geometry {
namespace {

/// A line of INDEX.tsv by the names of its columns.
using Row = std::map<std::string, std::string>;

std::vector<Row> read_index(const std::string& path) {
  std::ifstream file(path);
  std::vector<std::string> names;
  std::vector<Row> rows;
  for (std::string line; std::getline(file, line);) {
    std::istringstream cells(line);
    std::vector<std::string> row;
    for (std::string cell; std::getline(cells, cell, '\t');) row.push_back(cell);
    if (names.empty()) {
      names = row;
      continue;
    }
    Row& by_name = rows.emplace_back();
    for (std::size_t i = 0; i < row.size() && i < names.size(); ++i) by_name[names[i]] = row[i];
  }
  return rows;
}

glm::dvec3 point(const std::string& text) {
  glm::dvec3 p;
  std::istringstream(text) >> p.x >> p.y >> p.z;
  return p;
}

/// Vertices and triangles of all draws.
struct Counts {
  std::size_t vertices = 0, triangles = 0;
};
Counts counts(const Scene& scene) {
  Counts n;
  for (const Instance& i : scene.instances) {
    const Mesh& mesh = scene.meshes[i.mesh];
    n.vertices += mesh.positions.size();
    if (mesh.kind == MeshKind::triangles) n.triangles += mesh.n_primitives();
  }
  return n;
}

void check_consistent(const Scene& scene) {
  for (const Mesh& mesh : scene.meshes) {
    for (const std::uint32_t i : mesh.indices) ASSERT_LT(i, mesh.positions.size());
    for (const std::size_t n : {mesh.normals.size(), mesh.uvs.size(), mesh.colors.size()}) {
      EXPECT_TRUE(n == 0 || n == mesh.positions.size());
    }
    ASSERT_TRUE(!mesh.material || *mesh.material < scene.materials.size());
  }
  for (const Material& m : scene.materials) {
    EXPECT_TRUE(!m.color_texture || m.color_texture->picture < scene.pictures.size());
  }
}

TEST(ModelAssets, AreReadWithTheCountsOfTheIndex) {
  const char* const folder = std::getenv("LODESTONE_ASSETS");
  if (!folder) GTEST_SKIP() << "LODESTONE_ASSETS names no folder of models";
  std::size_t n_read = 0;
  for (const Row& row : read_index(std::string(folder) + "/INDEX.tsv")) {
    const std::string& path = row.at("path");
    if (!is_model_file(path)) continue;
    SCOPED_TRACE(path);
    try {
      const Scene scene = read_model_file(std::string(folder) + "/" + path);
      check_consistent(scene);
      EXPECT_EQ(std::to_string(counts(scene).triangles), row.at("triangles"));
      // The index counts an OBJ file's "v" lines: vertices are as many where nothing else tells them apart.
      const bool positions_alone = row.at("uv") == "0" && row.at("normals") == "0" && row.at("materials") == "0";
      if (!path.ends_with(".obj") || (positions_alone && row.at("watertight") == "yes")) {
        EXPECT_EQ(std::to_string(counts(scene).vertices), row.at("vertices"));
      }
      const Bounds box = scene.bounds();
      const double tolerance = 1e-5 * box.diagonal();  // the index has six digits
      EXPECT_LE(glm::length(box.low - point(row.at("bbox_min"))), tolerance);
      EXPECT_LE(glm::length(box.high - point(row.at("bbox_max"))), tolerance);
      ++n_read;
    } catch (const Error& error) {
      ADD_FAILURE() << error.what();
    }
  }
  EXPECT_GT(n_read, 0u);
  std::printf("%zu models read\n", n_read);
}

}  // namespace
}  // namespace lode::geometry

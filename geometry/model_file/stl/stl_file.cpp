#include "geometry/model_file/stl/stl_file.h"

#include <cmath>
#include <numeric>
#include <utility>

#include "geometry/error.h"
#include "geometry/loads.h"
#include "geometry/model_file/line_reader.h"
#include "geometry/model_file/model_files.h"
#include "geometry/procedural.h"

namespace lode::geometry {
namespace {

constexpr std::size_t kHeader = 84;  // 80 bytes of anything, and the count
constexpr std::size_t kFacet = 50;   // a normal, three corners, 16 bits of anything

/// What a facet takes in a mesh, while flat normals are made of another one.
constexpr std::size_t kFacetBytes = 2 * 3 * (sizeof(glm::vec3) + sizeof(std::uint32_t)) + 3 * sizeof(glm::vec3);

bool is_binary(std::span<const std::byte> bytes) {
  return bytes.size() >= kHeader &&
         std::uint64_t(load_le<std::uint32_t>(bytes, kHeader - 4)) * kFacet == bytes.size() - kHeader;
}

Mesh read_binary(ModelFiles& files, std::span<const std::byte> bytes) {
  const std::size_t n = (bytes.size() - kHeader) / kFacet;
  files.budget.take(n * kFacetBytes, files.model_path());
  Mesh mesh;
  mesh.positions.reserve(3 * n);
  for (std::size_t i = 0; i < 3 * n; ++i) {
    const std::size_t at = kHeader + i / 3 * kFacet + 12 * (1 + i % 3);
    const auto p = load_le<glm::vec3>(bytes, at);
    if (!(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z))) {
      throw Error(ErrorKind::bad_input, files.model_path() + ": facet " + std::to_string(i / 3) + ", byte " +
                                            std::to_string(at) + ": a corner that is not finite");
    }
    mesh.positions.push_back(p);
  }
  return mesh;
}

/// Facets as words, whatever the lines.
class AsciiReader {
 public:
  AsciiReader(ModelFiles& files, std::string_view text) : files_(files), lines_(text, files.model_path(), false) {}

  Mesh read() {
    expect("solid");
    (void)lines_.words.rest();  // a name
    lines_.words.left = {};
    for (std::string_view key = word(); key != "endsolid"; key = word()) {
      if (key != "facet") lines_.fail_expected("facet or endsolid", key);
      read_facet();
    }
    return std::move(mesh_);
  }

 private:
  /// The next word of the text.
  std::string_view word() {
    for (;;) {
      if (const std::string_view next = lines_.word(); !next.empty()) return next;
      if (!lines_.next_line()) lines_.fail("the file ends: expected endsolid");
    }
  }

  void expect(std::string_view expected) {
    if (const std::string_view found = word(); found != expected) lines_.fail_expected(expected, found);
  }

  float number() {
    const std::string_view found = word();
    float value = 0.0f;
    if (!parse_number(found, value)) lines_.fail_expected("a number", found);
    return value;
  }

  void read_facet() {
    files_.budget.take(2 * kFacetBytes, files_.model_path());
    expect("normal");
    for (int i = 0; i < 3; ++i) (void)word();
    expect("outer");
    expect("loop");
    for (int i = 0; i < 3; ++i) {
      expect("vertex");
      const float x = number(), y = number(), z = number();
      mesh_.positions.emplace_back(x, y, z);
    }
    expect("endloop");
    expect("endfacet");
  }

  ModelFiles& files_;
  LineReader lines_;
  Mesh mesh_;
};

Mesh read_mesh(ModelFiles& files, const FileBytes& file) {
  if (is_binary(file.span())) return read_binary(files, file.span());
  if (file.text().starts_with("solid")) return AsciiReader(files, file.text()).read();
  if (file.n < kHeader) throw Error(ErrorKind::bad_input, files.model_path() + ": expected an STL file");
  const std::uint64_t count = load_le<std::uint32_t>(file.span(), kHeader - 4);
  throw Error(ErrorKind::bad_input, files.model_path() + ": byte 80: claims " + std::to_string(count) +
                                        " facets: expected a file of " + std::to_string(kHeader + kFacet * count) +
                                        " bytes, found " + std::to_string(file.n));
}

}  // namespace

Scene read_stl(const std::string& path) {
  ModelFiles files(path);
  Mesh mesh = read_mesh(files, files.read(path, ""));
  mesh.indices.resize(mesh.positions.size());
  std::iota(mesh.indices.begin(), mesh.indices.end(), 0u);
  Material material;
  material.double_sided = true;
  Scene scene = scene_of(with_flat_normals(mesh), material);
  scene.name = path;
  scene.files = files.paths();
  return scene;
}

}  // namespace lode::geometry

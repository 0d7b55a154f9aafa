// libFuzzer target of the model readers: the first byte says as what file the others are read, beside a few small files
// that it may name. Whatever they are, there is a scene whose indices lead somewhere, or one Error in one line.
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "geometry/error.h"
#include "geometry/model_file.h"
#include "tests/geometry/small_models.h"
#include "tests/geometry/temporary_folder.h"

namespace {

using namespace lode::geometry;

[[noreturn]] void broken(const std::string& claim) {
  std::fprintf(stderr, "model_fuzzer: %s\n", claim.c_str());
  std::abort();
}

void check(bool holds, const char* claim) {
  if (!holds) broken(claim);
}

void check(const Scene& scene) {
  for (const Mesh& mesh : scene.meshes) {
    const std::size_t n = mesh.positions.size();
    check(mesh.indices.size() % corners_per_primitive(mesh.kind) == 0, "a primitive without all of its corners");
    for (const std::uint32_t index : mesh.indices) check(index < n, "an index that leads nowhere");
    for (const std::size_t m : {mesh.normals.size(), mesh.uvs.size(), mesh.colors.size()}) {
      check(m == 0 || m == n, "an attribute without a value for each vertex");
    }
    check(!mesh.material || *mesh.material < scene.materials.size(), "a material that is not there");
  }
  for (const Material& material : scene.materials) {
    check(!material.color_texture || material.color_texture->picture < scene.pictures.size(),
          "a picture that is not there");
  }
  for (const Instance& instance : scene.instances) {
    check(instance.mesh < scene.meshes.size() && instance.node < scene.nodes.size(), "an instance of nothing");
  }
  for (const Picture& picture : scene.pictures) {
    check(picture.texels.size() == std::size_t(picture.size_px.x) * std::size_t(picture.size_px.y),
          "a picture of another size");
  }
}

/// The folder that files are read from, with what they may name.
const lode::tests::TemporaryFolder& folder() {
  static const lode::tests::TemporaryFolder made;
  static const bool is_filled = [] {
    made.write("a.png", lode::tests::small_png());
    made.write("a.mtl", lode::tests::small_mtl());
    made.write("m.obj", "mtllib m.mtl\nv 0 0 0\nusemtl m\np 1\n");
    return true;
  }();
  (void)is_filled;
  return made;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t n) {
  if (n < 1) return 0;
  constexpr const char* kNames[] = {"f.gltf", "f.glb", "f.obj", "m.mtl", "f.ply", "f.stl"};
  const std::string name = kNames[data[0] % std::size(kNames)];
  const std::string path = folder().write(name, {reinterpret_cast<const char*>(data) + 1, n - 1});
  try {
    check(read_model_file(name == "m.mtl" ? folder().path("m.obj") : path));
  } catch (const Error& error) {
    const std::string_view text = error.what();
    if (text.find('\n') != std::string_view::npos) broken("an error of more than one line");
    if (error.kind() != ErrorKind::bad_input) broken(error.what());
  }
  return 0;
}

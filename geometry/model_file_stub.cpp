#include "geometry/error.h"
#include "geometry/model_file.h"

namespace lode::geometry {

bool is_model_file(const std::string& path) {
  for (const char* ending : {".gltf", ".glb", ".obj", ".ply", ".stl"}) {
    if (path.ends_with(ending)) return true;
  }
  return false;
}

Scene read_model_file(const std::string& path) {
  throw Error(ErrorKind::bad_input, path + ": model files cannot be read");
}

}  // namespace lode::geometry

#include "geometry/model_file.h"

#include <algorithm>
#include <new>
#include <string_view>

#include "geometry/error.h"
#include "geometry/model_file/gltf/gltf_file.h"
#include "geometry/model_file/obj/obj_file.h"
#include "geometry/model_file/ply/ply_file.h"
#include "geometry/model_file/stl/stl_file.h"

namespace lode::geometry {
namespace {

using Reader = Scene (*)(const std::string& path);

struct Format {
  std::string_view ending;
  Reader read;
};
constexpr Format kFormats[] = {
    {".gltf", read_gltf}, {".glb", read_gltf}, {".obj", read_obj}, {".ply", read_ply}, {".stl", read_stl}};

/// What reads files with the path's ending, or null.
Reader reader_of(std::string_view path) {
  for (const Format& format : kFormats) {
    const std::size_t n = format.ending.size();
    // A bare ".obj" is a hidden file's name, not an ending.
    if (path.size() <= n || path[path.size() - n - 1] == '/') continue;
    if (std::equal(format.ending.begin(), format.ending.end(), path.end() - std::ptrdiff_t(n),
                   [](char a, char b) { return a == (b >= 'A' && b <= 'Z' ? char(b - 'A' + 'a') : b); })) {
      return format.read;
    }
  }
  return nullptr;
}

}  // namespace

bool is_model_file(const std::string& path) { return reader_of(path) != nullptr; }

Scene read_model_file(const std::string& path) {
  const Reader read = reader_of(path);
  if (!read) {
    throw Error(ErrorKind::bad_input, path + ": unknown ending: expected .gltf, .glb, .obj, .ply or .stl");
  }
  try {
    return read(path);
  } catch (const std::bad_alloc&) {
    throw Error(ErrorKind::machine, path + ": no memory to read it");
  }
}

}  // namespace lode::geometry

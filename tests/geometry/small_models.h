#pragma once
/// A small file of each format with something of everything in it, and a mesh in the formats of one mesh.

#include <array>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include "geometry/mesh.h"
#include "tests/geometry/gltf_builder.h"
#include "tests/geometry/png_bytes.h"

namespace lode::tests {

inline std::string small_png() {
  const std::array<int, 4> texels[] = {{255, 0, 0, 255}, {0, 255, 0, 128}, {0, 0, 255, 0}, {9, 9, 9, 255}};
  return rgba_png(2, 2, texels);
}

inline GltfBuilder small_gltf() {
  GltfBuilder file;
  auto& primitive = file.primitive({{"POSITION", file.floats("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0})}});
  primitive["indices"] = file.accessor(file.view(bytes_of<std::uint16_t>({0, 1, 2, 3})), 5123, "SCALAR", 4);
  primitive["mode"] = 5;
  primitive["material"] = 0;
  primitive["attributes"]["TEXCOORD_0"] = file.floats("VEC2", {0, 0, 1, 0, 0, 1, 1, 1});
  primitive["attributes"]["COLOR_0"] = file.accessor(file.view(std::string(16, '\x7F')), 5121, "VEC4", 4);
  file.json["accessors"][std::size_t(primitive["attributes"]["COLOR_0"])]["normalized"] = true;
  file.json["accessors"][0]["sparse"] = {
      {"count", 1},
      {"indices", {{"bufferView", file.view(bytes_of<std::uint8_t>({3}))}, {"componentType", 5121}}},
      {"values", {{"bufferView", file.view(bytes_of<float>({2, 2, 0}))}}}};
  file.json["images"] = {{{"bufferView", file.view(small_png())}, {"mimeType", "image/png"}}};
  file.json["samplers"] = {{{"wrapS", 33648}, {"minFilter", 9729}}};
  file.json["textures"] = {{{"source", 0}, {"sampler", 0}}};
  nlohmann::json texture = {{"index", 0}};
  texture["extensions"]["KHR_texture_transform"] = {{"scale", {2, 3}}, {"rotation", 1}, {"offset", {0.5, 0}}};
  file.json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", texture}}}, {"alphaMode", "MASK"}}};
  file.json["nodes"][0]["rotation"] = {0, 0.6, 0, 0.8};
  file.json["nodes"].push_back({{"camera", 0}, {"children", {0}}, {"scale", {2, 1, 1}}});
  file.json["scenes"][0]["nodes"] = {1};
  file.json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0.1}}}}};
  return file;
}

/// Names "a.mtl", and that "a.png".
inline std::string small_obj() {
  return "mtllib a.mtl\no box\nv 0 0 0 1 0 0\nv 2 0 0\nv 2 2 0\nv 1 0.5 0\nv -1e-3 2 0.25\nvt 0 0\nvt 1 1\nvn 0 0 1\n"
         "usemtl m\nf 1/1/1 2/2/1 3//1 4 -1/-1/-1\ng more\nl 1 2 3\np 1 5\nf 1 2 \\\n 3\n";
}
inline std::string small_mtl() {
  return "newmtl m\nKd 0.5 1 0.25\nd 0.5\nmap_Kd -s 2 2 -clamp on a.png\nmap_d -s 2 2 a.png\n";
}

enum class PlyKind { ascii, little_endian, big_endian };

template <class T>
void append_number(std::string& bytes, T value, bool big) {
  std::string number = bytes_of<T>({value});
  if (big) number = std::string(number.rbegin(), number.rend());
  bytes += number;
}

/// Positions and triangles as PLY.
inline std::string as_ply(const geometry::Mesh& mesh, PlyKind kind) {
  constexpr const char* kFormats[] = {"ascii", "binary_little_endian", "binary_big_endian"};
  std::string bytes = std::string("ply\nformat ") + kFormats[int(kind)] + " 1.0\nelement vertex " +
                      std::to_string(mesh.positions.size()) +
                      "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
                      std::to_string(mesh.n_primitives()) + "\nproperty list uchar int vertex_indices\nend_header\n";
  const bool big = kind == PlyKind::big_endian, ascii = kind == PlyKind::ascii;
  for (const glm::vec3& p : mesh.positions) {
    for (int c = 0; c < 3; ++c) {
      if (ascii) bytes += std::to_string(p[c]) + (c == 2 ? "\n" : " ");
      if (!ascii) append_number(bytes, p[c], big);
    }
  }
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    if (i % 3 == 0) bytes += ascii ? "3" : "\3";
    if (ascii) bytes += " " + std::to_string(mesh.indices[i]) + (i % 3 == 2 ? "\n" : "");
    if (!ascii) append_number(bytes, std::int32_t(mesh.indices[i]), big);
  }
  return bytes;
}

inline std::string as_stl(const geometry::Mesh& mesh, bool ascii) {
  std::string bytes = ascii ? "solid s\n" : std::string(80, 's');
  if (!ascii) append_number(bytes, std::uint32_t(mesh.n_primitives()), false);
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    const glm::vec3& p = mesh.positions[mesh.indices[i]];
    if (ascii) {
      if (i % 3 == 0) bytes += "facet normal 0 0 0\nouter loop\n";
      bytes += "vertex " + std::to_string(p.x) + " " + std::to_string(p.y) + " " + std::to_string(p.z) + "\n";
      if (i % 3 == 2) bytes += "endloop\nendfacet\n";
    } else {
      if (i % 3 == 0) bytes += std::string(12, '\0');
      for (int c = 0; c < 3; ++c) append_number(bytes, p[c], false);
      if (i % 3 == 2) bytes += std::string(2, '\0');
    }
  }
  return ascii ? bytes + "endsolid s\n" : bytes;
}

/// A file that is read alone, or with those that stand before it: (name, bytes), the one to read last.
using SmallFiles = std::vector<std::pair<std::string, std::string>>;

/// Every format, text and binary.
inline std::vector<SmallFiles> small_models() {
  geometry::Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.5f, 0.25f, -2}};
  mesh.indices = {0, 1, 2, 0, 2, 3};
  return {{{"a.gltf", small_gltf().gltf()}},
          {{"a.glb", small_gltf().glb()}},
          {{"a.png", small_png()}, {"a.mtl", small_mtl()}, {"a.obj", small_obj()}},
          {{"a.ply", as_ply(mesh, PlyKind::ascii)}},
          {{"a.ply", as_ply(mesh, PlyKind::little_endian)}},
          {{"a.ply", as_ply(mesh, PlyKind::big_endian)}},
          {{"a.stl", as_stl(mesh, true)}},
          {{"a.stl", as_stl(mesh, false)}}};
}

}  // namespace lode::tests

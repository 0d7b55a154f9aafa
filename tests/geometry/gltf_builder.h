#pragma once
/// glTF files put together in a test: JSON, and one buffer that accessors are appended to.

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace lode::tests {

/// RFC 4648, sec. 4.
inline std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      bits = bits << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += i + k > bytes.size() ? '=' : kDigits[bits >> (18 - 6 * k) & 63];
    }
  }
  return text;
}

template <class T>
std::string bytes_of(const std::vector<T>& values) {
  std::string bytes(values.size() * sizeof(T), '\0');
  if (!values.empty()) std::memcpy(bytes.data(), values.data(), bytes.size());
  return bytes;
}

inline std::string little_endian(std::uint32_t v) { return bytes_of<std::uint32_t>({v}); }

class GltfBuilder {
 public:
  GltfBuilder() { json["asset"]["version"] = "2.0"; }

  /// Appends bytes and returns their buffer view. `stride` is left out if it is 0.
  std::size_t view(const std::string& bytes, int stride = 0) {
    nlohmann::json v = {{"buffer", 0}, {"byteOffset", buffer.size()}, {"byteLength", bytes.size()}};
    if (stride != 0) v["byteStride"] = stride;
    buffer += bytes;
    json["bufferViews"].push_back(v);
    return json["bufferViews"].size() - 1;
  }

  std::size_t accessor(std::size_t buffer_view, int component_type, const char* type, std::size_t count) {
    json["accessors"].push_back(
        {{"bufferView", buffer_view}, {"componentType", component_type}, {"type", type}, {"count", count}});
    return json["accessors"].size() - 1;
  }

  /// Packed floats of a type such as "VEC3".
  std::size_t floats(const char* type, const std::vector<float>& values) {
    const std::size_t n = std::string_view(type) == "SCALAR" ? 1 : std::size_t(type[3] - '0');
    return accessor(view(bytes_of(values)), 5126, type, values.size() / n);
  }
  std::size_t indices(const std::vector<std::uint32_t>& values) {
    return accessor(view(bytes_of(values)), 5125, "SCALAR", values.size());
  }

  /// A mesh of one primitive, and a node for it in the scene; returns the primitive.
  nlohmann::json& primitive(const nlohmann::json& attributes) {
    json["meshes"].push_back({{"primitives", {{{"attributes", attributes}}}}});
    json["nodes"].push_back({{"mesh", json["meshes"].size() - 1}});
    json["scenes"][0]["nodes"].push_back(json["nodes"].size() - 1);
    return json["meshes"].back()["primitives"][0];
  }

  /// The file, with the buffer inside its JSON.
  [[nodiscard]] std::string gltf() const {
    nlohmann::json document = json;
    if (!buffer.empty()) {
      document["buffers"] = {
          {{"byteLength", buffer.size()}, {"uri", "data:application/octet-stream;base64," + base64(buffer)}}};
    }
    return document.dump();
  }

  /// The same as a GLB.
  [[nodiscard]] std::string glb() const {
    nlohmann::json document = json;
    document["buffers"] = {{{"byteLength", buffer.size()}}};
    std::string text = document.dump(), binary = buffer;
    while (text.size() % 4 != 0) text += ' ';
    while (binary.size() % 4 != 0) binary += '\0';
    const std::string chunks = little_endian(std::uint32_t(text.size())) + "JSON" + text +
                               little_endian(std::uint32_t(binary.size())) + std::string("BIN\0", 4) + binary;
    return "glTF" + little_endian(2) + little_endian(std::uint32_t(12 + chunks.size())) + chunks;
  }

  nlohmann::json json;
  std::string buffer;
};

}  // namespace lode::tests

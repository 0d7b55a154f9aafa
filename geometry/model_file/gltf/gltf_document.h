#pragma once
/// A glTF file's JSON and the bytes that it refers to. References from one top-level array to another are followed
/// here, so that an index that leads nowhere is told with the place where it stands.

#include <cstddef>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/json/json_view.h"
#include "geometry/model_file/model_files.h"

namespace lode::geometry {

/// A part of a buffer. glTF 2.0, sec. 5.11.
struct BufferView {
  std::span<const std::byte> bytes;
  std::optional<std::size_t> stride;  ///< between elements, in bytes; nothing: they are packed
};

class GltfDocument {
 public:
  /// Reads the file, .gltf or .glb by its first bytes. Throws Error (bad_input) for what is not glTF 2 or requires an
  /// extension that we do not know.
  explicit GltfDocument(ModelFiles& files);
  GltfDocument(const GltfDocument&) = delete;
  GltfDocument& operator=(const GltfDocument&) = delete;

  [[nodiscard]] ModelFiles& files() { return files_; }
  [[nodiscard]] const JsonView& root() const { return root_; }

  /// A top-level array such as "nodes": how many there are, and one of them.
  [[nodiscard]] std::size_t count(std::string_view array) const;
  [[nodiscard]] JsonView element(std::string_view array, std::size_t index) const;
  /// The element that a reference (an index) leads to.
  [[nodiscard]] JsonView target(const JsonView& reference, std::string_view array) const;

  /// The bytes that a reference to a buffer view leads to. Buffers are read when they are first needed.
  [[nodiscard]] BufferView buffer_view(const JsonView& reference);

 private:
  /// One of "buffers", read.
  struct Buffer {
    std::span<const std::byte> bytes;
    FileBytes file;
    std::vector<std::byte> decoded;
  };

  void check_version() const;
  void check_extensions() const;
  const Buffer& buffer(const JsonView& reference);
  void read_uri(const JsonView& view, Buffer& buffer);

  ModelFiles& files_;
  FileBytes file_;
  std::optional<std::span<const std::byte>> binary_chunk_;
  nlohmann::json json_;
  JsonView root_;
  std::map<std::string_view, JsonView> arrays_;  ///< views point to them
  std::map<std::size_t, Buffer> buffers_;
};

}  // namespace lode::geometry

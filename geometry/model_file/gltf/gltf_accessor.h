#pragma once
/// Accessors: arrays of numbers inside the buffers of a glTF file. glTF 2.0, sec. 3.6.2. All component types,
/// normalized, strided, sparse, and without a buffer view (zeros). Results are checked against the memory budget
/// before they are allocated.

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "geometry/model_file/gltf/gltf_document.h"

namespace lode::geometry {

/// Where an accessor's elements lie, before they are read.
struct AccessorLayout {
  JsonView view;             ///< the accessor
  std::size_t count;         ///< of elements
  int component_type;        ///< 5120 to 5126, as the file has it
  std::size_t n_components;  ///< of an element: 1 to 4
  bool normalized;
};

/// What the accessor says of itself that a reference leads to. Throws Error (bad_input) for matrices.
[[nodiscard]] AccessorLayout accessor_layout(GltfDocument& document, const JsonView& reference);

/// Elements of two, three or four components as floats; normalized integers become −1…1 or 0…1 (sec. 3.6.2.2).
/// Throws Error (bad_input) if elements have another number of components than the accessor's.
[[nodiscard]] std::vector<glm::vec2> read_vec2(GltfDocument& document, const JsonView& reference);
[[nodiscard]] std::vector<glm::vec3> read_vec3(GltfDocument& document, const JsonView& reference);
[[nodiscard]] std::vector<glm::vec4> read_vec4(GltfDocument& document, const JsonView& reference);

/// Vertex indices. Throws Error (bad_input), naming the element, for one that is not below `n_vertices`.
[[nodiscard]] std::vector<std::uint32_t> read_indices(GltfDocument& document, const JsonView& reference,
                                                      std::size_t n_vertices);

}  // namespace lode::geometry

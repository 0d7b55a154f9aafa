#include "geometry/model_file/gltf/gltf_accessor.h"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <span>
#include <string>

#include "geometry/loads.h"

namespace lode::geometry {
namespace {

// glTF 2.0, sec. 3.6.2.2.
enum ComponentType { kByte = 5120, kUnsignedByte, kShort, kUnsignedShort, kUnsignedInt = 5125, kFloat };

int read_component_type(const JsonView& view) {
  const std::int64_t type = view.integer(kByte, kFloat);
  if (type == 5124) view.fail_expected("5120 to 5123, 5125 or 5126");
  return int(type);
}

std::size_t component_size(int type) {
  switch (type) {
    case kByte:
    case kUnsignedByte:
      return 1;
    case kShort:
    case kUnsignedShort:
      return 2;
    default:
      return 4;
  }
}

/// Elements as they lie in a buffer: element i begins at i · stride.
struct Elements {
  std::span<const std::byte> bytes;
  std::size_t stride = 0, count = 0;
};

/// `count` elements of `size` bytes in the buffer view that `holder` (an accessor, or a part of a sparse one) names.
/// All of the last element is inside.
Elements elements(GltfDocument& document, const JsonView& holder, std::size_t count, std::size_t size) {
  const JsonView reference = holder.require("bufferView");
  const BufferView view = document.buffer_view(reference);
  const auto offset_view = holder.find("byteOffset");
  const std::int64_t n = std::int64_t(view.bytes.size());
  const auto offset = std::size_t(offset_view ? offset_view->integer(0, n) : 0);
  const std::size_t stride = view.stride.value_or(size), left = view.bytes.size() - offset;
  if (count > 0 && (left < size || (left - size) / stride < count - 1)) {
    holder.fail(std::to_string(count) + " elements of " + std::to_string(size) + " bytes, " + std::to_string(stride) +
                " apart: the buffer view holds " + std::to_string(left) + " bytes");
  }
  return {view.bytes.subspan(offset), stride, count};
}

/// A component as a float. Sec. 3.6.2.2: normalized integers are c / max, signed ones no less than −1.
template <class Component>
float as_float(Component c, bool normalized) {
  if constexpr (std::is_floating_point_v<Component>) {
    return c;
  } else {
    if (!normalized) return float(c);
    return std::max(float(c) / float(std::numeric_limits<Component>::max()), -1.0f);
  }
}

template <class Component, int N>
void convert(const Elements& from, bool normalized, glm::vec<N, float>* to) {
  for (std::size_t i = 0; i < from.count; ++i) {
    for (int c = 0; c < N; ++c) {
      to[i][c] =
          as_float(load_le<Component>(from.bytes, i * from.stride + std::size_t(c) * sizeof(Component)), normalized);
    }
  }
}

template <int N>
void convert(const Elements& from, const AccessorLayout& layout, glm::vec<N, float>* to) {
  switch (layout.component_type) {
    case kByte:
      return convert<std::int8_t, N>(from, layout.normalized, to);
    case kUnsignedByte:
      return convert<std::uint8_t, N>(from, layout.normalized, to);
    case kShort:
      return convert<std::int16_t, N>(from, layout.normalized, to);
    case kUnsignedShort:
      return convert<std::uint16_t, N>(from, layout.normalized, to);
    case kFloat:
      if (from.stride == sizeof *to && from.count > 0) {
        std::memcpy(to, from.bytes.data(), from.count * sizeof *to);
        return;
      }
      return convert<float, N>(from, false, to);
    default:
      layout.view.require("componentType").fail_expected("floats, bytes or shorts");
  }
}

void widen(const Elements& from, int type, std::uint32_t* to) {
  if (type == kUnsignedInt && from.stride == 4 && from.count > 0) {
    std::memcpy(to, from.bytes.data(), from.count * 4);
    return;
  }
  for (std::size_t i = 0; i < from.count; ++i) {
    const std::size_t at = i * from.stride;
    to[i] = type == kUnsignedByte    ? load_le<std::uint8_t>(from.bytes, at)
            : type == kUnsignedShort ? load_le<std::uint16_t>(from.bytes, at)
                                     : load_le<std::uint32_t>(from.bytes, at);
  }
}

bool is_index_type(int type) { return type == kUnsignedByte || type == kUnsignedShort || type == kUnsignedInt; }

/// The first element that is not below n, or the number of elements.
std::size_t first_beyond(const std::vector<std::uint32_t>& indices, std::size_t n) {
  std::uint32_t greatest = 0;  // a loop that vectorizes decides for nearly all files
  for (const std::uint32_t index : indices) greatest = std::max(greatest, index);
  if (greatest < n) return indices.size();
  return std::size_t(std::find_if(indices.begin(), indices.end(), [&](std::uint32_t i) { return i >= n; }) -
                     indices.begin());
}

[[noreturn]] void fail_index(const JsonView& view, std::size_t element, std::uint32_t index, std::size_t n) {
  view.fail("element " + std::to_string(element) + ": index " + std::to_string(index) + ": expected less than " +
            std::to_string(n));
}

/// Which elements of an accessor a sparse one replaces, and where the new ones are. Sec. 3.6.2.3.
struct Sparse {
  std::vector<std::uint32_t> indices;
  Elements values;
};

Sparse read_sparse(GltfDocument& document, const JsonView& view, std::size_t count, std::size_t element_size) {
  const std::size_t n = std::size_t(view.require("count").integer(1, std::int64_t(count)));
  const JsonView indices = view.require("indices"), values = view.require("values");
  const JsonView type_view = indices.require("componentType");
  const int type = read_component_type(type_view);
  if (!is_index_type(type)) type_view.fail_expected("5121, 5123 or 5125");
  const Elements from = elements(document, indices, n, component_size(type));
  document.files().budget.take((4 + sizeof(glm::vec4)) * n, indices.place());  // and what replaces them
  Sparse sparse{std::vector<std::uint32_t>(n), elements(document, values, n, element_size)};
  widen(from, type, sparse.indices.data());
  if (const std::size_t bad = first_beyond(sparse.indices, count); bad < n) {
    fail_index(indices, bad, sparse.indices[bad], count);
  }
  return sparse;
}

/// All elements of an accessor: `convert_to(elements, to)` makes values of the bytes.
template <class Value, class Convert>
std::vector<Value> read_all(GltfDocument& document, const AccessorLayout& layout, Convert convert_to) {
  const std::size_t size = component_size(layout.component_type) * layout.n_components;
  // Bytes are looked at before memory is allocated; zeros without bytes are the budget's to refuse.
  Elements from;
  if (layout.view.find("bufferView")) from = elements(document, layout.view, layout.count, size);
  document.files().budget.take(layout.count * sizeof(Value), layout.view.place());
  std::vector<Value> values(layout.count);
  convert_to(from, values.data());
  if (const auto sparse_view = layout.view.find("sparse")) {
    const Sparse sparse = read_sparse(document, *sparse_view, layout.count, size);
    std::vector<Value> replacements(sparse.indices.size());
    convert_to(sparse.values, replacements.data());
    for (std::size_t i = 0; i < replacements.size(); ++i) values[sparse.indices[i]] = replacements[i];
  }
  return values;
}

template <int N>
std::vector<glm::vec<N, float>> read_vectors(GltfDocument& document, const JsonView& reference) {
  const AccessorLayout layout = accessor_layout(document, reference);
  if (layout.n_components != N) layout.view.require("type").fail_expected("\"VEC" + std::to_string(N) + "\"");
  return read_all<glm::vec<N, float>>(
      document, layout, [&](const Elements& from, glm::vec<N, float>* to) { convert<N>(from, layout, to); });
}

}  // namespace

AccessorLayout accessor_layout(GltfDocument& document, const JsonView& reference) {
  const JsonView view = document.target(reference, "accessors");
  const std::size_t count = std::size_t(view.require("count").integer(1, (std::int64_t(1) << 32) - 1));
  const int component_type = read_component_type(view.require("componentType"));
  const std::size_t type = view.require("type").choice({"SCALAR", "VEC2", "VEC3", "VEC4"});
  const auto normalized = view.find("normalized");
  return {view, count, component_type, type + 1, normalized && normalized->boolean()};
}

std::vector<glm::vec2> read_vec2(GltfDocument& document, const JsonView& reference) {
  return read_vectors<2>(document, reference);
}
std::vector<glm::vec3> read_vec3(GltfDocument& document, const JsonView& reference) {
  return read_vectors<3>(document, reference);
}
std::vector<glm::vec4> read_vec4(GltfDocument& document, const JsonView& reference) {
  return read_vectors<4>(document, reference);
}

std::vector<std::uint32_t> read_indices(GltfDocument& document, const JsonView& reference, std::size_t n_vertices) {
  const AccessorLayout layout = accessor_layout(document, reference);
  if (layout.n_components != 1) layout.view.require("type").fail_expected("\"SCALAR\"");
  if (!is_index_type(layout.component_type)) layout.view.require("componentType").fail_expected("5121, 5123 or 5125");
  std::vector<std::uint32_t> indices = read_all<std::uint32_t>(
      document, layout, [&](const Elements& from, std::uint32_t* to) { widen(from, layout.component_type, to); });
  if (const std::size_t bad = first_beyond(indices, n_vertices); bad < indices.size()) {
    fail_index(layout.view, bad, indices[bad], n_vertices);
  }
  return indices;
}

}  // namespace lode::geometry

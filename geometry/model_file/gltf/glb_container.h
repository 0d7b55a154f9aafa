#pragma once
/// The binary container of glTF: a header of 12 bytes, a chunk of JSON, and a chunk of bytes. glTF 2.0, sec. 4.4.

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace lode::geometry {

struct GlbChunks {
  std::string_view json;
  std::optional<std::span<const std::byte>> binary;
};

/// Whether a file begins as a GLB does.
[[nodiscard]] bool is_glb(std::span<const std::byte> bytes);

/// Views of the chunks; unknown ones are skipped. Throws Error (bad_input), naming the byte.
[[nodiscard]] GlbChunks glb_chunks(std::span<const std::byte> bytes, const std::string& name);

}  // namespace lode::geometry

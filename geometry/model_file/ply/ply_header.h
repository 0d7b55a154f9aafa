#pragma once
/// Headers of PLY files: G. Turk, "The PLY polygon file format" (1994). What elements there are, how many, and of which
/// properties each consists.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lode::geometry {

enum class PlyFormat : std::uint8_t { ascii, little_endian, big_endian };
enum class PlyType : std::uint8_t { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

[[nodiscard]] std::size_t ply_size(PlyType type);  ///< in bytes

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float32;    ///< of the value, or of the elements of a list
  std::optional<PlyType> list_count;  ///< of a list's length; nothing: it is no list
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;

  /// The property of this name, or of the other: its index.
  [[nodiscard]] std::optional<std::size_t> find(std::string_view name, std::string_view other = {}) const;
};

struct PlyHeader {
  PlyFormat format = PlyFormat::ascii;
  std::vector<PlyElement> elements;
  std::size_t n_bytes = 0;  ///< the data begins here
  std::size_t n_lines = 0;
};

/// Throws Error (bad_input), naming the line, for what is no PLY header, or counts that the rest of the text cannot
/// hold: before anything is allocated for them.
[[nodiscard]] PlyHeader read_ply_header(std::string_view text, const std::string& name);

}  // namespace lode::geometry

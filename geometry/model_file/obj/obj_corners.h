#pragma once
/// Corners of OBJ's elements: "v", "v/vt", "v//vn", "v/vt/vn", and vertices made of equal ones.

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "geometry/model_file/line_reader.h"

namespace lode::geometry {

/// Indices from 0 into the file's positions, texture coordinates and normals.
struct ObjCorner {
  static constexpr std::uint32_t kNone = 0xFFFFFFFFu;
  std::uint32_t position = kNone, uv = kNone, normal = kNone;
  friend bool operator==(const ObjCorner&, const ObjCorner&) = default;
};

/// How many of each the file has had so far; indices count from 1 to these, or back from the last with −1.
struct ObjCounts {
  std::size_t positions = 0, uvs = 0, normals = 0;
};

/// The corner that a word describes. Throws Error (bad_input), naming the line, for anything else or an index that
/// leads nowhere.
[[nodiscard]] ObjCorner read_corner(const LineReader& lines, std::string_view word, const ObjCounts& counts);

/// A corner of each kind, in the order of first use, and which one each corner is.
struct UniqueCorners {
  std::vector<ObjCorner> unique;
  std::vector<std::uint32_t> indices;  ///< [corners], into unique
};
[[nodiscard]] UniqueCorners unique_corners(const std::vector<ObjCorner>& corners);

}  // namespace lode::geometry

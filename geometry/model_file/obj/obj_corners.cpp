#include "geometry/model_file/obj/obj_corners.h"

#include <bit>
#include <string>

namespace lode::geometry {
namespace {

std::uint32_t read_index(const LineReader& lines, std::string_view text, std::size_t count, const char* what) {
  std::int64_t index = 0;
  if (!parse_number(text, index)) lines.fail_expected("v, v/vt, v//vn or v/vt/vn", text);
  const std::int64_t n = std::int64_t(count);
  const std::int64_t from_zero = index > 0 ? index - 1 : n + index;
  if (index == 0 || index > n || from_zero < 0) {
    lines.fail(std::string(what) + " " + std::to_string(index) + ": expected 1 to " + std::to_string(n) +
               ", or as much below 0: there are " + std::to_string(n) + " up to here");
  }
  return std::uint32_t(from_zero);
}

/// Spreads a corner's bits over all of a word (the finalizer of splitmix64, Steele et al. 2014, twice).
std::uint64_t mixed(const ObjCorner& c) {
  const auto finish = [](std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
  };
  return finish(finish(std::uint64_t(c.position) << 32 | c.uv) + c.normal + 0x9E3779B97F4A7C15u);
}

}  // namespace

ObjCorner read_corner(const LineReader& lines, std::string_view word, const ObjCounts& counts) {
  ObjCorner corner;
  const std::size_t slash = word.find('/');
  corner.position = read_index(lines, word.substr(0, slash), counts.positions, "vertex");
  if (slash == std::string_view::npos) return corner;
  word.remove_prefix(slash + 1);
  const std::size_t second = word.find('/');
  if (const auto uv = word.substr(0, second); !uv.empty()) {
    corner.uv = read_index(lines, uv, counts.uvs, "texture coordinate");
  }
  if (second == std::string_view::npos) return corner;
  if (const auto normal = word.substr(second + 1); !normal.empty()) {
    corner.normal = read_index(lines, normal, counts.normals, "normal");
  }
  return corner;
}

UniqueCorners unique_corners(const std::vector<ObjCorner>& corners) {
  UniqueCorners result;
  result.indices.reserve(corners.size());
  // Open addressing; it is only ever looked into, never gone through.
  std::vector<std::uint32_t> table(std::bit_ceil(2 * corners.size() + 1), ObjCorner::kNone);
  for (const ObjCorner& corner : corners) {
    std::size_t slot = mixed(corner) & (table.size() - 1);
    while (table[slot] != ObjCorner::kNone && result.unique[table[slot]] != corner)
      slot = (slot + 1) & (table.size() - 1);
    if (table[slot] == ObjCorner::kNone) {
      table[slot] = std::uint32_t(result.unique.size());
      result.unique.push_back(corner);
    }
    result.indices.push_back(table[slot]);
  }
  return result;
}

}  // namespace lode::geometry

#pragma once
/// A picture's planes as bytes: what the hash program hashes and compares.

#include <string>
#include <vector>

#include "raster/image.h"

namespace lode::pictures {

struct Plane {
  std::string name;  ///< color, srgb (of a linear colour), depth, ids
  std::size_t bytes_per_pixel;
  int width_px;
  std::vector<unsigned char> bytes;
};

[[nodiscard]] std::vector<Plane> planes_of(const raster::Image& image);

/// FNV-1a 64 of the bytes: sixteen hexadecimal digits.
[[nodiscard]] std::string hash_of(const Plane& plane);

/// True if the bytes are those expected; if not, prints where the first ten pixels of the picture's plane differ.
[[nodiscard]] bool check_plane(const std::string& picture, const Plane& plane,
                               const std::vector<unsigned char>& expected);

}  // namespace lode::pictures

#include "planes.h"

#include <cstdio>
#include <cstring>

#include "raster/srgb.h"

namespace lode::pictures {
namespace {

using raster::Image;

template <class T>
Plane plane_of(const char* name, const Image& image, const raster::PixelPlane<T>& pixels) {
  Plane plane{name, sizeof(T), image.size_px.x, std::vector<unsigned char>(pixels.size() * sizeof(T))};
  if (!pixels.empty()) std::memcpy(plane.bytes.data(), pixels.data(), plane.bytes.size());
  return plane;
}

std::string hex(const unsigned char* bytes, std::size_t n) {
  std::string text;
  char digits[4];
  for (std::size_t i = 0; i < n; ++i) {
    std::snprintf(digits, sizeof digits, "%02x", bytes[i]);
    text += digits;
  }
  return text;
}

}  // namespace

std::vector<Plane> planes_of(const Image& image) {
  std::vector<Plane> planes;
  if (image.format == raster::ColorFormat::rgba8) {
    planes.push_back(plane_of("color", image, image.rgba8));
  } else {
    planes.push_back(plane_of("color", image, image.rgba32f));
    raster::PixelPlane<glm::u8vec4> encoded;
    for (const glm::vec4& c : image.rgba32f) encoded.push_back(raster::srgb8_from_linear(c));
    planes.push_back(plane_of("srgb", image, encoded));
  }
  if (!image.depth.empty()) planes.push_back(plane_of("depth", image, image.depth));
  if (!image.ids.empty()) planes.push_back(plane_of("ids", image, image.ids));
  return planes;
}

std::string hash_of(const Plane& plane) {
  std::uint64_t hash = 0xCBF29CE484222325u;
  for (const unsigned char byte : plane.bytes) hash = (hash ^ byte) * 0x100000001B3u;
  char digits[24];
  std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(hash));
  return digits;
}

bool check_plane(const std::string& picture, const Plane& plane, const std::vector<unsigned char>& expected) {
  if (plane.bytes == expected) return true;
  std::printf("%s %s: ", picture.c_str(), plane.name.c_str());
  if (plane.bytes.size() != expected.size()) {
    std::printf("%zu bytes, expected %zu\n", plane.bytes.size(), expected.size());
    return false;
  }
  const std::size_t each = plane.bytes_per_pixel;
  std::size_t n_different = 0;
  std::string list;
  for (std::size_t at = 0; at < plane.bytes.size(); at += each) {
    if (std::memcmp(&plane.bytes[at], &expected[at], each) == 0 || ++n_different > 10) continue;
    const std::size_t pixel = at / each, width = std::size_t(plane.width_px);
    list += "  (" + std::to_string(pixel % width) + ", " + std::to_string(pixel / width) +
            "): " + hex(&plane.bytes[at], each) + ", expected " + hex(&expected[at], each) + "\n";
  }
  std::printf("%zu of %zu pixels differ; bytes of the first:\n%s", n_different, plane.bytes.size() / each,
              list.c_str());
  return false;
}

}  // namespace lode::pictures

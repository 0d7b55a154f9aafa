#pragma once
/// Pictures that `compare` reads: PNG and JPEG files, and the arrays (.npy) that the program writes.

#include <cstdint>
#include <glm/gtc/type_precision.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <variant>
#include <vector>

namespace lode::experiments {

using ColorPlane = std::vector<glm::u8vec4>;              ///< [w*h] as stored; linear floats become straight sRGB bytes
using DepthPlane = std::vector<float>;                    ///< [w*h]
using IdPlane = std::vector<glm::vec<2, std::uint32_t>>;  ///< [w*h] draw, primitive

struct StoredPicture {
  std::string path;
  glm::ivec2 size_px{0, 0};
  std::variant<ColorPlane, DepthPlane, IdPlane> plane;
  bool is_linear = false;         ///< colour that was read as floats:
  std::vector<glm::vec4> linear;  ///< [w*h] those, premultiplied; else empty
};

/// "colour", "depth", "ids".
[[nodiscard]] const char* kind_of(const StoredPicture& picture);

/// An array of shape h × w × 4 is colour (uint8, or float32 linear premultiplied), h × w float32 depth, h × w × 2
/// uint32 ids. Throws Error or geometry::Error (bad_input).
[[nodiscard]] StoredPicture read_stored_picture(const std::string& path);

}  // namespace lode::experiments

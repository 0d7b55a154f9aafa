#pragma once
/// Reading by OpenImageIO, for JPEG.

#include <glm/gtc/type_precision.hpp>
#include <span>
#include <string>

#include "geometry/image_file/bare_picture.h"

namespace lode::geometry {

/// Decodes into texels [w*h]. Throws Error (bad_input) if the data is damaged.
void decode_jpeg(const BarePicture& bare, const std::string& name, std::span<glm::u8vec4> texels);

}  // namespace lode::geometry

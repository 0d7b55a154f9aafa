#pragma once
/// The one door to libpng. (OpenImageIO reads PNG too, but lets libpng print to standard error.)

#include <glm/gtc/type_precision.hpp>
#include <span>
#include <string>

#include "geometry/image_file/bare_picture.h"

namespace lode::geometry {

/// Decodes into texels [w*h]. Throws Error (bad_input) if the data is damaged.
void decode_png(const BarePicture& bare, const std::string& name, std::span<glm::u8vec4> texels);

}  // namespace lode::geometry

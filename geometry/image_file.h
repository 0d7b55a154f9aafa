#pragma once
/// Pictures to files: the one door to OpenImageIO. The format goes by the file's ending:
///
///   .png   8-bit RGBA exactly as given: no premultiplication, no colour conversion
///   .exr   float or uint32 channels
///   .npy   the array's bytes as they are (NumPy, version 1.0, C order, little-endian)
///
/// Row 0 is the top. Rows are handed on a few at a time, nothing is copied whole, and the bytes written depend
/// on the picture alone (no dates). Every function throws Error: bad_input if the format cannot hold such a
/// picture (no format but .npy holds an empty one), machine if writing fails; it does not close the file.

#include <cstdint>
#include <glm/gtc/type_precision.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <span>
#include <string_view>

#include "geometry/output_file.h"

namespace lode::geometry {

enum class ImageFormat : std::uint8_t { png, exr, npy };

/// The format that the path's ending names, upper or lower case; nothing for an ending we do not know.
[[nodiscard]] std::optional<ImageFormat> image_format(std::string_view path);

/// 8-bit colours [w*h]. exr: R, G, B, A as value / 255; npy: uint8 h × w × 4.
void write_color(OutputFile& file, ImageFormat format, glm::ivec2 size_px, std::span<const glm::u8vec4> colors);

/// Linear premultiplied colours [w*h]. exr: R, G, B, A; npy: float32 h × w × 4; not png, which needs 8 bits.
void write_color(OutputFile& file, ImageFormat format, glm::ivec2 size_px, std::span<const glm::vec4> colors);

/// Depths [w*h]. exr: channel Z; npy: float32 h × w; not png.
void write_depth(OutputFile& file, ImageFormat format, glm::ivec2 size_px, std::span<const float> depths);

/// Ids [w*h*2], draw and primitive by turns. exr: uint32 channels draw, primitive; npy: uint32 h × w × 2; not png.
void write_ids(OutputFile& file, ImageFormat format, glm::ivec2 size_px, std::span<const std::uint32_t> ids);

}  // namespace lode::geometry

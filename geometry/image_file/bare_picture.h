#pragma once
/// A picture's file without all that is not the picture: what is left is small to decode, and its size is known to be
/// one that the data can hold. The decoders see nothing else, so that a flaw in how they read profiles, comments or
/// camera data cannot be reached.

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <string>
#include <vector>

namespace lode::geometry {

struct BarePicture {
  std::vector<std::byte> bytes;
  glm::ivec2 size_px{0, 0};
  std::uint64_t decoder_bytes = 0;  ///< memory that decoding takes, beyond the texels
};

/// Whether a file of this format begins so.
[[nodiscard]] bool is_png(std::span<const std::byte> bytes);
[[nodiscard]] bool is_jpeg(std::span<const std::byte> bytes);

/// Keeps IHDR, PLTE, tRNS, IDAT and IEND. PNG (3rd edition), sec. 5 and 11. Throws Error (bad_input), naming the byte,
/// if a chunk is cut off or unknown and critical, or the size is zero, over the limit, or more than the data can hold.
[[nodiscard]] BarePicture bare_png(std::span<const std::byte> bytes, const std::string& name);

/// Keeps frame, tables, scans and Adobe's note on colours. ITU-T T.81, annex B. Throws Error (bad_input) likewise, and
/// for what is neither baseline, extended nor progressive with 8 bits and one or three components.
[[nodiscard]] BarePicture bare_jpeg(std::span<const std::byte> bytes, const std::string& name);

/// Throws Error (bad_input) unless both sides are at least 1 and at most kMaxPictureSize_px.
void check_picture_size(std::uint64_t width_px, std::uint64_t height_px, const std::string& name);

}  // namespace lode::geometry

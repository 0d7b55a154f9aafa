#pragma once
/// PNG files put together by hand, byte for byte, without any library: data is "deflated" into stored blocks.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace lode::tests {

inline std::string big_endian(std::uint32_t v) {
  return {char(v >> 24), char(v >> 16 & 255), char(v >> 8 & 255), char(v & 255)};
}

/// Length, type, data and checksum. PNG (3rd edition), sec. 5.3; the checksum is annex D's.
inline std::string png_chunk(std::string_view type, std::string_view data) {
  std::uint32_t crc = 0xFFFFFFFFu;
  const std::string covered = std::string(type) + std::string(data);
  for (const char c : covered) {
    crc ^= static_cast<unsigned char>(c);
    for (int k = 0; k < 8; ++k) crc = (crc & 1) != 0 ? 0xEDB88320u ^ (crc >> 1) : crc >> 1;
  }
  return big_endian(std::uint32_t(data.size())) + covered + big_endian(~crc);
}

/// A zlib stream of stored blocks (RFC 1950, RFC 1951 sec. 3.2.4).
inline std::string stored(std::string_view raw) {
  std::string stream = "\x78\x01";
  std::uint32_t a = 1, b = 0;
  for (const char c : raw) {
    a = (a + static_cast<unsigned char>(c)) % 65521;
    b = (b + a) % 65521;
  }
  do {
    const std::size_t n = raw.size() < 65535 ? raw.size() : 65535;
    stream += n == raw.size() ? '\1' : '\0';
    stream += {char(n & 255), char(n >> 8), char(~n & 255), char(~n >> 8 & 255)};
    stream += raw.substr(0, n);
    raw.remove_prefix(n);
  } while (!raw.empty());
  return stream + big_endian(b << 16 | a);
}

struct PngParts {
  std::uint32_t width = 1, height = 1;
  char bit_depth = 8, color_type = 6, interlace = 0;
  std::string before_data;  ///< chunks between IHDR and IDAT
  std::string rows;         ///< each with its filter byte
};

inline std::string png_bytes(const PngParts& parts) {
  const std::string header = big_endian(parts.width) + big_endian(parts.height) +
                             std::string{parts.bit_depth, parts.color_type, 0, 0, parts.interlace};
  return "\x89PNG\r\n\x1a\n" + png_chunk("IHDR", header) + parts.before_data + png_chunk("IDAT", stored(parts.rows)) +
         png_chunk("IEND", "");
}

/// 8-bit RGBA, texels by rows from the top.
inline std::string rgba_png(std::uint32_t width, std::uint32_t height, std::span<const std::array<int, 4>> texels) {
  PngParts parts{.width = width, .height = height, .before_data = {}, .rows = {}};
  for (std::uint32_t y = 0; y < height; ++y) {
    parts.rows += '\0';
    for (std::uint32_t x = 0; x < width; ++x) {
      for (const int c : texels[y * width + x]) parts.rows += char(c);
    }
  }
  return png_bytes(parts);
}

}  // namespace lode::tests

#include <algorithm>
#include <string_view>

#include "geometry/error.h"
#include "geometry/image_file/bare_picture.h"
#include "geometry/image_file/read_picture.h"
#include "geometry/loads.h"

namespace lode::geometry {
namespace {

constexpr unsigned char kSignature[] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
constexpr std::size_t kChunkOverhead = 12;  // length, type and checksum

/// No byte of deflated data becomes more than this many (Deutsch, RFC 1951: 258 bytes from two bits at best).
constexpr std::uint64_t kMaxInflation = 1032;

[[noreturn]] void fail(const std::string& name, std::size_t at, const std::string& what) {
  throw Error(ErrorKind::bad_input, name + ": byte " + std::to_string(at) + ": " + what);
}

/// A type as text; what is not a letter becomes '?'.
std::string shown_type(std::span<const std::byte> type) {
  std::string text;
  for (const std::byte b : type) {
    const char c = char(b);
    text += (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') ? c : '?';
  }
  return text;
}

/// What IHDR says.
struct Header {
  std::uint64_t width_px, height_px, bits_a_pixel;
  [[nodiscard]] std::uint64_t n_bytes() const { return (width_px * height_px * bits_a_pixel + 7) / 8; }
};

Header read_header(std::span<const std::byte> chunk, const std::string& name) {
  if (chunk.size() != 13) fail(name, 8, "IHDR of " + std::to_string(chunk.size()) + " bytes: expected 13");
  const Header header{load_be<std::uint32_t>(chunk, 0), load_be<std::uint32_t>(chunk, 4),
                      std::uint64_t(chunk[8]) * (chunk[9] == std::byte(2)   ? 3
                                                 : chunk[9] == std::byte(4) ? 2
                                                 : chunk[9] == std::byte(6) ? 4
                                                                            : 1)};
  check_picture_size(header.width_px, header.height_px, name);
  return header;
}

}  // namespace

bool is_png(std::span<const std::byte> bytes) {
  return bytes.size() >= sizeof kSignature &&
         std::equal(std::begin(kSignature), std::end(kSignature), bytes.begin(),
                    [](unsigned char a, std::byte b) { return std::byte(a) == b; });
}

void check_picture_size(std::uint64_t width_px, std::uint64_t height_px, const std::string& name) {
  if (std::min(width_px, height_px) >= 1 && std::max(width_px, height_px) <= kMaxPictureSize_px) return;
  throw Error(ErrorKind::bad_input, name + ": " + std::to_string(width_px) + " x " + std::to_string(height_px) +
                                        " px: expected 1 to " + std::to_string(kMaxPictureSize_px) + " a side");
}

BarePicture bare_png(std::span<const std::byte> bytes, const std::string& name) {
  BarePicture bare;
  bare.bytes.assign(bytes.begin(), bytes.begin() + sizeof kSignature);
  Header header{};
  std::uint64_t n_deflated = 0;
  bool ended = false;
  for (std::size_t at = sizeof kSignature; !ended;) {
    const std::size_t left = bytes.size() - at;
    if (left < kChunkOverhead) fail(name, at, "the picture is cut off: expected a chunk up to IEND");
    const std::uint64_t length = load_be<std::uint32_t>(bytes, at);
    const std::string type = shown_type(bytes.subspan(at + 4, 4));
    if (length > left - kChunkOverhead) {
      fail(name, at, "a chunk " + type + " of " + std::to_string(length) + " bytes: the file ends before it does");
    }
    const auto chunk = bytes.subspan(at, std::size_t(length) + kChunkOverhead);
    if (at == sizeof kSignature) {
      if (type != "IHDR") fail(name, at, "a chunk " + type + ": expected IHDR first");
      header = read_header(chunk.subspan(8, std::size_t(length)), name);
    }
    if (type == "IDAT") n_deflated += length;
    const bool kept = type == "IHDR" || type == "PLTE" || type == "tRNS" || type == "IDAT" || type == "IEND";
    if (kept) bare.bytes.insert(bare.bytes.end(), chunk.begin(), chunk.end());
    if (!kept && type[0] >= 'A' && type[0] <= 'Z') fail(name, at, "an unknown chunk " + type + " that must be read");
    ended = type == "IEND";
    at += chunk.size();
  }
  if (header.n_bytes() > n_deflated * kMaxInflation) {
    throw Error(ErrorKind::bad_input, name + ": claims " + std::to_string(header.width_px) + " x " +
                                          std::to_string(header.height_px) + " px: its " + std::to_string(n_deflated) +
                                          " bytes of data cannot hold them");
  }
  bare.size_px = {int(header.width_px), int(header.height_px)};
  bare.decoder_bytes = 16 * header.width_px;  // rows of up to 64 bits a pixel, this one and the one before
  return bare;
}

}  // namespace lode::geometry

#include "geometry/model_file/gltf/glb_container.h"

#include <cstdint>

#include "geometry/error.h"
#include "geometry/loads.h"

namespace lode::geometry {
namespace {

constexpr std::uint32_t kMagic = 0x46546C67;   // "glTF"
constexpr std::uint32_t kJson = 0x4E4F534A;    // "JSON"
constexpr std::uint32_t kBinary = 0x004E4942;  // "BIN"
constexpr std::size_t kHeader = 12, kChunkHeader = 8;

[[noreturn]] void fail(const std::string& name, std::size_t at, const std::string& what) {
  throw Error(ErrorKind::bad_input, name + ": byte " + std::to_string(at) + ": " + what);
}

/// Text without the NULs that some programs pad it with; spaces are right, and the JSON parser skips those.
std::string_view unpadded(std::span<const std::byte> chunk) {
  std::string_view text(reinterpret_cast<const char*>(chunk.data()), chunk.size());
  while (text.ends_with('\0')) text.remove_suffix(1);
  return text;
}

}  // namespace

bool is_glb(std::span<const std::byte> bytes) {
  return bytes.size() >= 4 && load_le<std::uint32_t>(bytes, 0) == kMagic;
}

GlbChunks glb_chunks(std::span<const std::byte> bytes, const std::string& name) {
  if (bytes.size() < kHeader + kChunkHeader) fail(name, bytes.size(), "the file ends within its header");
  const std::uint32_t version = load_le<std::uint32_t>(bytes, 4);
  if (version != 2) fail(name, 4, "GLB version " + std::to_string(version) + ": expected 2");
  const std::uint32_t length = load_le<std::uint32_t>(bytes, 8);
  if (length > bytes.size()) {
    fail(name, 8, "claims " + std::to_string(length) + " bytes: the file has " + std::to_string(bytes.size()));
  }
  bytes = bytes.first(length);

  GlbChunks chunks;
  for (std::size_t at = kHeader; at < bytes.size();) {
    if (bytes.size() - at < kChunkHeader) fail(name, at, "the file ends within a chunk's header");
    const std::uint32_t n = load_le<std::uint32_t>(bytes, at), type = load_le<std::uint32_t>(bytes, at + 4);
    if (n > bytes.size() - at - kChunkHeader) {
      fail(name, at, "a chunk of " + std::to_string(n) + " bytes: the file ends before it does");
    }
    const auto chunk = bytes.subspan(at + kChunkHeader, n);
    if (at == kHeader && type != kJson) fail(name, at + 4, "expected a chunk of JSON first");
    if (at == kHeader) chunks.json = unpadded(chunk);
    if (type == kBinary && !chunks.binary) chunks.binary = chunk;
    at += kChunkHeader + n;
  }
  if (!chunks.json.data()) fail(name, kHeader, "expected a chunk of JSON");
  return chunks;
}

}  // namespace lode::geometry

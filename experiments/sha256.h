#pragma once
/// SHA-256 of bytes: the one door to OpenSSL.

#include <cstddef>
#include <span>
#include <string>

namespace lode::experiments {

/// 64 lower-case hexadecimal digits. Throws Error (machine_failed) if the library refuses.
[[nodiscard]] std::string sha256_hex(std::span<const std::byte> bytes);

}  // namespace lode::experiments

#pragma once
/// Numbers out of bytes, whatever their alignment and byte order.

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace lode::geometry {

static_assert(std::endian::native == std::endian::little, "files are read as this machine lays numbers out");

/// The number at `at`, little-endian. The caller has checked that at + sizeof(T) is within the bytes.
template <class T>
[[nodiscard]] T load_le(std::span<const std::byte> bytes, std::size_t at) {
  T value;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

/// The same, big-endian.
template <std::unsigned_integral T>
[[nodiscard]] T load_be(std::span<const std::byte> bytes, std::size_t at) {
  T value = 0;
  for (std::size_t i = 0; i < sizeof(T); ++i) value = T(T(value << 8) | T(bytes[at + i]));
  return value;
}

}  // namespace lode::geometry

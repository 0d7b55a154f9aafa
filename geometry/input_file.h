#pragma once
/// The bytes of a file that is read whole.

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace lode::geometry {

struct FileBytes {
  std::unique_ptr<std::byte[]> bytes;
  std::size_t n = 0;

  [[nodiscard]] std::span<const std::byte> span() const { return {bytes.get(), n}; }
  [[nodiscard]] std::string_view text() const { return {reinterpret_cast<const char*>(bytes.get()), n}; }
};

/// Throws Error: bad_input if there is no such file, it may not be read, is a directory, a device or a pipe (which is
/// not waited for), is empty, or is larger than 16 GiB; machine if there is no memory for it.
[[nodiscard]] FileBytes read_whole_file(const std::string& path);

}  // namespace lode::geometry

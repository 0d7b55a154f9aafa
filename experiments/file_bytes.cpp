#include "experiments/file_bytes.h"

#include <array>
#include <fstream>

namespace lode::experiments {

std::optional<std::string> file_bytes(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) return std::nullopt;
  std::string bytes;
  std::array<char, 65536> part;
  do {
    in.read(part.data(), std::streamsize(part.size()));
    bytes.append(part.data(), std::size_t(in.gcount()));
  } while (in);
  if (in.bad()) return std::nullopt;
  return bytes;
}

}  // namespace lode::experiments

#pragma once
/// Files with a mistake in them: cut off, or with some bytes changed.

#include <cstddef>
#include <string>

#include "geometry/error.h"
#include "geometry/random.h"

namespace lode::tests {

/// The text with one to eight bytes changed; mostly to any byte, sometimes by one bit, or to a digit of another number.
inline std::string with_changed_bytes(std::string bytes, std::uint64_t seed) {
  geometry::Random random(seed, 0xDA3A6E);
  for (std::uint32_t i = 0, n = 1 + random.below(8); i < n && !bytes.empty(); ++i) {
    // Half of them near the beginning, where headers are.
    const std::size_t range = random.below(2) == 0 ? std::min<std::size_t>(bytes.size(), 600) : bytes.size();
    char& byte = bytes[random.below(std::uint32_t(range))];
    switch (random.below(4)) {
      case 0:
        byte = char(byte ^ (1 << random.below(8)));
        break;
      case 1:
        byte = "0123456789-.e[]{}\",: \n/"[random.below(22)];
        break;
      default:
        byte = char(random.below(256));
        break;
    }
  }
  return bytes;
}

/// What a reader may do with a damaged file: return, or throw one Error of bad input, in one line. Else the reason.
template <class Read>
std::string outcome(Read read) {
  try {
    read();
    return "";
  } catch (const geometry::Error& error) {
    const std::string text = error.what();
    if (error.kind() != geometry::ErrorKind::bad_input) return "not bad input: " + text;
    if (text.find('\n') != std::string::npos) return "more than one line: " + text;
    return text.size() > 2000 ? "a long line: " + text : "";
  } catch (const std::exception& other) {
    return std::string("another exception: ") + other.what();
  }
}

}  // namespace lode::tests

#pragma once
/// std::bit_cast of C++20 for Debian 12's Emscripten, whose library has not got it; included before everything else.

#include <bit>

#ifndef __cpp_lib_bit_cast
namespace std {
template <class To, class From>
[[nodiscard]] constexpr To bit_cast(const From& from) noexcept {
  static_assert(sizeof(To) == sizeof(From));
  return __builtin_bit_cast(To, from);
}
}  // namespace std
#endif

#pragma once
/// What the library of Debian 12's Emscripten lacks of C++20, and this project uses; included before everything else.

#include <bit>
#include <memory>

namespace std {

#ifndef __cpp_lib_bit_cast
template <class To, class From>
[[nodiscard]] constexpr To bit_cast(const From& from) noexcept {
  static_assert(sizeof(To) == sizeof(From));
  return __builtin_bit_cast(To, from);
}
#endif

#ifndef __cpp_lib_smart_ptr_for_overwrite
template <class T>
  requires(is_array_v<T> && extent_v<T> == 0)
[[nodiscard]] unique_ptr<T> make_unique_for_overwrite(size_t n) {
  return unique_ptr<T>(new remove_extent_t<T>[n]);
}
template <class T>
  requires(!is_array_v<T>)
[[nodiscard]] unique_ptr<T> make_unique_for_overwrite() {
  return unique_ptr<T>(new T);
}
#endif

}  // namespace std

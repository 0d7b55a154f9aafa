#pragma once
/// The one exception type that raster/ throws, at its edges only: a frame, a texture or a size that
/// cannot be drawn, or memory that is not there. The message is one line, kept inside the object, so that
/// reporting "out of memory" needs none.

#include <exception>

namespace lode::raster {

enum class ErrorKind { bad_input, out_of_memory };

class Error : public std::exception {
 public:
  /// printf-style; cut at 255 characters.
  [[gnu::format(printf, 3, 4)]] Error(ErrorKind kind, const char* format, ...) noexcept;

  [[nodiscard]] ErrorKind kind() const noexcept { return kind_; }
  [[nodiscard]] const char* what() const noexcept override { return message_; }

 private:
  ErrorKind kind_;
  char message_[256];
};

}  // namespace lode::raster

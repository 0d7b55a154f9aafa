#include "raster/error.h"

#include <cstdarg>
#include <cstdio>

namespace lode::raster {

Error::Error(ErrorKind kind, const char* format, ...) noexcept : kind_(kind) {
  std::va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(message_, sizeof message_, format, arguments);
  va_end(arguments);
}

}  // namespace lode::raster

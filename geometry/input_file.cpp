#include "geometry/input_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <new>

#include "geometry/error.h"

namespace lode::geometry {
namespace {

constexpr std::int64_t kMaxFile = std::int64_t(1) << 34;
constexpr std::size_t kMaxRead = std::size_t(1) << 30;  // read() may stop at 2 GiB

[[noreturn]] void fail(const std::string& path, const std::string& what) {
  throw Error(ErrorKind::bad_input, path + ": " + what);
}

/// An open file descriptor, closed at the end.
struct Descriptor {
  explicit Descriptor(int opened) : number(opened) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (number >= 0) ::close(number);
  }
  int number;
};

std::size_t checked_size(const std::string& path, const Descriptor& file) {
  struct ::stat status {};
  if (::fstat(file.number, &status) != 0) fail(path, std::string("cannot be read: ") + std::strerror(errno));
  if (S_ISDIR(status.st_mode)) fail(path, "is a directory: expected a file");
  if (!S_ISREG(status.st_mode)) fail(path, "is a device or pipe: expected a file");
  if (status.st_size == 0) fail(path, "is empty");
  if (status.st_size > kMaxFile) fail(path, "is larger than 16 GiB");
  return std::size_t(status.st_size);
}

}  // namespace

FileBytes read_whole_file(const std::string& path) {
  if (path.find('\0') != std::string::npos) fail(path.substr(0, path.find('\0')), "a NUL byte follows in the path");
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));  // a pipe would wait for its writer
  if (file.number < 0) fail(path, std::string("cannot be read: ") + std::strerror(errno));

  FileBytes result;
  const std::size_t size = checked_size(path, file);
  result.bytes.reset(new (std::nothrow) std::byte[size]);
  if (!result.bytes) {
    throw Error(ErrorKind::machine, path + ": no memory for its " + std::to_string(size >> 20) + " MiB");
  }
  while (result.n < size) {
    const ssize_t n = ::read(file.number, result.bytes.get() + result.n, std::min(size - result.n, kMaxRead));
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) fail(path, std::string("cannot be read: ") + std::strerror(errno));
    if (n == 0) break;  // it has become shorter meanwhile
    result.n += std::size_t(n);
  }
  if (result.n == 0) fail(path, "is empty");
  return result;
}

}  // namespace lode::geometry

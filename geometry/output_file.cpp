#include "geometry/output_file.h"

#include <cerrno>
#include <cstring>
#include <utility>

#include "geometry/error.h"

namespace lode::geometry {

OutputFile::OutputFile(std::FILE* file, std::string shown_name) : file_(file), shown_name_(std::move(shown_name)) {}

void OutputFile::write(const void* bytes, std::size_t n) noexcept {
  if (first_errno_ != 0 || n == 0) return;
  if (std::fwrite(bytes, 1, n, file_.get()) != n) first_errno_ = errno != 0 ? errno : EIO;
}

void OutputFile::seek(std::int64_t offset) noexcept {
  if (first_errno_ != 0) return;
  if (::fseeko(file_.get(), offset, SEEK_SET) != 0) first_errno_ = errno;
}

std::int64_t OutputFile::tell() const noexcept { return ::ftello(file_.get()); }

void OutputFile::check() const {
  if (first_errno_ == 0) return;
  throw Error(ErrorKind::machine, shown_name_ + ": cannot be written: " + std::strerror(first_errno_));
}

void OutputFile::close() {
  // Closing writes the buffer's rest: the last chance for the disk to be full.
  if (file_ && std::fclose(file_.release()) != 0 && first_errno_ == 0) first_errno_ = errno;
  check();
}

}  // namespace lode::geometry

#pragma once
/// An open file that bytes go to, and that never loses an error: the first failed write is kept (a full disk,
/// a file size limit) and thrown by `check` or `close`, under the name that the user knows the file by.
/// Writing itself throws nothing, so that C libraries may call it from their callbacks.

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>

namespace lode::geometry {

class OutputFile {
 public:
  /// Takes over `file`, open for writing at its start. `shown_name` is what errors call it.
  OutputFile(std::FILE* file, std::string shown_name);

  /// Appends at the current position; does nothing after an error.
  void write(const void* bytes, std::size_t n) noexcept;
  void seek(std::int64_t offset) noexcept;  ///< from the start
  [[nodiscard]] std::int64_t tell() const noexcept;

  /// Throws Error (machine) if anything has failed so far.
  void check() const;
  /// Writes what is buffered and closes the file; then as `check`. Nothing may be written afterwards.
  void close();

  [[nodiscard]] const std::string& shown_name() const { return shown_name_; }

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::unique_ptr<std::FILE, Close> file_;
  std::string shown_name_;
  int first_errno_ = 0;
};

}  // namespace lode::geometry

#pragma once
/// Runs `lodestone` for a test: as a function, with strings for its streams (quick), or as a child process
/// (whatever concerns the process itself: signals, limits, standard output).

#include <string>
#include <vector>

namespace lode::tests {

struct Outcome {
  int status = -1;  ///< exit status; -1 if a signal ended the process
  int signal = 0;   ///< that signal
  std::string out, err;
};

using Arguments = std::vector<std::string>;

/// run_lodestone() on strings.
[[nodiscard]] Outcome run_lodestone(const Arguments& arguments, const std::string& input = "");

struct ChildLimits {
  long max_file_bytes = -1;        ///< no file may grow beyond it; −1: no limit
  const char* out_path = nullptr;  ///< where standard output goes instead of into Outcome::out
};

/// The built program in a child process.
[[nodiscard]] Outcome run_child(const Arguments& arguments, const std::string& input = "",
                                const ChildLimits& limits = {});

/// A directory of its own that is gone when the test ends.
class TemporaryDirectory {
 public:
  TemporaryDirectory();
  ~TemporaryDirectory();
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;

  [[nodiscard]] std::string operator/(const std::string& name) const { return path_ + "/" + name; }
  /// Names of all that is in it, hidden files too, sorted.
  [[nodiscard]] std::vector<std::string> names() const;

 private:
  std::string path_;
};

[[nodiscard]] std::string file_text(const std::string& path);
void write_text(const std::string& path, const std::string& text);

/// A NumPy file as it lies there.
struct NpyArray {
  std::string header;  ///< the dictionary, without padding
  std::string bytes;
};
[[nodiscard]] NpyArray read_npy(const std::string& path);

/// True if the text is one line that begins with "lodestone: " and ends in its only line break.
[[nodiscard]] bool is_one_error_line(const std::string& text);

}  // namespace lode::tests

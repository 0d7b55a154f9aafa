#pragma once
/// Output files that appear whole or not at all. Bytes go to a temporary file in the output's own directory;
/// `publish` renames the temporaries of a command when all of them are complete. Whatever ends the command
/// before that (an error, an exception, a signal from outside that can be caught) removes them and leaves older
/// files of the same names as they were.

#include <initializer_list>
#include <string>
#include <string_view>

#include "geometry/output_file.h"

namespace lode::experiments {

class WholeFile {
 public:
  /// Makes the temporary file. A symbolic link is followed: the file it names is the one replaced.
  /// Throws Error: bad_input (no such directory, not writable, a directory, a device), machine_failed (disk full).
  explicit WholeFile(const std::string& path);
  ~WholeFile();
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;

  [[nodiscard]] geometry::OutputFile& file() { return file_; }

 private:
  friend void publish(std::initializer_list<WholeFile*> files);

  std::string path_;  ///< where the file is to appear
  int slot_;          ///< of the temporary's name in the table that the signal handler sees
  geometry::OutputFile file_;
};

/// Closes the files and, if every byte of all of them was written, renames them to where they belong. Null
/// pointers are skipped. A signal that arrives meanwhile waits. Throws Error (machine_failed).
void publish(std::initializer_list<WholeFile*> files);

/// One file of these bytes. Throws Error as WholeFile and publish do.
void write_whole_file(const std::string& path, std::string_view bytes);

/// Whether the signals above also clear the line that standard error's cursor is in (progress is shown there).
void clear_terminal_line_on_signals(bool clear) noexcept;

/// Handles the signals above, where they are not ignored, until the process ends; SIGXFSZ (file too large)
/// becomes an ordinary write error. Called once, by the program.
void remove_temporary_files_on_signals();

}  // namespace lode::experiments

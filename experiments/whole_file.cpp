#include "experiments/whole_file.h"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <climits>
#include <cstring>
#include <filesystem>

#include "experiments/error.h"

namespace lode::experiments {
namespace {

// What the signal handler may touch: fixed memory and lock-free atomics only.
constexpr int kMaxFiles = 16;
char temporary_names[kMaxFiles][PATH_MAX];
std::atomic<bool> slot_taken[kMaxFiles];
std::atomic<bool> publishing{false};
std::atomic<int> waiting_signal{0};
std::atomic<bool> clearing_line{false};
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free);

extern "C" void remove_and_die(int signal_number) {
  if (publishing) {
    waiting_signal = signal_number;
    return;
  }
  for (int slot = 0; slot < kMaxFiles; ++slot) {
    if (slot_taken[slot]) ::unlink(temporary_names[slot]);
  }
  constexpr char kClearLine[] = "\r\033[K";
  if (clearing_line && ::write(STDERR_FILENO, kClearLine, sizeof kClearLine - 1) < 0) clearing_line = false;
  ::signal(signal_number, SIG_DFL);
  ::raise(signal_number);
}

/// A slot that holds `name`.
int take_slot(const std::string& name) {
  for (int slot = 0; slot < kMaxFiles; ++slot) {
    if (slot_taken[slot]) continue;
    if (name.size() >= PATH_MAX) throw Error(Status::bad_input, name + ": " + std::strerror(ENAMETOOLONG));
    std::strcpy(temporary_names[slot], name.c_str());
    slot_taken[slot] = true;
    return slot;
  }
  throw Error(Status::machine_failed, "more than " + std::to_string(kMaxFiles) + " output files at a time");
}

bool is_machine_failure(int error) {
  return error == ENOSPC || error == EDQUOT || error == EIO || error == EMFILE || error == ENFILE || error == ENOMEM;
}

/// The path with symbolic links followed, checked to be a file or nothing yet.
std::string checked_path(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::is_directory(status)) throw Error(Status::bad_input, path + ": is a directory: expected a file to write");
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    throw Error(Status::bad_input, path + ": is a device or pipe: expected a file to write");
  }
  if (!fs::is_symlink(fs::symlink_status(path, error))) return path;
  const fs::path followed = fs::weakly_canonical(path, error);
  if (error) throw Error(Status::bad_input, path + ": cannot be written: " + error.message());
  return followed.string();
}

/// ".lodestone-PID-N" beside the path, with the path's ending.
std::string temporary_name(const std::string& path, int n) {
  const std::filesystem::path p(path);
  const std::string name = ".lodestone-" + std::to_string(::getpid()) + "-" + std::to_string(n);
  const std::string ending = p.extension().string();
  return (p.parent_path() / (name + (ending.size() <= 16 ? ending : ""))).string();
}

/// Makes a temporary file that was not there before; `slot` is where the signal handler finds its name.
std::FILE* open_temporary(const std::string& path, const std::string& shown_name, int& slot) {
  static std::atomic<int> counter{0};
  for (;;) {
    const std::string name = temporary_name(path, counter++);
    slot = take_slot(name);
    const int descriptor = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    std::FILE* const file = descriptor < 0 ? nullptr : ::fdopen(descriptor, "wb");
    if (file) return file;
    const int error = errno;
    if (descriptor >= 0) {
      ::close(descriptor);
      ::unlink(name.c_str());
    }
    slot_taken[slot] = false;
    if (error == EEXIST) continue;  // left behind by a killed process of the same number
    throw Error(is_machine_failure(error) ? Status::machine_failed : Status::bad_input,
                shown_name + ": cannot be written: " + std::strerror(error));
  }
}

}  // namespace

WholeFile::WholeFile(const std::string& path)
    : path_(checked_path(path)), slot_(-1), file_(open_temporary(path_, path, slot_), path) {}

WholeFile::~WholeFile() {
  if (slot_ < 0) return;
  ::unlink(temporary_names[slot_]);
  slot_taken[slot_] = false;
}

void publish(std::initializer_list<WholeFile*> files) {
  for (WholeFile* const f : files) {
    if (f) f->file_.close();
  }
  publishing = true;
  int error = 0;
  std::string failed;
  for (WholeFile* const f : files) {
    if (!f) continue;
    if (std::rename(temporary_names[f->slot_], f->path_.c_str()) != 0) {
      error = errno;
      failed = f->path_;
      break;
    }
    slot_taken[f->slot_] = false;
    f->slot_ = -1;
  }
  publishing = false;
  if (waiting_signal != 0) remove_and_die(waiting_signal);
  if (error != 0) throw Error(Status::machine_failed, failed + ": cannot be written: " + std::strerror(error));
}

void write_whole_file(const std::string& path, std::string_view bytes) {
  WholeFile file(path);
  file.file().write(bytes.data(), bytes.size());
  publish({&file});
}

void clear_terminal_line_on_signals(bool clear) noexcept { clearing_line = clear; }

void remove_temporary_files_on_signals() {
  ::signal(SIGXFSZ, SIG_IGN);
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGQUIT, SIGXCPU, SIGALRM, SIGUSR1, SIGUSR2, SIGVTALRM}) {
    struct sigaction action = {};
    if (::sigaction(number, nullptr, &action) == 0 && action.sa_handler == SIG_IGN) continue;  // nohup, say
    action = {};
    action.sa_handler = remove_and_die;
    ::sigaction(number, &action, nullptr);
  }
}

}  // namespace lode::experiments

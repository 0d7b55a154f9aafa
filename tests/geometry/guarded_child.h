#pragma once
/// Cases run in a child process, where none may crash, hang, or take more memory than it is allowed.

#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstddef>
#include <cstdio>
#include <cstring>
#include <functional>
#include <string>

namespace lode::tests {

/// Runs cases 0…n−1, each for at most `seconds`, with `max_bytes` of address space beyond what the process has now.
/// A case returns "" if all is well. Returns what went wrong first, with the case's number, or "".
inline std::string run_guarded(std::size_t n, unsigned seconds, std::size_t max_bytes,
                               const std::function<std::string(std::size_t)>& run) {
  struct Report {
    std::size_t at;
    char text[1000];
  };
  void* const shared = ::mmap(nullptr, sizeof(Report), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  auto* const report = new (shared) Report{};
  std::fflush(nullptr);
  const pid_t child = ::fork();
  if (child == 0) {
    unsigned long n_pages = 0;
    if (std::FILE* const statm = std::fopen("/proc/self/statm", "r")) {
      if (std::fscanf(statm, "%lu", &n_pages) != 1) n_pages = 0;
      std::fclose(statm);
    }
    const rlim_t limit = n_pages * rlim_t(::sysconf(_SC_PAGESIZE)) + max_bytes;
    const struct ::rlimit address_space { limit, limit };
    ::setrlimit(RLIMIT_AS, &address_space);
    for (std::size_t i = 0; i < n; ++i) {
      report->at = i;
      ::alarm(seconds);
      const std::string wrong = run(i);
      if (wrong.empty()) continue;
      std::snprintf(report->text, sizeof report->text, "%s", wrong.c_str());
      ::_exit(1);
    }
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  std::string result;
  if (WIFSIGNALED(status)) {
    const int signal = WTERMSIG(status);
    result = signal == SIGALRM ? "hangs" : std::string("dies: ") + ::strsignal(signal);
  } else if (WEXITSTATUS(status) != 0) {
    result = report->text[0] != '\0' ? report->text : "ends by itself";
  }
  if (!result.empty()) result = "case " + std::to_string(report->at) + ": " + result;
  ::munmap(shared, sizeof(Report));
  return result;
}

}  // namespace lode::tests

#include "tests/experiments/run_program.h"

#include <fcntl.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "experiments/lodestone.h"

namespace lode::tests {
namespace {

std::vector<const char*> c_strings(const Arguments& arguments) {
  std::vector<const char*> list = {"lodestone"};
  for (const std::string& a : arguments) list.push_back(a.c_str());
  list.push_back(nullptr);
  return list;
}

void redirect(int stream, const char* path, int flags) {
  const int descriptor = ::open(path, flags, 0600);
  if (descriptor < 0 || ::dup2(descriptor, stream) < 0) ::_exit(127);
}

}  // namespace

Outcome run_lodestone(const Arguments& arguments, const std::string& input) {
  std::istringstream in(input);
  std::ostringstream out, err;
  const std::vector<const char*> argv = c_strings(arguments);
  Outcome run;
  run.status = experiments::run_lodestone(int(argv.size()) - 1, argv.data(), {in, out, err});
  run.out = out.str();
  run.err = err.str();
  return run;
}

Outcome run_child(const Arguments& arguments, const std::string& input, const ChildLimits& limits) {
  const TemporaryDirectory directory;
  const std::string in_path = directory / "in", out_path = directory / "out", err_path = directory / "err";
  write_text(in_path, input);
  const std::vector<const char*> argv = c_strings(arguments);
  const pid_t child = ::fork();
  if (child == 0) {
    redirect(0, in_path.c_str(), O_RDONLY);
    redirect(1, limits.out_path ? limits.out_path : out_path.c_str(), O_WRONLY | O_CREAT);
    redirect(2, err_path.c_str(), O_WRONLY | O_CREAT);
    if (limits.max_file_bytes >= 0) {
      const rlimit limit = {rlim_t(limits.max_file_bytes), rlim_t(limits.max_file_bytes)};
      ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    ::execv(LODESTONE_PROGRAM_PATH, const_cast<char* const*>(argv.data()));
    ::_exit(127);
  }
  int code = 0;
  if (child < 0 || ::waitpid(child, &code, 0) != child) throw std::runtime_error("the program cannot be started");
  Outcome run;
  if (WIFEXITED(code)) run.status = WEXITSTATUS(code);
  if (WIFSIGNALED(code)) run.signal = WTERMSIG(code);
  if (!limits.out_path) run.out = file_text(out_path);
  run.err = file_text(err_path);
  return run;
}

TemporaryDirectory::TemporaryDirectory() {
  std::string name = std::filesystem::temp_directory_path().string() + "/lodestone-test-XXXXXX";
  if (!::mkdtemp(name.data())) throw std::runtime_error("no temporary directory");
  path_ = name;
}

TemporaryDirectory::~TemporaryDirectory() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::vector<std::string> TemporaryDirectory::names() const {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(path_))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

std::string file_text(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error(path + ": cannot be read");
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

void write_text(const std::string& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

NpyArray read_npy(const std::string& path) {
  const std::string text = file_text(path);
  const auto byte = [&](std::size_t i) { return std::size_t(static_cast<unsigned char>(text.at(i))); };
  if (!text.starts_with("\x93NUMPY\x01")) throw std::runtime_error(path + ": not a NumPy file");
  const std::size_t n_header = byte(8) + 256 * byte(9);
  if ((10 + n_header) % 64 != 0 || text.at(9 + n_header) != '\n') throw std::runtime_error(path + ": bad padding");
  const std::string header = text.substr(10, n_header);
  return {header.substr(0, header.find('}') + 1), text.substr(10 + n_header)};
}

bool is_one_error_line(const std::string& text) {
  return text.starts_with("lodestone: ") && text.find('\n') == text.size() - 1;
}

}  // namespace lode::tests

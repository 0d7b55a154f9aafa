#include "experiments/report/gnuplot.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <numeric>

#include "experiments/error.h"
#include "experiments/report/html.h"
#include "experiments/report/plot_script.h"

extern char** environ;

namespace lode::experiments {
namespace {

constexpr const char* kMend = ": expected it to be installed (scripts/setup does that)";

/// The two ends of a pipe, closed at the end.
struct Pipe {
  std::array<int, 2> ends{-1, -1};
  Pipe() {
    if (::pipe(ends.data()) != 0) throw Error(Status::machine_failed, "gnuplot: no pipe to it could be opened");
  }
  ~Pipe() { close_end(0), close_end(1); }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  void close_end(std::size_t k) {
    if (ends[k] >= 0) ::close(ends[k]);
    ends[k] = -1;
  }
};

std::string read_all(int from) {
  std::string text;
  std::array<char, 65536> part;
  for (ssize_t n; (n = ::read(from, part.data(), part.size())) > 0;) text.append(part.data(), std::size_t(n));
  return text;
}

/// A script where gnuplot can read it, removed at the end.
class ScriptFile {
 public:
  explicit ScriptFile(const std::string& script) {
    std::string name = (std::filesystem::temp_directory_path() / "lodestone-plot-XXXXXX").string();
    const int file = ::mkstemp(name.data());
    path_ = name;
    const bool written = file >= 0 && ::write(file, script.data(), script.size()) == ssize_t(script.size());
    if (file >= 0) ::close(file);
    if (!written) throw Error(Status::machine_failed, path_ + ": a plot's script cannot be written");
  }
  ~ScriptFile() { ::unlink(path_.c_str()); }
  ScriptFile(const ScriptFile&) = delete;
  ScriptFile& operator=(const ScriptFile&) = delete;
  [[nodiscard]] std::string& path() { return path_; }

 private:
  std::string path_;
};

/// What gnuplot writes for a script.
std::string run_gnuplot(const std::string& script) {
  ScriptFile file(script);
  Pipe out;
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, out.ends[1], 1);
  for (const int end : out.ends) posix_spawn_file_actions_addclose(&actions, end);
  std::string program = "gnuplot";
  std::array<char*, 3> arguments = {program.data(), file.path().data(), nullptr};
  pid_t child = 0;
  const int failed = ::posix_spawnp(&child, program.c_str(), &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failed != 0) throw Error(Status::machine_failed, std::string("gnuplot cannot be run") + kMend);
  out.close_end(1);
  const std::string text = read_all(out.ends[0]);
  int status = 0;
  ::waitpid(child, &status, 0);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || text.find("<svg") == std::string::npos) {
    throw Error(Status::machine_failed, std::string("gnuplot failed") + kMend);
  }
  return text;
}

void replace_all(std::string& text, std::string_view from, std::string_view to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) {
    text.replace(at, from.size(), to);
  }
}

}  // namespace

std::string svg_of(const Plot& plot) {
  std::string svg = run_gnuplot(plot_script(plot));
  svg.erase(0, svg.find("<svg"));  // a page has one XML declaration at most
  replace_all(svg, "black", "currentColor");
  replace_all(svg, "rgb(  0,   0,   0)", "currentColor");
  return svg;
}

std::string html_plot(const Plot& plot, const std::string& caption) {
  return "<figure class=\"plot\"><div class=\"wide\">" + svg_of(plot) + "</div><figcaption>" + escaped(caption) +
         "</figcaption></figure>\n";
}

std::vector<std::size_t> pareto_front(std::span<const double> x, std::span<const double> y) {
  std::vector<std::size_t> order(x.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return x[a] != x[b] ? x[a] < x[b] : (y[a] != y[b] ? y[a] < y[b] : a < b);
  });
  std::vector<std::size_t> front;
  for (const std::size_t i : order) {
    if (front.empty() || y[i] < y[front.back()]) front.push_back(i);
  }
  return front;
}

}  // namespace lode::experiments

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
#include "experiments/parameter.h"

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

/// A text in gnuplot's double quotes, with nothing in it that it would take as markup.
std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c == '\n' ? ' ' : c;
  }
  return result + "\"";
}

std::string script_of(const Plot& plot) {
  std::string s = "set terminal svg size " + std::to_string(plot.width) + "," + std::to_string(plot.height) +
                  " dynamic noenhanced font 'sans-serif,13'\n";
  s += "set xlabel " + quoted(plot.x_title) + "\nset ylabel " + quoted(plot.y_title) + "\n";
  s += "set key outside right top\nset grid\nset border 3\nset tics nomirror\nset offsets graph 0.02, graph 0.12, 0, "
       "0\n";
  if (plot.log_y) s += "set logscale y\nset format y '%g'\n";
  for (std::size_t k = 0; k < plot.series.size(); ++k) {
    const PlotSeries& series = plot.series[k];
    s += "$d" + std::to_string(k) + " << EOD\n";
    for (std::size_t i = 0; i < series.x.size(); ++i) {
      s += number_text(series.x[i]) + " " + number_text(series.y[i]);
      s += (series.labels.empty() ? std::string() : " " + quoted(series.labels[i])) + "\n";
    }
    s += "EOD\n";
  }
  s += "plot ";
  for (std::size_t k = 0; k < plot.series.size(); ++k) {
    const PlotSeries& series = plot.series[k];
    const std::string data = "$d" + std::to_string(k), title = " title " + quoted(series.title);
    const std::string style = " lc " + std::to_string(k + 1) + " lw 2";
    s += k > 0 ? ", " : "";
    if (series.labels.empty()) {
      s += data + " using 1:2 with lines" + style + title;
    } else {
      s += data + " using 1:2 with points pt 7 ps 0.7" + style + title + ", " + data +
           " using 1:2:3 with labels left offset 0.7,0.3 font ',10' notitle";
    }
  }
  return s + "\n";
}

void replace_all(std::string& text, std::string_view from, std::string_view to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) {
    text.replace(at, from.size(), to);
  }
}

}  // namespace

std::string svg_of(const Plot& plot) {
  std::string svg = run_gnuplot(script_of(plot));
  svg.erase(0, svg.find("<svg"));  // a page has one XML declaration at most
  replace_all(svg, "black", "currentColor");
  replace_all(svg, "rgb(  0,   0,   0)", "currentColor");
  return svg;
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

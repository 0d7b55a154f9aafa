#include "experiments/progress.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ostream>
#include <utility>

#include "experiments/whole_file.h"

namespace lode::experiments {
namespace {

constexpr double kFirstShown_s = 0.5;
constexpr double kRedrawn_s = 0.1;
constexpr const char* kClearLine = "\r\033[K";

double steady_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// 812, 8.1k, 8.1M, ...
std::string rate_text(double per_s) {
  const char* suffix = "";
  for (const char* larger : {"k", "M", "G"}) {
    if (per_s < 10000.0) break;
    per_s /= 1000.0;
    suffix = larger;
  }
  char text[32];
  std::snprintf(text, sizeof text, per_s < 10.0 ? "%.1f%s" : "%.0f%s", per_s, suffix);
  return text;
}

/// 0:07, 1:05, 2:03:10.
std::string time_text(double seconds) {
  const auto s = static_cast<long long>(std::min(std::ceil(seconds), 359999.0));
  char text[32];
  if (s >= 3600) {
    std::snprintf(text, sizeof text, "%lld:%02lld:%02lld", s / 3600, s / 60 % 60, s % 60);
  } else {
    std::snprintf(text, sizeof text, "%lld:%02lld", s / 60, s % 60);
  }
  return text;
}

}  // namespace

std::string progress_line(const std::string& what, const std::string& unit, std::uint64_t done, std::uint64_t total,
                          double elapsed_s) {
  const double part = std::min(double(done) / double(total), 1.0);
  char percent[16];
  std::snprintf(percent, sizeof percent, "%3.0f %%", std::floor(100.0 * part));
  std::string line = what + " " + percent;
  if (done == 0 || !(elapsed_s > 0.0)) return line;
  return line + "  " + rate_text(double(done) / elapsed_s) + " " + unit + "/s  " +
         time_text(elapsed_s * (1.0 - part) / part) + " left";
}

Progress::Progress(const Streams& streams, const CommonOptions& common, std::string what, std::string unit,
                   std::uint64_t total)
    : Progress(streams, common, std::move(what), std::move(unit), total, steady_seconds) {}

Progress::Progress(const Streams& streams, const CommonOptions& common, std::string what, std::string unit,
                   std::uint64_t total, Clock clock)
    : err_(streams.err),
      what_(std::move(what)),
      unit_(std::move(unit)),
      total_(total),
      clock_(std::move(clock)),
      started_s_(clock_()),
      on_(streams.err_is_terminal && !common.quiet && total > 0),
      next_s_(started_s_ + kFirstShown_s) {}

Progress::~Progress() { finish(); }

void Progress::add(std::uint64_t n) noexcept {
  const std::uint64_t done = done_.fetch_add(n) + n;
  if (!on_ || !drawing_.try_lock()) return;
  const std::lock_guard<std::mutex> lock(drawing_, std::adopt_lock);
  try {
    const double now_s = clock_();
    if (!on_ || now_s < next_s_) return;
    draw(done, now_s);
  } catch (...) {  // a line that cannot be shown is not shown
  }
}

void Progress::show() noexcept {
  const std::lock_guard<std::mutex> lock(drawing_);
  try {
    if (on_) draw(done_, clock_());
  } catch (...) {
  }
}

void Progress::draw(std::uint64_t done, double now_s) {
  next_s_ = now_s + kRedrawn_s;
  drawn_ = true;
  clear_terminal_line_on_signals(true);  // before there is anything to clear: a signal may come at any moment
  err_ << kClearLine << progress_line(what_, unit_, done, total_, now_s - started_s_) << std::flush;
}

void Progress::finish() noexcept {
  const std::lock_guard<std::mutex> lock(drawing_);
  on_ = false;
  if (!drawn_) return;
  drawn_ = false;
  try {
    err_ << kClearLine << std::flush;
  } catch (...) {
  }
  clear_terminal_line_on_signals(false);
}

}  // namespace lode::experiments

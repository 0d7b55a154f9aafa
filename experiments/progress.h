#pragma once
/// How far long work is, on standard error: percent, rate and time left, on one line that is redrawn in place. Only on
/// a terminal and without --quiet; otherwise it shows nothing and costs an addition.

#include <atomic>
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <mutex>
#include <string>

#include "experiments/common_options.h"
#include "experiments/streams.h"

namespace lode::experiments {

/// The line for `done` of `total` units (total > 0) after `elapsed_s`: "rendering  43 %  812 tiles/s  1:05 left".
[[nodiscard]] std::string progress_line(const std::string& what, const std::string& unit, std::uint64_t done,
                                        std::uint64_t total, double elapsed_s);

class Progress {
 public:
  using Clock = std::function<double()>;  ///< seconds since any moment

  /// `what` is done in `total` units. Shows nothing for the first half second, and is redrawn at most ten times a
  /// second.
  Progress(const Streams& streams, const CommonOptions& common, std::string what, std::string unit,
           std::uint64_t total);
  Progress(const Streams& streams, const CommonOptions& common, std::string what, std::string unit, std::uint64_t total,
           Clock clock);
  ~Progress();  ///< clears the line
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// n more units are done. From any thread; never waits for another one and never throws.
  void add(std::uint64_t n) noexcept;
  /// Draws the line at once: a long step begins, which cannot say how far it is.
  void show() noexcept;
  /// Clears the line; nothing is shown from here on.
  void finish() noexcept;

 private:
  void draw(std::uint64_t done, double now_s);

  std::ostream& err_;
  std::string what_, unit_;
  std::uint64_t total_;
  Clock clock_;
  double started_s_ = 0.0;
  std::atomic<bool> on_;
  std::atomic<std::uint64_t> done_{0};
  std::mutex drawing_;   ///< held while the line is drawn, and guards what follows
  double next_s_ = 0.0;  ///< no redraw before
  bool drawn_ = false;
};

}  // namespace lode::experiments

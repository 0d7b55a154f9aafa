#pragma once
/// Seconds spent in each part of making an approximation.

#include <chrono>
#include <iterator>
#include <numeric>
#include <string>

#include "experiments/harness/row.h"
#include "techniques/convex_culling/approximation_params.h"

namespace lode::experiments {

/// Made for one approximation; `enter` goes to ApproximationParams::on_stage.
class StageClock {
 public:
  void enter(techniques::convex_culling::ApproximationStage stage) {
    const auto now = std::chrono::steady_clock::now();
    if (current_ < std::size(kStages)) seconds_[current_] += std::chrono::duration<double>(now - since_).count();
    current_ = std::size_t(stage), since_ = now;
  }
  [[nodiscard]] double seconds() const { return std::accumulate(std::begin(seconds_), std::end(seconds_), 0.0); }
  [[nodiscard]] double hull_seconds() const { return seconds_[4]; }
  /// seconds, and of it weld_s, area_s, cluster_s, partition_s, hulls_s.
  void add_to(Row& row) const {
    row.add("seconds", seconds());
    for (std::size_t k = 0; k < std::size(kStages); ++k) row.add(std::string(kStages[k]) + "_s", seconds_[k]);
  }

 private:
  static constexpr const char* kStages[] = {"weld", "area", "cluster", "partition", "hulls"};
  std::size_t current_ = std::size(kStages);
  double seconds_[std::size(kStages)] = {};
  std::chrono::steady_clock::time_point since_ = std::chrono::steady_clock::now();
};

}  // namespace lode::experiments

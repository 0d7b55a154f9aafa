#include "experiments/image_reuse/summary.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "experiments/harness/method.h"
#include "experiments/image_reuse/cost_model.h"
#include "experiments/image_reuse/names.h"

namespace lode::experiments {
namespace {

constexpr double kPaperFrames = 2000.0;

/// One column of some rows, where they have it.
class Values {
 public:
  Values(const std::vector<Row>& rows, std::string_view column) {
    for (const Row& row : rows) {
      if (row.find(column) != nullptr) values_.push_back(row.number(column));
    }
    std::sort(values_.begin(), values_.end());
  }
  [[nodiscard]] bool empty() const { return values_.empty(); }
  [[nodiscard]] double sum() const {
    double total = 0.0;
    for (const double v : values_) total += v;
    return total;
  }
  [[nodiscard]] double mean() const { return empty() ? 0.0 : sum() / double(values_.size()); }
  [[nodiscard]] double most() const { return empty() ? 0.0 : values_.back(); }
  /// The value that a share of all are not above.
  [[nodiscard]] double quantile(double share) const {
    if (empty()) return 0.0;
    return values_[std::size_t(std::max(std::ceil(share * double(values_.size())), 1.0)) - 1];
  }

 private:
  std::vector<double> values_;
};

Row row_of_method(const std::vector<Row>& results, const std::vector<Row>& times, double without_ms, double each) {
  const auto of = [&](std::string_view column) { return Values(results, column); };
  const Values ms(times, "frame_ms");
  Row row;
  row.add("kind", kOfMethod).add("scene", results[0].text("scene")).add("path", results[0].text("path"));
  row.add("each", each).add("method", results[0].text("method")).add("frames", std::int64_t(results.size()));
  if (!ms.empty()) {
    row.add("frame_ms_mean", ms.mean()).add("frame_ms_median", ms.quantile(0.5));
    row.add("frame_ms_p99", ms.quantile(0.99)).add("frame_ms_max", ms.most());
    row.add("seconds", ms.mean() * kPaperFrames / 1000.0).add("speedup", without_ms / ms.mean());
  }
  const double reused = of("reused").sum(), could = of("objects_in_view").sum() - of("near").sum();
  if (!of("reused").empty()) row.add("reused_percent", could > 0.0 ? 100.0 * reused / could : 0.0);
  row.add("captures_per_frame", of("captures").mean()).add("captured_px_per_frame", of("captured_px").mean());
  if (!of("picture_bytes").empty()) row.add("picture_mib", of("picture_bytes").most() / double(1 << 20));
  row.add("triangles_per_frame", of("triangles_in").mean());
  for (const char* column : {"flip", "psnr_db", "ssim", "displacement_px", "pop", "pop_p99"}) {
    if (!of(column).empty()) row.add(column, of(column).mean());
  }
  if (!of("displacement_max_px").empty()) row.add("displacement_max_px", of("displacement_max_px").most());
  row.add("pop_max", of("pop").most());
  return row;
}

/// The time of a method in a summary; nothing if it was not timed.
const Row* timed_row(const std::vector<Row>& rows, const std::string& method) {
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const Row& row) {
    return row.text("method") == method && row.find("frame_ms_mean") != nullptr;
  });
  return found == rows.end() ? nullptr : &*found;
}

void add_cost_model(const std::vector<Row>& methods, std::string_view skips, std::vector<Row>& summary) {
  std::vector<double> threshold, ms;
  for (const char* degrees : kThresholds_deg) {
    const Row* row = timed_row(methods, reuse_at(degrees) + std::string(skips));
    if (row == nullptr) continue;
    threshold.push_back(std::strtod(degrees, nullptr)), ms.push_back(row->number("frame_ms_mean"));
  }
  const Row* without = timed_row(methods, kNoCache + std::string(skips));
  if (threshold.size() < 3 || without == nullptr) return;
  const CostModel model = fit_cost_model(threshold, ms);
  Row row;
  row.add("kind", kOfFit).add("scene", without->text("scene")).add("path", without->text("path"));
  row.add("each", without->number("each")).add("skips", std::int64_t(skips.empty() ? 0 : 1));
  row.add("t0_ms", model.t0).add("k_ms_deg", model.k).add("residual_percent", 100.0 * model.residual);
  if (const auto degrees = model.break_even_deg(without->number("frame_ms_mean"))) row.add("break_even_deg", *degrees);
  summary.push_back(std::move(row));
}

/// The fastest of some methods whose FLIP is at most so much; null if there is none.
const Row* fastest(const std::vector<Row>& methods, double most_flip, bool reuse) {
  const Row* best = nullptr;
  for (const Row& row : methods) {
    const std::string method = row.text("method");
    if (method.ends_with(kWithSkips) || method == kNoCache || method.starts_with(kReuse) != reuse) continue;
    if (!row.find("frame_ms_mean") || !row.find("flip") || row.number("flip") > most_flip) continue;
    if (best == nullptr || row.number("frame_ms_mean") < best->number("frame_ms_mean")) best = &row;
  }
  return best;
}

void add_equal_errors(const std::vector<Row>& methods, std::vector<Row>& summary) {
  for (const char* degrees : kThresholds_deg) {
    const Row* threshold = timed_row(methods, reuse_at(degrees));
    if (threshold == nullptr || !threshold->find("flip")) continue;
    const double flip = threshold->number("flip");
    const Row *reuse = fastest(methods, flip, true), *rival = fastest(methods, flip, false);
    if (rival == nullptr) continue;
    Row row;
    row.add("kind", kOfEqualError).add("scene", threshold->text("scene")).add("path", threshold->text("path"));
    row.add("each", threshold->number("each")).add("flip", flip);
    row.add("method", reuse->text("method")).add("frame_ms_mean", reuse->number("frame_ms_mean"));
    row.add("rival", rival->text("method")).add("rival_ms", rival->number("frame_ms_mean"));
    row.add("ratio", reuse->number("frame_ms_mean") / rival->number("frame_ms_mean"));
    summary.push_back(std::move(row));
  }
}

}  // namespace

void add_summary(const CaseResult& walk, double each, std::vector<Row>& summary) {
  std::vector<Row> methods;
  for (const std::string& method : values_of(walk.results, "method")) {
    const bool skips = method.ends_with(kWithSkips);
    const std::string without = kNoCache + std::string(skips ? kWithSkips : "");
    const double without_ms = Values(rows_with(walk.times, "method", without), "frame_ms").mean();
    methods.push_back(row_of_method(rows_with(walk.results, "method", method), rows_with(walk.times, "method", method),
                                    without_ms, each));
  }
  summary.insert(summary.end(), methods.begin(), methods.end());
  add_cost_model(methods, "", summary);
  add_cost_model(methods, kWithSkips, summary);
  add_equal_errors(methods, summary);
}

void add_crossovers(std::vector<Row>& summary) {
  const std::vector<Row> methods = rows_with(summary, "kind", kOfMethod);
  for (const std::string_view path : {kApproach, kSideways}) {
    for (const char* degrees : kThresholds_deg) {
      std::vector<Row> rows = rows_with(rows_with(methods, "path", std::string(path)), "method", reuse_at(degrees));
      std::erase_if(rows, [](const Row& row) { return row.number("each") <= 0.0 || row.find("speedup") == nullptr; });
      std::stable_sort(rows.begin(), rows.end(),
                       [](const Row& a, const Row& b) { return a.number("each") < b.number("each"); });
      if (rows.size() < 2) continue;
      std::vector<double> size, speedup;
      for (const Row& row : rows) size.push_back(row.number("each")), speedup.push_back(row.number("speedup"));
      Row row;
      const std::string scene = rows[0].text("scene");
      row.add("kind", kOfCrossover).add("scene", scene.substr(0, scene.find(':'))).add("path", std::string(path));
      row.add("method", reuse_at(degrees));
      if (const auto triangles = crossover(size, speedup)) row.add("triangles", *triangles);
      summary.push_back(std::move(row));
    }
  }
}

}  // namespace lode::experiments

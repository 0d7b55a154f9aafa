#include "experiments/convex_culling/summary.h"

#include <algorithm>
#include <cmath>

#include "experiments/convex_culling/names.h"
#include "experiments/harness/method.h"

namespace lode::experiments {
namespace {

std::vector<const Row*> rows_of_method(const std::vector<Row>& rows, const std::string& method) {
  std::vector<const Row*> of;
  for (const Row& row : rows) {
    if (row.text("method") == method) of.push_back(&row);
  }
  return of;
}

double sum(const std::vector<const Row*>& rows, std::string_view column) {
  double total = 0.0;
  for (const Row* row : rows) total += row->number(column);
  return total;
}

/// The value that a share of all values are not above.
double quantile(const std::vector<const Row*>& rows, std::string_view column, double share) {
  std::vector<double> values;
  for (const Row* row : rows) values.push_back(row->number(column));
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  return values[std::size_t(std::max(std::ceil(share * double(values.size())), 1.0)) - 1];
}

std::int64_t count_if_positive(const std::vector<const Row*>& rows, std::string_view column) {
  return std::count_if(rows.begin(), rows.end(), [&](const Row* row) { return row->number(column) > 0.0; });
}

/// Of the views that were held against the truth. Where pictures are equal there is no PSNR.
void add_true_means(const std::vector<const Row*>& rows, Row& row) {
  const auto n_with = [&](const char* column) {
    return std::count_if(rows.begin(), rows.end(), [&](const Row* r) { return r->find(column) != nullptr; });
  };
  const auto n_views = std::int64_t(n_with("flip_true"));
  if (n_views == 0) return;
  row.add("true_views", n_views);
  for (const char* column : {"flip_true", "psnr_true_db", "flip_whole", "psnr_whole_db"}) {
    if (const auto n = n_with(column); n > 0) row.add(column, sum(rows, column) / double(n));
  }
}

}  // namespace

void add_summary(const CaseResult& result, std::vector<Row>& summary) {
  std::vector<std::string> methods;
  for (const Row& row : result.results) {
    const std::string name = row.text("method");
    if (std::find(methods.begin(), methods.end(), name) == methods.end()) methods.push_back(name);
  }
  const double baseline_ms = sum(rows_of_method(result.times, kBaseline), "frame_ms");
  for (const std::string& method : methods) {
    const auto found = rows_of_method(result.results, method), times = rows_of_method(result.times, method);
    const double ms = sum(times, "frame_ms"), own_ms = sum(times, "technique_ms");
    const double n_times = std::max(double(times.size()), 1.0), could = sum(found, "could_be_culled");
    // Culled rightly: in view, not drawn, and not visible.
    double rightly = 0.0, shown = 0.0;
    std::int64_t differ = 0;
    for (const Row* row : found) {
      const double not_drawn =
          row->number("visible") + row->number("could_be_culled") - row->number("objects_in_view_drawn");
      rightly += not_drawn - row->number("false_objects");
      shown += row->number("shown_px");
      differ += row->number("same_picture") == 0.0 ? 1 : 0;
    }
    Row& row = summary.emplace_back();
    row.add("scene", found[0]->text("scene")).add("path", found[0]->text("path")).add("method", method);
    row.add("promise", found[0]->text("promise")).add("frames", std::int64_t(found.size()));
    row.add("frame_ms_median", quantile(times, "frame_ms", 0.5)).add("frame_ms_mean", ms / n_times);
    row.add("frame_ms_p99", quantile(times, "frame_ms", 0.99)).add("technique_ms_mean", own_ms / n_times);
    row.add("speedup", ms > 0.0 ? baseline_ms / ms : 0.0);
    const double saved_ms = baseline_ms - (ms - own_ms);
    if (saved_ms > 0.0 && without_skips(method) != kBaseline) {
      row.add("own_percent_of_saved", 100.0 * own_ms / saved_ms);
    }
    row.add("culled_percent", could > 0.0 ? 100.0 * rightly / could : 0.0);
    row.add("false_frames", count_if_positive(found, "false_px"))
        .add("false_objects", std::int64_t(sum(found, "false_objects")));
    row.add("false_px", std::int64_t(sum(found, "false_px")));
    row.add("false_percent", shown > 0.0 ? 100.0 * sum(found, "false_px") / shown : 0.0);
    row.add("false_samples_4x4", std::int64_t(sum(found, "false_samples_4x4")));
    row.add("false_samples_random", std::int64_t(sum(found, "false_samples_random")));
    row.add("pictures_that_differ", differ);
    add_true_means(found, row);
    for (const Row* losses : rows_of_method(result.losses, method)) {
      for (const Cause& cause : kCauses) row.add(cause.column, std::int64_t(losses->number(cause.column)));
    }
  }
}

}  // namespace lode::experiments

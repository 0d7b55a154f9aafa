#include "experiments/convex_culling/overview.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "experiments/report/html.h"

namespace lode::experiments {
namespace {

constexpr std::string_view kBaseline = "frustum_culling", kPaper = "convex_culling:mode=safe", kBest = "oracle";

std::string digits(double value, int n) {
  std::array<char, 64> text;
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, n);
  return error == std::errc() ? std::string(text.data(), end) : "–";
}

std::vector<const Row*> rows_of(const std::vector<Row>& rows, std::string_view method) {
  std::vector<const Row*> found;
  for (const Row& row : rows) {
    if (row.text("method") == method) found.push_back(&row);
  }
  return found;
}

/// Of all frames of all walks.
double total(const std::vector<const Row*>& rows, std::string_view mean_column) {
  double sum = 0.0;
  for (const Row* row : rows) sum += row->number(mean_column) * row->number("frames");
  return sum;
}
double frames(const std::vector<const Row*>& rows) {
  double n = 0.0;
  for (const Row* row : rows) n += row->number("frames");
  return std::max(n, 1.0);
}

const char* losses_of(const std::vector<const Row*>& rows) {
  const auto any = [&](std::string_view column) {
    return std::any_of(rows.begin(), rows.end(), [&](const Row* row) { return row->number(column) > 0.0; });
  };
  if (any("false_px")) return "pixels";
  return any("false_samples_4x4") || any("false_samples_random") ? "between pixel centres" : "nothing";
}

const Row* find(const std::vector<Row>& rows, std::string_view method) {
  const auto found = rows_of(rows, method);
  return found.empty() ? nullptr : found[0];
}

}  // namespace

std::vector<Row> overview_of(const std::vector<Row>& summary) {
  const double baseline_ms = total(rows_of(summary, kBaseline), "frame_ms_mean");
  std::vector<Row> overview;
  for (const Row& first : summary) {
    const std::string method = first.text("method");
    if (method.ends_with(kWithSkipsSuffix) || find(overview, method) != nullptr) continue;
    const auto rows = rows_of(summary, method);
    const auto speedup = [&](const std::string& name) {
      const double ms = total(rows_of(summary, name), "frame_ms_mean");
      return ms > 0.0 ? baseline_ms / ms : 0.0;
    };
    const auto by_loss = [](const Row* a, const Row* b) {
      return a->number("false_percent") < b->number("false_percent");
    };
    const auto by_culled = [](const Row* a, const Row* b) {
      return a->number("culled_percent") < b->number("culled_percent");
    };
    const Row& worst = **std::max_element(rows.begin(), rows.end(), by_loss);
    const Row& least = **std::min_element(rows.begin(), rows.end(), by_culled);
    Row& row = overview.emplace_back();
    row.add("method", method).add("promise", first.text("promise"));
    row.add("speedup", speedup(method)).add("speedup_skips", speedup(method + std::string(kWithSkipsSuffix)));
    row.add("own_ms", total(rows, "technique_ms_mean") / frames(rows));
    row.add("culled_percent", total(rows, "culled_percent") / frames(rows));
    row.add("least_culled_percent", least.number("culled_percent"));
    row.add("least_walk", least.text("scene") + ", " + least.text("path"));
    row.add("false_percent", total(rows, "false_percent") / frames(rows));
    row.add("worst_false_percent", worst.number("false_percent"));
    row.add("worst_walk", worst.number("false_percent") > 0.0 ? worst.text("scene") + ", " + worst.text("path") : "–");
    row.add("loses", std::string(losses_of(rows)));
  }
  return overview;
}

std::string findings_of(const std::vector<Row>& overview) {
  std::string html;
  if (const Row* paper = find(overview, kPaper)) {
    html += "The paper's technique with the depth rule (" + escaped(std::string(kPaper)) + ") leaves out " +
            digits(paper->number("culled_percent"), 0) + " % of the hidden objects, makes frames " +
            digits(paper->number("speedup"), 2) + " times as fast as frustum culling does, and loses " +
            digits(paper->number("false_percent"), 4) + " % of the pixels";
    html += paper->number("worst_false_percent") > 0.0
                ? ", most of them in " + escaped(paper->text("worst_walk")) + " (" +
                      digits(paper->number("worst_false_percent"), 3) + " %). "
                : ". ";
  }
  const Row* most = nullptr;
  for (const Row& row : overview) {
    if (row.text("method") == kBest || row.number("false_percent") > 0.0 || row.number("culled_percent") == 0.0)
      continue;
    if (most == nullptr || row.number("culled_percent") > most->number("culled_percent")) most = &row;
  }
  if (most != nullptr) {
    html += "Of the methods that lose no pixel, " + escaped(most->text("method")) +
            " leaves out the most: " + digits(most->number("culled_percent"), 0) + " %. ";
  }
  if (const Row* best = find(overview, kBest)) {
    html += "Whoever knew beforehand what is visible (oracle) would be " + digits(best->number("speedup"), 2) +
            " times as fast: no method that leaves out whole objects can be faster in these scenes. ";
  }
  return html.empty() ? html : "<p class=\"finding\">" + html + "</p>\n";
}

}  // namespace lode::experiments

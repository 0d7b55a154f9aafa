#include "experiments/convex_culling/method_rows.h"

#include <algorithm>

#include "experiments/convex_culling/names.h"
#include "experiments/convex_culling/summary.h"
#include "experiments/harness/method.h"
#include "experiments/report/html.h"

namespace lode::experiments {
namespace {

const Row* row_of(const std::vector<Row>& rows, std::string_view method) {
  const auto found =
      std::find_if(rows.begin(), rows.end(), [&](const Row& row) { return row.text("method") == method; });
  return found == rows.end() ? nullptr : &*found;
}

std::string causes_of(const Row& row) {
  std::string text;
  for (const Cause& cause : kCauses) {
    if (row.number(cause.column) <= 0.0) continue;
    text += (text.empty() ? "" : ", ") + row.text(cause.column) + " px " + cause.words;
  }
  return text;
}

/// The causes of all walks together: a row a method.
std::vector<Row> losses_of(const FoundResults& found) {
  std::vector<Row> losses;
  for (const std::string& method : values_of(found.summary, "method")) {
    const std::vector<Row> rows = rows_with(found.summary, "method", method);
    if (rows.front().find(kCauses.front().column) == nullptr) continue;
    Row& row = losses.emplace_back();
    row.add("method", method);
    for (const Cause& cause : kCauses) {
      double px = 0.0;
      for (const Row& one : rows) px += one.number(cause.column);
      row.add(cause.column, std::int64_t(px));
    }
  }
  return losses;
}

std::string times_as_fast(const Row& row) { return fixed_text(row.number("speedup"), 2) + " times as fast"; }

/// Of the methods that decide by themselves and lose no pixel, the fastest; null if there is none.
const Row* fastest_without_loss(const std::vector<Row>& summary) {
  const Row* best = nullptr;
  for (const Row& row : summary) {
    const std::string method = row.text("method");
    const bool decides =
        method != kEverything && method != kBaseline && method != kOracle && !method.ends_with(kWithSkips);
    if (!decides || row.number("false_px") > 0.0) continue;
    if (best == nullptr || row.number("speedup") > best->number("speedup")) best = &row;
  }
  return best;
}

std::string losses_sentence(const Row& row) {
  if (row.number("false_px") == 0.0) return " and loses no pixel.";
  return ", and leaves out what can be seen in " + row.text("false_frames") + " of " + row.text("frames") +
         " views: " + fixed_text(row.number("false_percent"), 4) + " % of the pixels that show anything.";
}

}  // namespace

std::string spoken_name(const std::string& method) {
  std::string name;
  for (std::size_t i = 0; i < method.size(); ++i) {
    const char c = method[i];
    if (c == ':' || c == ',') {  // "mode=safe": the value speaks for itself
      name += ", ";
      i = std::min(method.find('=', i), method.size());
    } else {
      name += c == '_' ? ' ' : c;
    }
  }
  return name;
}

std::vector<Row> over_all_scenes(const FoundResults& found) {
  std::vector<Row> all;
  add_summary({.results = found.results, .times = found.times, .losses = losses_of(found)}, all);
  for (Row& row : all) {
    double least = 1e300, most = 0.0;
    for (const Row& one : rows_with(found.summary, "method", row.text("method"))) {
      least = std::min(least, one.number("speedup")), most = std::max(most, one.number("speedup"));
    }
    row.add("speedups", fixed_text(least, 2) + " – " + fixed_text(most, 2));
  }
  return all;
}

std::vector<Row> with_skips_beside(const std::vector<Row>& summary) {
  std::vector<Row> rows;
  for (const Row& row : summary) {
    const std::string method = row.text("method");
    if (method.ends_with(kWithSkips)) continue;
    Row& one = rows.emplace_back(row);
    one.add("name", spoken_name(method)).add("causes", causes_of(row));
    if (const Row* skips = row_of(summary, method + std::string(kWithSkips))) {
      one.add("speedup_with_skips", skips->number("speedup"));
    }
  }
  return rows;
}

std::string findings(const std::vector<Row>& summary, const std::vector<Row>& results) {
  double visible = 0.0, hidden = 0.0;
  const std::vector<Row> views = rows_with(results, "method", kBaseline);
  for (const Row& row : views) visible += row.number("visible"), hidden += row.number("could_be_culled");
  const double n = std::max(double(views.size()), 1.0);
  std::string text = "In " + std::to_string(views.size()) + " views there are " +
                     fixed_text((visible + hidden) / n, 0) + " objects on average, of which " +
                     fixed_text(hidden / n, 0) + " cannot be seen.";
  if (const Row* oracle = row_of(summary, kOracle)) {
    text += " Whoever knew which, and left out just those, would be " + times_as_fast(*oracle) +
            " as frustum culling: but for noise, no method that leaves out whole objects can be faster.";
  }
  if (const Row* best = fastest_without_loss(summary)) {
    text += " The fastest method that loses no pixel is " + escaped(spoken_name(best->text("method"))) + ": " +
            times_as_fast(*best) + ".";
    const Row* oracle = row_of(summary, kOracle);
    if (oracle && best->number("speedup") > oracle->number("speedup")) {
      text += " That it is faster than the oracle is noise, which more rounds make less (<code>--set rounds=N</code>).";
    }
  }
  if (const Row* paper = row_of(summary, kPaper)) {
    text += " The paper's technique (" + escaped(spoken_name(kPaper)) + ") leaves out " +
            fixed_text(paper->number("culled_percent"), 1) + " % of what cannot be seen, is " + times_as_fast(*paper) +
            losses_sentence(*paper);
  }
  return "<p>" + text + "</p>\n";
}

}  // namespace lode::experiments

#include "experiments/convex_culling/truth_table.h"

#include "experiments/convex_culling/method_rows.h"
#include "experiments/convex_culling/names.h"
#include "experiments/harness/method.h"
#include "experiments/report/html.h"

namespace lode::experiments {
namespace {

const std::vector<Column> kColumns = {{"name", "drawn"},
                                      {"flip_true", "FLIP to the truth", 5},
                                      {"added", "added by culling", 5},
                                      {"psnr_true_db", "PSNR to the truth, dB", 2},
                                      {"flip_whole", "FLIP to everything", 5},
                                      {"psnr_whole_db", "PSNR to everything, dB", 2}};

Row named(Row row, const std::string& name) {
  row.add("name", name);
  return row;
}

}  // namespace

std::string truth_table(const std::vector<Row>& summary) {
  const std::vector<Row> plain = rows_with(summary, "method", kEverything);
  if (plain.empty() || plain.front().find("flip_true") == nullptr) return {};
  const double own_error = plain.front().number("flip_true"), views = plain.front().number("true_views");
  std::vector<Row> rows = {named(plain.front(), "everything")};
  for (const Row& row : summary) {
    const std::string method = row.text("method");
    if (method.ends_with(kWithSkips) || row.number("flip_whole") == 0.0) continue;
    rows.push_back(named(row, spoken_name(method)).add("added", row.number("flip_true") - own_error));
  }
  std::string text = "<p>Against the truth, 8&nbsp;&times;&nbsp;8 samples a pixel, in " +
                     (views == 1.0 ? std::string("the view shown") : fixed_text(views, 0) + " views") +
                     ": the picture of everything, of one sample a pixel, is itself off by a FLIP of " +
                     fixed_text(own_error, 4) + " (aliasing: steps at edges, and what is smaller than a pixel). ";
  if (rows.size() == 1) return text + "Culling adds nothing to that: all methods draw the same picture.</p>\n";
  return text + "What culling adds to that is its own; methods that are not in the table add nothing.</p>\n" +
         html_table(rows, kColumns);
}

}  // namespace lode::experiments

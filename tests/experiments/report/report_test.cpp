// Pieces of a report, and a whole one of results made up here.
#include <gmock/gmock.h>

#include <filesystem>

#include "experiments/convex_culling/method_rows.h"
#include "experiments/convex_culling/truth_table.h"
#include "experiments/error.h"
#include "experiments/file_bytes.h"
#include "experiments/report/found_results.h"
#include "experiments/report/gnuplot.h"
#include "experiments/report/html.h"
#include "experiments/report/plot_script.h"
#include "tests/experiments/run_program.h"
#include "tests/geometry/temporary_folder.h"

namespace lode::tests {
namespace {

using namespace experiments;
using testing::ElementsAre;
using testing::HasSubstr;

TEST(Html, EscapesWhatWouldBeMarkup) { EXPECT_EQ(escaped("a<b> & \"c\""), "a&lt;b&gt; &amp; &quot;c&quot;"); }

// RFC 4648, sec. 10.
TEST(Base64, IsThatOfTheStandardAndReadsBack) {
  const std::pair<const char*, const char*> vectors[] = {{"", ""},
                                                         {"f", "Zg=="},
                                                         {"fo", "Zm8="},
                                                         {"foo", "Zm9v"},
                                                         {"foob", "Zm9vYg=="},
                                                         {"fooba", "Zm9vYmE="},
                                                         {"foobar", "Zm9vYmFy"}};
  for (const auto& [bytes, text] : vectors) {
    EXPECT_EQ(base64(bytes), text);
    EXPECT_EQ(from_base64(text), bytes);
  }
  std::string all;
  for (int k = 0; k < 256; ++k) all += char(k);
  EXPECT_EQ(from_base64(base64(all)), all);
}

TEST(Html, TableHasAColumnForEachThatIsNamed) {
  std::vector<Row> rows(2);
  rows[0].add("name", std::string("a<b")).add("ms", 1.26);
  rows[1].add("name", std::string("c"));
  const std::vector<Column> columns = {{"name", "Name"}, {"ms", "ms", 1}};
  const std::string html = html_table(rows, columns);
  EXPECT_THAT(html, HasSubstr("<tr><td>a&lt;b</td><td class=\"n\">1.3</td></tr>"));
  EXPECT_THAT(html, HasSubstr("<tr><td>c</td><td class=\"n\">–</td></tr>"));
}

TEST(FoundResults, ReadTheCsvThatRowsMake) {
  std::vector<Row> rows(2);
  rows[0].add("name", std::string("a, \"b\"\n")).add("n", std::int64_t(3)).add("ms", 0.5);
  rows[1].add("n", std::int64_t(-4));
  const std::vector<Row> read = rows_of_csv("file.csv", csv_text(rows));
  ASSERT_EQ(read.size(), 2u);
  EXPECT_EQ(read[0].text("name"), "a, \"b\"\n");
  EXPECT_EQ(read[0].number("ms"), 0.5);
  EXPECT_EQ(read[1].find("ms"), nullptr);
  EXPECT_EQ(csv_text(read), csv_text(rows));
  try {
    static_cast<void>(rows_of_csv("file.csv", "a,b\n1,2\n3\n"));
    FAIL() << "expected an error";
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "file.csv:3: expected 2 cells, found 1");
  }
}

// (1, 5) and (3, 1) beat each other in one coordinate; (3, 2) and (2, 6) are beaten, (1, 6) too.
TEST(Pareto, FrontHasWhatNothingBeatsInBoth) {
  const double x[] = {3, 1, 3, 2, 1, 4}, y[] = {1, 5, 2, 6, 6, 1};
  EXPECT_THAT(pareto_front(x, y), ElementsAre(1u, 0u));
  EXPECT_THAT(pareto_front({}, {}), ElementsAre());
}

// Of 0.001 and 0.1 the least decade is 10^-3; zeros lie a decade below it, at -4.
TEST(PlotScript, ALogarithmicAxisHasAPlaceForZero) {
  const std::string script = plot_script({.x_title = "ms",
                                          .y_title = "%",
                                          .log_y = true,
                                          .series = {{.title = "a", .x = {1, 2, 3}, .y = {0, 0.001, 0.1}}}});
  EXPECT_THAT(script, HasSubstr("$d0 << EOD\n1 -4\n2 -3\n3 -1\nEOD"));
  EXPECT_THAT(script, HasSubstr("set ytics (\"0\" -4, \"0.001\" -3, \"0.01\" -2, \"0.1\" -1)"));
}

// Two points in one place share a label. The one just above has a label of its own, a line higher than its 0.8.
TEST(PlotScript, LabelsDoNotLieOnEachOther) {
  const std::string script = plot_script(
      {.x_title = "",
       .y_title = "",
       .series = {{.title = "a", .x = {1, 1, 1, 9}, .y = {5, 5, 5.01, 5}, .labels = {"1", "2", "4", "3"}}}});
  EXPECT_THAT(script, HasSubstr("\"1 2\" at 1,5 center offset 0,0.8"));
  EXPECT_THAT(script, HasSubstr("\"4\" at 1,5.01 center offset 0,1.8"));
  EXPECT_THAT(script, HasSubstr("\"3\" at 9,5 center offset 0,0.8"));
}

TEST(MethodRows, AreNamedForPeople) {
  EXPECT_EQ(spoken_name("masked_occlusion"), "masked occlusion");
  EXPECT_EQ(spoken_name("convex_culling:mode=safe,slabs=50"), "convex culling, safe, 50");
}

// Two views: 3 and 1 objects seen, 1 and 3 hidden. The method takes half of the baseline's time and loses 2 of 1000 px.
TEST(MethodRows, SayWhatWasFound) {
  std::vector<Row> summary(2), results(2);
  summary[0].add("method", std::string("hierarchical_z")).add("speedup", 1.5);
  summary[1].add("method", std::string("convex_culling:mode=safe")).add("speedup", 2.0);
  summary[1].add("culled_percent", 90.0).add("false_px", std::int64_t(2)).add("false_percent", 0.2);
  summary[1].add("frames", std::int64_t(2)).add("false_frames", std::int64_t(1)).add("bulge_px", std::int64_t(2));
  for (std::int64_t k = 0; k < 2; ++k) {
    results[std::size_t(k)].add("method", std::string("frustum_culling"));
    results[std::size_t(k)].add("visible", 3 - 2 * k).add("could_be_culled", 1 + 2 * k);
  }
  const std::string text = findings(summary, results);
  EXPECT_THAT(text, HasSubstr("In 2 views there are 4 objects on average, of which 2 cannot be seen."));
  EXPECT_THAT(text, HasSubstr("loses no pixel is hierarchical z: 1.50 times as fast."));
  EXPECT_EQ(with_skips_beside(summary)[1].text("causes"), "2 px by hulls that bulge out of models");
  EXPECT_THAT(text, HasSubstr("leaves out 90.0 % of what cannot be seen, is 2.00 times as fast, and leaves out what "
                              "can be seen in 1 of 2 views: 0.2000 % of the pixels that show anything."));
}

// 0.031 of which everything has 0.030 by itself: culling added 0.001.
TEST(TruthTable, TellsWhatCullingAddsToThePicturesOwnError) {
  std::vector<Row> summary(2);
  summary[0].add("method", std::string("plain")).add("true_views", std::int64_t(1));
  summary[0].add("flip_true", 0.030).add("flip_whole", 0.0);
  EXPECT_THAT(truth_table({summary[0]}), HasSubstr("off by a FLIP of 0.0300"));
  EXPECT_THAT(truth_table({summary[0]}), HasSubstr("all methods draw the same picture"));
  summary[1].add("method", std::string("convex_culling:mode=safe")).add("flip_true", 0.031).add("flip_whole", 0.002);
  EXPECT_THAT(truth_table(summary), HasSubstr("<td>convex culling, safe</td><td class=\"n\">0.03100</td>"
                                              "<td class=\"n\">0.00100</td>"));
  EXPECT_EQ(truth_table({}), "");
}

TEST(Report, OfDamagedResultsIsRefusedInOneLine) {
  const TemporaryFolder folder;
  ASSERT_EQ(run_lodestone({"run", "image_reuse", "--set", "scene=houses24", "--set", "frames=1", "--set", "passes=0",
                           "--out", folder.path()})
                .status,
            0);
  const auto error_with = [&](const std::string& file, std::string (*damaged)(std::string)) {
    const std::string whole = *file_bytes(folder.path(file));
    folder.write(file, damaged(whole));
    const auto run = run_lodestone({"report", folder.path(), "--out", folder.path("page.html")});
    folder.write(file, whole);
    EXPECT_EQ(run.status, 3) << file;
    EXPECT_FALSE(std::filesystem::exists(folder.path("page.html")));
    return run.err;
  };
  const auto no_line = [](std::string) { return std::string(); };
  const auto half = [](std::string text) { return text.substr(0, text.size() / 2); };
  const auto first_lines = [](std::string text) { return text.substr(0, text.find('\n', text.find('\n') + 1) + 1); };
  EXPECT_THAT(error_with("image_reuse/results.csv", no_line), HasSubstr("results.csv: expected"));
  EXPECT_THAT(error_with("image_reuse/results.csv", first_lines), HasSubstr("rows, as the summary says, found 1"));
  EXPECT_THAT(error_with("image_reuse/summary.json", half),
              HasSubstr("expected the summary that lodestone run writes"));
  const auto pictures = std::filesystem::directory_iterator(folder.path("image_reuse/images"));
  const std::string picture = "image_reuse/images/" + pictures->path().filename().string();
  EXPECT_THAT(error_with(picture, half), HasSubstr("expected a whole PNG file"));
  EXPECT_EQ(run_lodestone({"report", folder.path(), "--out", folder.path("page.html")}).status, 0);
}

TEST(Report, OfNothingIsRefusedInOneLine) {
  const TemporaryFolder folder;
  const auto run = run_lodestone({"report", folder.path()});
  EXPECT_EQ(run.status, 3);
  EXPECT_THAT(run.err, HasSubstr("expected a folder that holds a folder of each experiment"));
  folder.write("convex_culling/summary.json", "{");
  EXPECT_THAT(run_lodestone({"report", folder.path()}).err,
              HasSubstr("expected the summary that lodestone run writes"));
  EXPECT_FALSE(std::filesystem::exists(folder.path("report.html")));
}

}  // namespace
}  // namespace lode::tests

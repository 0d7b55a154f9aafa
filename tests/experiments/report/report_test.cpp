// Pieces of a report, and a whole one of results made up here.
#include <gmock/gmock.h>

#include <filesystem>

#include "experiments/error.h"
#include "experiments/report/found_results.h"
#include "experiments/report/gnuplot.h"
#include "experiments/report/html.h"
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

TEST(Report, OfNothingIsRefusedInOneLine) {
  const TemporaryFolder folder;
  const auto run = run_lodestone({"report", folder.path()});
  EXPECT_EQ(run.status, 3);
  EXPECT_THAT(run.err, HasSubstr("expected the folder of an experiment"));
  folder.write("convex_culling/summary.json", "{");
  EXPECT_THAT(run_lodestone({"report", folder.path()}).err,
              HasSubstr("expected the summary that lodestone run writes"));
  EXPECT_FALSE(std::filesystem::exists(folder.path("report.html")));
}

}  // namespace
}  // namespace lode::tests

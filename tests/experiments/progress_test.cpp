/// What long work shows on a terminal.

#include "experiments/progress.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

namespace lode::experiments {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

/// Work of `total` units, one a second of a clock of the test's own, and what standard error then holds.
std::string shown(std::uint64_t total, double seconds_each, bool terminal, bool quiet) {
  std::istringstream in;
  std::ostringstream out, err;
  CommonOptions common;
  common.quiet = quiet;
  double now_s = 100.0;
  {
    Progress progress({in, out, err, terminal}, common, "rendering", "tiles", total, [&] { return now_s; });
    for (std::uint64_t k = 0; k < total; ++k) {
      now_s += seconds_each;
      progress.add(1);
    }
  }
  EXPECT_EQ(out.str(), "");
  return err.str();
}

TEST(Progress, ALineHasPercentRateAndTimeLeft) {
  // 25 of 100 after 10 s: 2.5 a second, 30 s left.
  EXPECT_EQ(progress_line("rendering", "tiles", 25, 100, 10.0), "rendering  25 %  2.5 tiles/s  0:30 left");
  EXPECT_EQ(progress_line("checking", "rays", 1'000'000, 100'000'000, 40.0),
            "checking   1 %  25k rays/s  1:06:00 left");
  EXPECT_EQ(progress_line("rendering", "tiles", 0, 100, 10.0), "rendering   0 %");
  EXPECT_EQ(progress_line("rendering", "tiles", 100, 100, 10.0), "rendering 100 %  10 tiles/s  0:00 left");
}

TEST(Progress, IsShownOnATerminalOnlyAndNotWhenQuiet) {
  EXPECT_THAT(shown(10, 1.0, true, false), HasSubstr("rendering  10 %"));
  EXPECT_EQ(shown(10, 1.0, false, false), "");
  EXPECT_EQ(shown(10, 1.0, true, true), "");
}

TEST(Progress, ShortWorkShowsNothing) { EXPECT_EQ(shown(40, 0.01, true, false), ""); }

TEST(Progress, ALongStepThatBeginsIsShownAtOnce) {
  std::istringstream in;
  std::ostringstream out, err;
  Progress progress({in, out, err, true}, CommonOptions{}, "preparing", "methods", 4, [] { return 100.0; });
  progress.show();
  EXPECT_THAT(err.str(), EndsWith("preparing   0 %"));
}

TEST(Progress, TheLineIsClearedInTheEnd) { EXPECT_THAT(shown(10, 1.0, true, false), EndsWith("left\r\033[K")); }

TEST(Progress, IsRedrawnAtMostTenTimesASecond) {
  // 2000 units in 2 s: from 0.5 s on, every 0.1 s: 16 times at most.
  const std::string text = shown(2000, 0.001, true, false);
  std::size_t n = 0;
  for (std::size_t at = text.find("rendering"); at != std::string::npos; at = text.find("rendering", at + 1)) ++n;
  EXPECT_GE(n, 10u);
  EXPECT_LE(n, 16u);
}

}  // namespace
}  // namespace lode::experiments

/// The program's face: its options, its help, its exit statuses.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "raster/render.h"
#include "tests/experiments/run_program.h"

namespace lode::tests {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

const std::string kEmpty = R"({"size": [2, 1], "draws": []})";

void expect_wrong_usage(const Arguments& arguments, const std::string& message) {
  const Outcome run = run_lodestone(arguments, kEmpty);
  EXPECT_EQ(run.status, 2) << message;
  EXPECT_TRUE(is_one_error_line(run.err)) << run.err;
  EXPECT_THAT(run.err, HasSubstr(message));
  EXPECT_EQ(run.out, "");
}

TEST(Program, PrintsItsVersionAndThePixelContract) {
  const Outcome run = run_child({"--version"});
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(run.out, "lodestone 0.1.0, pixel contract 1\n");
}

TEST(Program, HelpGoesToStandardOutputWithExamples) {
  const Outcome run = run_lodestone({"--help"});
  EXPECT_EQ(run.status, 0);
  EXPECT_THAT(run.out, HasSubstr("lodestone draw picture.json --out picture.png"));
  const Outcome draw = run_lodestone({"draw", "--help"});
  EXPECT_EQ(draw.status, 0);
  EXPECT_THAT(draw.out, HasSubstr("--depth"));
}

TEST(Program, WithoutArgumentsHelpGoesToStandardError) {
  const Outcome run = run_child({});
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(run.out, "");
  EXPECT_THAT(run.err, HasSubstr("Usage: lodestone"));
}

TEST(Program, ACommandThatDoesNotExistIsWrongUsage) {
  expect_wrong_usage({"paint"}, "unknown command \"paint\": expected list, ");
  expect_wrong_usage({"--quiet"}, "subcommand");
  expect_wrong_usage({"draw", "-", "--print", "--frobnicate"}, "--frobnicate");
  expect_wrong_usage({"draw", "-", "extra", "--print"}, "extra");
  expect_wrong_usage({"draw", "--print"}, "PICTURE");
}

TEST(Program, CommonOptionsStandBeforeOrAfterTheCommand) {
  const Arguments common = {"--quiet",    "--threads", "3",      "--target", "scalar",
                            "--pipeline", "reference", "--skip", "none"};
  Arguments before = common, after = {"draw", "-", "--print"};
  before.insert(before.end(), {"draw", "-", "--print"});
  after.insert(after.end(), common.begin(), common.end());
  for (const Arguments& arguments : {before, after}) {
    const Outcome run = run_lodestone(arguments, kEmpty);
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(run.out, "..\n");
  }
}

TEST(Program, ThreadsAreCountedFromZeroUp) {
  for (const char* n : {"0", "1", "1000"})
    EXPECT_EQ(run_lodestone({"draw", "-", "--print", "--threads", n}, kEmpty).status, 0);
  for (const char* n : {"-1", "two", "1.5", "", "99999999999999999999"}) {
    expect_wrong_usage({"draw", "-", "--print", "--threads", n}, "--threads");
  }
}

TEST(Program, ATargetThatTheProcessorLacksIsWrongUsage) {
  for (const char* name : {"best", "scalar"}) {
    EXPECT_EQ(run_lodestone({"draw", "-", "--print", "--target", name}, kEmpty).status, 0);
  }
#if defined(__x86_64__)
  expect_wrong_usage({"draw", "-", "--print", "--target", "neon"}, "neon: this processor lacks it");
  expect_wrong_usage({"draw", "-", "--print", "--target", "wasm"}, "wasm: this processor lacks it");
#elif defined(__aarch64__)
  expect_wrong_usage({"draw", "-", "--print", "--target", "avx2"}, "avx2: this processor lacks it");
#endif
  expect_wrong_usage({"draw", "-", "--print", "--target", "mmx"}, "expected best, scalar, sse4");
  using raster::Target;
  for (const Target target : {Target::sse4, Target::avx2, Target::avx512, Target::neon, Target::wasm}) {
    const Outcome run = run_lodestone({"draw", "-", "--print", "--target", raster::name_of(target)}, kEmpty);
    EXPECT_EQ(run.status, raster::can_run(target) ? 0 : 2) << raster::name_of(target);
  }
}

TEST(Program, PipelinesAndSkipsAreKnownByName) {
  EXPECT_EQ(run_lodestone({"draw", "-", "--print", "--pipeline", "fast"}, kEmpty).status, 0);
  EXPECT_EQ(run_lodestone({"draw", "-", "--print", "--skip", "all"}, kEmpty).status, 0);
  expect_wrong_usage({"draw", "-", "--print", "--pipeline", "slow"}, "expected fast or reference");
  for (const char* list : {"none", "frustum", "blocks,samples", "frustum,facing,occlusion,samples,blocks"}) {
    EXPECT_EQ(run_lodestone({"draw", "-", "--print", "--skip", list}, kEmpty).status, 0) << list;
  }
  for (const char* list : {"tiles", "", "frustum,", "frustum,tiles", "all,none", "Blocks"}) {
    expect_wrong_usage({"draw", "-", "--print", "--skip", list},
                       "--skip: expected all, none, or some of frustum, facing, occlusion, samples, blocks, found");
  }
}

TEST(Program, AControlCharacterInANameDoesNotBreakTheLine) {
  const Outcome run = run_lodestone({"draw", "no\nsuch\x1b[31mfile", "--print"});
  EXPECT_EQ(run.status, 3);
  EXPECT_EQ(run.err, "lodestone: no?such?[31mfile: cannot be read: No such file or directory\n");
}

}  // namespace
}  // namespace lode::tests

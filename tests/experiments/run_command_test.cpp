// `lodestone run` on the command line. What an experiment finds is its own tests' matter.
#include <gmock/gmock.h>

#include <filesystem>

#include "experiments/error.h"
#include "experiments/experiment.h"
#include "experiments/run/results_folder.h"
#include "tests/experiments/run_program.h"
#include "tests/geometry/temporary_folder.h"

namespace lode::tests {
namespace {

using namespace experiments;

using testing::HasSubstr;

TEST(Run, RefusesWhatItDoesNotKnowInOneLine) {
  const auto refused = [](std::vector<std::string> arguments, const char* message) {
    arguments.insert(arguments.begin(), "run");
    const auto run = run_lodestone(arguments);
    EXPECT_EQ(run.status, 2) << message;
    EXPECT_THAT(run.err, HasSubstr(message));
  };
  refused({"shadows"}, "run: expected convex_approximation, convex_culling or image_reuse, found \"shadows\"");
  refused({"convex_culling", "--size", "huge"}, "--size: expected quick or full, found \"huge\"");
  refused({"convex_culling", "--seed", "-1"}, "--seed: expected a whole number from 0 on, found \"-1\"");
  refused({"convex_culling", "convex_approximation", "--set", "k=1"}, "--set: expected EXPERIMENT.NAME=VALUE");
  refused({"convex_culling", "--out", ""}, "--out: expected a folder, found \"\"");
  refused({}, "EXPERIMENT");
  EXPECT_EQ(run_lodestone({"run", "convex_culling", "--set", "k=1"}).status, 3);
  const auto moon = run_lodestone({"run", "convex_culling", "--set", "scene=moon"});
  EXPECT_EQ(moon.status, 3);
  EXPECT_THAT(moon.err, HasSubstr("one of all, town179, interior124"));
  EXPECT_EQ(run_lodestone({"run", "convex_culling", "--set", "viewpoints=0.5"}).status, 3);
}

TEST(Run, OfNothingWritesNothing) {
  const TemporaryFolder folder;
  const auto run = run_lodestone(
      {"run", "image_reuse", "--set", "scene=houses24", "--set", "frames=0", "--out", folder.path("out")});
  EXPECT_EQ(run.status, 3);
  EXPECT_THAT(run.err, HasSubstr("image_reuse: nothing was looked at, and nothing is written"));
  EXPECT_FALSE(std::filesystem::exists(folder.path("out/image_reuse")));
}

TEST(Run, IsListed) {
  const auto list = run_lodestone({"list", "experiments"});
  for (const Experiment& experiment : experiment_list()) EXPECT_THAT(list.out, HasSubstr(experiment.name));
}

TEST(ResultsFolder, AppearsWholeAndReplacesAnOlderOne) {
  const TemporaryFolder folder;
  const std::string at = folder.path("out/experiment");
  folder.write("out/experiment/results.csv", "old");
  {
    const ResultsFolder abandoned(at);  // a run that failed
    EXPECT_TRUE(std::filesystem::exists(at + "/results.csv"));
  }
  EXPECT_FALSE(std::filesystem::exists(folder.path("out/.experiment.unfinished")));
  ResultsFolder results(at);
  ExperimentResults found;
  found.results.emplace_back().add("n", std::int64_t(1));
  results.publish(found, "{}\n");
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(at)) names.push_back(entry.path().filename().string());
  EXPECT_THAT(names, testing::UnorderedElementsAre("results.csv", "times.csv", "summary.json", "images"));
  int n_beside = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path("out"))) n_beside += entry.exists() ? 1 : 0;
  EXPECT_EQ(n_beside, 1);
}

TEST(ResultsFolder, IsNotPutInThePlaceOfOtherFiles) {
  const TemporaryFolder folder;
  folder.write("out/experiment/results.csv", "old");
  folder.write("out/experiment/thesis.txt", "mine");
  folder.write("out/file", "mine");
  for (const char* at : {"out/experiment", "out/file"}) {
    try {
      const ResultsFolder refused(folder.path(at));
      ADD_FAILURE() << at;
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), HasSubstr("expected nothing, or results of an earlier run")) << at;
    }
  }
  EXPECT_TRUE(std::filesystem::exists(folder.path("out/experiment/thesis.txt")));
  EXPECT_TRUE(std::filesystem::exists(folder.path("out/file")));
}

TEST(ResultsFolder, IsWrittenByOneRunAtATime) {
  const TemporaryFolder folder;
  const std::string at = folder.path("out/experiment");
  ResultsFolder first(at);
  folder.write("out/.experiment.unfinished/images/picture.png", "of the first run");
  try {
    const ResultsFolder second(at);
    ADD_FAILURE() << "two runs write one folder";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("another run is writing it"));
  }
  first.publish({}, "{}\n");
  EXPECT_TRUE(std::filesystem::exists(at + "/images/picture.png"));
  ResultsFolder third(at);  // the first one is done, though still there
  third.publish({}, "{}\n");
  EXPECT_FALSE(std::filesystem::exists(at + "/images/picture.png"));
}

TEST(ResultsFolder, StandsInAFolder) {
  const TemporaryFolder folder;
  folder.write("out", "a file");
  try {
    const ResultsFolder refused(folder.path("out/experiment"));
    ADD_FAILURE() << "made in a file";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("out: expected a folder, or nothing yet"));
  }
  EXPECT_THROW(ResultsFolder(folder.path("out/deeper/experiment")), Error);
}

}  // namespace
}  // namespace lode::tests

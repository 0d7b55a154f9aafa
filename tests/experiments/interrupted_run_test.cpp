/// An experiment that is interrupted leaves no results, keeps the cases that it has finished, and goes on after them.

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <iterator>
#include <map>
#include <thread>

#include "tests/experiments/run_program.h"

namespace lode::tests {
namespace {

namespace fs = std::filesystem;

/// Two views of each walk among houses of three sizes: six cases.
Arguments few_frames(const std::string& out) {
  return {"run", "image_reuse", "--set", "scene=houses24", "--set", "frames=2", "--set", "passes=0", "--out", out, "--quiet"};
}

/// When each of the finished cases was written.
std::map<std::string, fs::file_time_type> kept_cases(const std::string& out) {
  std::map<std::string, fs::file_time_type> kept;
  if (!fs::is_directory(out + "/.kept")) return kept;
  for (const auto& entry : fs::directory_iterator(out + "/.kept")) {
    const std::string name = entry.path().filename().string();
    if (name.find('.') == std::string::npos) kept[name] = entry.last_write_time();  // not one being written
  }
  return kept;
}

/// The signal that ended a run which was interrupted as soon as it had finished a case; 0 if it ended by itself.
int interrupted_after_a_case(const std::string& out) {
  Arguments arguments = few_frames(out);
  arguments.insert(arguments.begin(), "lodestone");
  std::vector<char*> pointers;
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  const pid_t child = ::fork();
  if (child == 0) {
    ::execv(LODESTONE_PROGRAM_PATH, pointers.data());
    ::_exit(127);
  }
  int code = 0;
  while (::waitpid(child, &code, WNOHANG) == 0) {
    if (!kept_cases(out).empty()) ::kill(child, SIGINT);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return WIFSIGNALED(code) ? WTERMSIG(code) : 0;
}

TEST(InterruptedExperiment, LeavesNoResultsAndGoesOnWhereItWas) {
  const TemporaryDirectory directory;
  const std::string out = directory / "out";
  ASSERT_EQ(interrupted_after_a_case(out), SIGINT);
  EXPECT_FALSE(fs::exists(out + "/image_reuse"));
  const auto before = kept_cases(out);
  ASSERT_GE(before.size(), 1u);
  ASSERT_LT(before.size(), 6u);

  ASSERT_EQ(run_child(few_frames(out)).status, 0);
  const auto after = kept_cases(out);
  for (const auto& [name, written] : before) {
    ASSERT_TRUE(after.contains(name));
    EXPECT_EQ(after.at(name), written);  // not made again
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(out), fs::directory_iterator()), 2);  // the results, and what is kept

  const std::string whole = directory / "whole";
  ASSERT_EQ(run_child(few_frames(whole)).status, 0);
  EXPECT_EQ(file_text(out + "/image_reuse/results.csv"), file_text(whole + "/image_reuse/results.csv"));
}

}  // namespace
}  // namespace lode::tests
